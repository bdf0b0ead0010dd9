// Where the camera stands: on a sphere about the scene, moved by pointer and keys.
const TURN = Math.PI / 24; // of one key press
const CLOSER = 0.87;
const STEEPEST = Math.PI / 2 - 0.01;
const NEAREST = 0.25, FARTHEST = 2.5;

export class Orbit {
  constructor(canvas, [azimuth, elevation], changed) {
    this.first = { azimuth, elevation, distance: 1 };
    this.changed = changed;
    this.reset();
    canvas.addEventListener("keydown", event => this.#key(event));
    this.#drag(canvas);
  }

  reset() { this.look(this.first); }

  look({ azimuth = this.azimuth, elevation = this.elevation, distance = this.distance }) {
    this.azimuth = azimuth;
    this.elevation = Math.min(Math.max(elevation, -STEEPEST), STEEPEST);
    this.distance = Math.min(Math.max(distance, NEAREST), FARTHEST);
    this.changed();
  }

  turn(across, up) {
    this.look({ azimuth: this.azimuth + across, elevation: this.elevation + up });
  }

  // Put the camera there: `radius` is its distance where the view shows everything.
  place(camera, middle, radius) {
    const flat = Math.cos(this.elevation);
    camera.position.set(flat * Math.cos(this.azimuth), flat * Math.sin(this.azimuth), Math.sin(this.elevation));
    camera.position.multiplyScalar(radius * this.distance).add(middle);
    camera.lookAt(middle);
  }

  #key(event) {
    const keys = {
      ArrowLeft: () => this.turn(-TURN, 0),
      ArrowRight: () => this.turn(TURN, 0),
      ArrowUp: () => this.turn(0, TURN),
      ArrowDown: () => this.turn(0, -TURN),
      "+": () => this.look({ distance: this.distance * CLOSER }),
      "=": () => this.look({ distance: this.distance * CLOSER }),
      "-": () => this.look({ distance: this.distance / CLOSER }),
      Home: () => this.reset(),
    };
    if (!(event.key in keys) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    keys[event.key]();
  }

  // One pointer turns, two zoom; a finger that moves up or down scrolls the page (see the style).
  #drag(canvas) {
    const pointers = new Map();
    const spread = () => {
      const [a, b] = [...pointers.values()];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };
    canvas.addEventListener("pointerdown", event => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    });
    canvas.addEventListener("pointermove", event => {
      const last = pointers.get(event.pointerId);
      if (!last) return;
      const before = pointers.size === 2 ? spread() : 0;
      const across = event.clientX - last.x, up = event.clientY - last.y;
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      if (pointers.size === 2) this.look({ distance: this.distance * before / Math.max(spread(), 1) });
      else this.turn(-across * Math.PI / canvas.clientWidth, up * Math.PI / canvas.clientWidth);
    });
    for (const end of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(end, event => pointers.delete(event.pointerId));
    }
    canvas.addEventListener("wheel", event => {
      if (!event.ctrlKey) return; // a plain wheel scrolls the page
      event.preventDefault();
      this.look({ distance: this.distance * Math.exp(event.deltaY / 300) });
    }, { passive: false });
  }
}

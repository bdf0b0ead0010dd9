// One view: it reads its scene from the page, draws it, and obeys the controls beside it.
import { DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { Clock, told } from "./clock.js";
import { Orbit } from "./orbit.js";
import { Readings } from "./readings.js";
import { Robot } from "./robot.js";
import { axes, floor, path, plane, waypoints } from "./scenery.js";

const ANGLE = 30; // degrees, of the camera
const MARGIN = 1.12; // room for labels about all that moves

export function startView(figure) {
  const part = name => figure.querySelector(`.arm-${name}`);
  const canvas = part("canvas"), data = JSON.parse(part("scene").textContent);
  const context = canvas.getContext("webgl2", { antialias: true, alpha: true });
  if (!context) return; // no WebGL: the still stays
  const renderer = new WebGLRenderer({ canvas, context, alpha: true });
  const show = live => {
    figure.classList.toggle("arm-live", live);
    part("view").hidden = !live;
  };
  show(true);
  new View(figure, part, canvas, renderer, data);
  canvas.addEventListener("webglcontextlost", () => show(false));
  canvas.addEventListener("webglcontextrestored", () => show(true));
}

class View {
  #wanted = false;

  constructor(figure, part, canvas, renderer, data) {
    Object.assign(this, { figure, part, canvas, renderer, data });
    this.camera = new PerspectiveCamera(ANGLE, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.readings = new Readings(part("joints"), part("where"), data);
    this.middle = new Vector3(...data.middle).divideScalar(1000);
    this.#furnish();
    this.clock = new Clock(Math.max(...data.motions.map(motion => motion.times.at(-1))), () => this.#told());
    this.orbit = new Orbit(canvas, data.view, () => this.draw());
    this.#connect();
    new ResizeObserver(() => this.draw()).observe(part("stage"));
    for (const query of ["(prefers-color-scheme: dark)", "print"]) {
      matchMedia(query).addEventListener("change", () => this.draw());
    }
    this.#told();
  }

  #furnish() {
    const { data } = this, reach = data.radius / 1000, thick = 0.03 * reach;
    this.scene = new Scene();
    this.robots = data.motions.map((motion, k) =>
      new Robot(motion, data.joints, thick, { seeThrough: k > 0, column: data.column && k === 0 }));
    this.paths = data.motions.map((motion, k) => path(motion, thick * (k ? 0.16 : 0.2)));
    this.floor = floor(data.grid / 1000, 1.1 * reach);
    this.floor.position.z = -0.003 * reach; // just below the axes, which lie on it
    this.plane = plane(Math.ceil(1.1 * reach / (data.grid / 1000)) * data.grid / 1000);
    this.plane.position.z = -0.005 * reach;
    const frame = axes(data.axis / 1000), marks = waypoints(data.waypoints, 0.55 * thick);
    this.inks = [frame.material, marks.material];
    this.sun = new DirectionalLight(0xffffff, 1.6);
    this.scene.add(...this.robots, ...this.paths, this.floor, this.plane, frame.group, marks.group, new HemisphereLight(0xffffff, 0x777777, 1.9), this.sun);
    this.labels = [...frame.names, ...marks.names].map(({ text, place, kind }) => {
      const label = document.createElement("span");
      label.className = `arm-label arm-label-${kind}`;
      label.textContent = text;
      this.part("labels").append(label);
      return { label, place };
    });
  }

  #connect() {
    const { clock, orbit, part } = this, range = part("time");
    clock.speed = Number(part("speed").value);
    range.max = clock.end;
    range.step = "any";
    range.addEventListener("input", () => { clock.pause(); clock.now = range.valueAsNumber; });
    range.addEventListener("keydown", event => this.#step(event));
    part("play").addEventListener("click", () => clock.playing ? clock.pause() : clock.play());
    part("speed").addEventListener("change", event => { clock.speed = Number(event.target.value); });
    for (const button of this.figure.querySelectorAll("[data-azimuth]")) {
      const angle = name => Number(button.dataset[name]) * Math.PI / 180;
      button.addEventListener("click", () => orbit.look({ azimuth: angle("azimuth"), elevation: angle("elevation") }));
    }
    part("reset").addEventListener("click", () => orbit.reset());
    new IntersectionObserver(([entry]) => entry.isIntersecting || clock.pause()).observe(part("stage"));
  }

  // A hundredth of the whole motion per key, a tenth with Page Up and Down.
  #step(event) {
    const { clock } = this;
    const keys = {
      ArrowRight: 0.01, ArrowUp: 0.01, ArrowLeft: -0.01, ArrowDown: -0.01, PageUp: 0.1, PageDown: -0.1, Home: -1, End: 1,
    };
    if (!(event.key in keys)) return;
    event.preventDefault();
    clock.pause();
    clock.now += keys[event.key] * clock.end;
  }

  // Say and show the time that the clock has now.
  #told() {
    const { clock, part } = this, range = part("time");
    for (const robot of this.robots) robot.at(clock.now);
    const where = this.readings.show(this.robots, clock.now);
    const seconds = told(clock.now, clock.end);
    range.value = clock.now;
    range.setAttribute("aria-valuetext", `${seconds}. ${where}`);
    part("now").textContent = `${seconds} of ${told(clock.end, clock.end)}`;
    part("play").textContent = clock.playing ? "Pause" : "Play";
    this.draw();
  }

  draw() {
    if (this.#wanted) return;
    this.#wanted = true;
    requestAnimationFrame(() => {
      this.#wanted = false;
      this.#draw();
    });
  }

  #draw() {
    const { clientWidth: width, clientHeight: height } = this.part("stage");
    if (!width || !height || !this.orbit) return;
    this.#dress();
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    const narrow = Math.min(1, this.camera.aspect);
    const radius = MARGIN * this.data.radius / 1000 / Math.sin(ANGLE * Math.PI / 360) / narrow;
    this.orbit.place(this.camera, this.middle, radius);
    this.camera.near = radius / 100;
    this.camera.far = 10 * radius;
    this.camera.updateProjectionMatrix();
    this.sun.position.copy(this.camera.position).add(new Vector3(0, 0, radius / 2));
    this.renderer.render(this.scene, this.camera);
    for (const { label, place } of this.labels) {
      const { x, y } = place.clone().project(this.camera);
      label.style.transform = `translate(${((x + 1) * width / 2).toFixed(1)}px, ${((1 - y) * height / 2).toFixed(1)}px)`;
    }
  }

  // Take the colours from the page's style, which knows light and dark.
  #dress() {
    const style = getComputedStyle(this.figure);
    const colour = name => style.getPropertyValue(`--arm-${name}`).trim();
    this.robots.forEach((robot, k) => robot.dress(colour(k ? "ghost" : "solid"), colour(k ? "ghost" : "joint")));
    this.paths.forEach((tube, k) => tube.material.color.set(colour(k ? "ghost" : "solid")));
    this.floor.material.color.set(colour("floor"));
    this.plane.material.color.set(colour("plane"));
    for (const material of this.inks) material.color.set(colour("ink"));
  }
}

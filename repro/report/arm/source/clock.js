// Return an instant with its unit, to a hundredth of a second, or of a motion that is shorter.
export const told = (seconds, end) => `${seconds.toFixed(Math.min(12, Math.max(2, Math.ceil(2 - Math.log10(end)))))} s`;

// The time that all motions share. It never starts by itself, and pauses when nobody can see it.
export class Clock {
  #now = 0;
  #frame = 0;

  constructor(end, changed) {
    this.end = end;
    this.speed = 1;
    this.changed = changed;
    document.addEventListener("visibilitychange", () => document.hidden && this.pause());
  }

  get now() { return this.#now; }

  set now(seconds) {
    this.#now = Math.min(Math.max(seconds, 0), this.end);
    this.changed();
  }

  get playing() { return this.#frame !== 0; }

  play() {
    if (this.playing) return;
    if (this.#now >= this.end) this.#now = 0;
    let before = performance.now();
    const tick = time => {
      this.#frame = requestAnimationFrame(tick);
      const passed = Math.max(time - before, 0) / 1000;
      before = time;
      if (this.#now + passed * this.speed >= this.end) this.#stop();
      this.now += passed * this.speed;
    };
    this.#frame = requestAnimationFrame(tick);
    this.changed();
  }

  pause() {
    if (!this.playing) return;
    this.#stop();
    this.changed();
  }

  #stop() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
  }
}

// The present time of a player: plays, loops, and tells who listens.

export const RATES = [0.1, 0.25, 0.5, 1, 2, 4];

export class Clock {
  constructor(duration, loopWindow) {
    this.duration = duration;
    this.window = loopWindow;
    this.wholly = loopWindow[0] <= 0 && loopWindow[1] >= duration; // then no part of it stands out
    this.time = 0;
    this.rate = 1;
    this.playing = false;
    this.looping = false;
    this.listeners = new Map();
    this.frame = 0;
    this.last = 0;
  }

  on(event, listener) {
    if (!this.listeners.has(event)) this.listeners.set(event, new Set());
    this.listeners.get(event).add(listener);
    return () => this.listeners.get(event).delete(listener);
  }

  emit(event, value) {
    for (const listener of this.listeners.get(event) ?? []) listener(value);
  }

  seek(time) {
    this.time = Math.min(Math.max(Number(time) || 0, 0), this.duration);
    this.emit("time", this.time);
  }

  /** Go by so many samples of `step` seconds, to where a sample lies. */
  stepBy(count, step) {
    this.pause();
    this.seek((Math.round(this.time / step) + count) * step);
  }

  play() {
    if (this.playing) return;
    if (this.looping && !this.inWindow()) this.seek(this.window[0]);
    else if (this.time >= this.duration - 1e-6) this.seek(0);
    this.playing = true;
    this.last = 0;
    this.emit("playing", true);
    this.frame = requestAnimationFrame((now) => this.tick(now));
  }

  pause() {
    if (!this.playing) return;
    this.playing = false;
    cancelAnimationFrame(this.frame);
    this.emit("playing", false);
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  setRate(rate) {
    this.rate = rate;
    this.emit("rate", rate);
  }

  setLooping(looping) {
    this.looping = looping;
    this.emit("looping", looping);
  }

  inWindow() {
    return this.time >= this.window[0] && this.time < this.window[1] - 1e-6;
  }

  tick(now) {
    if (!this.playing) return;
    // A tab that was hidden goes on where it was, not where it would be.
    const passed = this.last ? Math.min((now - this.last) / 1000, 0.25) : 0;
    this.last = now;
    const end = this.looping ? this.window[1] : this.duration;
    let next = this.time + passed * this.rate;
    if (next >= end) next = this.looping ? this.window[0] : end;
    this.seek(next);
    if (!this.looping && next >= end) this.pause();
    else this.frame = requestAnimationFrame((later) => this.tick(later));
  }
}

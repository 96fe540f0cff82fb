// The player: mount(element, scene, { before }) shows a scene that `player_scene` has written.

import { Clock, RATES } from "./clock.js";
import { ICONS, playBar, viewBar, zoomBar } from "./controls.js";
import { h, number, setIcon, setText } from "./dom.js";
import { keyListener, keySheet, keyTable } from "./keys.js";
import { Panel } from "./panel.js";
import { Plots } from "./plots.js";
import { Recording } from "./recording.js";
import { Stage } from "./stage.js";
import { Timeline } from "./timeline.js";

const OPENING_S = 1.2; // the first picture is so long before the moment that matters

class Player {
  constructor(element, scene, { before = null } = {}) {
    this.recording = new Recording(scene);
    this.earlier = before ? new Recording(before) : null;
    this.clock = new Clock(this.recording.duration, scene.critical_s);
    this.colours = new Map();
    this.shared = {
      show: { trails: true, ways: false, areas: true, sight: this.sightMatters(), names: true },
      selected: null,
      follow: null,
      closer: 1,
      paint: (name) => this.paint(name),
      paintKey: () => this.epoch,
      comparing: () => this.comparing,
      onCamera: (change, stage) => this.camera(change, stage),
      onSelect: (id) => this.select(id),
    };
    this.epoch = 0;
    this.comparing = false;
    this.build(element);
    this.listen(element);
    this.resize();
    this.camera({ home: true });
    this.seek(scene.moment_s === null ? 0 : scene.moment_s - OPENING_S);
  }

  /** Whether somebody who matters is hidden at some time. */
  sightMatters() {
    const { pair, data, ego } = this.recording;
    return data.hidden.some((one) => one.observer === ego && pair.includes(one.target));
  }

  build(element) {
    const { recording, earlier, clock, shared } = this;
    this.stages = [new Stage(recording, shared, earlier ? "Found" : "")];
    if (earlier) this.stages.unshift(new Stage(earlier, shared, "First timing"));
    this.timeline = this.newTimeline();
    this.plots = new Plots(recording, earlier, clock, shared, (time) => this.seek(time));
    this.panel = new Panel(recording, {
      select: (id) => this.select(shared.selected === id ? null : id),
      claim: (claim) => this.claim(claim.id),
    });
    this.keys = keyTable(this);
    this.sheet = keySheet(this.keys);
    this.pictures = h("div", { class: "stages" }, ...this.stages.map((stage) => stage.element), zoomBar(this));
    this.main = h("div", { class: "main" }, viewBar(this), this.pictures, playBar(this),
      h("div", { class: "course" }, this.timeline.element, this.plots.element));
    this.element = h("section", { class: "player", "aria-label": `Player: ${recording.data.name}` }, this.main, this.panel.element, this.sheet);
    element.replaceChildren(this.element);
  }

  newTimeline() {
    return new Timeline(this.recording, this.clock, {
      seek: (time) => this.seek(time),
      moment: (moment) => this.goTo(moment),
    });
  }

  listen(element) {
    const { clock } = this;
    clock.on("time", () => this.draw());
    clock.on("playing", (playing) => setIcon(this.playButton, playing ? "Pause (space)" : "Play (space)", playing ? ICONS.pause : ICONS.play));
    clock.on("rate", (rate) => { this.rateChoice.value = rate; });
    clock.on("looping", (on) => this.loopButton.setAttribute("aria-pressed", String(on)));
    this.pressed = keyListener(this.keys);
    this.element.addEventListener("keydown", this.pressed);
    const stops = [];
    const size = new ResizeObserver(() => this.resize());
    size.observe(this.pictures);
    stops.push(() => size.disconnect());
    const theme = () => this.repaint();
    const dark = window.matchMedia("(prefers-color-scheme: dark)");
    dark.addEventListener("change", theme);
    const marked = new MutationObserver(theme);
    marked.observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme", "class"] });
    stops.push(() => dark.removeEventListener("change", theme), () => marked.disconnect());
    this.stops = stops;
  }

  /** A colour of the theme. */
  paint(name) {
    if (!this.colours.has(name)) {
      this.colours.set(name, getComputedStyle(this.element).getPropertyValue(name).trim() || "#888888");
    }
    return this.colours.get(name);
  }

  repaint() {
    this.colours.clear();
    this.epoch += 1;
    this.plots.draw();
    this.draw();
  }

  resize() {
    const shown = this.comparing || !this.earlier ? this.stages : this.stages.slice(-1);
    for (const stage of this.stages) stage.element.hidden = !shown.includes(stage);
    this.pictures.classList.toggle("compared", shown.length > 1);
    const gap = 8, full = document.fullscreenElement === this.element;
    const width = Math.max(200, Math.floor((this.pictures.clientWidth - gap * (shown.length - 1)) / shown.length));
    const share = this.stages.at(-1).aspect() * (shown.length > 1 ? 1.5 : 1);
    const high = full ? Math.max(240, window.innerHeight - 420) : Math.min(Math.max(width * share, 240), 560);
    if (width !== this.width || high !== this.high) {
      const first = this.width === undefined;
      [this.width, this.high] = [width, high];
      for (const stage of this.stages) {
        const grown = stage.camera.width > 1 ? width / stage.camera.width : 1;
        stage.resize(width, Math.round(high));
        if (!first) stage.camera.scale *= grown;
      }
    }
    const plot = this.plots.panels[0]?.canvas.parentElement.clientWidth;
    if (plot && plot !== this.plots.outer) this.plots.resize(plot);
    this.draw();
  }

  /** Move the pictures: { zoom, at }, { pan } or { home }. */
  camera(change, from = null) {
    if (change.home) {
      this.shared.closer = 1;
      const found = this.stages.at(-1), far = found.home();
      for (const stage of this.stages) stage.like(found);
      this.setFollow(far ? (this.recording.pair.length === 2 ? "pair" : this.recording.ego) : "");
    }
    if (change.pan) this.setFollow("");
    for (const stage of this.stages) {
      if (change.zoom) {
        const at = from && !this.shared.follow ? change.at : undefined;
        stage.camera.zoom(change.zoom, ...(at ?? []));
      }
      if (change.pan) stage.camera.pan(...change.pan);
    }
    if (change.zoom) this.shared.closer = Math.min(Math.max(this.shared.closer * change.zoom, 0.2), 8);
    this.draw();
  }

  setFollow(whom) {
    this.shared.follow = whom || null;
    this.followed.value = whom;
  }

  /** Keep somebody in the middle: an id, "pair", or "" for nobody. */
  follow(whom) {
    this.shared.closer = 1;
    this.setFollow(whom);
    this.draw();
  }

  compare() {
    if (!this.earlier) return;
    this.comparing = !this.comparing;
    this.compareButton.setAttribute("aria-pressed", String(this.comparing));
    // Both timings have to fit on the line; the later end counts.
    this.clock.duration = Math.max(this.recording.duration, this.comparing ? this.earlier.duration : 0);
    const line = this.newTimeline();
    this.timeline.element.replaceWith(line.element);
    this.timeline = line;
    this.width = null;
    this.resize();
    this.camera({ home: true });
    this.plots.draw();
  }

  changeRate(by) {
    const place = RATES.indexOf(this.clock.rate) + by;
    this.clock.setRate(RATES[Math.min(Math.max(place, 0), RATES.length - 1)]);
  }

  nextMoment(by) {
    const times = [...new Set(this.recording.data.moments.map((one) => one.time_s))];
    const next = by > 0 ? times.find((t) => t > this.time + 1e-3) : times.filter((t) => t < this.time - 1e-3).at(-1);
    if (next !== undefined) this.seek(next);
  }

  /** Go to a moment of the time line. */
  goTo(moment) {
    if (moment.claim) {
      this.claim(moment.claim);
      return;
    }
    this.pause();
    this.select(moment.who.find((id) => id !== this.recording.ego) ?? null);
    this.seek(moment.time_s);
  }

  /** Go to the moment of a statement, and mark it. */
  claim(id) {
    const claim = this.recording.data.claims.find((one) => one.id === id);
    if (!claim) return;
    this.pause();
    this.panel.mark([id]);
    this.select(claim.who.find((name) => name !== this.recording.ego) ?? claim.who[0] ?? null);
    if (claim.shown_s !== null) this.seek(claim.shown_s);
    this.clock.emit("claim", id);
  }

  /** Show a moment with what leads to it; those who do not want motion see the moment alone. */
  playMoment(time, lead = 1.5, rest = 1) {
    if (window.matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.seek(time);
      return;
    }
    this.pause();
    this.seek(time - lead);
    const ends = Math.min(time + rest, this.clock.duration);
    const stop = this.clock.on("time", (now) => {
      if (now < ends && now >= time - lead - 1e-6) return;
      stop();
      if (now < ends + 0.3) this.pause();
    });
    this.play();
  }

  select(id) {
    if (id !== null && !this.recording.byId.has(id)) return;
    this.shared.selected = id;
    this.panel.select(id);
    this.plots.draw();
    this.draw();
    this.clock.emit("select", id);
  }

  /** Do what a key stands for. */
  key(event) {
    this.pressed(event);
  }

  fullscreen() {
    if (document.fullscreenElement) document.exitFullscreen();
    else this.element.requestFullscreen?.().catch(() => undefined);
  }

  help() {
    if (this.sheet.open) this.sheet.close();
    else this.sheet.showModal();
  }

  draw() {
    const { time, playing, duration } = this.clock;
    for (const stage of this.stages) {
      if (!stage.element.hidden) stage.draw(Math.min(time, stage.recording.duration));
    }
    this.timeline.show(time);
    setText(this.clockText, `${number(time, 2)} / ${number(duration, 2)} s`);
    // Numbers that change every frame cannot be read; ten a second can.
    const now = performance.now(), words = !playing || now - (this.written ?? 0) > 100;
    if (words) {
      this.written = now;
      this.panel.show(time);
    }
    this.plots.show(time, words);
  }

  get time() {
    return this.clock.time;
  }

  seek(time) {
    this.clock.seek(time);
  }

  play() {
    this.clock.play();
  }

  pause() {
    this.clock.pause();
  }

  /** The pose of somebody at the present time: { x, y, heading, speed } (m, rad, m/s). */
  pose(id) {
    return this.recording.pose(id, this.time);
  }

  /** Listen to "time" (s), "select" (an id or null), "claim" (an id), "playing"; returns how to stop. */
  on(event, listener) {
    return this.clock.on(event, listener);
  }

  /** Take the player away. */
  destroy() {
    this.pause();
    for (const stop of this.stops) stop();
    this.element.remove();
  }
}

/** Show a scene in an element; `before` is an earlier timing of the same, to compare. */
export function mount(element, scene, options = {}) {
  return new Player(element, scene, options);
}

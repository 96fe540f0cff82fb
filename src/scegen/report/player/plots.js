// Speed, acceleration, distance and time to collision over the same seconds as the time line.

import { colourName } from "./bodies.js";
import { h, KMH, number, setText } from "./dom.js";

const HIGH = 84, TOP = 8, BOTTOM = 6;
const LEFT = 34, RIGHT = 52; // beside the curves, as in the style sheet
const FARTHEST_M = 60, LONGEST_S = 6, CRITICAL_S = 1.5;
const HARDEST = 11; // m/s²: who stands at once, as people on foot do, would flatten all others
const DASHES = [[], [7, 3], [2, 3], [9, 3, 2, 3]];

export class Plots {
  constructor(recording, before, clock, shared, seek) {
    Object.assign(this, { recording, before, clock, shared });
    this.panels = this.describe().filter((panel) => panel.series().length);
    for (const panel of this.panels) {
      panel.canvas = h("canvas", { "aria-hidden": "true" });
      panel.values = h("span", { class: "values" });
      panel.element = h("figure", { class: "plot" },
        h("figcaption", {}, h("b", {}, panel.title), " ", panel.values),
        h("div", { class: "axes" }, panel.canvas));
    }
    this.cursor = h("div", { class: "cursor" });
    this.element = h("div", { class: "plots" }, ...this.panels.map((panel) => panel.element), this.cursor);
    let held = false;
    const go = (event) => {
      const box = this.panels[0].canvas.getBoundingClientRect();
      seek(((event.clientX - box.left - LEFT) / this.width) * clock.duration);
    };
    this.element.addEventListener("pointerdown", (event) => {
      if (!(event.target instanceof HTMLCanvasElement)) return;
      held = true;
      this.element.setPointerCapture(event.pointerId);
      go(event);
    });
    this.element.addEventListener("pointermove", (event) => held && go(event));
    for (const end of ["pointerup", "pointercancel"]) this.element.addEventListener(end, () => { held = false; });
  }

  /** What is plotted: who, which values at a time, how high. */
  describe() {
    const { recording } = this;
    const everybody = () => this.ordered(recording.movers.map((one) => one.id));
    // Whoever is near the ego; the two that it is about, where the ego is neither.
    const { ego } = recording, about = recording.pair.length && !recording.pair.includes(ego) ? [recording.pair[0]] : [];
    const others = () => this.ordered([...about, ...recording.data.pairs.filter(({ between }) => between.includes(ego))
      .map(({ between }) => between.find((id) => id !== ego))
      .filter((id) => !about.includes(id) && (recording.movers.some((one) => one.id === id) || recording.pair.includes(id)))]);
    const measured = (name) => (rec, id, time) => {
      const pair = about.includes(id) ? rec.between(...rec.pair) : rec.between(ego, id);
      return pair ? rec.at(pair[name], time) : null;
    };
    const label = (id) => (about.includes(id) ? recording.pair.join(" – ") : id);
    const to = about.length ? ` to ${ego}, and between ${recording.pair.join(" and ")}` : ` to ${ego}`;
    const all = (ids, value) => ids.flatMap((id) => this.times().map((t) => value(recording, id, t)))
      .filter((v) => v !== null);
    const speed = (rec, id, time) => rec.pose(id, time)?.speed ?? null;
    const rate = (rec, id, time) => rec.acceleration(id, time);
    const distance = measured("distance_m"), ttc = measured("ttc_s");
    const fastest = Math.max(5, ...all(everybody(), speed)) * 1.05;
    const rates = all(everybody(), rate);
    const farthest = Math.min(FARTHEST_M, Math.max(5, ...all(others(), distance)) * 1.03);
    return [
      { title: "Speed", unit: "m/s", series: everybody, value: speed, low: 0, high: fastest, kmh: true },
      { title: "Acceleration", unit: "m/s²", series: everybody, value: rate,
        low: Math.max(Math.min(-2, ...rates) * 1.1, -HARDEST), high: Math.min(Math.max(2, ...rates) * 1.1, HARDEST) },
      { title: `Distance${to}`, label, unit: "m", series: others, value: distance, low: 0, high: farthest, digits: 2 },
      { title: `Time to collision${to.replace(" to ", " with ")}`, label, unit: "s", series: others, value: ttc, low: 0, high: LONGEST_S,
        digits: 2, threshold: CRITICAL_S },
    ];
  }

  /** Those who matter last, so that their lines lie on top. */
  ordered(ids) {
    const matters = (id) => this.recording.pair.includes(id) || id === this.shared.selected;
    return [...ids].sort((a, b) => matters(a) - matters(b));
  }

  times() {
    const { step, duration } = this.recording, every = Math.max(1, Math.ceil(duration / step / 600));
    const count = Math.floor(duration / (step * every) + 1e-6);
    return Array.from({ length: count + 1 }, (_, k) => k * step * every);
  }

  resize(width) {
    const ratio = Math.min(window.devicePixelRatio || 1, 3);
    this.outer = width;
    this.width = width - LEFT - RIGHT;
    for (const { canvas } of this.panels) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(HIGH * ratio);
      canvas.style.width = `${width}px`;
      canvas.style.height = `${HIGH}px`;
    }
    this.ratio = ratio;
    this.draw();
  }

  draw() {
    if (!this.width) return;
    for (const panel of this.panels) this.drawPanel(panel);
  }

  drawPanel(panel) {
    const { width, ratio, clock, shared } = this, { paint } = shared;
    const context = panel.canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width + LEFT + RIGHT, HIGH);
    context.translate(LEFT, 0);
    const x = (time) => (time / clock.duration) * width;
    const y = (value) => TOP + (HIGH - TOP - BOTTOM) * (1 - (value - panel.low) / (panel.high - panel.low));
    const [from, to] = clock.window;
    context.fillStyle = paint("--hazard");
    context.globalAlpha = 0.06;
    if (!clock.wholly) context.fillRect(x(from), 0, x(to) - x(from), HIGH);
    context.globalAlpha = 1;
    context.font = "11px system-ui, sans-serif";
    context.textBaseline = "middle";
    context.lineWidth = 1;
    for (const level of ticks(panel.low, panel.high)) {
      context.strokeStyle = paint("--line");
      context.beginPath();
      context.moveTo(0, Math.round(y(level)) + 0.5);
      context.lineTo(width, Math.round(y(level)) + 0.5);
      context.stroke();
    }
    if (panel.threshold !== undefined) {
      context.strokeStyle = paint("--hazard");
      context.setLineDash([1, 4]);
      context.beginPath();
      context.moveTo(0, y(panel.threshold));
      context.lineTo(width, y(panel.threshold));
      context.stroke();
      context.setLineDash([]);
      context.fillStyle = paint("--hazard");
      context.fillText(`${number(panel.threshold)} s`, width + 6, y(panel.threshold));
    }
    context.save();
    context.beginPath();
    context.rect(0, 0, width, HIGH);
    context.clip();
    if (this.before && shared.comparing()) this.curves(context, panel, this.before, x, y, 0.45);
    this.curves(context, panel, this.recording, x, y, 1);
    context.restore();
    context.fillStyle = paint("--text-soft");
    for (const level of ticks(panel.low, panel.high)) {
      context.textAlign = "right";
      context.fillText(number(level, level % 1 ? 1 : 0), -6, y(level));
      context.textAlign = "left";
      if (panel.kmh) context.fillText(`${number(level * KMH, 0)} km/h`, width + 6, y(level));
    }
  }

  curves(context, panel, recording, x, y, alpha) {
    const ids = panel.series(), { shared } = this;
    const many = ids.length > 4;
    for (const id of ids) {
      const one = recording.byId.get(id);
      if (!one) continue;
      const matters = this.recording.pair.includes(id) || id === this.recording.ego || id === shared.selected;
      context.strokeStyle = shared.paint(colourName(one));
      context.globalAlpha = alpha * (matters || !many ? 1 : 0.45);
      context.lineWidth = matters ? 2.2 : 1.3;
      context.setLineDash(alpha < 1 ? [2, 3] : DASHES[this.dash(one)]);
      context.beginPath();
      let down = false;
      for (const time of this.times()) {
        const value = time <= recording.duration + 1e-6 ? panel.value(recording, id, time) : null;
        if (value === null || value > panel.high) {
          down = false;
          continue;
        }
        if (down) context.lineTo(x(time), y(value));
        else context.moveTo(x(time), y(value));
        down = true;
      }
      context.stroke();
    }
    context.setLineDash([]);
    context.globalAlpha = 1;
  }

  show(time, words) {
    this.cursor.style.transform = `translateX(${LEFT + (time / this.clock.duration) * this.width}px)`;
    if (!words) return;
    for (const panel of this.panels) {
      const chosen = panel.series().filter((id) => this.recording.pair.includes(id) || id === this.shared.selected
        || id === this.recording.ego).reverse();
      if (panel.chosen !== chosen.join()) {
        panel.chosen = chosen.join();
        panel.values.replaceChildren(...chosen.map((id) => h("span", { class: "value" },
          h("i", { style: `border-top-color:var(${colourName(this.recording.byId.get(id))});border-top-style:${this.style(id)}` }),
          document.createTextNode(""))));
      }
      for (const [k, id] of chosen.entries()) {
        const value = panel.value(this.recording, id, time);
        const kmh = panel.kmh && value !== null ? ` (${number(value * KMH, 0)} km/h)` : "";
        setText(panel.values.children[k].lastChild,
          `${panel.label?.(id) ?? id} ${number(value, panel.digits ?? 1)} ${value === null ? "" : panel.unit}${kmh}`);
      }
    }
  }

  style(id) {
    return ["solid", "dashed", "dotted", "dashed"][this.dash(this.recording.byId.get(id))];
  }

  /** Those whose colours look alike to some are told apart by dashes. */
  dash(one) {
    return one.role === "ego" || one.category ? 0 : one.colour % DASHES.length;
  }
}

function ticks(low, high) {
  const step = [0.5, 1, 2, 5, 10, 20, 50, 100].find((one) => (high - low) / one <= 3.6) ?? 200;
  const found = [];
  for (let level = Math.ceil(low / step) * step; level <= high + 1e-9; level += step) found.push(level);
  return found;
}

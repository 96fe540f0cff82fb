// The time line: scrub, moments to go to, the critical seconds, who is on common ground when.

import { colourName } from "./bodies.js";
import { h, number } from "./dom.js";

const SIGNS = { danger: "◆", contact: "✖", closest: "▲", claim: "●" };
const ORDER = ["contact", "closest", "danger", "claim"];
const TOGETHER = 0.013; // of the line: marks nearer than this are one button

export class Timeline {
  /** actions: { seek(time), moment(moment) }. */
  constructor(recording, clock, actions) {
    this.recording = recording;
    this.clock = clock;
    this.range = h("input", {
      type: "range", min: 0, max: clock.duration, step: recording.step, value: 0,
      "aria-label": "Time", class: "scrub", oninput: () => actions.seek(Number(this.range.value)),
    });
    const [from, to] = clock.window;
    this.critical = h("div", { hidden: clock.wholly, class: "critical", style: this.place(from, to), title: "the critical seconds" });
    this.marks = h("div", { class: "marks", role: "group", "aria-label": "Moments" },
      ...this.grouped().map((group) => this.mark(group, actions)));
    this.rail = h("div", { class: "rail" }, this.critical, this.range);
    this.element = h("div", { class: "timeline" },
      this.marks,
      this.rail,
      ...this.occupancy());
  }

  share(time) {
    return (100 * time) / this.clock.duration;
  }

  place(from, to) {
    return `left:${this.share(from)}%;width:${this.share(to) - this.share(from)}%`;
  }

  /** Moments by row and nearness, so that no mark covers another. */
  grouped() {
    const groups = [];
    for (const moment of this.recording.data.moments) {
      const row = moment.kind === "claim" ? 1 : 0;
      const near = groups.find((group) => group.row === row
        && Math.abs(group.moments[0].time_s - moment.time_s) < TOGETHER * this.clock.duration);
      if (near) near.moments.push(moment);
      else groups.push({ row, moments: [moment] });
    }
    return groups;
  }

  mark({ row, moments }, actions) {
    const first = [...moments].sort((a, b) => ORDER.indexOf(a.kind) - ORDER.indexOf(b.kind))[0];
    const holds = moments.every((one) => one.holds);
    const words = moments.map((one) => `${one.label}${one.holds ? "" : " (does not hold)"}`).join("\n");
    return h("button", {
      type: "button", class: `mark ${first.kind} ${holds ? "held" : "failed"} row${row}`,
      style: `left:${this.share(first.time_s)}%`,
      "aria-label": `${number(first.time_s, 2)} s: ${words}`,
      title: `${number(first.time_s, 2)} s\n${words}`,
      onclick: () => actions.moment(first),
    }, holds ? SIGNS[first.kind] : "✕");
  }

  /** A bar for either of the pair: when it is on their common ground; between them lies the PET. */
  occupancy() {
    const { recording } = this, { pair } = recording;
    const areas = recording.data.areas.filter((area) => area.between.every((id) => pair.includes(id)));
    const visited = areas.filter((area) => area.occupied_s.every(Boolean)).slice(0, 2);
    return visited.map((area) => {
      const spans = area.occupied_s.map((span, i) => ({ span, id: area.between[i] })).sort((a, b) => a.span[0] - b.span[0]);
      const bars = spans.map(({ span, id }) => {
        const bar = h("div", { class: "bar", style: `${this.place(...span)};background:var(${colourName(recording.byId.get(id))})` });
        bar.title = `${id} is on the common ground from ${number(span[0], 2)} to ${number(span[1], 2)} s`;
        return bar;
      });
      const [before, after] = [this.share(spans[0].span[0]), this.share(spans[1].span[1])];
      const side = after > 84 && before > 16 ? `right:calc(${100 - before}% + 6px)` : `left:calc(${Math.min(after, 84)}% + 6px)`;
      const words = area.pet_s === null ? "" : `PET ${number(area.pet_s, 2)} s`;
      return h("div", { class: "ground", title: "who is on the common ground of their ways, and when" }, ...bars,
        h("span", { class: "gap", style: side }, words));
    });
  }

  show(time) {
    this.range.value = time;
    this.range.setAttribute("aria-valuetext", `${number(time, 2)} of ${number(this.clock.duration, 2)} seconds`);
    this.rail.style.setProperty("--done", `${this.share(time)}%`);
  }
}

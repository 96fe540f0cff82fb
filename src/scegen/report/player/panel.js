// Beside the picture: everybody with live numbers, and the statements with how they came out.

import { colourName } from "./bodies.js";
import { h, KMH, number, setText } from "./dom.js";

const NEAR_S = 0.4;

export class Panel {
  /** actions: { select(id), claim(claim) }. */
  constructor(recording, actions) {
    this.recording = recording;
    this.rows = new Map();
    this.claims = new Map();
    this.timed = [];
    const people = [...recording.participants, ...recording.objects].map((one) => this.person(one, actions));
    const marked = new Set(recording.data.moments.map((moment) => moment.claim));
    // What does not hold comes first, what is so all the time last.
    const worth = ({ id, holds, shown_s }) => (holds ? (marked.has(id) && shown_s > NEAR_S ? 1 : 2) : 0);
    const statements = [...recording.data.claims].sort((a, b) => worth(a) - worth(b) || (a.shown_s ?? 0) - (b.shown_s ?? 0)).map((one) => this.statement(one, actions));
    const hold = recording.data.claims.filter((one) => one.holds).length;
    this.element = h("div", { class: "side" },
      h("ul", { class: "people", "aria-label": "Participants" }, ...people),
      statements.length ? h("h4", {}, `${hold} of ${statements.length} statements hold`) : null,
      statements.length ? h("ul", { class: "claims", "aria-label": "Statements" }, ...statements) : null);
  }

  person(one, actions) {
    const swatch = h("i", { style: `background:var(${colourName(one)})`, "aria-hidden": "true" });
    const speed = h("span", { class: "speed" }), doing = h("span", { class: "doing" });
    // what the name says already is not said again
    const is = one.what ?? one.kind, ego = one.role === "ego" && one.id !== "ego" ? "ego" : "";
    const kind = [ego, one.id.startsWith(is) ? "" : is.replaceAll("_", " ")].filter(Boolean).join(" · ");
    const button = h("button", { type: "button", "aria-pressed": "false", onclick: () => actions.select(one.id) },
      swatch, h("span", { class: "who" }, h("b", {}, one.id), " ", h("span", { class: "kind" }, kind)), speed, doing);
    this.rows.set(one.id, { button, speed, doing, still: Boolean(one.category || one.parked) });
    return h("li", {}, button);
  }

  statement(claim, actions) {
    const button = h("button", { type: "button", class: claim.holds ? "held" : "failed", title: claim.words && `“${claim.words}”`, onclick: () => actions.claim(claim) },
      h("span", { class: "verdict", "aria-hidden": "true" }, claim.holds ? "✓" : "✕"),
      h("span", { class: "said" }, claim.statement, h("span", { class: "visually-hidden" }, claim.holds ? ": holds" : ": does not hold")),
      h("span", { class: "when" }, measured(claim)));
    this.claims.set(claim.id, button);
    if (claim.shown_s) this.timed.push([claim.shown_s, button]);
    return h("li", {}, button);
  }

  /** Mark the statements that are meant; the first is brought into sight within the list. */
  mark(ids) {
    for (const [id, button] of this.claims) button.classList.toggle("meant", ids.includes(id));
    const first = this.claims.get(ids[0]), list = first?.closest("ul");
    if (first) list.scrollTop = first.offsetTop - list.offsetTop - list.clientHeight / 3;
  }

  select(id) {
    for (const [name, { button }] of this.rows) button.setAttribute("aria-pressed", String(name === id));
  }

  show(time) {
    const { recording } = this;
    for (const [when, button] of this.timed) button.classList.toggle("now", Math.abs(time - when) < NEAR_S);
    for (const [id, { speed, doing, still }] of this.rows) {
      if (still) {
        setText(speed, "stands");
        continue;
      }
      const now = recording.pose(id, time).speed, rate = recording.acceleration(id, time);
      setText(speed, `${number(now)} m/s · ${number(now * KMH, 0)} km/h`);
      const pace = recording.reversing(id, time) ? "backwards" : rate < -0.3 ? `▼ ${number(-rate)} m/s²` : rate > 0.3 ? `▲ ${number(rate)} m/s²` : "";
      setText(doing, pace);
    }
  }
}

function measured(claim) {
  const value = claim.measured === null || claim.unit === "1" ? "" : `${number(claim.measured, 2)} ${claim.unit.replace("m/s2", "m/s²")}`;
  const time = !claim.shown_s ? "" : `at ${number(claim.shown_s, 1)} s`;
  return [value, time].filter(Boolean).join(" ");
}

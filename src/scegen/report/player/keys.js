// Keys as in video players, and the sheet that lists them.

import { h } from "./dom.js";

/** What keys do: names shown to people, keys as events name them, what happens. */
export function keyTable(player) {
  const { clock } = player;
  return [
    ["Space, K", [" ", "k", "K"], "play or pause", () => clock.toggle()],
    ["← →", ["ArrowLeft"], "half a second back or on", () => clock.seek(clock.time - 0.5)],
    [null, ["ArrowRight"], null, () => clock.seek(clock.time + 0.5)],
    ["J L", ["j", "J"], "two seconds back or on", () => clock.seek(clock.time - 2)],
    [null, ["l", "L"], null, () => clock.seek(clock.time + 2)],
    [", .", [","], "one step back or on", () => clock.stepBy(-1, player.recording.step)],
    [null, ["."], null, () => clock.stepBy(1, player.recording.step)],
    ["< >", ["<"], "slower or faster", () => player.changeRate(-1)],
    [null, [">"], null, () => player.changeRate(1)],
    ["Home End", ["Home"], "to the start or the end", () => clock.seek(0)],
    [null, ["End"], null, () => clock.seek(clock.duration)],
    ["N P", ["n", "N"], "next or previous moment", () => player.nextMoment(1)],
    [null, ["p", "P"], null, () => player.nextMoment(-1)],
    ["R", ["r", "R"], "repeat the critical seconds", () => clock.setLooping(!clock.looping)],
    ["+ −", ["+", "="], "larger or smaller", () => player.camera({ zoom: 1.25 })],
    [null, ["-", "_"], null, () => player.camera({ zoom: 0.8 })],
    ["0", ["0"], "show what matters", () => player.camera({ home: true })],
    ["C", ["c", "C"], "before and after, side by side", () => player.compare()],
    ["F", ["f", "F"], "fill the screen", () => player.fullscreen()],
    ["?", ["?"], "these keys", () => player.help()],
  ];
}

/** What to do with a pressed key; those that somebody types into a field are left alone. */
export function keyListener(table) {
  const actions = new Map(table.flatMap(([, keys, , act]) => keys.map((key) => [key, act])));
  return (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const target = event.target;
    if (target.closest("select, textarea, dialog, input:not([type=range])")) return;
    if (event.key === " " && target.closest("button, summary, a")) return;
    const act = actions.get(event.key);
    if (!act) return;
    event.preventDefault();
    act();
  };
}

/** The sheet of keys, a dialog. */
export function keySheet(table) {
  const rows = table.filter(([names]) => names).map(([names, , words]) => h("tr", {},
    h("th", { scope: "row" }, ...names.split(/(?:, | )/).map((name) => h("kbd", {}, name))), h("td", {}, words)));
  const dialog = h("dialog", { class: "keys", "aria-label": "Keys" },
    h("h4", {}, "Keys"), h("table", {}, h("tbody", {}, ...rows)),
    h("form", { method: "dialog" }, h("button", { class: "plain" }, "Close")));
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  return dialog;
}

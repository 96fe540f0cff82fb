// The two bars of buttons: how it is looked at, and how it is played.

import { RATES } from "./clock.js";
import { h, iconButton } from "./dom.js";

export const ICONS = {
  play: "M8 5v14l11-7z",
  pause: "M6 5h4v14H6zM14 5h4v14h-4z",
  first: "M6 5h2.5v14H6zM19 5v14l-9-7z",
  last: "M15.5 5H18v14h-2.5zM5 5v14l9-7z",
  back: "M17 5v14l-8-7zM6 9h2v6H6z",
  on: "M7 5v14l8-7zM16 9h2v6h-2z",
  loop: "M7 7h9V4l4 4-4 4V9H9v4H7zM17 17H8v3l-4-4 4-4v3h7v-4h2z",
  plus: "M11 5h2v6h6v2h-6v6h-2v-6H5v-2h6z",
  minus: "M5 11h14v2H5z",
  home: "M12 8.500a3.500 3.500 0 1 0 0 7 3.500 3.500 0 0 0 0-7zM11 2h2v4h-2zM11 18h2v4h-2zM2 11h4v2H2zM18 11h4v2h-4z",
  full: "M5 5h6v2H7v4H5zM13 5h6v6h-2V7h-4zM5 13h2v4h4v2H5zM17 13h2v6h-6v-2h4z",
  help: "M12 3a5 5 0 0 1 5 5c0 3-3.5 3.6-3.5 6h-3c0-3.700 3.500-4 3.500-6a2 2 0 0 0-4 0H7a5 5 0 0 1 5-5zM10.500 16h3v3h-3z",
};
const LAYERS = [
  ["trails", "Trails", "the last three seconds, an outline for each"],
  ["ways", "Ways", "the planned ways"],
  ["areas", "Conflict areas", "ground that two ways share"],
  ["sight", "Sight", "what the ego's driver cannot see"],
  ["names", "Names", "names and speeds"],
];

/** Follow, layers, comparison; the player keeps what it changes later. */
export function viewBar(player) {
  const { recording, shared } = player;
  const pair = recording.pair.length === 2 ? [["pair", recording.pair.join(" and ")]] : [];
  const options = [["", "nobody"], ...pair, ...recording.movers.map((one) => [one.id, one.id])];
  player.followed = h("select", { onchange: () => player.follow(player.followed.value) },
    ...options.map(([value, words]) => h("option", { value }, words)));
  player.layers = LAYERS.map(([name, words, title]) => h("button", {
    type: "button", class: "chip", title, "aria-pressed": String(shared.show[name]),
    onclick: (event) => {
      shared.show[name] = !shared.show[name];
      event.currentTarget.setAttribute("aria-pressed", String(shared.show[name]));
      player.draw();
    },
  }, words));
  player.compareButton = player.earlier ? h("button", {
    type: "button", class: "chip", "aria-pressed": "false", onclick: () => player.compare(),
    title: "the first timing beside the one that was found",
  }, "Before and after") : null;
  return h("div", { class: "bar view", role: "toolbar", "aria-label": "View" },
    h("label", { class: "choice" }, "Follow ", player.followed), ...player.layers, player.compareButton);
}

/** In a corner of the picture: larger, smaller, all that matters, the whole screen. */
export function zoomBar(player) {
  return h("div", { class: "zoom", role: "toolbar", "aria-label": "Zoom" },
    iconButton("Larger (+)", ICONS.plus, () => player.camera({ zoom: 1.25 })),
    iconButton("Smaller (−)", ICONS.minus, () => player.camera({ zoom: 0.8 })),
    iconButton("Show what matters (0)", ICONS.home, () => player.camera({ home: true })),
    iconButton("Fill the screen (F)", ICONS.full, () => player.fullscreen()));
}

/** Play, steps, time, speed, loop. */
export function playBar(player) {
  const { clock, recording } = player;
  player.playButton = iconButton("Play (space)", ICONS.play, () => clock.toggle(), { class: "icon large" });
  player.clockText = h("output", { class: "time", "aria-live": "off" });
  player.rateChoice = h("select", { "aria-label": "Speed of playing", onchange: () => clock.setRate(Number(player.rateChoice.value)) },
    ...RATES.map((rate) => h("option", { value: rate, selected: rate === 1 }, `${rate} ×`)));
  player.loopButton = iconButton("Repeat the critical seconds (R)", ICONS.loop,
    () => clock.setLooping(!clock.looping), { "aria-pressed": "false" });
  return h("div", { class: "bar play", role: "toolbar", "aria-label": "Playing" },
    iconButton("To the start (Home)", ICONS.first, () => clock.seek(0)),
    iconButton("One step back (,)", ICONS.back, () => clock.stepBy(-1, recording.step)),
    player.playButton,
    iconButton("One step on (.)", ICONS.on, () => clock.stepBy(1, recording.step)),
    iconButton("To the end (End)", ICONS.last, () => clock.seek(clock.duration)),
    player.clockText, player.rateChoice, player.loopButton,
    h("span", { class: "space" }), h("span", { class: "now", "aria-live": "off" }),
    iconButton("Keys (?)", ICONS.help, () => player.help()));
}

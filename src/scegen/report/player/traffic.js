// The moving part of the picture, in world coordinates, from the ground up.

import { colourName, drawBody } from "./bodies.js";

const TRAIL_S = 3, GHOST_S = 1;
const EYE_M = 1.08; // as in the scene: what is lower hides nobody

/** Draw everything that moves or changes; `show` says which layers. */
export function drawTraffic(context, recording, time, { paint, pixel, show, selected, reach }) {
  const hidden = new Set(recording.hiddenFrom(recording.ego, time).map(([target]) => target));
  if (show.areas) drawAreas(context, recording, time, paint, pixel, selected);
  if (show.sight) drawShadows(context, recording, time, paint, reach);
  if (show.trails) for (const one of recording.movers) drawTrail(context, recording, one, time, paint, pixel);
  for (const light of recording.data.road.lights) drawLight(context, light, time, paint);
  for (const one of [...recording.objects, ...recording.participants]) {
    drawBody(context, one, {
      pose: recording.pose(one.id, time),
      braking: one.kind ? recording.braking(one.id, time) : false,
      reversing: one.kind ? recording.reversing(one.id, time) : false,
      hidden: show.sight && hidden.has(one.id),
      selected: one.id === selected,
      pixel,
    }, paint);
  }
  if (show.sight) drawSightLines(context, recording, time, paint, pixel, selected);
}

function polygon(context, flat) {
  context.beginPath();
  for (let i = 0; i < flat.length; i += 2) context.lineTo(flat[i], flat[i + 1]);
  context.closePath();
}

/** Common ground: a frame, filled while somebody is on it, strongly while both are. */
function drawAreas(context, recording, time, paint, pixel, selected) {
  const matter = new Set(recording.pair);
  for (const area of recording.data.areas) {
    const chosen = selected ? area.between.includes(selected) : area.between.every((id) => matter.has(id));
    if (!chosen) continue;
    const on = area.occupied_s.filter((span) => span && span[0] <= time && time <= span[1]).length;
    polygon(context, area.points);
    context.fillStyle = context.strokeStyle = paint("--conflict");
    context.globalAlpha = [0.1, 0.25, 0.5][on];
    context.fill();
    context.globalAlpha = 0.9;
    context.lineWidth = 1.5 * pixel;
    context.setLineDash([5 * pixel, 3 * pixel]);
    context.stroke();
    context.setLineDash([]);
    context.globalAlpha = 1;
  }
}

/** What the ego's driver cannot see: the shade behind everything that is high enough. */
function drawShadows(context, recording, time, paint, reach) {
  const eye = recording.middle(recording.ego, time);
  context.fillStyle = paint("--hidden");
  context.globalAlpha = 0.22;
  const named = new Set(recording.data.hidden.map((one) => one.by));
  context.beginPath();
  for (const one of [...recording.participants, ...recording.objects]) {
    if (one.id === recording.ego || (one.height_m <= EYE_M && !named.has(one.id))) continue;
    const corners = recording.corners(one.id, time);
    const far = corners.map(([x, y]) => {
      const d = Math.hypot(x - eye.x, y - eye.y) || 1, on = 1 + reach / d;
      return [eye.x + (x - eye.x) * on, eye.y + (y - eye.y) * on];
    });
    const [a, b] = silhouette(eye, corners);
    context.moveTo(...corners[a]);
    for (const corner of [far[a], far[b], corners[b]]) context.lineTo(...corner);
    context.closePath();
  }
  context.fill("nonzero");
  context.globalAlpha = 1;
}

/** The two corners between which a body is seen. */
function silhouette(eye, corners) {
  const middle = corners.reduce(([sx, sy], [x, y]) => [sx + x / 4, sy + y / 4], [0, 0]);
  const base = Math.atan2(middle[1] - eye.y, middle[0] - eye.x);
  const off = corners.map(([x, y]) => {
    const angle = Math.atan2(y - eye.y, x - eye.x) - base;
    return Math.atan2(Math.sin(angle), Math.cos(angle));
  });
  return [off.indexOf(Math.min(...off)), off.indexOf(Math.max(...off))];
}

function drawSightLines(context, recording, time, paint, pixel, selected) {
  const eye = recording.middle(recording.ego, time);
  const hidden = new Map(recording.hiddenFrom(recording.ego, time));
  const watched = new Set([...recording.pair, selected, ...hidden.keys()]);
  for (const one of recording.movers) {
    if (one.id === recording.ego || !watched.has(one.id)) continue;
    const to = recording.middle(one.id, time);
    context.beginPath();
    context.moveTo(eye.x, eye.y);
    context.lineTo(to.x, to.y);
    context.lineWidth = 1.5 * pixel;
    context.strokeStyle = paint(hidden.has(one.id) ? "--hidden" : "--accent");
    context.globalAlpha = hidden.has(one.id) ? 0.9 : 0.6;
    context.setLineDash(hidden.has(one.id) ? [2 * pixel, 5 * pixel] : []);
    context.stroke();
    context.setLineDash([]);
    context.globalAlpha = 1;
  }
}

/** A planned way: it lies still, as the road does. */
export function drawWay(context, one, paint, pixel) {
  if (!one.way.length) return;
  context.beginPath();
  for (let i = 0; i < one.way.length; i += 2) context.lineTo(one.way[i], one.way[i + 1]);
  context.strokeStyle = paint(colourName(one));
  context.globalAlpha = 0.55;
  context.lineWidth = 1.3 * pixel;
  context.setLineDash([6 * pixel, 6 * pixel]);
  context.stroke();
  context.setLineDash([]);
  context.globalAlpha = 1;
}

/** The last seconds: a line that fades, and an outline every second. */
function drawTrail(context, recording, one, time, paint, pixel) {
  const steps = 20, from = Math.max(0, time - TRAIL_S);
  if (recording.still(one.id)) return;
  context.strokeStyle = paint(colourName(one));
  context.lineWidth = 3 * pixel;
  let last = recording.pose(one.id, from);
  for (let i = 1; i <= steps; i += 1) {
    const next = recording.pose(one.id, from + ((time - from) * i) / steps);
    context.globalAlpha = (0.7 * i) / steps;
    context.beginPath();
    context.moveTo(last.x, last.y);
    context.lineTo(next.x, next.y);
    context.stroke();
    last = next;
  }
  context.globalAlpha = 1;
  for (let back = GHOST_S; back <= TRAIL_S && time - back >= 0; back += GHOST_S) {
    const pose = recording.pose(one.id, time - back), now = recording.pose(one.id, time);
    if (Math.hypot(pose.x - now.x, pose.y - now.y) < 0.5) continue;
    drawBody(context, one, { pose, pixel, ghost: 0.75 - back * 0.17 }, paint);
  }
}

/** Three lamps beside the stop line, the burning one bright. */
function drawLight(context, light, time, paint) {
  const state = light.states.filter(([since]) => since <= time + 1e-9).at(-1)?.[1] ?? "off";
  context.save();
  context.translate(light.x_m, light.y_m);
  context.rotate(light.heading_rad);
  const lamps = light.afoot ? ["red", "green"] : ["red", "amber", "green"];
  const long = 1.2 * lamps.length;
  if (light.afoot) context.scale(0.7, 0.7);
  context.fillStyle = "#20262d";
  context.beginPath();
  context.roundRect(-0.7, -0.8, long + 0.4, 1.6, 0.5);
  context.fill();
  lamps.forEach((name, i) => {
    context.beginPath();
    context.arc(long - 1.1 - i * 1.2, 0, 0.5, 0, 2 * Math.PI);
    context.fillStyle = paint(name === state ? `--signal-${name}` : "--signal-off");
    context.fill();
  });
  context.restore();
}

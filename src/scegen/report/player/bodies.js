// Bodies from above, to scale: vehicles with glass and lights, people, things.

const TWO_WHEELS = new Set(["bicycle", "motorcycle"]);
const PLANTS = new Set(["tree", "vegetation"]);

/** The custom property that holds the colour of a participant or a thing. */
export function colourName(one) {
  if (one.category) return PLANTS.has(one.category) ? "--plant" : "--thing";
  return one.role === "ego" ? "--ego" : `--participant-${((one.colour - 1) % 10) + 1}`;
}

function box(context, x, y, length, width, radius) {
  context.beginPath();
  context.roundRect(x, y, length, width, radius);
}

/**
 * Draw a body in world coordinates.
 *
 * state: { pose, braking, reversing, hidden, ghost, selected, pixel } where `pixel` is the size of
 * a pixel in metres.
 */
export function drawBody(context, one, state, paint) {
  const { pose, pixel } = state;
  context.save();
  context.translate(pose.x, pose.y);
  context.rotate(pose.heading);
  context.translate(one.ahead_m ?? 0, 0);
  const l = one.length_m, w = one.width_m, colour = paint(colourName(one));
  context.lineJoin = "round";
  if (state.ghost) {
    context.globalAlpha = state.ghost;
    context.strokeStyle = colour;
    context.lineWidth = 1.2 * pixel;
    box(context, -l / 2, -w / 2, l, w, Math.min(w * 0.25, 0.6));
    context.stroke();
    context.restore();
    return;
  }
  const edge = one.role === "ego" ? 2 * pixel : pixel;
  context.strokeStyle = paint("--outline");
  context.lineWidth = edge;
  if (state.hidden) context.globalAlpha = 0.55;
  if (one.kind === "pedestrian") person(context, one, colour, pixel, state);
  else if (TWO_WHEELS.has(one.kind)) twoWheels(context, one, colour, paint);
  else if (one.category) thing(context, one, colour, paint);
  else vehicle(context, one, colour, paint, state);
  if (state.hidden) hatch(context, l, w, paint, pixel);
  if (state.selected) {
    context.globalAlpha = 1;
    context.strokeStyle = paint("--accent");
    context.lineWidth = 2.5 * pixel;
    const room = 5 * pixel;
    box(context, -l / 2 - room, -w / 2 - room, l + 2 * room, w + 2 * room, room);
    context.stroke();
  }
  context.restore();
}

function vehicle(context, one, colour, paint, state) {
  const l = one.length_m, w = one.width_m, front = l / 2;
  box(context, -front, -w / 2, l, w, [0.35, 0.7, 0.7, 0.35].map((r) => Math.min(r, w / 3)));
  context.fillStyle = colour;
  context.fill();
  context.stroke();
  context.fillStyle = paint("--glass");
  const glass = context.globalAlpha;
  context.globalAlpha = glass * 0.85;
  const large = one.kind === "truck" || one.kind === "bus" || one.kind === "van" || one.kind === "emergency_vehicle";
  const cab = large ? 0.9 : l * 0.3, deep = large ? 0.7 : l * 0.13;
  context.beginPath();
  context.moveTo(front - cab + deep, -w * 0.36);
  context.lineTo(front - cab + deep, w * 0.36);
  context.lineTo(front - cab, w * 0.3);
  context.lineTo(front - cab, -w * 0.3);
  context.fill();
  if (!large) {
    context.globalAlpha = glass * 0.5;
    context.beginPath();
    context.moveTo(-front + l * 0.1, -w * 0.32);
    context.lineTo(-front + l * 0.1, w * 0.32);
    context.lineTo(-front + l * 0.19, w * 0.3);
    context.lineTo(-front + l * 0.19, -w * 0.3);
    context.fill();
  }
  context.globalAlpha = glass;
  if (one.kind === "truck") {
    context.beginPath();
    context.moveTo(front - 2.1, -w / 2);
    context.lineTo(front - 2.1, w / 2);
    context.stroke();
  }
  if (one.kind === "emergency_vehicle") {
    context.fillStyle = "#1f6feb";
    context.fillRect(front - 2.2, -w * 0.35, 0.4, w * 0.7);
  }
  context.fillStyle = "#fff3c4";
  for (const side of [-1, 1]) context.fillRect(front - 0.28, side * w * 0.36 - w * 0.09, 0.28, w * 0.18);
  context.fillStyle = paint("--brake-light");
  if (state.braking) {
    // A glow by blurring costs more than all the rest of the picture.
    for (const [glow, opacity] of [[0.3, 0.3], [0, 1]]) {
      context.globalAlpha = glass * opacity;
      for (const side of [-1, 1]) {
        context.fillRect(-front - 0.12 - glow, side * w * 0.33 - w * 0.16 - glow, 0.5 + 2 * glow, w * 0.32 + 2 * glow);
      }
    }
    context.globalAlpha = glass;
  } else {
    context.globalAlpha = glass * 0.45;
    for (const side of [-1, 1]) context.fillRect(-front, side * w * 0.37 - w * 0.08, 0.16, w * 0.16);
    context.globalAlpha = glass;
  }
  if (state.reversing) {
    context.fillStyle = "#ffffff";
    for (const side of [-1, 1]) context.fillRect(-front - 0.12, side * w * 0.16 - w * 0.06, 0.45, w * 0.12);
  }
}

function twoWheels(context, one, colour, paint) {
  const l = one.length_m, w = one.width_m;
  box(context, -l / 2, -0.12, l, 0.24, 0.12);
  context.fillStyle = paint("--outline");
  context.fill();
  context.beginPath();
  context.ellipse(-0.05, 0, l * 0.26, w / 2, 0, 0, 2 * Math.PI);
  context.fillStyle = colour;
  context.fill();
  context.stroke();
  context.beginPath();
  context.arc(0, 0, 0.16, 0, 2 * Math.PI);
  context.fillStyle = paint("--glass");
  context.fill();
}

/** A person is never drawn smaller than can be seen; the ring around says how large they are. */
function person(context, one, colour, pixel, state) {
  const r = Math.max(one.width_m / 2, 4.5 * pixel);
  context.beginPath();
  context.ellipse(0, 0, r * 0.75, r * 1.25, 0, 0, 2 * Math.PI);
  context.fillStyle = colour;
  context.fill();
  context.stroke();
  context.beginPath();
  context.arc(r * 0.15, 0, r * 0.55, 0, 2 * Math.PI);
  context.fillStyle = "#ffffff";
  context.fill();
  if (state.pose.speed > 0.1) {
    context.beginPath();
    context.moveTo(r * 2.2, 0);
    context.lineTo(r * 1.4, r * 0.6);
    context.lineTo(r * 1.4, -r * 0.6);
    context.fillStyle = colour;
    context.fill();
  }
}

function thing(context, one, colour, paint) {
  const l = one.length_m, w = one.width_m;
  box(context, -l / 2, -w / 2, l, w, Math.min(l, w) * 0.12);
  context.fillStyle = colour;
  context.fill();
  context.stroke();
  context.clip();
  context.beginPath();
  for (let u = -l / 2 - w; u < l / 2; u += Math.max(0.5, (l + w) / 12)) {
    context.moveTo(u, -w / 2);
    context.lineTo(u + w, w / 2);
  }
  context.strokeStyle = paint("--outline");
  context.globalAlpha *= 0.5;
  context.stroke();
}

function hatch(context, l, w, paint, pixel) {
  context.beginPath();
  box(context, -l / 2, -w / 2, l, w, 0.2);
  context.setLineDash([4 * pixel, 3 * pixel]);
  context.strokeStyle = paint("--hidden");
  context.lineWidth = 2 * pixel;
  context.stroke();
  context.setLineDash([]);
}

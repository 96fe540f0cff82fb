// The still part of the picture: surfaces, marks, crosswalks, signs.

const FILL = { sidewalk: "--sidewalk", border: "--shoulder", shoulder: "--parking", median: "--shoulder", parking: "--parking", driving: "--road" };

function path(points, closed) {
  const made = new Path2D();
  for (let i = 0; i < points.length; i += 2) {
    if (i) made.lineTo(points[i], points[i + 1]);
    else made.moveTo(points[0], points[1]);
  }
  if (closed) made.closePath();
  return made;
}

/** Shapes of a road, made once, drawn in world coordinates. */
export class Ground {
  constructor(road) {
    this.surfaces = road.surfaces.map((one) => [FILL[one.type], path(one.points, true)]);
    this.stripes = road.stripes.map((points) => path(points, true));
    this.marks = road.marks.map((one) => [one.kind, path(one.points, false)]);
    this.signs = road.signs;
    this.points = road.surfaces.map((one) => one.points);
  }

  draw(context, paint) {
    // The outline of each colour closes the hairlines between neighbours of the same kind.
    context.lineJoin = "round";
    for (const name of new Set(this.surfaces.map(([fill]) => fill))) {
      if (name === "--road") this.drawKerb(context, paint);
      context.fillStyle = context.strokeStyle = paint(name);
      context.lineWidth = 0.12;
      for (const [fill, shape] of this.surfaces) {
        if (fill !== name) continue;
        context.fill(shape);
        context.stroke(shape);
      }
    }
    context.fillStyle = context.strokeStyle = paint("--mark");
    for (const shape of this.stripes) context.fill(shape);
    for (const [kind, shape] of this.marks) {
      context.lineWidth = kind === "stop_line" ? 0.5 : kind === "yield_line" ? 0.45 : 0.15;
      context.setLineDash(kind === "lane" ? [3, 4.5] : kind === "yield_line" ? [0.5, 0.3] : []);
      context.stroke(shape);
    }
    context.setLineDash([]);
    for (const sign of this.signs) drawSign(context, sign, paint);
  }

  /** The rim of all carriageways together: what lies between them is covered by them afterwards. */
  drawKerb(context, paint) {
    context.strokeStyle = paint("--kerb");
    context.lineWidth = 0.4;
    for (const [fill, shape] of this.surfaces) if (fill === "--road") context.stroke(shape);
  }
}

/** A sign as seen from above, turned so that its foot points to who must obey it. */
function drawSign(context, sign, paint) {
  context.save();
  context.translate(sign.x_m, sign.y_m);
  context.rotate(sign.heading_rad - Math.PI / 2);
  context.lineWidth = 0.22;
  context.beginPath();
  const corners = sign.kind === "stop" ? 8 : 3;
  const turn = sign.kind === "stop" ? Math.PI / 8 : -Math.PI / 2;
  for (let i = 0; i < corners; i += 1) {
    const angle = turn + (2 * Math.PI * i) / corners;
    context.lineTo(0.85 * Math.cos(angle), 0.85 * Math.sin(angle));
  }
  context.closePath();
  context.fillStyle = sign.kind === "stop" ? paint("--signal-red") : "#ffffff";
  context.strokeStyle = sign.kind === "stop" ? "#ffffff" : paint("--signal-red");
  context.fill();
  context.stroke();
  context.restore();
}

// Names beside bodies that do not cover one another, in pixels.

const LABEL_GAP = 8, LABEL_HIGH = 15;

/**
 * Places for names: each takes the first free spot around its body, the one it had before first.
 *
 * wanted: [{ id, text, x, y, reach, width }] by importance; taken: rectangles [x0, y0, x1, y1]; the
 * last are width and height of the picture.
 */
export function placeLabels(wanted, before, taken, [wide, high]) {
  const rectangles = [...taken];
  const placed = new Map();
  for (const one of wanted) {
    const free = spots(one).map((spot, index) => ({ ...spot, index }))
      .sort((a, b) => (b.index === before.get(one.id)) - (a.index === before.get(one.id)))
      .filter(({ box: [x0, y0, x1, y1] }) => x0 >= 0 && y0 >= 0 && x1 <= wide && y1 <= high)
      .find((spot) => !rectangles.some((other) => overlap(other, spot.box)));
    if (!free) continue;
    rectangles.push(free.box);
    placed.set(one.id, { ...free, text: one.text, anchor: [one.x, one.y] });
  }
  return placed;
}

function spots({ x, y, reach, width }) {
  const found = [];
  for (const extra of [0, 16, 34]) {
    const r = reach + LABEL_GAP + extra;
    for (const [u, v] of [[0.7, -0.7], [0.7, 0.7], [-0.7, -0.7], [-0.7, 0.7], [1, 0], [-1, 0], [0, -1], [0, 1]]) {
      const cx = x + u * r, cy = y + v * r;
      const left = u > 0.1 ? cx : u < -0.1 ? cx - width : cx - width / 2;
      const top = v > 0.1 ? cy : v < -0.1 ? cy - LABEL_HIGH : cy - LABEL_HIGH / 2;
      found.push({ box: [left - 2, top - 1, left + width + 2, top + LABEL_HIGH + 1], left, top, far: extra > 0 });
    }
  }
  return found;
}

function overlap([a0, b0, a1, b1], [c0, d0, c1, d1]) {
  return a0 < c1 && c0 < a1 && b0 < d1 && d0 < b1;
}

// From the world (m, y north) to the picture (CSS pixels, y down), turned, moved and enlarged.

const CLOSEST = 80, FARTHEST = 0.4; // pixels per metre

export class Camera {
  constructor() {
    this.x = 0;
    this.y = 0;
    this.scale = 6;
    this.angle = 0;
    this.width = 1;
    this.height = 1;
  }

  /** The matrix of a canvas whose pixels are `ratio` times finer. */
  matrix(ratio) {
    const k = this.scale * ratio, c = Math.cos(this.angle) * k, s = Math.sin(this.angle) * k;
    return [
      c, -s, -s, -c,
      (this.width / 2) * ratio - c * this.x + s * this.y,
      (this.height / 2) * ratio + s * this.x + c * this.y,
    ];
  }

  toScreen(x, y) {
    const [a, b, c, d, e, f] = this.matrix(1);
    return [a * x + c * y + e, b * x + d * y + f];
  }

  toWorld(u, v) {
    const c = Math.cos(this.angle), s = Math.sin(this.angle);
    const du = (u - this.width / 2) / this.scale, dv = (this.height / 2 - v) / this.scale;
    return [this.x + du * c + dv * s, this.y - du * s + dv * c];
  }

  /** Enlarge by a factor about a point of the picture. */
  zoom(factor, u = this.width / 2, v = this.height / 2) {
    const [x, y] = this.toWorld(u, v);
    this.scale = Math.min(Math.max(this.scale * factor, FARTHEST), CLOSEST);
    const [x2, y2] = this.toWorld(u, v);
    this.x += x - x2;
    this.y += y - y2;
  }

  pan(du, dv) {
    const [x0, y0] = this.toWorld(0, 0), [x1, y1] = this.toWorld(du, dv);
    this.x -= x1 - x0;
    this.y -= y1 - y0;
  }

  /** Half of width and height, and middle, of points in the turned world. */
  static extent(points, angle) {
    const c = Math.cos(angle), s = Math.sin(angle);
    let [u0, u1, v0, v1] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const [x, y] of points) {
      const u = c * x - s * y, v = s * x + c * y;
      u0 = Math.min(u0, u); u1 = Math.max(u1, u);
      v0 = Math.min(v0, v); v1 = Math.max(v1, v);
    }
    const u = (u0 + u1) / 2, v = (v0 + v1) / 2;
    return { x: c * u + s * v, y: -s * u + c * v, halfWidth: (u1 - u0) / 2, halfHeight: (v1 - v0) / 2 };
  }

  /** Show these points whole, with some metres around them. */
  fit(points, margin = 8) {
    const found = Camera.extent(points, this.angle);
    this.x = found.x;
    this.y = found.y;
    this.scale = Math.min(
      this.width / (2 * (found.halfWidth + margin)),
      this.height / (2 * (found.halfHeight + margin)),
      28,
    );
  }
}

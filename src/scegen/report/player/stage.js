// One picture of one recording: two canvases, the road below, the traffic above.

import { Camera } from "./camera.js";
import { colourName } from "./bodies.js";
import { h, number } from "./dom.js";
import { Ground } from "./ground.js";
import { placeLabels } from "./labels.js";
import { drawTraffic, drawWay } from "./traffic.js";

const WIDEST_M = 70, NEAR_M = 34, NARROW = 0.85;
const ROUND_M = [1, 2, 5, 10, 20, 50, 100, 200, 500];

export class Stage {
  constructor(recording, shared, caption) {
    this.recording = recording;
    this.shared = shared; // { show, selected, follow, paint, onCamera, onSelect }
    this.camera = new Camera();
    this.ground = new Ground(recording.data.road);
    this.below = h("canvas", { "aria-hidden": "true" });
    this.above = h("canvas", {
      role: "img",
      tabindex: "0",
      "aria-label": `Roads and traffic from above${caption ? `, ${caption}` : ""}. Drag to move, wheel or plus and minus to zoom.`,
    });
    this.hint = h("p", { class: "hint", "aria-hidden": "true", "data-words": "Click the picture, or hold Ctrl, to zoom with the wheel" });
    this.element = h("div", { class: "stage" }, this.below, this.above, this.hint, caption ? h("p", { class: "caption" }, caption) : null);
    this.spots = new Map();
    this.placed = new Map();
    this.time = 0;
    this.drawn = "";
    this.listen();
  }

  /** Where things happen: those who matter in the critical seconds, in as many as fit a picture. */
  interesting() {
    const { recording } = this, ids = recording.pair.length ? recording.pair : [recording.ego];
    const around = recording.data.moment_s ?? recording.duration / 2;
    let [before, after] = [around - recording.data.critical_s[0], recording.data.critical_s[1] - around];
    for (;;) {
      const points = [];
      for (const id of ids) {
        for (let k = 0; k <= 12; k += 1) points.push(...recording.corners(id, around - before + ((before + after) * k) / 12));
      }
      const { halfWidth, halfHeight } = Camera.extent(points, 0);
      if (2 * Math.max(halfWidth, halfHeight) < WIDEST_M || before + after < 1) return points;
      [before, after] = [before * NARROW, after * NARROW];
    }
  }

  /** The turn in which the picture is used best: north is up unless that wastes it. */
  bestAngle(points) {
    if (this.recording.data.road.kind === "straight") {
      return -this.recording.pose(this.recording.ego, 0).heading;
    }
    const room = (angle) => {
      const { halfWidth, halfHeight } = Camera.extent(points, angle);
      return Math.min(this.camera.width / (halfWidth + 8), this.camera.height / (halfHeight + 8));
    };
    return room(Math.PI / 2) > 1.6 * room(0) ? Math.PI / 2 : 0;
  }

  /** Show what matters; says whether it has to be followed to stay in sight. */
  home() {
    const points = this.interesting();
    this.camera.angle = this.bestAngle(points);
    this.camera.fit(points);
    // Not the middle of all ways counts, but where they meet.
    const around = this.recording.data.moment_s, met = this.recording.pair.map((id) => this.recording.middle(id, around));
    if (around !== null && met.length) {
      for (const axis of ["x", "y"]) {
        const place = met.reduce((sum, one) => sum + one[axis] / met.length, 0);
        this.camera[axis] += (place - this.camera[axis]) / 2;
      }
    }
    this.drawn = "";
    return this.recording.data.road.kind === "straight";
  }

  /** Show what another picture shows. */
  like({ camera }) {
    const { x, y, scale, angle } = camera;
    Object.assign(this.camera, { x, y, scale, angle });
  }

  /** How high the picture should be for its width. */
  aspect() {
    if (this.recording.data.road.kind === "straight") return 0.3;
    return 0.5;
  }

  resize(width, height) {
    const ratio = Math.min(window.devicePixelRatio || 1, 3);
    this.ratio = ratio;
    this.camera.width = width;
    this.camera.height = height;
    for (const canvas of [this.below, this.above]) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
      canvas.style.width = `${width}px`;
      canvas.style.height = `${height}px`;
    }
    this.drawn = "";
  }

  /** Keep to the road where it is longer than the picture, and to its middle where it is slimmer. */
  keepToRoad() {
    const { camera } = this, { road } = this.recording.data;
    if (road.kind !== "straight") return;
    this.outline ??= road.surfaces.flatMap(({ points }) => points.flatMap((x, i) => (i % 2 ? [] : [[x, points[i + 1]]])));
    const found = Camera.extent(this.outline, camera.angle);
    const c = Math.cos(camera.angle), s = Math.sin(camera.angle);
    const du = camera.x - found.x, dv = camera.y - found.y;
    const roomU = Math.max(0, found.halfWidth - camera.width / 2 / camera.scale);
    const roomV = Math.max(0, found.halfHeight - camera.height / 2 / camera.scale);
    const u = Math.min(Math.max(c * du - s * dv, -roomU), roomU);
    const v = Math.min(Math.max(s * du + c * dv, -roomV), roomV);
    camera.x = found.x + c * u + s * v;
    camera.y = found.y - s * u + c * v;
  }

  /** Keep whoever is followed in the middle; both of a pair in sight. */
  track(time) {
    const { follow } = this.shared, { camera, recording } = this;
    if (!follow) return;
    const ids = follow === "pair" ? recording.pair : [follow];
    const places = ids.filter((id) => recording.byId.has(id)).map((id) => recording.middle(id, time));
    if (!places.length) return;
    const spread = Camera.extent(places.map(({ x, y }) => [x, y]), camera.angle);
    camera.x = spread.x;
    camera.y = spread.y;
    if (follow === "pair") {
      const needed = Math.min(
        camera.width / (2 * spread.halfWidth + NEAR_M),
        camera.height / (2 * spread.halfHeight + NEAR_M / 3),
      );
      camera.scale = Math.min(needed, 16) * this.shared.closer;
    }
    this.keepToRoad();
  }

  draw(time) {
    this.time = time;
    this.track(time);
    const { camera, shared, ratio } = this, matrix = camera.matrix(ratio);
    const key = `${matrix.map((v) => v.toFixed(3))} ${this.below.width} ${shared.paintKey()} ${shared.show.ways}`;
    if (key !== this.drawn) {
      this.drawn = key;
      const context = this.below.getContext("2d", { alpha: false });
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.fillStyle = shared.paint("--ground");
      context.fillRect(0, 0, this.below.width, this.below.height);
      context.setTransform(...matrix);
      this.ground.draw(context, shared.paint);
      if (shared.show.ways) {
        for (const one of this.recording.movers) drawWay(context, one, shared.paint, 1 / camera.scale);
      }
    }
    const context = this.above.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.above.width, this.above.height);
    context.setTransform(...matrix);
    const pixel = 1 / camera.scale;
    const reach = Math.hypot(camera.width, camera.height) / camera.scale;
    drawTraffic(context, this.recording, time, { ...shared, pixel, reach });
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    if (shared.show.names) this.drawNames(context, time);
    this.drawScale(context);
  }

  drawNames(context, time) {
    const { camera, recording, shared } = this;
    context.font = "600 12px system-ui, sans-serif";
    const matter = new Set([recording.ego, ...recording.pair, shared.selected]);
    const everybody = [...recording.participants, ...recording.objects];
    // The scale, the caption and the buttons for zooming lie on the picture, too.
    const taken = [[0, camera.height - 34, 120, camera.height], [0, 0, 130, 34], [camera.width - 48, 0, camera.width, 146]];
    const wanted = [];
    for (const one of everybody) {
      const middle = recording.middle(one.id, time);
      const [x, y] = camera.toScreen(middle.x, middle.y);
      if (x < 0 || y < 0 || x > camera.width || y > camera.height) continue;
      const corners = recording.corners(one.id, time).map(([u, v]) => camera.toScreen(u, v));
      const xs = corners.map((c) => c[0]), ys = corners.map((c) => c[1]);
      taken.push([Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)]);
      const reach = Math.min(one.length_m, 5) * 0.36 * camera.scale;
      const text = one.category || one.parked ? one.id : `${one.id}  ${number(middle.speed * 3.6, 0)} km/h`;
      wanted.push({ id: one.id, text, x, y, reach, width: context.measureText(text).width, first: matter.has(one.id) });
    }
    wanted.sort((a, b) => b.first - a.first);
    const placed = placeLabels(wanted, this.spots, taken, [camera.width, camera.height]);
    this.spots = new Map([...placed].map(([id, { index }]) => [id, index]));
    this.placed = placed;
    context.textBaseline = "top";
    context.lineJoin = "round";
    for (const [id, { left, top, text, anchor, far }] of placed) {
      const one = recording.byId.get(id);
      if (far) {
        context.strokeStyle = shared.paint(colourName(one));
        context.lineWidth = 1;
        context.beginPath();
        context.moveTo(...anchor);
        context.lineTo(Math.min(Math.max(anchor[0], left), left + context.measureText(text).width), anchor[1] > top ? top + 15 : top);
        context.stroke();
      }
      context.strokeStyle = shared.paint("--halo");
      context.lineWidth = 3.5;
      context.strokeText(text, left, top + 1);
      context.fillStyle = shared.paint("--text");
      context.fillText(text, left, top + 1);
    }
  }

  drawScale(context) {
    const { camera, shared } = this;
    const length = ROUND_M.find((m) => m * camera.scale > 46) ?? 1000;
    const x = 14, y = camera.height - 12, end = x + length * camera.scale;
    context.font = "600 11px system-ui, sans-serif";
    context.textBaseline = "bottom";
    for (const [colour, width] of [["--halo", 5], ["--text", 2]]) {
      context.strokeStyle = shared.paint(colour);
      context.lineWidth = width;
      context.beginPath();
      context.moveTo(x, y - 5);
      context.lineTo(x, y);
      context.lineTo(end, y);
      context.lineTo(end, y - 5);
      context.stroke();
    }
    context.strokeStyle = shared.paint("--halo");
    context.lineWidth = 3;
    context.strokeText(`${length} m`, x + 5, y - 5);
    context.fillStyle = shared.paint("--text");
    context.fillText(`${length} m`, x + 5, y - 5);
  }

  /** Whose body lies under a point of the picture. */
  hit(u, v) {
    const [x, y] = this.camera.toWorld(u, v), room = 8 / this.camera.scale;
    const found = [...this.recording.participants, ...this.recording.objects].reverse().find((one) => {
      const m = this.recording.middle(one.id, this.time), c = Math.cos(m.heading), s = Math.sin(m.heading);
      const along = (x - m.x) * c + (y - m.y) * s, across = (y - m.y) * c - (x - m.x) * s;
      return Math.abs(along) < one.length_m / 2 + room && Math.abs(across) < one.width_m / 2 + room;
    });
    return found?.id ?? null;
  }

  listen() {
    const pointers = new Map();
    let moved = 0;
    const place = (event) => {
      const box = this.above.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    this.above.addEventListener("pointerdown", (event) => {
      this.above.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, place(event));
      moved = 0;
    });
    this.above.addEventListener("pointermove", (event) => {
      const before = pointers.get(event.pointerId), now = place(event);
      if (!before) return;
      moved += Math.hypot(now[0] - before[0], now[1] - before[1]);
      const others = [...pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
      if (others.length) {
        const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
        const factor = apart(now, others[0]) / Math.max(apart(before, others[0]), 1);
        this.shared.onCamera({ zoom: factor, at: others[0] }, this);
      } else if (moved > 4) {
        this.shared.onCamera({ pan: [now[0] - before[0], now[1] - before[1]] }, this);
      }
      pointers.set(event.pointerId, now);
    });
    const release = (event) => {
      if (event.type === "pointerup" && moved <= 4 && pointers.size === 1) this.shared.onSelect(this.hit(...place(event)));
      pointers.delete(event.pointerId);
    };
    this.above.addEventListener("pointerup", release);
    this.above.addEventListener("pointercancel", release);
    this.above.addEventListener("dblclick", () => this.shared.onCamera({ home: true }, this));
    this.above.addEventListener("wheel", (event) => {
      // The page goes on scrolling unless the picture is meant: it has the focus, or Ctrl is held.
      if (!event.ctrlKey && document.activeElement !== this.above) {
        this.hint.classList.add("shown");
        clearTimeout(this.hinted);
        this.hinted = setTimeout(() => this.hint.classList.remove("shown"), 1200);
        return;
      }
      event.preventDefault();
      this.shared.onCamera({ zoom: Math.exp(-event.deltaY * 0.0016), at: place(event) }, this);
    }, { passive: false });
  }
}

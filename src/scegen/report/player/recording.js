// A scene ready to be asked: who is where at a time, how fast, how far apart.

/** Wraps the data that `player_scene` writes. */
export class Recording {
  constructor(data) {
    this.data = data;
    this.duration = data.duration_s;
    this.step = data.step_s;
    this.ego = data.ego;
    this.pair = data.pair;
    this.participants = data.participants;
    this.objects = data.objects;
    this.byId = new Map([...data.participants, ...data.objects].map((one) => [one.id, one]));
    this.movers = data.participants.filter((one) => !one.parked);
  }

  /** A value of a series at a time: straight between samples, the last one to the end. */
  at(series, time) {
    const place = Math.min(Math.max(time, 0), this.duration) / this.step;
    const low = Math.min(Math.floor(place + 1e-9), series.length - 1);
    const a = series[low], b = series[Math.min(low + 1, series.length - 1)];
    if (a === null || b === null) return place - low < 0.5 ? a : b;
    return a + (b - a) * Math.min(Math.max(place - low, 0), 1);
  }

  /** The pose of a reference point in the world (m, rad) and the speed (m/s); null: not there. */
  pose(id, time) {
    const one = this.byId.get(id);
    if (!one) return null;
    if (typeof one.x_m === "number") return { x: one.x_m, y: one.y_m, heading: one.heading_rad, speed: 0 };
    return {
      x: this.at(one.x_m, time),
      y: this.at(one.y_m, time),
      heading: this.at(one.heading_rad, time),
      speed: this.at(one.speed_mps, time),
    };
  }

  /** The middle of a body in the world. */
  middle(id, time) {
    const pose = this.pose(id, time), ahead = this.byId.get(id).ahead_m ?? 0;
    return { ...pose, x: pose.x + ahead * Math.cos(pose.heading), y: pose.y + ahead * Math.sin(pose.heading) };
  }

  /** The corners of a body: front left, front right, rear right, rear left. */
  corners(id, time) {
    const one = this.byId.get(id), m = this.middle(id, time);
    const c = Math.cos(m.heading), s = Math.sin(m.heading);
    const l = one.length_m / 2, w = one.width_m / 2;
    return [[l, w], [l, -w], [-l, -w], [-l, w]].map(([u, v]) => [m.x + u * c - v * s, m.y + u * s + v * c]);
  }

  /** Change of speed (m/s²) over two samples. */
  acceleration(id, time) {
    const one = this.byId.get(id);
    if (!one || typeof one.x_m === "number") return 0;
    const low = Math.max(time - this.step, 0), high = Math.min(time + this.step, this.duration);
    if (high <= low) return 0;
    return (this.at(one.speed_mps, high) - this.at(one.speed_mps, low)) / (high - low);
  }

  /** Whether somebody drives backwards. */
  reversing(id, time) {
    return (this.byId.get(id).backwards_s ?? []).some(([from, to]) => from <= time && time <= to);
  }

  /** Whether brake lights are on: while slowing down, and while standing after that. */
  braking(id, time) {
    const one = this.byId.get(id);
    if (one.parked || one.kind === "pedestrian" || one.kind === "bicycle") return false;
    return this.acceleration(id, time) < -0.3 || (this.pose(id, time).speed < 0.05 && time > 0);
  }

  /** The series measured between two. */
  between(a, b) {
    return this.data.pairs.find(({ between: [x, y] }) => (x === a && y === b) || (x === b && y === a)) ?? null;
  }

  /** Who is hidden from an observer at a time, and by whom: [target, by] pairs. */
  hiddenFrom(observer, time) {
    return this.data.hidden
      .filter((one) => one.observer === observer && one.spans_s.some(([from, to]) => from <= time && time < to))
      .map((one) => [one.target, one.by]);
  }

  /** Whether somebody stands all the time. */
  still(id) {
    const one = this.byId.get(id);
    return typeof one.x_m === "number" || (one.x_m.length === 1 && one.y_m.length === 1);
  }
}

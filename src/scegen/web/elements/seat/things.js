// Bodies and roads in three dimensions: plain shapes, in the colours of the theme.
import { THREE } from "nicegui-scene";

const material = (color) => new THREE.MeshLambertMaterial({ color });
const box = (l, w, h, color) => new THREE.Mesh(new THREE.BoxGeometry(l, w, h), material(color));

/** Something that lies on the ground: painted over what lies in lower layers, under everything that stands. */
export function flat(geometry, color, layer) {
  const paint = new THREE.MeshLambertMaterial({ color, side: THREE.DoubleSide, depthTest: false, depthWrite: false });
  const mesh = new THREE.Mesh(geometry, paint);
  mesh.renderOrder = layer - 100;
  return mesh;
}

/** A flat polygon: x and y in turn. */
export function patch(corners, color, layer) {
  const points = [];
  for (let i = 0; i < corners.length; i += 2) points.push(new THREE.Vector2(corners[i], corners[i + 1]));
  return flat(new THREE.ShapeGeometry(new THREE.Shape(points)), color, layer);
}

/** A painted line along points; lane marks are broken. */
export function ribbon(line, color, kind) {
  const half = kind === "stop_line" || kind === "yield_line" ? 0.2 : 0.07;
  const broken = kind === "lane" || kind === "yield_line";
  const [on, off] = kind === "yield_line" ? [0.5, 0.3] : [3, 4.5];
  const corners = [];
  let gone = 0;
  for (let i = 0; i + 3 < line.length; i += 2) {
    const [ax, ay, bx, by] = line.slice(i, i + 4);
    const length = Math.hypot(bx - ax, by - ay);
    if (!length) continue;
    const [ux, uy] = [(bx - ax) / length, (by - ay) / length];
    const piece = (from, to) => {
      const [x0, y0, x1, y1] = [ax + ux * from, ay + uy * from, ax + ux * to, ay + uy * to];
      const [nx, ny] = [-uy * half, ux * half];
      corners.push(x0 + nx, y0 + ny, 0, x0 - nx, y0 - ny, 0, x1 - nx, y1 - ny, 0);
      corners.push(x0 + nx, y0 + ny, 0, x1 - nx, y1 - ny, 0, x1 + nx, y1 + ny, 0);
    };
    if (!broken) piece(0, length);
    for (let at = broken ? 0 : length; at < length;) {
      const phase = (gone + at) % (on + off);
      const next = Math.min(length, at + (phase < on ? on - phase : on + off - phase));
      if (phase < on) piece(at, next);
      at = Math.max(next, at + 1e-3);
    }
    gone += length;
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));
  geometry.computeVertexNormals();
  return flat(geometry, color, 4);
}

/** A thing that does not move. */
export function boxOf(one, color) {
  const mesh = box(one.length_m, one.width_m, one.height_m, color);
  mesh.position.set(one.x_m, one.y_m, one.height_m / 2);
  mesh.rotation.z = one.heading_rad;
  return mesh;
}

/** A participant: its group, and the lamps that its brakes light. */
export function bodyOf(one, color, paint, own) {
  const group = new THREE.Group();
  const [l, w, h] = [one.length_m, one.width_m, one.height_m];
  const dark = paint("--outline"), glass = new THREE.Color(0x27323f);
  const put = (mesh, x, y, z) => {
    mesh.position.set(x, y, z);
    group.add(mesh);
    return mesh;
  };
  if (one.kind === "pedestrian") {
    put(new THREE.Mesh(new THREE.CapsuleGeometry(Math.min(l, w) * 0.42, h * 0.5, 4, 10), material(color)), 0, 0, h * 0.45).rotation.x = Math.PI / 2;
    put(new THREE.Mesh(new THREE.SphereGeometry(h * 0.075, 12, 10), material(new THREE.Color(0xd9b38c))), 0, 0, h * 0.92);
    return { group };
  }
  if (one.kind === "bicycle" || one.kind === "motorcycle") {
    const wheel = Math.min(0.33, l * 0.18);
    for (const x of [-l / 2 + wheel, l / 2 - wheel]) {
      put(new THREE.Mesh(new THREE.TorusGeometry(wheel, 0.05, 8, 20), material(dark)), x, 0, wheel).rotation.x = Math.PI / 2;
    }
    put(box(l * 0.6, 0.14, 0.28, color), 0, 0, wheel * 2);
    if (!own) {
      put(new THREE.Mesh(new THREE.CapsuleGeometry(0.2, h * 0.34, 4, 10), material(color)), -0.1, 0, h * 0.66).rotation.x = Math.PI / 2;
      put(new THREE.Mesh(new THREE.SphereGeometry(0.13, 12, 10), material(dark)), 0, 0, h - 0.13);
    }
    return { group };
  }
  const tall = ["truck", "bus", "van"].includes(one.kind) || h > 2;
  const sill = 0.28, waist = tall ? h * 0.45 : h * 0.58;
  if (own) {
    // the bonnet alone: nobody sees the own roof
    if (!tall) put(box(l * 0.24, w * 0.84, 0.1, color), l * 0.38, 0, 0.46);
    return { group };
  }
  put(box(l, w, (tall ? h : waist) - sill, color), 0, 0, ((tall ? h : waist) + sill) / 2);
  if (tall) {
    put(box(0.06, w * 0.92, h * 0.3, glass), l / 2, 0, h * 0.68);
    put(box(l * 0.5, w * 1.01, h * 0.22, glass), one.kind === "bus" ? 0 : l * 0.2, 0, h * 0.7);
  } else {
    const cabin = box(l * 0.5, w * 0.86, h - waist, glass);
    put(cabin, -l * 0.06, 0, (h + waist) / 2);
    put(box(l * 0.42, w * 0.8, 0.05, color), -l * 0.06, 0, h);
  }
  for (const [x, y] of [[l * 0.32, 1], [l * 0.32, -1], [-l * 0.32, 1], [-l * 0.32, -1]]) {
    put(new THREE.Mesh(new THREE.CylinderGeometry(0.33, 0.33, 0.22, 16), material(dark)), x, y * (w / 2 - 0.09), 0.33);
  }
  for (const y of [w * 0.36, -w * 0.36]) put(box(0.04, 0.3, 0.14, new THREE.Color(0xfff6d8)), l / 2 + 0.01, y, 0.66);
  const lamp = new THREE.MeshBasicMaterial({ color: paint("--brake-light") });
  const brakes = [w * 0.36, -w * 0.36].map((y) =>
    put(new THREE.Mesh(new THREE.BoxGeometry(0.05, 0.34, 0.16), lamp), -l / 2 - 0.02, y, Math.min(waist, 1) * 0.85));
  return { group, brakes };
}

/** A sign on its pole, facing those whom it concerns. */
export function signOf(one, paint) {
  const group = new THREE.Group();
  const pole = new THREE.Mesh(new THREE.CylinderGeometry(0.04, 0.04, 2.4, 8), material(paint("--kerb")));
  pole.rotation.x = Math.PI / 2;
  pole.position.z = 1.2;
  const sides = one.kind === "stop" ? 8 : 3;
  const face = new THREE.Mesh(new THREE.CylinderGeometry(0.4, 0.4, 0.04, sides),
    material(one.kind === "stop" ? paint("--signal-red") : new THREE.Color(0xf7f7f2)));
  face.rotation.set(0, 0, Math.PI / 2);
  face.position.z = 2.3;
  group.add(pole, face);
  group.position.set(one.x_m, one.y_m, 0);
  group.rotation.z = one.heading_rad;
  return group;
}

/** A signal with three lamps; `show(time)` lights the right one. */
export function lightOf(one, paint) {
  const group = new THREE.Group();
  const pole = new THREE.Mesh(new THREE.CylinderGeometry(0.06, 0.06, 2.6, 8), material(paint("--kerb")));
  pole.rotation.x = Math.PI / 2;
  pole.position.z = 1.3;
  const housing = box(0.25, 0.36, 1.0, new THREE.Color(0x1b2026));
  housing.position.z = 3.0;
  group.add(pole, housing);
  const lamps = {};
  for (const [name, z] of [["red", 3.32], ["amber", 3.0], ["green", 2.68]]) {
    const lamp = new THREE.Mesh(new THREE.SphereGeometry(0.15, 14, 10), new THREE.MeshBasicMaterial());
    lamp.position.set(-0.1, 0, z);
    group.add(lamp);
    lamps[name] = lamp.material;
  }
  group.position.set(one.x_m, one.y_m, 0);
  group.rotation.z = one.heading_rad;
  const off = paint("--signal-off").multiplyScalar(0.45);
  const show = (time) => {
    let state = null;
    for (const [since, name] of one.states) if (since <= time + 1e-9) state = String(name);
    const lit = (name) => Boolean(state && state.includes(name));
    for (const name of Object.keys(lamps)) lamps[name].color.copy(lit(name) ? paint(`--signal-${name}`) : off);
  };
  return { group, show };
}

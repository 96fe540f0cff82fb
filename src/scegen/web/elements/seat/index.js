// What the ego's driver could see: the scene in 3D from the driver's eyes, in step with the player.
import { THREE } from "nicegui-scene";
import { bodyOf, boxOf, flat, lightOf, patch, ribbon, signOf } from "./things.js";

const EYES = { car: 1.2, van: 1.55, truck: 2.4, bus: 2.1, motorcycle: 1.45, bicycle: 1.6, emergency_vehicle: 1.6 };
const RANGE_M = { poor: 60, reduced: 140, fog: 70, heavy_rain: 160, snow: 140 };
const UP = new THREE.Vector3(0, 0, 1);

export class DriversSeat {
  constructor(player, scene, environment) {
    this.player = player;
    this.data = scene;
    this.environment = environment || {};
    this.yaw = 0;
    this.host = document.createElement("figure");
    this.host.className = "seat";
    this.host.setAttribute("aria-label", "View from the driver's seat");
    this.caption = document.createElement("figcaption");
    this.host.append(this.caption);
    player.panel.element.prepend(this.host);
    this.stops = [];
    try {
      this.renderer = new THREE.WebGLRenderer({ antialias: true, powerPreference: "low-power" });
    } catch {
      this.caption.textContent = "This browser shows no 3D (WebGL is off).";
      this.host.classList.add("flat");
      return;
    }
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.domElement.tabIndex = 0;
    this.renderer.domElement.setAttribute("role", "img");
    this.renderer.domElement.setAttribute("aria-label", "What the driver of the ego sees; drag to look around");
    this.host.prepend(this.renderer.domElement);
    this.camera = new THREE.PerspectiveCamera(52, 16 / 9, 0.1, 900);
    this.camera.up.copy(UP);
    this.build();
    this.listen();
    this.resize();
  }

  paint(name) {
    return new THREE.Color(this.player.paint(name));
  }

  build() {
    const paint = (name) => this.paint(name);
    const { time_of_day: day, weather, visibility } = this.environment;
    const dark = matchMedia("(prefers-color-scheme: dark)").matches && !document.documentElement.dataset.theme
      ? true : document.documentElement.dataset.theme === "dark";
    const night = day === "night";
    const grey = ["fog", "rain", "heavy_rain", "snow", "cloudy"].includes(weather);
    const sky = new THREE.Color(night ? 0x0b1018 : day === "dawn" || day === "dusk" ? 0xd9b48f : grey ? 0xb9c2ca : dark ? 0x33475c : 0xbfd9ee);
    this.world = new THREE.Scene();
    this.world.background = sky;
    const range = RANGE_M[visibility] || RANGE_M[weather] || (night ? 110 : 420);
    this.world.fog = new THREE.Fog(sky, range * 0.35, range);
    this.world.add(new THREE.HemisphereLight(0xffffff, 0x777766, night ? 0.5 : 2.0));
    const sun = new THREE.DirectionalLight(0xffffff, night ? 0.3 : 1.4);
    sun.position.set(-40, -60, 90);
    this.world.add(sun);
    this.world.add(flat(new THREE.PlaneGeometry(2400, 2400, 24, 24), paint("--ground"), 0));
    const { road } = this.data;
    const layer = { sidewalk: 1, border: 1, shoulder: 1, median: 1, parking: 2 };
    for (const one of road.surfaces) {
      const name = { parking: "--parking", shoulder: "--parking", median: "--shoulder", sidewalk: "--sidewalk" }[one.type] || "--road";
      this.world.add(patch(one.points, paint(name), layer[one.type] ?? 3));
    }
    for (const one of road.marks) this.world.add(ribbon(one.points, paint("--mark"), one.kind));
    for (const one of road.stripes) this.world.add(patch(one.points ?? one, paint("--mark"), 5));
    for (const one of road.signs) this.world.add(signOf(one, paint));
    this.lights = road.lights.map((one) => ({ data: one, ...lightOf(one, paint) }));
    for (const light of this.lights) this.world.add(light.group);
    for (const one of this.data.objects) this.world.add(boxOf(one, paint(one.category === "vegetation" || one.category === "tree" ? "--plant" : "--thing")));
    this.bodies = this.data.participants.map((one) => {
      const own = one.id === this.data.ego;
      const colour = paint(own ? "--ego" : `--participant-${((one.colour - 1) % 10) + 1}`);
      const body = bodyOf(one, colour, paint, own);
      this.world.add(body.group);
      return { one, ...body };
    });
  }

  listen() {
    const canvas = this.renderer.domElement;
    const on = (target, name, listener) => {
      target.addEventListener(name, listener);
      this.stops.push(() => target.removeEventListener(name, listener));
    };
    on(canvas, "pointerdown", (event) => {
      this.from = { x: event.clientX, yaw: this.yaw };
      canvas.setPointerCapture(event.pointerId);
    });
    on(canvas, "pointermove", (event) => {
      if (!this.from) return;
      this.yaw = this.from.yaw + (event.clientX - this.from.x) * 0.006;
      this.draw();
    });
    on(canvas, "pointerup", () => (this.from = null));
    on(canvas, "dblclick", () => this.look(0));
    on(canvas, "keydown", (event) => {
      const turn = { ArrowLeft: 0.12, ArrowRight: -0.12 }[event.key];
      if (turn === undefined) return;
      this.look(this.yaw + turn);
      event.stopPropagation();
      event.preventDefault();
    });
    this.stops.push(this.player.on("time", () => this.soon()));
    const size = new ResizeObserver(() => this.resize());
    size.observe(this.host);
    const theme = new MutationObserver(() => (this.build(), this.draw()));
    theme.observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
    this.stops.push(() => size.disconnect(), () => theme.disconnect());
  }

  // at most once a frame, however often the time is told
  soon() {
    this.due ??= requestAnimationFrame(() => {
      this.due = null;
      if (this.host.isConnected) this.draw();
    });
  }

  look(yaw) {
    this.yaw = yaw;
    this.draw();
  }

  resize() {
    const width = Math.max(this.host.clientWidth, 120);
    const height = Math.round(width * 0.5625);
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    if (!this.renderer) return;
    const { recording, time } = this.player;
    for (const { one, group, brakes } of this.bodies) {
      const place = recording.middle(one.id, time);
      group.position.set(place.x, place.y, 0);
      group.rotation.z = place.heading;
      if (brakes) for (const lamp of brakes) lamp.visible = recording.braking(one.id, time);
    }
    for (const light of this.lights) light.show(time);
    const ego = recording.byId.get(recording.ego);
    const at = recording.middle(recording.ego, time);
    const height = EYES[ego.kind] ?? 1.2;
    const two = ego.kind === "bicycle" || ego.kind === "motorcycle";
    const long = ["truck", "bus"].includes(ego.kind) ? ego.length_m * 0.4 : two ? 0 : ego.length_m * 0.04;
    const left = two ? 0 : (this.data.road.side === "left" ? -1 : 1) * ego.width_m * 0.2;
    const [c, s] = [Math.cos(at.heading), Math.sin(at.heading)];
    const eye = new THREE.Vector3(at.x + long * c - left * s, at.y + long * s + left * c, height);
    const way = at.heading + this.yaw;
    this.camera.position.copy(eye);
    this.camera.lookAt(eye.x + Math.cos(way), eye.y + Math.sin(way), height - 0.035);
    this.renderer.render(this.world, this.camera);
    this.tell(recording, time);
  }

  tell(recording, time) {
    const hidden = new Map(recording.hiddenFrom(recording.ego, time));
    const who = [...hidden].map(([target, by]) => `${target} is hidden by ${by}`);
    const told = who.length > 2 ? [`hidden: ${[...hidden.keys()].join(", ")}`] : who;
    const speed = `${Math.round(recording.pose(recording.ego, time).speed * 3.6)} km/h`;
    const text = [`${recording.ego}, driver's seat · ${speed}`, ...told].join(" · ");
    if (text !== this.told) {
      this.caption.textContent = this.told = text;
      this.caption.title = who.join("\n");
    }
    this.host.classList.toggle("blind", hidden.size > 0);
  }

  destroy() {
    for (const stop of this.stops) stop();
    this.renderer?.dispose();
    this.renderer?.forceContextLoss();
    this.host.remove();
  }
}

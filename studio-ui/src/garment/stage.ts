/** Camera, light and floor; draws only when something has changed. */

import {
  AmbientLight,
  type Box3,
  CanvasTexture,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  Spherical,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Side } from "../state/display";

const AZIMUTH: Record<Side, number> = { front: 0, back: Math.PI, left: Math.PI / 2, right: -Math.PI / 2 };
const TURN_MS = 280;

export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(28, 1, 5, 3000);
  readonly renderer: WebGLRenderer;
  readonly controls: OrbitControls;
  /** Milliseconds that the last frame took to draw, for measuring. */
  lastFrameMs = 0;
  private asked = 0;
  private turning = 0;
  private readonly observer: ResizeObserver;

  constructor(
    private readonly box: HTMLElement,
    private readonly beforeDraw: () => void,
  ) {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, powerPreference: "high-performance" });
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setClearColor(0x000000, 0);
    box.append(this.renderer.domElement);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.minDistance = 25;
    this.controls.maxDistance = 1200;
    this.controls.addEventListener("change", () => {
      const [at, to] = [this.camera.position, this.controls.target];
      this.mark("camera", [...at.toArray(), ...to.toArray()].map((each) => each.toFixed(2)).join(" "));
      this.invalidate();
    });
    this.controls.addEventListener("start", () => cancelAnimationFrame(this.turning));
    this.light();
    this.floor();
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(box);
    this.camera.position.set(60, 110, 420);
    this.controls.target.set(0, 95, 0);
    this.controls.update();
    this.resize();
  }

  /** Draws at the next frame of the screen, once however often it is asked. */
  invalidate(): void {
    if (this.asked !== 0) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      const start = performance.now();
      this.beforeDraw();
      this.renderer.render(this.scene, this.camera);
      this.lastFrameMs = performance.now() - start;
      this.mark("frameMs", this.lastFrameMs.toFixed(2));
    });
  }

  /** Looks at all of the box from the side that it is looked at from now. */
  frame(box: Box3, smooth: boolean): void {
    if (box.isEmpty()) return;
    const center = box.getCenter(new Vector3());
    const size = box.getSize(new Vector3());
    const half = Math.tan((this.camera.fov * Math.PI) / 360);
    const width = Math.hypot(size.x, size.z) * 0.92;
    const distance =
      (1.12 * Math.max(size.y, width / this.camera.aspect)) / 2 / half + Math.max(size.x, size.z) / 2;
    const offset = this.camera.position.clone().sub(this.controls.target).setLength(distance);
    this.goTo(center, new Spherical().setFromVector3(offset), smooth);
  }

  look(side: Side): void {
    const spherical = this.spherical();
    this.goTo(
      this.controls.target.clone(),
      new Spherical(spherical.radius, Math.PI / 2 - 0.06, AZIMUTH[side]),
      true,
    );
  }

  /** Orbits by angles in radians, and moves nearer by a factor. */
  orbit(azimuth: number, polar: number, nearer = 1): void {
    const s = this.spherical();
    const phi = Math.min(Math.PI - 0.05, Math.max(0.05, s.phi + polar));
    const radius = Math.min(
      this.controls.maxDistance,
      Math.max(this.controls.minDistance, s.radius / nearer),
    );
    this.goTo(this.controls.target.clone(), new Spherical(radius, phi, s.theta + azimuth), false);
  }

  /** Moves the view by shares of its height. */
  pan(right: number, up: number): void {
    const span = 2 * this.spherical().radius * Math.tan((this.camera.fov * Math.PI) / 360);
    const shift = new Vector3(right * span, up * span, 0).applyQuaternion(this.camera.quaternion);
    this.camera.position.add(shift);
    this.controls.target.add(shift);
    this.controls.update();
    this.invalidate();
  }

  /** Says in the page what is drawn, for tests and the curious: `data-mesh` and such at the canvas. */
  mark(name: string, value: string): void {
    this.renderer.domElement.dataset[name] = value;
  }

  unmark(name: string): void {
    delete this.renderer.domElement.dataset[name];
  }

  /** What is seen now, as a data URL. */
  picture(): string {
    this.beforeDraw();
    this.renderer.render(this.scene, this.camera);
    return this.renderer.domElement.toDataURL("image/webp", 0.9);
  }

  dispose(): void {
    cancelAnimationFrame(this.asked);
    cancelAnimationFrame(this.turning);
    this.observer.disconnect();
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.renderer.domElement.remove();
  }

  private spherical(): Spherical {
    return new Spherical().setFromVector3(this.camera.position.clone().sub(this.controls.target));
  }

  private goTo(target: Vector3, to: Spherical, smooth: boolean): void {
    cancelAnimationFrame(this.turning);
    const from = this.spherical();
    const start = this.controls.target.clone();
    const still = !smooth || window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    let turn = to.theta - from.theta;
    turn -= 2 * Math.PI * Math.round(turn / (2 * Math.PI));
    const begun = performance.now();
    const step = () => {
      const t = still ? 1 : Math.min(1, (performance.now() - begun) / TURN_MS);
      const eased = t * t * (3 - 2 * t);
      const now = new Spherical(
        from.radius + eased * (to.radius - from.radius),
        from.phi + eased * (to.phi - from.phi),
        from.theta + eased * turn,
      );
      this.controls.target.lerpVectors(start, target, eased);
      this.camera.position.setFromSpherical(now).add(this.controls.target);
      this.controls.update();
      this.invalidate();
      if (t < 1) this.turning = requestAnimationFrame(step);
    };
    step();
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.box;
    if (width === 0 || height === 0) return;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.renderer.setSize(width, height);
    // Drawn at once: a resized canvas is empty until it is.
    this.beforeDraw();
    this.renderer.render(this.scene, this.camera);
  }

  private light(): void {
    const key = new DirectionalLight(0xffffff, 1.9);
    key.position.set(120, 260, 320);
    const rim = new DirectionalLight(0xdfe9ff, 0.9);
    rim.position.set(-220, 180, -260);
    // Lights turn with the camera, so that no side is dark.
    this.camera.add(key, rim);
    this.scene.add(
      this.camera,
      new HemisphereLight(0xffffff, 0xb9c2c6, 1.25),
      new AmbientLight(0xffffff, 0.25),
    );
  }

  private floor(): void {
    const canvas = document.createElement("canvas");
    canvas.width = 128;
    canvas.height = 128;
    const context = canvas.getContext("2d");
    if (context === null) return;
    const gradient = context.createRadialGradient(64, 64, 4, 64, 64, 64);
    gradient.addColorStop(0, "rgba(0,0,0,0.34)");
    gradient.addColorStop(0.5, "rgba(0,0,0,0.10)");
    gradient.addColorStop(1, "rgba(0,0,0,0)");
    context.fillStyle = gradient;
    context.fillRect(0, 0, 128, 128);
    const material = new MeshBasicMaterial({
      map: new CanvasTexture(canvas),
      transparent: true,
      depthWrite: false,
    });
    const shadow = new Mesh(new PlaneGeometry(130, 110), material);
    shadow.rotation.x = -Math.PI / 2;
    shadow.position.y = 0.1;
    this.scene.add(shadow);
  }
}

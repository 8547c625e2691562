/** The garment in 3D: what is shown of it, how it is looked at, and what lies under the pointer. */

import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Mesh,
  MeshStandardMaterial,
  Points,
  PointsMaterial,
  Raycaster,
  Vector2,
  Vector3,
} from "three";
import type { EdgePlace } from "../api/types";
import type { Side } from "../state/display";
import type { Target } from "../state/selection";
import { Cloth, type ClothLook } from "./cloth";
import { type ColoredPath, EdgePaths, Lines } from "./lines";
import type { MeshData } from "./mesh-file";
import { Stage } from "./stage";
import { Trims } from "./trims";

/** How near to an edge the pointer has to be, px. */
const EDGE_PX = 9;

export interface Marks {
  selected: Target[];
  hover: Target | null;
  selectColor: string;
  hoverColor: string;
}

/** The two sides of a stitch of the pattern that is shown. */
export type SeamLookup = (stitch: number) => readonly [EdgePlace, EdgePlace] | null;

export class GarmentViewer {
  readonly stage: Stage;
  private readonly cloth: Cloth;
  private readonly trims = new Trims();
  private readonly seams = new Lines(2, false);
  private readonly hovered = new Lines(5, true);
  private readonly selected = new Lines(5, true);
  private readonly points: Points<BufferGeometry, PointsMaterial>;
  private body: Mesh<BufferGeometry, MeshStandardMaterial> | null = null;
  private paths: EdgePaths | null = null;
  private seamColors: string[] = [];
  private seamsShown = true;
  private marks: Marks = { selected: [], hover: null, selectColor: "#c2410c", hoverColor: "#0b63ce" };
  private seamOf: SeamLookup = () => null;
  private readonly raycaster = new Raycaster();
  private marksStale = false;
  /** Whether frames have moved the cloth from where its mesh has it. */
  private moved = false;

  constructor(box: HTMLElement) {
    this.stage = new Stage(box, () => this.refreshMarks());
    this.cloth = new Cloth(this.stage.renderer.capabilities.getMaxAnisotropy());
    this.points = new Points(
      new BufferGeometry(),
      new PointsMaterial({ size: 11, sizeAttenuation: false, depthTest: false }),
    );
    this.points.frustumCulled = false;
    this.points.visible = false;
    const { cloth, trims, seams, hovered, selected, points } = this;
    this.stage.scene.add(cloth.mesh, trims.object, cloth.glow, seams.object, selected.object);
    this.stage.scene.add(hovered.object, points);
  }

  get data(): MeshData | null {
    return this.cloth.data;
  }

  /** Shows this mesh where the one before it was; the camera stays. */
  showGarment(data: MeshData | null, seamColors: string[]): void {
    this.cloth.mesh.visible = data !== null;
    this.seamColors = seamColors;
    if (data === null) {
      this.cloth.data = null;
      this.paths = null;
      this.trims.show([]);
    } else if (this.cloth.data !== data || this.moved) {
      this.cloth.show(data);
      this.paths = new EdgePaths(data);
      this.trims.show(data.trims);
    }
    this.moved = false;
    this.markTrims();
    this.drawSeams();
    this.markAgain();
  }

  showFrame(frame: Float32Array): void {
    this.cloth.moveTo(frame);
    this.moved = true;
    // They lie where the cloth was; the garment that comes at the end brings its own.
    this.trims.show([]);
    this.markTrims();
    this.seams.follow(this.cloth.positions);
    this.markAgain();
  }

  showBody(data: MeshData | null): void {
    if (this.body !== null) {
      this.stage.scene.remove(this.body);
      this.body.geometry.dispose();
      this.body = null;
    }
    if (data !== null) {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(data.positions, 3));
      geometry.setAttribute("normal", new BufferAttribute(data.normals, 3));
      const colored = data.colors.length === data.positions.length;
      if (colored) geometry.setAttribute("color", new BufferAttribute(data.colors, 3));
      geometry.setIndex(new BufferAttribute(data.triangles, 1));
      const material = new MeshStandardMaterial({ roughness: 0.75, vertexColors: colored });
      if (!colored) material.color.set("#c9bfb6");
      this.body = new Mesh(geometry, material);
      this.stage.scene.add(this.body);
    }
    this.stage.invalidate();
  }

  setBodyVisible(visible: boolean): void {
    if (this.body !== null) this.body.visible = visible;
    this.stage.invalidate();
  }

  setLook(look: ClothLook): void {
    this.cloth.setLook(look);
    this.trims.setLook(look, this.cloth.texture);
    this.stage.mark("print", this.cloth.printShown);
    this.markTrims();
    this.stage.invalidate();
  }

  setSeamsVisible(shown: boolean): void {
    this.seamsShown = shown;
    this.drawSeams();
    this.stage.invalidate();
  }

  setMarks(marks: Marks, seamOf: SeamLookup): void {
    this.marks = marks;
    this.seamOf = seamOf;
    this.markAgain();
  }

  look(side: Side): void {
    this.stage.look(side);
  }

  /** Brings the garment into view; without one the body. */
  frameAll(smooth: boolean): void {
    this.stage.frame(this.bounds(), smooth);
  }

  /** Of the garment, or of the body where there is none, cm. */
  bounds(): Box3 {
    const box = new Box3();
    if (this.cloth.data !== null) box.setFromArray(this.cloth.positions as unknown as number[]);
    else if (this.body !== null) box.setFromObject(this.body);
    return box;
  }

  /** The edge or panel under a point of the canvas, px from its upper left; null: nothing of the garment. */
  pick(x: number, y: number): Target | null {
    const data = this.cloth.data;
    if (data === null) return null;
    const { clientWidth: width, clientHeight: height } = this.stage.renderer.domElement;
    this.raycaster.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), this.stage.camera);
    this.cloth.mesh.geometry.computeBoundingSphere();
    const solid = this.body?.visible ? [this.cloth.mesh, this.body] : [this.cloth.mesh];
    const hit = this.raycaster.intersectObjects(solid, false)[0];
    if (hit?.face == null || hit.object !== this.cloth.mesh) return null;
    const panel = data.panels[data.panel[hit.face.a] as number];
    if (panel === undefined) return null;
    const cmPerPx = (2 * hit.distance * Math.tan((this.stage.camera.fov * Math.PI) / 360)) / height;
    const edge = this.nearestEdge(panel, hit.point, EDGE_PX * cmPerPx);
    return edge === null ? { kind: "panel", panel } : { kind: "edge", panel, edge };
  }

  dispose(): void {
    this.stage.dispose();
  }

  private nearestEdge(panel: string, point: Vector3, within: number): number | null {
    const data = this.cloth.data;
    if (data === null) return null;
    let best: number | null = null;
    let least = within;
    const [a, b, nearest] = [new Vector3(), new Vector3(), new Vector3()];
    for (const place of data.edges) {
      if (place.panel !== panel) continue;
      const path = this.paths?.of(place);
      if (path === undefined) continue;
      for (let k = 1; k < path.length; k += 1) {
        a.fromArray(this.cloth.positions, 3 * (path[k - 1] as number));
        b.fromArray(this.cloth.positions, 3 * (path[k] as number));
        const along = b.clone().sub(a);
        const t = Math.min(1, Math.max(0, point.clone().sub(a).dot(along) / (along.lengthSq() || 1)));
        const distance = nearest.copy(a).addScaledVector(along, t).distanceTo(point);
        if (distance < least) [least, best] = [distance, place.edge];
      }
    }
    return best;
  }

  private drawSeams(): void {
    const { data } = this.cloth;
    const paths: ColoredPath[] = [];
    if (data !== null && this.seamsShown)
      data.seams.forEach((seam, k) => {
        const vertices = this.paths?.of(seam.first) ?? this.paths?.of(seam.second);
        if (vertices !== undefined) paths.push({ vertices, color: this.seamColors[k] ?? "#888888" });
      });
    this.seams.setPaths(paths, this.cloth.positions);
  }

  private markTrims(): void {
    this.stage.mark("trims", this.trims.object.visible ? this.trims.looks.join(" ") : "");
  }

  private markAgain(): void {
    this.marksStale = true;
    this.stage.invalidate();
  }

  /** Marks are worked out once per drawn frame, however often the pointer moved. */
  private refreshMarks(): void {
    if (!this.marksStale) return;
    this.marksStale = false;
    const { selected, hover, selectColor, hoverColor } = this.marks;
    this.selected.setPaths(this.pathsOf(selected, selectColor), this.cloth.positions);
    this.hovered.setPaths(this.pathsOf(hover === null ? [] : [hover], hoverColor), this.cloth.positions);
    const hoveredPanel = hover?.kind === "panel" ? hover.panel : null;
    const panels = selected.flatMap((target) => (target.kind === "panel" ? [target.panel] : []));
    this.cloth.setGlow(
      new Set(hoveredPanel !== null ? [hoveredPanel] : panels),
      hoveredPanel !== null ? hoverColor : selectColor,
    );
    this.markPoints([...selected, ...(hover === null ? [] : [hover])], selectColor);
  }

  private pathsOf(targets: Target[], color: string): ColoredPath[] {
    return targets.flatMap((target) => {
      const places: readonly EdgePlace[] =
        target.kind === "edge" ? [target] : target.kind === "seam" ? (this.seamOf(target.stitch) ?? []) : [];
      return places.flatMap((place) => {
        const vertices = this.paths?.of(place);
        return vertices === undefined ? [] : [{ vertices, color }];
      });
    });
  }

  private markPoints(targets: Target[], color: string): void {
    const points: number[] = [];
    for (const target of targets) {
      if (target.kind !== "vertex") continue;
      const first = this.paths?.of({ panel: target.panel, edge: target.vertex })?.[0];
      if (first !== undefined) points.push(...this.cloth.positions.subarray(3 * first, 3 * first + 3));
    }
    this.points.visible = points.length > 0;
    if (points.length === 0) return;
    this.points.geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
    this.points.material.color.set(color);
  }
}

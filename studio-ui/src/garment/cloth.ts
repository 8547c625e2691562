/** The garment's surface: one geometry whose arrays are replaced in place wherever they fit. */

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Mesh,
  MeshBasicMaterial,
  MeshNormalMaterial,
  MeshStandardMaterial,
  type Texture,
  Vector4,
} from "three";
import type { PanelLook } from "../api/types";
import type { Coloring, Print } from "../state/display";
import { linear, PANEL_COLORS, type Rgb } from "./colors";
import { computeNormals, type MeshData, spreadFrame } from "./mesh-file";
import { isWoven, type PrintTile, tileTexture } from "./print-tile";
import { printTexture } from "./prints";
import { strainColor } from "./strain-colors";
import { DARKEST, ownColor } from "./trim-color";

/** Linear channels, and the share of what lies beneath that is hidden. */
type Rgba = [number, number, number, number];

export interface ClothLook {
  coloring: Coloring;
  print: Print;
  /** The garment's own print, in place of `print`. */
  tile: PrintTile | null;
  /** "#rrggbb" */
  color: string;
  /** Panels that look otherwise, by name. */
  panels: Readonly<Record<string, PanelLook>>;
  wireframe: boolean;
  /** Which way the cloth faces, seen from the camera, in place of its colour. */
  normals: boolean;
}

export const PLAIN_LOOK: ClothLook = {
  coloring: "cloth",
  print: "plain",
  tile: null,
  color: "#8aa5b8",
  panels: {},
  wireframe: false,
  normals: false,
};

/** Panels that look otherwise than their garment have nothing of its print. */
const PRINTED_PANELS = `
#ifdef USE_MAP
  diffuseColor *= mix(vec4(1.0), texture2D(map, vMapUv), vPrinted);
#endif`;
/**
 * The wrong side of the cloth is darker, so that one sees into a neck or under a hem; what is printed and not woven is
 * not seen there.
 */
const WRONG_SIDE = `
#include <color_fragment>
  if (!gl_FrontFacing) {
    if (wrongSide.a * vPrinted > 0.5) diffuseColor.rgb = wrongSide.rgb;
    diffuseColor.rgb *= 0.62;
  }`;

/** No cloth throws back all light: the brightest keep room for their folds to be seen. */
export const ALBEDO = 0.86;

export class Cloth {
  readonly mesh: Mesh<BufferGeometry, MeshStandardMaterial | MeshNormalMaterial>;
  /** Panels that are pointed at or selected, drawn over the cloth. */
  readonly glow: Mesh<BufferGeometry, MeshBasicMaterial>;
  data: MeshData | null = null;
  private look: ClothLook = PLAIN_LOOK;
  /** Linear channels of the wrong side; the last is 1 where it is otherwise than the right one. */
  private readonly wrongSide = new Vector4();
  private readonly material: MeshStandardMaterial;
  private readonly normalMaterial = new MeshNormalMaterial({
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });

  constructor(private readonly anisotropy: number) {
    this.material = new MeshStandardMaterial({
      side: DoubleSide,
      roughness: 0.86,
      metalness: 0,
      polygonOffset: true,
    });
    this.material.color.set(this.look.color).multiplyScalar(ALBEDO);
    this.material.polygonOffsetFactor = 1;
    this.material.polygonOffsetUnits = 1;
    this.material.onBeforeCompile = (shader) => {
      shader.uniforms.wrongSide = { value: this.wrongSide };
      shader.vertexShader = shader.vertexShader
        .replace("#include <common>", "#include <common>\nattribute float printed;\nvarying float vPrinted;")
        .replace("#include <uv_vertex>", "#include <uv_vertex>\n  vPrinted = printed;");
      shader.fragmentShader = shader.fragmentShader
        .replace("#include <common>", "#include <common>\nvarying float vPrinted;\nuniform vec4 wrongSide;")
        .replace("#include <map_fragment>", PRINTED_PANELS)
        .replace("#include <color_fragment>", WRONG_SIDE);
    };
    this.mesh = new Mesh(new BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    const glow = new MeshBasicMaterial({
      transparent: true,
      opacity: 0.28,
      side: DoubleSide,
      depthWrite: false,
    });
    this.glow = new Mesh(new BufferGeometry(), glow);
    this.glow.frustumCulled = false;
    this.glow.visible = false;
  }

  get positions(): Float32Array {
    return this.mesh.geometry.getAttribute("position")?.array as Float32Array;
  }

  /** What is printed on the cloth; null where it is plain or not shown as cloth. */
  get texture(): Texture | null {
    return this.material.map;
  }

  /** What is drawn, for tests and the curious: "plain", a print to look at, or "own" and the kind of the garment's. */
  get printShown(): string {
    if (this.material.map === null) return "plain";
    return this.look.tile === null ? this.look.print : `own ${this.look.tile.print.kind}`;
  }

  show(data: MeshData): void {
    const geometry = this.mesh.geometry;
    this.data = data;
    if (geometry.getAttribute("position")?.count === data.vertices) {
      this.copy("position", data.positions);
      this.copy("normal", data.normals);
      this.copy("uv", data.uv);
      this.copy("uv1", data.cloth);
    } else {
      // Attributes are replaced and not the geometry, so that materials and draw order stay.
      geometry.dispose();
      geometry.setAttribute("position", new BufferAttribute(data.positions.slice(), 3));
      geometry.setAttribute("normal", new BufferAttribute(data.normals.slice(), 3));
      geometry.setAttribute("uv", new BufferAttribute(data.uv.slice(), 2));
      geometry.setAttribute("uv1", new BufferAttribute(data.cloth.slice(), 2));
      geometry.setAttribute("printed", new BufferAttribute(new Float32Array(data.vertices), 1));
      geometry.setAttribute("color", new BufferAttribute(new Float32Array(4 * data.vertices), 4));
    }
    geometry.setIndex(new BufferAttribute(data.triangles, 1));
    this.recolor();
  }

  /** Moves the vertices to a frame of the welded ones, (welded, 3). */
  moveTo(frame: Float32Array): void {
    if (this.data === null || frame.length !== 3 * this.data.welded) return;
    const position = this.mesh.geometry.getAttribute("position") as BufferAttribute;
    const normal = this.mesh.geometry.getAttribute("normal") as BufferAttribute;
    spreadFrame(this.data, frame, position.array as Float32Array);
    computeNormals(this.data, position.array as Float32Array, normal.array as Float32Array);
    position.needsUpdate = true;
    normal.needsUpdate = true;
  }

  setLook(look: ClothLook): void {
    const before = this.look;
    this.look = look;
    const printed = look.coloring === "cloth";
    const other = before.print !== look.print || before.tile !== look.tile || before.color !== look.color;
    if (other || before.coloring !== look.coloring || before.panels !== look.panels) {
      const dyed = printed && Object.keys(look.panels).length > 0;
      this.material.map?.dispose();
      this.material.map = printed ? this.textureOf(look) : null;
      const hidden = printed && look.tile !== null && !isWoven(look.tile.print);
      const ground = ownColor(look.tile?.print.colors[0] ?? look.color);
      this.wrongSide.set(ALBEDO * ground[0], ALBEDO * ground[1], ALBEDO * ground[2], hidden ? 1 : 0);
      this.material.vertexColors = !printed || dyed;
      this.material.transparent = dyed && Object.values(look.panels).some(({ opacity }) => opacity < 1);
      this.material.color
        .set(printed && !dyed && this.material.map === null ? look.color : "#ffffff")
        .setRGB(...lit(this.material.color))
        .multiplyScalar(printed ? ALBEDO : 1);
      this.material.needsUpdate = true;
      this.recolor();
    }
    this.material.wireframe = look.wireframe;
    this.normalMaterial.wireframe = look.wireframe;
    this.mesh.material = look.normals ? this.normalMaterial : this.material;
  }

  /** Draws these panels over the cloth in this colour; none: nothing. */
  setGlow(panels: ReadonlySet<string>, color: string): void {
    const data = this.data;
    this.glow.visible = data !== null && panels.size > 0;
    if (data === null || panels.size === 0) return;
    const shown = new Set([...panels].map((name) => data.panels.indexOf(name)));
    const triangles: number[] = [];
    for (let t = 0; t < data.triangles.length; t += 3) {
      const first = data.triangles[t] as number;
      if (shown.has(data.panel[first] as number))
        triangles.push(first, data.triangles[t + 1] as number, data.triangles[t + 2] as number);
    }
    const position = this.mesh.geometry.getAttribute("position");
    if (position !== undefined) this.glow.geometry.setAttribute("position", position);
    this.glow.geometry.setIndex(triangles);
    this.glow.material.color.set(color);
  }

  private textureOf({ tile, print, color }: ClothLook): Texture | null {
    return tile === null ? printTexture(print, color, this.anisotropy) : tileTexture(tile, this.anisotropy);
  }

  private recolor(): void {
    const data = this.data;
    if (data === null) return;
    const printed = this.mesh.geometry.getAttribute("printed") as BufferAttribute;
    const plain = data.panels.map((name) => this.isPlain(name));
    for (let v = 0; v < data.vertices; v += 1) printed.array[v] = plain[data.panel[v] as number] ? 0 : 1;
    printed.needsUpdate = true;
    if (!this.material.vertexColors) return;
    const attribute = this.mesh.geometry.getAttribute("color") as BufferAttribute;
    const out = attribute.array as Float32Array;
    const panels = data.panels.map((name) => this.panelColor(name));
    for (let v = 0; v < data.vertices; v += 1) {
      const rgba = this.look.coloring === "cloth" ? panels[data.panel[v] as number] : this.codeColor(data, v);
      if (rgba !== undefined) out.set(rgba, 4 * v);
    }
    attribute.needsUpdate = true;
  }

  /** Linear channels and opacity of a panel of its own look, or of the rest; white below a print. */
  private panelColor(name: string): Rgba {
    const own = this.look.panels[name];
    const base = this.material.map === null || this.isPlain(name) ? this.look.color : "#ffffff";
    return [...ownColor(own?.color ?? base), own?.opacity ?? 1];
  }

  /** Whether a panel has nothing of the garment's own print. */
  private isPlain(name: string): boolean {
    return this.look.tile !== null && this.look.panels[name]?.printed === false;
  }

  /** Linear channels that stand for a number: how the cloth is stretched, or which panel it is. */
  private codeColor(data: MeshData, v: number): Rgba {
    const rgb =
      this.look.coloring === "strain"
        ? strainColor(data.strain[v] ?? 0)
        : (PANEL_COLORS[(data.panel[v] as number) % PANEL_COLORS.length] as Rgb);
    return [linear(rgb[0]), linear(rgb[1]), linear(rgb[2]), 1];
  }

  private copy(name: string, values: Float32Array): void {
    const attribute = this.mesh.geometry.getAttribute(name) as BufferAttribute;
    (attribute.array as Float32Array).set(values);
    attribute.needsUpdate = true;
  }
}

/** Linear channels, none darker than cloth is in previews: what lies on black cloth is no lighter than the cloth. */
function lit({ r, g, b }: { r: number; g: number; b: number }): [number, number, number] {
  return [Math.max(r, DARKEST), Math.max(g, DARKEST), Math.max(b, DARKEST)];
}

/** Pockets, buttons, zips and belts: small meshes that lie on the cloth of the garment that is shown. */

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshNormalMaterial,
  MeshStandardMaterial,
  type Texture,
} from "three";
import type { TrimLook } from "../api/types";
import { ALBEDO, type ClothLook, PLAIN_LOOK } from "./cloth";
import type { Rgb } from "./colors";
import type { TrimData } from "./mesh-file";
import { edgeColor, ownColor, trimColor } from "./trim-color";

/** How a surface throws back light: horn and metal shine, cloth does not. */
const ROUGHNESS: Record<TrimLook, number> = {
  cloth: 0.86,
  dark: 0.9,
  metal: 0.38,
  button: 0.42,
  leather: 0.6,
};

interface Part {
  data: TrimData;
  mesh: Mesh<BufferGeometry, MeshStandardMaterial | MeshNormalMaterial>;
  material: MeshStandardMaterial;
  edges: LineSegments<BufferGeometry, LineBasicMaterial>;
}

export class Trims {
  readonly object = new Group();
  private parts: Part[] = [];
  private shown: readonly TrimData[] = [];
  private look: ClothLook = PLAIN_LOOK;
  private texture: Texture | null = null;
  private readonly normalMaterial = new MeshNormalMaterial({ side: DoubleSide });

  /** Of what there is, whether or not it is drawn. */
  get looks(): TrimLook[] {
    return [...new Set(this.parts.map(({ data }) => data.look))];
  }

  /** Shows these in place of those before; none: nothing. */
  show(trims: readonly TrimData[]): void {
    if (trims === this.shown) return;
    this.shown = trims;
    this.clear();
    this.parts = trims.map((data) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(data.positions, 3));
      if (data.uv !== null) geometry.setAttribute("uv", new BufferAttribute(data.uv, 2));
      if (data.cloth !== null) geometry.setAttribute("uv1", new BufferAttribute(data.cloth, 2));
      geometry.setIndex(new BufferAttribute(data.triangles, 1));
      geometry.computeVertexNormals();
      const material = new MeshStandardMaterial({
        side: DoubleSide,
        roughness: ROUGHNESS[data.look],
        metalness: 0,
        // Behind the lines of its own edges, and before the cloth all the same: it lies higher by millimetres.
        polygonOffset: true,
        polygonOffsetFactor: 1,
        polygonOffsetUnits: 1,
      });
      const outline = new BufferGeometry();
      outline.setAttribute("position", geometry.getAttribute("position"));
      outline.setIndex(new BufferAttribute(data.lines, 1));
      const mesh = new Mesh(geometry, material);
      const edges = new LineSegments(outline, new LineBasicMaterial());
      for (const each of [mesh, edges]) each.frustumCulled = false;
      this.object.add(mesh, edges);
      return { data, mesh, material, edges };
    });
    this.paint();
  }

  /** Follows the cloth's colour and print (its texture); hidden where colours of the cloth say something else. */
  setLook(look: ClothLook, texture: Texture | null): void {
    this.look = look;
    this.texture = texture;
    this.paint();
  }

  private paint(): void {
    const { coloring, wireframe, normals, tile } = this.look;
    const color = tile?.print.colors[0] ?? this.look.color;
    this.object.visible = this.parts.length > 0 && (coloring === "cloth" || normals);
    this.normalMaterial.wireframe = wireframe;
    for (const { data, mesh, material, edges } of this.parts) {
      const part = data.color === null ? trimColor(data.look, color) : ownColor(data.color);
      const printed = data.look === "cloth" && data.color === null && data.uv !== null ? this.texture : null;
      if (material.map !== printed) material.needsUpdate = true;
      material.map = printed;
      if (printed === null) set(material.color, part, ALBEDO);
      else material.color.setScalar(0.94 * ALBEDO);
      material.wireframe = wireframe;
      set(edges.material.color, edgeColor(part), ALBEDO);
      edges.visible = !normals && !wireframe;
      mesh.material = normals ? this.normalMaterial : material;
    }
  }

  private clear(): void {
    for (const { mesh, material, edges } of this.parts) {
      this.object.remove(mesh, edges);
      mesh.geometry.dispose();
      edges.geometry.dispose();
      edges.material.dispose();
      material.dispose();
    }
  }
}

/** Materials take linear channels. */
function set(
  color: { setRGB: (r: number, g: number, b: number) => unknown },
  rgb: Rgb,
  factor: number,
): void {
  color.setRGB(factor * rgb[0], factor * rgb[1], factor * rgb[2]);
}

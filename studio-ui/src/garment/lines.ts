/** Seams and edges on the garment, as lines some pixels wide. */

import { Color } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { EdgePlace } from "../api/types";
import type { MeshData } from "./mesh-file";

export interface ColoredPath {
  /** Vertices of the mesh, in order. */
  vertices: Uint32Array;
  color: string;
}

export class Lines {
  readonly object: LineSegments2;
  private readonly material: LineMaterial;
  private paths: ColoredPath[] = [];

  constructor(width: number, onTop: boolean) {
    this.material = new LineMaterial({
      vertexColors: true,
      linewidth: width,
      depthTest: !onTop,
      transparent: onTop,
    });
    if (onTop) this.material.opacity = 0.95;
    this.object = new LineSegments2(new LineSegmentsGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.visible = false;
    this.object.renderOrder = onTop ? 3 : 2;
  }

  setPaths(paths: ColoredPath[], positions: Float32Array | undefined): void {
    this.paths = paths;
    this.follow(positions);
  }

  /** Draws the same paths through the vertices where they are now. */
  follow(positions: Float32Array | undefined): void {
    const count = this.paths.reduce((sum, path) => sum + Math.max(0, path.vertices.length - 1), 0);
    this.object.visible = count > 0 && positions !== undefined;
    if (count === 0 || positions === undefined) return;
    const points = new Float32Array(6 * count);
    const colors = new Float32Array(6 * count);
    const color = new Color();
    let at = 0;
    for (const path of this.paths) {
      color.set(path.color);
      for (let k = 1; k < path.vertices.length; k += 1)
        for (const vertex of [path.vertices[k - 1] as number, path.vertices[k] as number]) {
          points.set(positions.subarray(3 * vertex, 3 * vertex + 3), at);
          colors.set([color.r, color.g, color.b], at);
          at += 3;
        }
    }
    // The line geometry cannot grow: a new one where the number of pieces differs.
    if (this.object.geometry.attributes.instanceStart?.count !== count) {
      this.object.geometry.dispose();
      this.object.geometry = new LineSegmentsGeometry();
    }
    this.object.geometry.setPositions(points);
    this.object.geometry.setColors(colors);
  }
}

/** Vertices along each edge of the pattern, by panel and edge. */
export class EdgePaths {
  private readonly paths = new Map<string, Uint32Array>();

  constructor(data: MeshData) {
    data.edges.forEach((place, k) => {
      this.paths.set(key(place), data.edgeVertices.subarray(data.edgeOffsets[k], data.edgeOffsets[k + 1]));
    });
  }

  of(place: EdgePlace): Uint32Array | undefined {
    return this.paths.get(key(place));
  }
}

const key = ({ panel, edge }: EdgePlace): string => `${edge} ${panel}`;

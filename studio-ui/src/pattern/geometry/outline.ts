/** Panels as closed loops of curves. */

import type { EdgeRef, Panel, Point, Specification } from "../specification";
import { panelOf } from "../specification";
import { at } from "./at";
import { type Box, boxAround, curveBox } from "./bounds";
import type { Curve } from "./curve";
import { flattened } from "./flatten";
import { curveLength } from "./length";

/** Edge k of a panel over its end points. */
export function curveOf(panel: Panel, edge: number): Curve {
  const count = panel.vertices.length;
  return {
    shape: at(panel.edges, edge).curvature,
    start: at(panel.vertices, edge),
    end: at(panel.vertices, (edge + 1) % count),
  };
}

const lengths = new WeakMap<Panel, readonly number[]>();

/** Arc lengths of all edges, cm; remembered for as long as the panel is. */
export function edgeLengths(panel: Panel): readonly number[] {
  let known = lengths.get(panel);
  if (known === undefined) {
    known = panel.edges.map((_, k) => curveLength(curveOf(panel, k)));
    lengths.set(panel, known);
  }
  return known;
}

export function edgeLength(specification: Specification, ref: EdgeRef): number {
  return at(edgeLengths(panelOf(specification, ref.panel)), ref.edge);
}

/** Closed polyline within `tolerance` cm of the loop; the first point is not repeated. */
export function outlineOf(panel: Panel, tolerance: number): Point[] {
  return panel.edges.flatMap((_, k) => flattened(curveOf(panel, k), tolerance).slice(0, -1));
}

const areas = new WeakMap<Panel, number>();

/** Area in cm^2, positive where the loop runs anticlockwise; remembered for as long as the panel is. */
export function signedArea(panel: Panel): number {
  let known = areas.get(panel);
  if (known === undefined) {
    known = polygonArea(outlineOf(panel, 0.001));
    areas.set(panel, known);
  }
  return known;
}

export function polygonArea(points: readonly Point[]): number {
  const [ox, oy] = points[0] ?? [0, 0];
  let sum = 0;
  for (let k = 0; k < points.length; k++) {
    const [x, y] = at(points, k);
    const [u, v] = at(points, (k + 1) % points.length);
    sum += (x - ox) * (v - oy) - (u - ox) * (y - oy);
  }
  return sum / 2;
}

export function panelBox(panel: Panel): Box {
  return boxAround(panel.edges.map((_, k) => curveBox(curveOf(panel, k))));
}

/** Whether a point lies inside the loop (a polyline). */
export function isInside(point: Point, outline: readonly Point[]): boolean {
  let inside = false;
  for (let k = 0; k < outline.length; k++) {
    const [x, y] = at(outline, k);
    const [u, v] = at(outline, (k + 1) % outline.length);
    if (y > point[1] !== v > point[1] && point[0] < x + ((point[1] - y) / (v - y)) * (u - x))
      inside = !inside;
  }
  return inside;
}

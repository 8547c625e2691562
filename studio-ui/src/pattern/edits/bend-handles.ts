/** The points by which an edge is bent. A straight edge has one, in its middle. */

import { type Curve, controlPolygon, pointAt, type Shape, toRelative } from "../geometry/curve";
import type { Point } from "../specification";
import { shapeWithHandle } from "./bend-edge";

/** A handle this near to its chord, as a share of it, straightens the edge. */
const STRAIGHT = 0.004;

/** Handles in cm, in the panel's frame: control points, or the middle of lines and arcs. */
export function bendHandlesOf(curve: Curve): Point[] {
  if (curve.shape === undefined || curve.shape.type === "circle") return [pointAt(curve, 0.5)];
  return controlPolygon(curve).slice(1, -1);
}

/** The shape after a handle has been dragged to a point: a straight edge becomes a curve through it. */
export function bent(curve: Curve, handle: number, to: Point): Shape {
  if (curve.shape !== undefined && curve.shape.type !== "circle") return shapeWithHandle(curve, handle, to);
  const [x, y] = toRelative(to, curve.start, curve.end);
  if (Math.abs(y) < STRAIGHT) return undefined;
  if (curve.shape !== undefined) return shapeWithHandle(curve, handle, to);
  // The quadratic curve that passes the point half-way.
  return { type: "quadratic", params: [[2 * x - 0.5, 2 * y]] };
}

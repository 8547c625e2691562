/** Tight boxes around edges, from their exact extrema. */

import type { Point } from "../specification";
import { at } from "./at";
import { arcOf, type Curve, controlPolygon, hodograph, pointAt } from "./curve";

export interface Box {
  readonly low: Point;
  readonly high: Point;
}

export function curveBox(curve: Curve): Box {
  return boxOf(extrema(curve).map((t) => pointAt(curve, t)));
}

/** The smallest box around points; of none, an empty box at the origin. */
export function boxOf(points: readonly Point[]): Box {
  if (points.length === 0) return { low: [0, 0], high: [0, 0] };
  let [x0, y0] = at(points, 0);
  let [x1, y1] = at(points, 0);
  for (const [x, y] of points) {
    x0 = Math.min(x0, x);
    x1 = Math.max(x1, x);
    y0 = Math.min(y0, y);
    y1 = Math.max(y1, y);
  }
  return { low: [x0, y0], high: [x1, y1] };
}

export function boxAround(boxes: readonly Box[]): Box {
  return boxOf(boxes.flatMap((b) => [b.low, b.high]));
}

export function boxSize(box: Box): Point {
  return [box.high[0] - box.low[0], box.high[1] - box.low[1]];
}

export function boxMiddle(box: Box): Point {
  return [(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2];
}

/** Whether two boxes share more than a border. */
export function boxesOverlap(one: Box, other: Box): boolean {
  return (
    one.low[0] < other.high[0] &&
    other.low[0] < one.high[0] &&
    one.low[1] < other.high[1] &&
    other.low[1] < one.high[1]
  );
}

export function isInBox(point: Point, box: Box): boolean {
  return (
    point[0] >= box.low[0] && point[0] <= box.high[0] && point[1] >= box.low[1] && point[1] <= box.high[1]
  );
}

function extrema(curve: Curve): number[] {
  const { shape, start, end } = curve;
  const found = [0, 1];
  if (shape === undefined) return found;
  if (shape.type === "circle") {
    const arc = arcOf(shape.params, start, end);
    if (arc.sweep === 0) return found;
    for (let quarter = -8; quarter <= 8; quarter++) {
      const t = (quarter * (Math.PI / 2) - arc.startAngle) / arc.sweep;
      if (t > 0 && t < 1) found.push(t);
    }
    return found;
  }
  const speed = hodograph(controlPolygon(curve));
  for (const axis of [0, 1] as const) found.push(...bezierRoots(speed.map((p) => p[axis])));
  return found;
}

/** Roots between 0 and 1 of a Bezier polynomial of degree one or two. */
function bezierRoots(coefficients: readonly number[]): number[] {
  const inside = (t: number) => t > 0 && t < 1;
  if (coefficients.length === 2) {
    const [start, end] = coefficients as [number, number];
    return start === end ? [] : [start / (start - end)].filter(inside);
  }
  const [start, middle, end] = coefficients as [number, number, number];
  // a t^2 - 2 h t + start = 0, solved without cancellation.
  const a = start - 2 * middle + end;
  const h = start - middle;
  const discriminant = h * h - a * start;
  if (discriminant < 0) return [];
  const q = h + (h < 0 ? -1 : 1) * Math.sqrt(discriminant);
  const roots: number[] = [];
  if (a !== 0) roots.push(q / a);
  if (q !== 0) roots.push(start / q);
  return roots.filter(inside);
}

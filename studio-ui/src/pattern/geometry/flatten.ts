/** Polylines close to a curve. */

import type { Point } from "../specification";
import { at } from "./at";
import { arcOf, type Curve, controlPolygon, pointAt } from "./curve";

/** Points within `tolerance` cm of the curve, both ends included. */
export function flattened(curve: Curve, tolerance: number): Point[] {
  const count = segments(curve, tolerance);
  return Array.from({ length: count + 1 }, (_, k) => pointAt(curve, k / count));
}

function segments(curve: Curve, tolerance: number): number {
  const { shape, start, end } = curve;
  if (shape === undefined) return 1;
  let count: number;
  if (shape.type === "circle") {
    const arc = arcOf(shape.params, start, end);
    const step = 2 * Math.acos(Math.max(1 - tolerance / Math.max(arc.radius, tolerance), -1));
    count = Math.ceil(Math.abs(arc.sweep) / Math.max(step, 1e-3));
  } else {
    const control = controlPolygon(curve);
    let bend = 0;
    for (let k = 2; k < control.length; k++)
      for (const axis of [0, 1] as const)
        bend = Math.max(
          bend,
          Math.abs(at(control, k)[axis] - 2 * at(control, k - 1)[axis] + at(control, k - 2)[axis]),
        );
    bend *= (control.length - 1) * (control.length - 2);
    count = Math.ceil(Math.sqrt((bend * Math.SQRT2) / (8 * tolerance)));
  }
  return Math.min(Math.max(count, 2), 2000);
}

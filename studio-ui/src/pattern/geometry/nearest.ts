/** The place on an edge that is nearest to a point. */

import type { Point } from "../specification";
import { type Curve, derivativeAt, pointAt } from "./curve";
import { distance, dot, subtract } from "./point";

export interface Nearest {
  /** Curve parameter, 0 to 1. */
  readonly t: number;
  readonly point: Point;
  readonly distance: number;
}

const SAMPLES = 24;

export function nearestOn(curve: Curve, to: Point): Nearest {
  if (curve.shape === undefined) {
    const d = subtract(curve.end, curve.start);
    const squared = dot(d, d);
    const t = squared === 0 ? 0 : dot(subtract(to, curve.start), d) / squared;
    return at(curve, Math.min(Math.max(t, 0), 1), to);
  }
  let best = at(curve, 0, to);
  for (let k = 1; k <= SAMPLES; k++) {
    const next = at(curve, k / SAMPLES, to);
    if (next.distance < best.distance) best = next;
  }
  // The best sample's neighbours hold the nearest point: where the derivative of the squared distance is zero.
  let low = Math.max(best.t - 1 / SAMPLES, 0);
  let high = Math.min(best.t + 1 / SAMPLES, 1);
  const slope = (t: number) => dot(subtract(pointAt(curve, t), to), derivativeAt(curve, t));
  if (slope(low) > 0) high = low;
  if (slope(high) < 0) low = high;
  while (high - low > 1e-12) {
    const middle = (low + high) / 2;
    if (slope(middle) > 0) high = middle;
    else low = middle;
    if (middle === low && middle === high) break;
  }
  const found = at(curve, (low + high) / 2, to);
  return found.distance < best.distance ? found : best;
}

function at(curve: Curve, t: number, to: Point): Nearest {
  const point = pointAt(curve, t);
  return { t, point, distance: distance(point, to) };
}

/** Arc length of edges, and the parameter at a share of it. */

import type { Point } from "../specification";
import { at } from "./at";
import { arcOf, bezier, type Curve, controlPolygon, hodograph } from "./curve";
import { distance, norm } from "./point";

// Gauss-Legendre rule of eight points on [0, 1].
const NODES = [
  0.019855071751231856, 0.10166676129318664, 0.2372337950418355, 0.4082826787521751, 0.5917173212478249,
  0.7627662049581645, 0.8983332387068134, 0.9801449282487682,
];
const WEIGHTS = [
  0.05061426814518819, 0.11119051722668724, 0.15685332293894363, 0.18134189168918097, 0.18134189168918097,
  0.15685332293894363, 0.11119051722668724, 0.05061426814518819,
];
const TOLERANCE = 1e-11;
const MOST_HALVINGS = 40;

/** Arc length, cm. */
export function curveLength(curve: Curve): number {
  const { shape, start, end } = curve;
  if (shape === undefined) return distance(start, end);
  if (shape.type === "circle") {
    const arc = arcOf(shape.params, start, end);
    return arc.radius * Math.abs(arc.sweep);
  }
  return bezierLength(hodograph(controlPolygon(curve)), 0, 1);
}

/** The parameter at which a share (0 to 1) of the arc length has been travelled. */
export function parameterAtShare(curve: Curve, share: number): number {
  const { shape } = curve;
  if (share <= 0) return 0;
  if (share >= 1) return 1;
  if (shape === undefined || shape.type === "circle") return share;
  const speed = hodograph(controlPolygon(curve));
  const target = share * bezierLength(speed, 0, 1);
  let low = 0;
  let high = 1;
  let t = share;
  for (let round = 0; round < 60; round++) {
    const excess = bezierLength(speed, 0, t) - target;
    if (excess > 0) high = t;
    else low = t;
    const slope = norm(bezier(speed, t));
    const next = slope > 1e-12 ? t - excess / slope : (low + high) / 2;
    // Newton's step, or a halving where it would leave what is known to hold the answer.
    const step = next > low && next < high ? next : (low + high) / 2;
    if (Math.abs(step - t) < 1e-14) return step;
    t = step;
  }
  return t;
}

/** The share of the arc length that has been travelled at a parameter. */
export function shareAtParameter(curve: Curve, t: number): number {
  const { shape } = curve;
  if (shape === undefined || shape.type === "circle") return t;
  const speed = hodograph(controlPolygon(curve));
  const whole = bezierLength(speed, 0, 1);
  return whole === 0 ? t : bezierLength(speed, 0, t) / whole;
}

function bezierLength(speed: readonly Point[], low: number, high: number): number {
  const coarse = gauss(speed, low, high);
  return refined(speed, low, high, coarse, 0);
}

function refined(speed: readonly Point[], low: number, high: number, coarse: number, depth: number): number {
  const middle = (low + high) / 2;
  const first = gauss(speed, low, middle);
  const second = gauss(speed, middle, high);
  if (Math.abs(first + second - coarse) <= TOLERANCE * (1 + coarse) || depth >= MOST_HALVINGS)
    return first + second;
  return refined(speed, low, middle, first, depth + 1) + refined(speed, middle, high, second, depth + 1);
}

function gauss(speed: readonly Point[], low: number, high: number): number {
  let sum = 0;
  for (let k = 0; k < NODES.length; k++)
    sum += at(WEIGHTS, k) * norm(bezier(speed, low + (high - low) * at(NODES, k)));
  return sum * (high - low);
}

/** Arithmetic on points and vectors of the plane, cm. */

import type { Point } from "../specification";

export function add(a: Point, b: Point): Point {
  return [a[0] + b[0], a[1] + b[1]];
}

export function subtract(a: Point, b: Point): Point {
  return [a[0] - b[0], a[1] - b[1]];
}

export function scaled(a: Point, factor: number): Point {
  return [a[0] * factor, a[1] * factor];
}

export function between(a: Point, b: Point, share: number): Point {
  return [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share];
}

export function dot(a: Point, b: Point): number {
  return a[0] * b[0] + a[1] * b[1];
}

/** Positive where b lies to the left of a. */
export function cross(a: Point, b: Point): number {
  return a[0] * b[1] - a[1] * b[0];
}

export function norm(a: Point): number {
  return Math.hypot(a[0], a[1]);
}

export function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/** A vector turned by a quarter to the left. */
export function leftOf(a: Point): Point {
  return [-a[1], a[0]];
}

/** The vector of length one; zero stays zero. */
export function unit(a: Point): Point {
  const length = norm(a);
  return length === 0 ? [0, 0] : [a[0] / length, a[1] / length];
}

export function turned(a: Point, radians: number): Point {
  const c = Math.cos(radians);
  const s = Math.sin(radians);
  return [a[0] * c - a[1] * s, a[0] * s + a[1] * c];
}

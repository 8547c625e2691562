/**
 * Exact geometry of the four edge shapes: line, quadratic, cubic, circular arc.
 *
 * The same conventions as the Python package (swifttailor.pattern.curve), whose numbers these functions are
 * tested against: control points are relative to the chord, (0, 0) its start, (1, 0) its end and +y to the
 * left of travel; an arc keeps its radius in cm. Parameters run from 0 to 1.
 */

import type { Curvature, Point } from "../specification";
import { at } from "./at";
import { add, between, cross, distance, dot, leftOf, scaled, subtract } from "./point";

export type Shape = Curvature | undefined;

/** An edge's shape over its end points. */
export interface Curve {
  readonly shape: Shape;
  readonly start: Point;
  readonly end: Point;
}

export function toRelative(point: Point, start: Point, end: Point): Point {
  const d = subtract(end, start);
  const v = subtract(point, start);
  const squared = dot(d, d);
  return squared === 0 ? [0, 0] : [dot(v, d) / squared, cross(d, v) / squared];
}

export function toAbsolute(relative: Point, start: Point, end: Point): Point {
  const d = subtract(end, start);
  return add(start, add(scaled(d, relative[0]), scaled(leftOf(d), relative[1])));
}

/** Control points in cm, the end points included; of a line, only these. */
export function controlPolygon(curve: Curve): Point[] {
  const { shape, start, end } = curve;
  if (shape === undefined || shape.type === "circle") return [start, end];
  return [start, ...shape.params.map((p) => toAbsolute(p, start, end)), end];
}

export interface Arc {
  readonly center: Point;
  readonly radius: number;
  readonly startAngle: number;
  /** Radians, positive anticlockwise. */
  readonly sweep: number;
}

/** The circle of an arc; a radius that cannot span the chord counts as half of it. */
export function arcOf(params: readonly [number, number, number], start: Point, end: Point): Arc {
  const [given, large, right] = params;
  const d = subtract(end, start);
  const chord = Math.hypot(d[0], d[1]);
  if (chord === 0) return { center: start, radius: given, startAngle: 0, sweep: 0 };
  const radius = Math.max(given, chord / 2);
  const height = Math.sqrt(Math.max(radius * radius - (chord * chord) / 4, 0));
  const side = Boolean(right) !== Boolean(large) ? 1 : -1;
  const center = add(between(start, end, 0.5), scaled(leftOf(d), (side * height) / chord));
  const half = Math.asin(Math.min(1, chord / (2 * radius)));
  const sweep = 2 * (large ? Math.PI - half : half);
  const offset = subtract(start, center);
  return {
    center,
    radius,
    startAngle: Math.atan2(offset[1], offset[0]),
    sweep: right ? sweep : -sweep,
  };
}

/** The point at a parameter; 0 and 1 give the end points exactly. */
export function pointAt(curve: Curve, t: number): Point {
  if (t === 0) return curve.start;
  if (t === 1) return curve.end;
  const { shape, start, end } = curve;
  if (shape === undefined) return between(start, end, t);
  if (shape.type === "circle") {
    const arc = arcOf(shape.params, start, end);
    const angle = arc.startAngle + arc.sweep * t;
    return add(arc.center, [arc.radius * Math.cos(angle), arc.radius * Math.sin(angle)]);
  }
  return bezier(controlPolygon(curve), t);
}

/** First derivative by the parameter, cm. */
export function derivativeAt(curve: Curve, t: number): Point {
  const { shape, start, end } = curve;
  if (shape === undefined) return subtract(end, start);
  if (shape.type === "circle") {
    const arc = arcOf(shape.params, start, end);
    const angle = arc.startAngle + arc.sweep * t;
    const speed = arc.radius * arc.sweep;
    return [-Math.sin(angle) * speed, Math.cos(angle) * speed];
  }
  return bezier(hodograph(controlPolygon(curve)), t);
}

/** Control points of a Bezier curve's derivative. */
export function hodograph(control: readonly Point[]): Point[] {
  const degree = control.length - 1;
  return control.slice(1).map((p, k) => scaled(subtract(p, at(control, k)), degree));
}

export function bezier(control: readonly Point[], t: number): Point {
  let layer = control;
  while (layer.length > 1) {
    const below = layer;
    layer = below.slice(1).map((p, k) => {
      const q = at(below, k);
      return [(1 - t) * q[0] + t * p[0], (1 - t) * q[1] + t * p[1]] as Point;
    });
  }
  return at(layer, 0);
}

/** The same line travelled from end to start. */
export function reversedShape(shape: Shape): Shape {
  if (shape === undefined) return undefined;
  if (shape.type === "quadratic") return { type: "quadratic", params: [turnRound(shape.params[0])] };
  if (shape.type === "cubic")
    return { type: "cubic", params: [turnRound(shape.params[1]), turnRound(shape.params[0])] };
  const [radius, large, right] = shape.params;
  return { type: "circle", params: [radius, large, right ? 0 : 1] };
}

/** The shape after its end points have been reflected in any line. */
export function mirroredShape(shape: Shape): Shape {
  if (shape === undefined) return undefined;
  if (shape.type === "quadratic") return { type: "quadratic", params: [acrossChord(shape.params[0])] };
  if (shape.type === "cubic")
    return { type: "cubic", params: [acrossChord(shape.params[0]), acrossChord(shape.params[1])] };
  const [radius, large, right] = shape.params;
  return { type: "circle", params: [radius, large, right ? 0 : 1] };
}

/** The shape after its chord has grown by a factor: only the radius of arcs has to follow. */
export function scaledShape(shape: Shape, factor: number): Shape {
  if (shape?.type !== "circle") return shape;
  const [radius, large, right] = shape.params;
  return { type: "circle", params: [radius * factor, large, right] };
}

/** Shape from control points in cm, end points included: two give a line. */
export function shapeFromControl(control: readonly Point[]): Shape {
  const start = at(control, 0);
  const end = at(control, control.length - 1);
  if (control.length === 2) return undefined;
  if (control.length === 3) return { type: "quadratic", params: [toRelative(at(control, 1), start, end)] };
  return {
    type: "cubic",
    params: [toRelative(at(control, 1), start, end), toRelative(at(control, 2), start, end)],
  };
}

export interface Halves {
  readonly first: Shape;
  readonly second: Shape;
  readonly point: Point;
}

/** Cuts a curve at a parameter between 0 and 1 into two that trace exactly the same points. */
export function splitAt(curve: Curve, t: number): Halves {
  const { shape, start, end } = curve;
  const point = pointAt(curve, t);
  if (shape === undefined) return { first: undefined, second: undefined, point };
  if (shape.type === "circle") {
    const arc = arcOf(shape.params, start, end);
    const radius = Math.max(arc.radius, shape.params[0]);
    const right = shape.params[2];
    const sweep = Math.abs(arc.sweep);
    const piece = (share: number): Shape => ({
      type: "circle",
      params: [radius, sweep * share > Math.PI ? 1 : 0, right],
    });
    return { first: piece(t), second: piece(1 - t), point };
  }
  const left: Point[] = [];
  const right: Point[] = [];
  let layer = controlPolygon(curve);
  while (layer.length > 0) {
    left.push(at(layer, 0));
    right.unshift(at(layer, layer.length - 1));
    const below = layer;
    layer = below.slice(1).map((p, k) => between(at(below, k), p, t));
  }
  return { first: shapeFromControl(left), second: shapeFromControl(right), point };
}

/** How far the middle of an edge stands off its chord, as a share of the chord, positive to the left. */
export function bulge(curve: Curve): number {
  return toRelative(pointAt(curve, 0.5), curve.start, curve.end)[1];
}

export function chordLength(curve: Curve): number {
  return distance(curve.start, curve.end);
}

function turnRound(p: Point): Point {
  return [1 - p[0], -p[1]];
}

function acrossChord(p: Point): Point {
  return [p[0], -p[1]];
}

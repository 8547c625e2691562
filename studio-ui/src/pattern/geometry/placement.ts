/** Where a flat panel stands in the world before it is sewn. Angles are read as R = Rx Ry Rz. */

import type { Panel, Point } from "../specification";

export type Vector = readonly [number, number, number];

/** The panel's local x and y axes in the world. */
export interface Axes {
  readonly x: Vector;
  readonly y: Vector;
}

export function axesOf(panel: Panel): Axes {
  const [a, b, c] = panel.rotation.map((degrees) => (degrees * Math.PI) / 180) as [number, number, number];
  const [ca, sa, cb, sb, cc, sc] = [
    Math.cos(a),
    Math.sin(a),
    Math.cos(b),
    Math.sin(b),
    Math.cos(c),
    Math.sin(c),
  ];
  return {
    x: [cb * cc, ca * sc + sa * sb * cc, sa * sc - ca * sb * cc],
    y: [-cb * sc, ca * cc - sa * sb * sc, sa * cc + ca * sb * sc],
  };
}

/** A direction in the panel's plane, in the world. */
export function directionInWorld(axes: Axes, direction: Point): Vector {
  return [
    axes.x[0] * direction[0] + axes.y[0] * direction[1],
    axes.x[1] * direction[0] + axes.y[1] * direction[1],
    axes.x[2] * direction[0] + axes.y[2] * direction[1],
  ];
}

export function pointInWorld(panel: Panel, axes: Axes, point: Point): Vector {
  const [x, y, z] = directionInWorld(axes, point);
  const [tx, ty, tz] = panel.translation;
  return [x + tx, y + ty, z + tz];
}

/** The part of a direction of the world that lies in the panel's plane, in its frame. */
export function directionInPanel(axes: Axes, direction: Vector): Point {
  return [inner(axes.x, direction), inner(axes.y, direction)];
}

export function inner(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function gap(a: Vector, b: Vector): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** Pulls a dragged point to what it probably was meant for, and says to what. */

import { add, distance, scaled, subtract, unit } from "../geometry/point";
import type { Point } from "../specification";

/** A line that shows what a point has snapped to, in the panel's frame, cm. */
export interface Guide {
  readonly panel: string;
  readonly from: Point;
  readonly to: Point;
  readonly label: string;
}

export interface SnapTargets {
  /** Other points of the panel, which the dragged one may be level with or above. */
  readonly points: readonly Point[];
  /** Where the drag began: straight across and straight up from it. */
  readonly origin: Point;
  /** Circles on which an edge to the dragged point is as long as its seam's partner. */
  readonly circles: readonly { readonly center: Point; readonly radius: number; readonly label: string }[];
  /** Distance of the grid's lines, cm; 0: none. */
  readonly grid: number;
}

export interface Snapped {
  readonly point: Point;
  readonly guides: readonly Omit<Guide, "panel">[];
}

/** Snaps a point within `reach` cm: to its start, to equal lengths, to the level of other points, to the grid. */
export function snapPoint(point: Point, targets: SnapTargets, reach: number): Snapped {
  // Back where it was: the hand has thought better of it.
  if (distance(point, targets.origin) <= reach / 2) return { point: targets.origin, guides: [] };
  for (const { center, radius, label } of targets.circles) {
    const away = subtract(point, center);
    if (Math.abs(Math.hypot(...away) - radius) > reach || radius === 0) continue;
    const on = add(center, scaled(unit(away), radius));
    return { point: on, guides: [{ from: center, to: on, label }] };
  }
  const guides: Omit<Guide, "panel">[] = [];
  const found: [number, number] = [point[0], point[1]];
  for (const axis of [0, 1] as const) {
    const level = nearestOnAxis(point, targets, axis, reach);
    if (level !== null) {
      found[axis] = level.place[axis];
      guides.push({ from: level.place, to: point, label: level.label });
    } else if (targets.grid > 0) {
      const line = Math.round(point[axis] / targets.grid) * targets.grid;
      if (Math.abs(line - point[axis]) <= reach) found[axis] = line;
    }
  }
  const snapped: Point = [found[0], found[1]];
  return { point: snapped, guides: guides.map((guide) => ({ ...guide, to: snapped })) };
}

function nearestOnAxis(point: Point, targets: SnapTargets, axis: 0 | 1, reach: number) {
  let best: { place: Point; label: string; off: number } | null = null;
  const candidates = [
    ...targets.points.map((place) => ({ place, label: axis === 0 ? "above a point" : "level with a point" })),
    { place: targets.origin, label: axis === 0 ? "straight up" : "straight across" },
  ];
  for (const { place, label } of candidates) {
    const off = Math.abs(place[axis] - point[axis]);
    if (off <= reach && (best === null || off < best.off)) best = { place, label, off };
  }
  return best;
}

/** Snaps a shift: along one axis where the other is nearly none, and to steps of the grid. */
export function snapShift(shift: Point, grid: number, reach: number): Snapped {
  const straight = Math.abs(shift[0]) <= reach ? 0 : Math.abs(shift[1]) <= reach ? 1 : null;
  const stepped = shift.map((value, axis) => {
    if (axis === straight) return 0;
    if (grid === 0) return value;
    const line = Math.round(value / grid) * grid;
    return Math.abs(line - value) <= reach ? line : value;
  }) as unknown as Point;
  const guides =
    straight === null || distance(stepped, [0, 0]) === 0
      ? []
      : [{ from: [0, 0] as Point, to: stepped, label: straight === 0 ? "straight up" : "straight across" }];
  return { point: stepped, guides };
}

/** A length snapped to steps. */
export function snapLength(length: number, grid: number, reach: number): number {
  const line = grid === 0 ? length : Math.round(length / grid) * grid;
  return Math.abs(line - length) <= reach ? line : length;
}

/**
 * Where each panel lies in the pattern window. It is no part of the pattern: the garment does not change with it.
 *
 * A place is that of the panel's own origin on the sheet, so that an edit of its outline moves nothing else.
 */

import { at } from "../geometry/at";
import { type Box, boxAround, boxesOverlap, boxMiddle, boxOf } from "../geometry/bounds";
import { outlineOf, panelBox } from "../geometry/outline";
import { add, subtract, turned } from "../geometry/point";
import { type Panel, type Point, panelNames, panelOf, type Specification } from "../specification";
import { placePanel } from "./placing";
import { shelves } from "./shelves";

export interface Place {
  /** Of the panel's origin on the sheet, cm, y up. */
  readonly at: Point;
  /** Degrees anticlockwise. */
  readonly angle: number;
  /** Turned over, so that the right side of the cloth is seen. */
  readonly mirrored: boolean;
}

export type Arrangement = Readonly<Record<string, Place>>;

const FONT = 2;
const GAP = 5;

/** An arrangement from a saved file; null where it is none. */
export function arrangementOf(saved: unknown): Arrangement | null {
  if (typeof saved !== "object" || saved === null || Array.isArray(saved)) return null;
  const whole = Object.values(saved as Record<string, Partial<Place> | null>).every(
    (place) =>
      place !== null &&
      Array.isArray(place.at) &&
      place.at.length === 2 &&
      place.at.every(Number.isFinite) &&
      Number.isFinite(place.angle) &&
      typeof place.mirrored === "boolean",
  );
  return whole ? (saved as Arrangement) : null;
}

/** All panels side by side on a sheet whose upper left corner is the origin; `aspect`: its width over its height. */
export function arranged(specification: Specification, aspect: number | null = null): Arrangement {
  const names = panelNames(specification);
  const placed = names.map((name) => placePanel(name, panelOf(specification, name), FONT));
  const { corners } = shelves(
    placed.map((p) => p.size),
    GAP,
    aspect,
  );
  return Object.fromEntries(
    names.map((name, k) => {
      const { low, size, mirrored } = at(placed, k);
      const [x, y] = at(corners, k);
      return [name, { at: [x - low[0], -y - size[1] - low[1]] as Point, angle: 0, mirrored }];
    }),
  );
}

/**
 * The arrangement for another state of the pattern: panels that are known stay exactly where they are, renamed
 * ones too, and new ones go below. Where most of the panels are new, all are arranged anew.
 */
export function kept(
  arrangement: Arrangement,
  before: Specification,
  after: Specification,
  aspect: number | null = null,
): Arrangement {
  const names = panelNames(after);
  const renamed = renamedPanel(before, after);
  const known = (name: string): Place | undefined =>
    arrangement[name] ?? (renamed?.to === name ? arrangement[renamed.from] : undefined);
  const missing = names.filter((name) => known(name) === undefined);
  const gone = panelNames(before).length - (names.length - missing.length);
  if (missing.length === 0 && gone === 0 && renamed === null) return arrangement;
  if (2 * missing.length > names.length) return arranged(after, aspect);
  const places: Record<string, Place> = {};
  for (const name of names) {
    const place = known(name);
    if (place !== undefined) places[name] = place;
  }
  if (missing.length === 0) return places;
  const taken = boxAround(Object.entries(places).map(([name, p]) => boxOnSheet(panelOf(after, name), p)));
  let x = taken.low[0];
  for (const name of missing) {
    const { low, size, mirrored } = placePanel(name, panelOf(after, name), FONT);
    places[name] = { at: [x - low[0], taken.low[1] - GAP - size[1] - low[1]], angle: 0, mirrored };
    x += size[0] + GAP;
  }
  return places;
}

function renamedPanel(before: Specification, after: Specification): { from: string; to: string } | null {
  const [old, now] = [panelNames(before), panelNames(after)];
  const from = old.filter((name) => !Object.hasOwn(after.pattern.panels, name));
  const to = now.filter((name) => !Object.hasOwn(before.pattern.panels, name));
  if (from.length !== 1 || to.length !== 1) return null;
  const [one, other] = [at(from, 0), at(to, 0)];
  return panelOf(before, one) === panelOf(after, other) ? { from: one, to: other } : null;
}

export function moved(arrangement: Arrangement, panels: Iterable<string>, by: Point): Arrangement {
  const places: Record<string, Place> = { ...arrangement };
  for (const name of panels) {
    const place = arrangement[name];
    if (place !== undefined) places[name] = { ...place, at: add(place.at, by) };
  }
  return places;
}

/** Turns a panel about the middle of its box, degrees anticlockwise. */
export function rotated(arrangement: Arrangement, name: string, panel: Panel, degrees: number): Arrangement {
  const place = arrangement[name];
  if (place === undefined) return arrangement;
  const middle = boxMiddle(panelBox(panel));
  const angle = (((place.angle + degrees) % 360) + 360) % 360;
  const after: Place = { ...place, angle };
  const drift = subtract(toSheet(place, middle), toSheet(after, middle));
  return { ...arrangement, [name]: { ...after, at: add(after.at, drift) } };
}

/** A point of the panel's frame on the sheet. */
export function toSheet(place: Place, point: Point): Point {
  return add(place.at, directionToSheet(place, point));
}

export function toPanel(place: Place, point: Point): Point {
  return directionToPanel(place, subtract(point, place.at));
}

export function directionToSheet(place: Place, direction: Point): Point {
  const flipped: Point = place.mirrored ? [-direction[0], direction[1]] : direction;
  return place.angle === 0 ? flipped : turned(flipped, (place.angle * Math.PI) / 180);
}

export function directionToPanel(place: Place, direction: Point): Point {
  const [x, y] = place.angle === 0 ? direction : turned(direction, (-place.angle * Math.PI) / 180);
  return place.mirrored ? [-x, y] : [x, y];
}

export function boxOnSheet(panel: Panel, place: Place): Box {
  if (place.angle % 90 !== 0) return boxOf(outlineOf(panel, 0.1).map((p) => toSheet(place, p)));
  const { low, high } = panelBox(panel);
  const corners: Point[] = [low, high, [low[0], high[1]], [high[0], low[1]]];
  return boxOf(corners.map((p) => toSheet(place, p)));
}

export function boxOfAll(specification: Specification, arrangement: Arrangement): Box {
  return boxAround(
    panelNames(specification).flatMap((name) => {
      const place = arrangement[name];
      return place === undefined ? [] : [boxOnSheet(panelOf(specification, name), place)];
    }),
  );
}

/** Whether any two panels lie on each other. */
export function hasOverlaps(specification: Specification, arrangement: Arrangement): boolean {
  const boxes = panelNames(specification).flatMap((name) => {
    const place = arrangement[name];
    return place === undefined ? [] : [boxOnSheet(panelOf(specification, name), place)];
  });
  return boxes.some((one, k) => boxes.slice(k + 1).some((other) => boxesOverlap(one, other)));
}

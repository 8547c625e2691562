/** Which panel, and which of its points, lies on the body's other side. */

import { at } from "../geometry/at";
import { pointAt } from "../geometry/curve";
import { curveOf, signedArea } from "../geometry/outline";
import { axesOf, gap, pointInWorld, type Vector } from "../geometry/placement";
import { add, cross, distance, dot, scaled, subtract } from "../geometry/point";
import { type Panel, type Point, panelNames, panelOf, type Specification } from "../specification";

/** Sides that differ by more are not meant to be alike, cm (as in swifttailor.pattern.tidying). */
const ALIKE_CM = 6;
/** Ways to lay one outline on another that fit equally well to this much are told apart by their place, cm. */
const AS_GOOD_CM = 0.5;
/** Without a name that says so, a counterpart stands no farther from the mirrored place than this, cm. */
const NEAR_CM = 15;
const STRAIGHT = 1e-7;

export interface Counterpart {
  /** Its name; the panel's own where it is symmetric itself. */
  readonly panel: string;
  /** The vertex that mirrors one of the panel's. */
  readonly vertex: (vertex: number) => number;
  readonly edge: (edge: number) => number;
  /** A shift in the panel's frame, as it is in the counterpart's. */
  readonly shift: (by: Point) => Point;
  /** Whether shapes are reflected on the way; they are in all but oddly wound patterns. */
  readonly reflects: boolean;
  /** The farthest that mirrored points are from each other, cm. */
  readonly deviation: number;
}

const known = new WeakMap<Specification, Map<string, Counterpart | null>>();

/** The counterpart of a panel; null where there is none. Remembered for as long as the pattern is. */
export function counterpartOf(specification: Specification, name: string): Counterpart | null {
  const own = known.get(specification) ?? new Map<string, Counterpart | null>();
  known.set(specification, own);
  let found = own.get(name);
  if (found === undefined) {
    found = sought(specification, name);
    own.set(name, found);
  }
  return found;
}

function sought(specification: Specification, name: string): Counterpart | null {
  const panel = panelOf(specification, name);
  const twin = twinName(name, (other) => Object.hasOwn(specification.pattern.panels, other));
  if (twin !== null) return laidOn(panel, panelOf(specification, twin), twin)?.counterpart ?? null;
  if (SIDE.test(name)) return null;
  const best = nearest(specification, name);
  if (best === null || best.counterpart.panel === name) return best?.counterpart ?? null;
  // Gores stand all around: two are counterparts only if each is the other's.
  const back = nearest(specification, best.counterpart.panel);
  return back?.counterpart.panel === name ? best.counterpart : null;
}

/** The panel that stands nearest to the mirrored place of one and has its outline; it may be the panel itself. */
function nearest(specification: Specification, name: string): Laid | null {
  const panel = panelOf(specification, name);
  let best: Laid | null = null;
  for (const other of panelNames(specification)) {
    const laid = laidOn(panel, panelOf(specification, other), other);
    if (laid === null || laid.apart > NEAR_CM) continue;
    if (best === null || laid.apart + laid.counterpart.deviation < best.apart + best.counterpart.deviation)
      best = laid;
  }
  return best;
}

const SIDE = /(^|[^a-z])(left|right|l|r)(?=[^a-z]|$)/i;
const OTHER: Readonly<Record<string, string>> = { left: "right", right: "left", l: "r", r: "l" };

/** The name with "left" and "right", or "l" and "r", exchanged, if there is such a panel. */
export function twinName(name: string, exists: (name: string) => boolean): string | null {
  const other = name.replace(
    SIDE,
    (_, before: string, side: string) => before + inCaseOf(side, OTHER[side.toLowerCase()] ?? side),
  );
  return other !== name && exists(other) ? other : null;
}

function inCaseOf(model: string, word: string): string {
  if (model === model.toUpperCase()) return word.toUpperCase();
  return at([...model], 0) === at([...model], 0).toUpperCase()
    ? word.charAt(0).toUpperCase() + word.slice(1)
    : word;
}

interface Laid {
  readonly counterpart: Counterpart;
  /** Mean distance in the world from the mirrored panel, cm. */
  readonly apart: number;
}

/** How a panel, mirrored, lies best on another; null where it does not. */
function laidOn(panel: Panel, other: Panel, name: string): Laid | null {
  const count = panel.vertices.length;
  if (other.vertices.length !== count) return null;
  const reflects = signedArea(panel) * signedArea(other) > 0;
  const [mine, theirs] = [samples(panel), samples(other)];
  const mirrored = inWorld(panel, mine.vertices).map(([x, y, z]): Vector => [-x, y, z]);
  const places = inWorld(other, theirs.vertices);
  const found: Laid[] = [];
  for (let turn = 0; turn < count; turn++) {
    // Both loops run around the outside, so a mirrored one runs the other way.
    const vertex = (k: number) => (turn - k + 2 * count) % count;
    const edge = (k: number) => (turn - 1 - k + 2 * count) % count;
    if (panel.edges.some((e, k) => e.curvature?.type !== at(other.edges, edge(k)).curvature?.type)) continue;
    const from = [...mine.vertices, ...mine.middles];
    const to = [
      ...mine.vertices.map((_, k) => at(theirs.vertices, vertex(k))),
      ...mine.middles.map((_, k) => at(theirs.middles, edge(k))),
    ];
    const { linear, deviation } = motion(from, to, reflects);
    if (deviation > ALIKE_CM) continue;
    const apart = mirrored.reduce((sum, p, k) => sum + gap(p, at(places, vertex(k))), 0) / count;
    const shift = ([x, y]: Point): Point => [linear[0] * x + linear[1] * y, linear[2] * x + linear[3] * y];
    found.push({ counterpart: { panel: name, vertex, edge, shift, reflects, deviation }, apart });
  }
  if (found.length === 0) return null;
  const least = Math.min(...found.map((laid) => laid.counterpart.deviation));
  const good = found.filter((laid) => laid.counterpart.deviation <= least + AS_GOOD_CM);
  return good.reduce((best, laid) => (laid.apart < best.apart - 1e-9 ? laid : best));
}

function samples(panel: Panel): { vertices: readonly Point[]; middles: readonly Point[] } {
  return { vertices: panel.vertices, middles: panel.edges.map((_, k) => pointAt(curveOf(panel, k), 0.5)) };
}

function inWorld(panel: Panel, points: readonly Point[]): Vector[] {
  const axes = axesOf(panel);
  return points.map((p) => pointInWorld(panel, axes, p));
}

type Linear = readonly [number, number, number, number];

/** The motion of the plane that takes points nearest to others: its linear part, rows, and what is left. */
function motion(from: readonly Point[], to: readonly Point[], reflects: boolean) {
  const [a, b] = [middle(from), middle(to)];
  const flipped = from.map((p): Point => {
    const [x, y] = subtract(p, a);
    return reflects ? [-x, y] : [x, y];
  });
  const goal = to.map((p) => subtract(p, b));
  let [along, across] = [0, 0];
  for (const [k, p] of flipped.entries()) {
    along += dot(p, at(goal, k));
    across += cross(p, at(goal, k));
  }
  const angle = Math.atan2(across, along);
  const quarter = Math.round(angle / (Math.PI / 2)) * (Math.PI / 2);
  const snapped = Math.abs(angle - quarter) < STRAIGHT ? quarter : angle;
  const [c, s] = [exact(Math.cos(snapped)), exact(Math.sin(snapped))];
  const sign = reflects ? -1 : 1;
  const linear: Linear = [sign * c + 0, -s + 0, sign * s + 0, c];
  const deviation = Math.max(
    ...flipped.map(([x, y], k) => distance([c * x - s * y, s * x + c * y], at(goal, k))),
  );
  return { linear, deviation };
}

function exact(value: number): number {
  const whole = Math.round(value);
  return (Math.abs(value - whole) < 1e-12 ? whole : value) + 0;
}

function middle(points: readonly Point[]): Point {
  return scaled(
    points.reduce((sum, p) => add(sum, p), [0, 0] as Point),
    1 / points.length,
  );
}

/** How the edges of each panel are marked: the seam's number, and how much longer one side of it is. */

import { at } from "../geometry/at";
import { edgeLength, edgeLengths } from "../geometry/outline";
import { type EdgeRef, panelNames, panelOf, type Specification } from "../specification";

export interface EdgeMark {
  /** Number of the stitch; -1: a free edge. */
  readonly seam: number;
  /** How much longer this edge is than its partner, cm; 0 where it is the shorter, or as long. */
  readonly longer: number;
  readonly length: number;
  /** A seam of two neighbouring edges of one panel. */
  readonly dart: boolean;
}

/** Differences below this are no more than cutting is off by, cm. */
export const SEEN_CM = 0.15;

const FREE = -1;

/** Marks by panel. A panel's list is the same object as before where nothing in it differs. */
export function seamMarks(
  specification: Specification,
  before: ReadonlyMap<string, readonly EdgeMark[]>,
): ReadonlyMap<string, readonly EdgeMark[]> {
  const seams = new Map<string, number[]>();
  const longer = new Map<string, number[]>();
  const darts = new Map<string, boolean[]>();
  for (const name of panelNames(specification)) {
    const count = panelOf(specification, name).edges.length;
    seams.set(name, Array(count).fill(FREE));
    longer.set(name, Array(count).fill(0));
    darts.set(name, Array(count).fill(false));
  }
  specification.pattern.stitches.forEach(([one, other], number) => {
    const difference = edgeLength(specification, one) - edgeLength(specification, other);
    const dart = isDart(specification, one, other);
    for (const [ref, more] of [
      [one, difference],
      [other, -difference],
    ] as const) {
      put(seams, ref, number);
      put(longer, ref, more >= SEEN_CM ? more : 0);
      put(darts, ref, dart);
    }
  });
  const marks = new Map<string, readonly EdgeMark[]>();
  for (const name of panelNames(specification)) {
    const now = edgeLengths(panelOf(specification, name)).map((length, k) => ({
      seam: at(seams.get(name) ?? [], k),
      longer: at(longer.get(name) ?? [], k),
      length,
      dart: at(darts.get(name) ?? [], k),
    }));
    const known = before.get(name);
    marks.set(name, known !== undefined && same(known, now) ? known : now);
  }
  return marks;
}

function put<T>(lists: Map<string, T[]>, ref: EdgeRef, value: T): void {
  const list = lists.get(ref.panel);
  if (list !== undefined && ref.edge < list.length) list[ref.edge] = value;
}

function isDart(specification: Specification, one: EdgeRef, other: EdgeRef): boolean {
  if (one.panel !== other.panel) return false;
  const count = panelOf(specification, one.panel).edges.length;
  const apart = (one.edge - other.edge + count) % count;
  return apart === 1 || apart === count - 1;
}

function same(one: readonly EdgeMark[], other: readonly EdgeMark[]): boolean {
  return (
    one.length === other.length &&
    one.every((mark, k) => {
      const b = at(other, k);
      return (
        mark.seam === b.seam && mark.longer === b.longer && mark.length === b.length && mark.dart === b.dart
      );
    })
  );
}

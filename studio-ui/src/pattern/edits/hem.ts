/** Hems: the free border of a garment that one free edge belongs to, on all panels that it runs across. */

import { at } from "../geometry/at";
import { derivativeAt } from "../geometry/curve";
import { curveOf, edgeLengths, signedArea } from "../geometry/outline";
import { axesOf, directionInPanel, directionInWorld, inner, type Vector } from "../geometry/placement";
import { leftOf, norm, scaled, subtract, unit } from "../geometry/point";
import {
  type EdgeRef,
  isRightWrong,
  type Point,
  panelOf,
  partnerIn,
  type Specification,
  stitchOf,
} from "../specification";
import type { Moves } from "./move-vertices";

/** Border that points elsewhere by more than this (cosine) is no longer the hem but a slit or a front edge. */
const ALIKE = 0.7;
/** A hem that points down but for so much (cosine) is moved straight down. */
const UPRIGHT = 0.8;
const LONGEST_WALK = 2000;

export interface Hem {
  readonly edges: readonly EdgeRef[];
  /** Unit vector of the world along which the hem gets longer. */
  readonly outward: Vector;
}

/** The hem that a free edge belongs to; null for a sewn edge. */
export function hemOf(specification: Specification, ref: EdgeRef): Hem | null {
  if (stitchOf(specification, ref) >= 0) return null;
  const outward = upright(outwardOf(specification, ref));
  const border = borderOf(specification, ref);
  const edges = border.filter((each) => inner(outwardOf(specification, each), outward) > ALIKE);
  return { edges: edges.length === 0 ? [ref] : edges, outward };
}

/** Moves of all vertices of a hem, by so many cm outward. */
export function movesOfHem(specification: Specification, hem: Hem, by: number): Moves {
  const moves = new Map<string, Map<number, Point>>();
  for (const { panel: name, edge } of hem.edges) {
    const panel = panelOf(specification, name);
    const along = unit(directionInPanel(axesOf(panel), hem.outward));
    const own = moves.get(name) ?? new Map<number, Point>();
    for (const vertex of [edge, (edge + 1) % panel.vertices.length]) own.set(vertex, scaled(along, by));
    moves.set(name, own);
  }
  return moves;
}

/** How far outward a shift in a panel's frame goes. */
export function outwardShare(specification: Specification, hem: Hem, panel: string, by: Point): number {
  return inner(directionInWorld(axesOf(panelOf(specification, panel)), by), hem.outward);
}

/** All free edges in the order in which the garment's border runs through them, from one on. */
function borderOf(specification: Specification, ref: EdgeRef): EdgeRef[] {
  const found = [ref];
  let from = ref;
  for (let walked = 0; walked < LONGEST_WALK; walked++) {
    const next = nextFree(specification, from);
    if (next === null || (next.panel === ref.panel && next.edge === ref.edge)) return found;
    if (found.some((each) => each.panel === next.panel && each.edge === next.edge)) return found;
    found.push(next);
    from = next;
  }
  return found;
}

/** The free edge after the end of one: on the same panel, or across the seams that meet there. */
function nextFree(specification: Specification, ref: EdgeRef): EdgeRef | null {
  let edge = after(specification, ref);
  for (let turns = 0; turns < LONGEST_WALK; turns++) {
    const number = stitchOf(specification, edge);
    if (number < 0) return edge;
    const stitch = at(specification.pattern.stitches, number);
    if (isRightWrong(stitch)) return null;
    // The start of this edge meets the end of its partner.
    edge = after(specification, partnerIn(stitch, edge));
  }
  return null;
}

function after(specification: Specification, ref: EdgeRef): EdgeRef {
  const count = panelOf(specification, ref.panel).edges.length;
  return { panel: ref.panel, edge: (ref.edge + 1) % count };
}

/** Unit vector of the world out of a panel across an edge. */
export function outwardOf(specification: Specification, ref: EdgeRef): Vector {
  const panel = panelOf(specification, ref.panel);
  return directionInWorld(axesOf(panel), outwardInPanel(panel, ref.edge));
}

/** Unit vector out of a panel across an edge, in its own frame. */
export function outwardInPanel(panel: ReturnType<typeof panelOf>, edge: number): Point {
  const curve = curveOf(panel, edge);
  const chord = subtract(curve.end, curve.start);
  const along = norm(chord) > 1e-9 ? chord : derivativeAt(curve, 0.5);
  return unit(scaled(leftOf(along), signedArea(panel) >= 0 ? -1 : 1));
}

function upright(direction: Vector): Vector {
  if (Math.abs(direction[1]) < UPRIGHT) return direction;
  return [0, Math.sign(direction[1]), 0];
}

/** Length of a hem over all panels, cm. */
export function hemLength(specification: Specification, hem: Hem): number {
  return hem.edges.reduce(
    (sum, { panel, edge }) => sum + at(edgeLengths(panelOf(specification, panel)), edge),
    0,
  );
}

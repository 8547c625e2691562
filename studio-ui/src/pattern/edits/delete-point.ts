/** Deletes a point: its two edges become one. */

import { at } from "../geometry/at";
import {
  arcOf,
  type Curve,
  chordLength,
  derivativeAt,
  type Shape,
  shapeFromControl,
} from "../geometry/curve";
import { curveOf, edgeLengths } from "../geometry/outline";
import { add, between, cross, distance, dot, norm, scaled, subtract } from "../geometry/point";
import {
  type Edge,
  type EdgeRef,
  isRightWrong,
  panelOf,
  partnerIn,
  type Specification,
  type Stitch,
  sameVertex,
  stitchOf,
  type VertexRef,
} from "../specification";
import { inLoop } from "./add-point";
import {
  type Edit,
  edited,
  followedBy,
  refused,
  renumbered,
  withoutStitch,
  withPanels,
  withStitches,
} from "./edit";
import { SHORTEST_EDGE_CM } from "./move-vertices";

const FEWEST_VERTICES = 3;
/** Edges that meet at less than this angle, radians, are taken for one smooth line. */
const SMOOTH = 0.05;
/** Control points this near to each other, as a share of the length, are one. */
const ONE_CURVE = 1e-6;

/**
 * Joins the two edges at a point into one. Pieces of one curve become exactly that curve again. Where both
 * edges are sewn to the two edges at one other point, that point goes too and the seam stays whole; where only
 * one edge is sewn, the joined edge is; of two other seams the longer edge's is kept, and a note says so.
 */
export function deletePoint(specification: Specification, ref: VertexRef): Edit {
  const facing = facingPoint(specification, ref);
  const few = (each: VertexRef) => panelOf(specification, each.panel).vertices.length <= FEWEST_VERTICES;
  if (few(ref) || (facing !== null && (few(facing) || crowded(specification, ref, facing))))
    return refused(specification, "A panel needs at least three points.");
  const panels = facing === null ? [ref] : [ref, facing];
  for (const each of panels) {
    const panel = panelOf(specification, each.panel);
    const count = panel.vertices.length;
    const before = at(panel.vertices, (each.vertex + count - 1) % count);
    if (distance(before, at(panel.vertices, (each.vertex + 1) % count)) < SHORTEST_EDGE_CM)
      return refused(specification, "The points beside this one coincide. Move one of them first.");
  }
  if (facing === null) return join(specification, ref);

  const number = stitchOf(specification, edgesAt(specification, ref)[1]);
  const open = withStitches(specification, withoutStitch(specification.pattern.stitches, number));
  const first = joinEdges(open, ref);
  const moved = first.vertex(facing);
  return moved === null ? first : followedBy(first, (next) => joinEdges(next, moved));
}

/** The point that lies on this one in a seam which runs through both; null where there is none. */
export function facingPoint(specification: Specification, ref: VertexRef): VertexRef | null {
  const [before, after] = edgesAt(specification, ref);
  const [one, two] = [stitchOf(specification, before), stitchOf(specification, after)];
  if (one < 0 || two < 0 || one === two) return null;
  const stitches = specification.pattern.stitches;
  const flipped = isRightWrong(at(stitches, one));
  if (flipped !== isRightWrong(at(stitches, two))) return null;
  const [p, q] = [partnerIn(at(stitches, one), before), partnerIn(at(stitches, two), after)];
  if (p.panel !== q.panel) return null;
  const count = panelOf(specification, p.panel).edges.length;
  // Plain seams run against each other: the edge before the point faces the one after the other point.
  const [early, late] = flipped ? [p, q] : [q, p];
  if ((early.edge + 1) % count !== late.edge) return null;
  const found = { panel: late.panel, vertex: late.edge };
  return sameVertex(found, ref) ? null : found;
}

function crowded(specification: Specification, ref: VertexRef, facing: VertexRef): boolean {
  if (ref.panel !== facing.panel) return false;
  const count = panelOf(specification, ref.panel).vertices.length;
  const apart = (ref.vertex - facing.vertex + count) % count;
  return count - 2 < FEWEST_VERTICES || apart === 1 || apart === count - 1;
}

/** The edges that end and begin at a point. */
function edgesAt(specification: Specification, ref: VertexRef): [EdgeRef, EdgeRef] {
  const count = panelOf(specification, ref.panel).edges.length;
  return [
    { panel: ref.panel, edge: (ref.vertex + count - 1) % count },
    { panel: ref.panel, edge: ref.vertex },
  ];
}

/** Joins edges of which at most one seam can stay. */
function join(specification: Specification, ref: VertexRef): Edit {
  const pair = edgesAt(specification, ref);
  const numbers = pair.map((edge) => stitchOf(specification, edge));
  const lengths = edgeLengths(panelOf(specification, ref.panel));
  const both = numbers.every((number) => number >= 0);
  if (!both) return joinEdges(specification, ref);
  const lost = at(lengths, pair[0].edge) < at(lengths, pair[1].edge) ? 0 : 1;
  const stitch = at(specification.pattern.stitches, at(numbers, lost)) as Stitch;
  const other = partnerIn(stitch, at(pair, lost));
  const stitches = withoutStitch(specification.pattern.stitches, at(numbers, lost));
  const joined = joinEdges(withStitches(specification, stitches), ref);
  return {
    ...joined,
    notes: [`Edge ${other.edge} of ${other.panel} is no longer sewn: its partner is gone.`],
  };
}

/** Joins the edges at a point; stitches of either now hold the joined edge. */
function joinEdges(specification: Specification, ref: VertexRef): Edit {
  const panel = panelOf(specification, ref.panel);
  const count = panel.edges.length;
  const { vertex } = ref;
  const before = (vertex + count - 1) % count;
  const [a, b] = [at(panel.edges, before), at(panel.edges, vertex)];
  const { curvature: _, label: __, ...rest } = a;
  const label = a.label === b.label || !b.label ? a.label : a.label || b.label;
  const curvature = joinedShape(curveOf(panel, before), curveOf(panel, vertex));
  const merged: Edge = { ...rest, ...(label ? { label } : {}), ...(curvature ? { curvature } : {}) };
  const edges = panel.edges.map((edge, k) => (k === before ? merged : edge)).filter((_, k) => k !== vertex);
  const vertices = panel.vertices.filter((_, k) => k !== vertex);
  const to = (edge: number) => {
    const kept = edge === vertex ? before : edge;
    return kept > vertex ? kept - 1 : kept;
  };
  const moved = (each: EdgeRef) => (each.panel === ref.panel ? { ...each, edge: to(each.edge) } : each);
  const joined = { ...panel, vertices, edges: inLoop(edges) };
  return {
    ...edited(
      withPanels(specification, { [ref.panel]: joined }, renumbered(specification.pattern.stitches, moved)),
    ),
    edges: (each) => [moved(each)],
    vertex: (each) => {
      if (each.panel !== ref.panel || each.vertex < vertex) return each;
      return each.vertex === vertex ? null : { ...each, vertex: each.vertex - 1 };
    },
  };
}

/** One curve in place of two that follow each other. */
function joinedShape(one: Curve, two: Curve): Shape {
  if (one.shape === undefined && two.shape === undefined) return undefined;
  const arc = joinedArc(one, two);
  if (arc !== undefined) return arc;
  const [from, through] = [derivativeAt(one, 0), derivativeAt(one, 1)];
  const [on, to] = [derivativeAt(two, 0), derivativeAt(two, 1)];
  const smooth = Math.abs(Math.atan2(cross(through, on), dot(through, on))) < SMOOTH;
  // Of two pieces of one Bezier curve the speeds at the cut are as the pieces of the parameter.
  const known = norm(through) + norm(on) > 0 && one.shape?.type !== "circle" && two.shape?.type !== "circle";
  const chords = chordLength(one) + chordLength(two);
  const t = smooth && known ? norm(through) / (norm(through) + norm(on)) : chordLength(one) / chords;
  const share = Math.min(Math.max(t, 1e-6), 1 - 1e-6);
  // Of two pieces of one quadratic curve both ends tell the same control point.
  const ahead = add(one.start, scaled(from, 1 / (2 * share)));
  const behind = subtract(two.end, scaled(to, 1 / (2 * (1 - share))));
  if (smooth && known && distance(ahead, behind) < ONE_CURVE * chords)
    return shapeFromControl([one.start, between(ahead, behind, 0.5), two.end]);
  return shapeFromControl([
    one.start,
    add(one.start, scaled(from, 1 / (3 * share))),
    subtract(two.end, scaled(to, 1 / (3 * (1 - share)))),
    two.end,
  ]);
}

function joinedArc(one: Curve, two: Curve): Shape {
  if (one.shape?.type !== "circle" || two.shape?.type !== "circle") return undefined;
  const [a, b] = [one.shape.params, two.shape.params];
  if (a[2] !== b[2] || Math.abs(a[0] - b[0]) > 1e-6 * a[0]) return undefined;
  const [first, second] = [arcOf(a, one.start, one.end), arcOf(b, two.start, two.end)];
  if (distance(first.center, second.center) > 1e-4 * a[0]) return undefined;
  const sweep = Math.abs(first.sweep + second.sweep);
  if (sweep >= 2 * Math.PI) return undefined;
  const chord = distance(one.start, two.end);
  return { type: "circle", params: [Math.max(a[0], chord / 2), sweep > Math.PI ? 1 : 0, a[2]] };
}

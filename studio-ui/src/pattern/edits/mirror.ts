/** Edits done on both sides of the body at once. Where a panel has no counterpart, only it is changed. */

import { at } from "../geometry/at";
import { mirroredShape, reversedShape, type Shape } from "../geometry/curve";
import { add, between, scaled } from "../geometry/point";
import {
  type EdgeRef,
  type Point,
  type Specification,
  type Stitch,
  sameEdge,
  stitchOf,
  type VertexRef,
} from "../specification";
import { addPoint } from "./add-point";
import { reshapeEdge } from "./bend-edge";
import { type Counterpart, counterpartOf } from "./counterpart";
import { deletePoint } from "./delete-point";
import { type Edit, followedBy } from "./edit";
import { type Moves, moveVertices } from "./move-vertices";
import { makeStitch, removeStitch } from "./stitches";

/** The edge that mirrors one; null where its panel has no counterpart. It may be the edge itself. */
export function mirroredEdge(specification: Specification, ref: EdgeRef): EdgeRef | null {
  const counterpart = counterpartOf(specification, ref.panel);
  return counterpart && { panel: counterpart.panel, edge: counterpart.edge(ref.edge) };
}

export function mirroredVertex(specification: Specification, ref: VertexRef): VertexRef | null {
  const counterpart = counterpartOf(specification, ref.panel);
  return counterpart && { panel: counterpart.panel, vertex: counterpart.vertex(ref.vertex) };
}

/**
 * Moves and their reflections. A point on the middle line stays on it; of two points that mirror each other
 * and are both moved, each takes the mean of its own move and the other's reflected.
 */
export function mirroredMoves(specification: Specification, moves: Moves): Moves {
  const both = new Map<string, Map<number, Point>>();
  for (const [panel, own] of moves) both.set(panel, new Map(own));
  for (const [panel, own] of moves) {
    const counterpart = counterpartOf(specification, panel);
    if (counterpart === null) continue;
    for (const [vertex, by] of own) {
      const image = counterpart.vertex(vertex);
      const reflected = counterpart.shift(by);
      const there = moves.get(counterpart.panel)?.get(image);
      const list = both.get(counterpart.panel) ?? new Map<number, Point>();
      list.set(image, there === undefined ? reflected : scaled(add(there, reflected), 0.5));
      both.set(counterpart.panel, list);
    }
  }
  return both;
}

export function moveMirrored(specification: Specification, moves: Moves): Edit {
  return moveVertices(specification, mirroredMoves(specification, moves));
}

/** Reshapes an edge and its counterpart; an edge across the middle line becomes symmetric. */
export function reshapeMirrored(specification: Specification, ref: EdgeRef, shape: Shape): Edit {
  const counterpart = counterpartOf(specification, ref.panel);
  if (counterpart === null) return reshapeEdge(specification, ref, shape);
  const image = { panel: counterpart.panel, edge: counterpart.edge(ref.edge) };
  const reflected = reflectedShape(shape, counterpart);
  if (sameEdge(image, ref)) return reshapeEdge(specification, ref, halfway(shape, reflected));
  return followedBy(reshapeEdge(specification, ref, shape), (next) => reshapeEdge(next, image, reflected));
}

export function addPointMirrored(specification: Specification, ref: EdgeRef, share: number): Edit {
  const image = mirroredEdge(specification, ref);
  const first = addPoint(specification, ref, share);
  if (image === null || first.refused !== undefined) return first;
  const pieces = first.edges(image);
  if (pieces.length === 1) return followedBy(first, (next) => addPoint(next, at(pieces, 0), 1 - share));
  // The counterpart was split with it: it is its partner in a seam down the middle, or the edge itself.
  if (!sameEdge(image, ref) || Math.abs(share - 0.5) < 1e-6) return first;
  const [piece, rest] =
    share < 0.5 ? [at(pieces, 1), (1 - 2 * share) / (1 - share)] : [at(pieces, 0), (1 - share) / share];
  return followedBy(first, (next) => addPoint(next, piece, rest));
}

export function deletePointMirrored(specification: Specification, ref: VertexRef): Edit {
  const image = mirroredVertex(specification, ref);
  const first = deletePoint(specification, ref);
  const moved = image && first.vertex(image);
  if (first.refused !== undefined || moved === null) return first;
  return followedBy(first, (next) => deletePoint(next, moved));
}

export function makeStitchMirrored(specification: Specification, one: EdgeRef, other: EdgeRef): Edit {
  const first = makeStitch(specification, one, other);
  const images = [mirroredEdge(specification, one), mirroredEdge(specification, other)] as const;
  if (first.refused !== undefined || images[0] === null || images[1] === null) return first;
  const [a, b] = [images[0], images[1]];
  const same = (sameEdge(a, one) && sameEdge(b, other)) || (sameEdge(a, other) && sameEdge(b, one));
  return same ? first : followedBy(first, (next) => makeStitch(next, a, b));
}

export function removeStitchMirrored(specification: Specification, number: number): Edit {
  const first = removeStitch(specification, number);
  if (first.refused !== undefined) return first;
  const stitch = at(specification.pattern.stitches, number);
  const image = mirroredStitch(first.specification, specification, stitch);
  return image < 0 ? first : followedBy(first, (next) => removeStitch(next, image));
}

function mirroredStitch(after: Specification, before: Specification, stitch: Stitch): number {
  const [a, b] = [mirroredEdge(before, stitch[0]), mirroredEdge(before, stitch[1])];
  if (a === null || b === null) return -1;
  const number = stitchOf(after, a);
  return number >= 0 && number === stitchOf(after, b) ? number : -1;
}

function reflectedShape(shape: Shape, counterpart: Counterpart): Shape {
  const turned = reversedShape(shape);
  return counterpart.reflects ? mirroredShape(turned) : turned;
}

/** The shape between two of the same kind. */
function halfway(one: Shape, other: Shape): Shape {
  if (one?.type === "quadratic" && other?.type === "quadratic")
    return { type: "quadratic", params: [between(one.params[0], other.params[0], 0.5)] };
  if (one?.type === "cubic" && other?.type === "cubic")
    return {
      type: "cubic",
      params: [between(one.params[0], other.params[0], 0.5), between(one.params[1], other.params[1], 0.5)],
    };
  return one;
}

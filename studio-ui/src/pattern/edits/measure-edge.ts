/** Edits by number: an edge's length and direction, a vertex's place. */

import { at } from "../geometry/at";
import { edgeLength } from "../geometry/outline";
import { add, distance, scaled, subtract, turned } from "../geometry/point";
import { type EdgeRef, type Point, panelOf, type Specification, type VertexRef } from "../specification";
import { type Moves, movesOf } from "./move-vertices";

/** Which end of an edge stays where it is. */
export type Anchor = "start" | "end" | "middle";

/** Moves that give an edge a length in cm; its shape and direction stay. */
export function movesForLength(
  specification: Specification,
  ref: EdgeRef,
  length: number,
  anchor: Anchor,
): Moves {
  const { start, end } = ends(specification, ref);
  // The whole edge grows like its chord, curves and arcs included.
  const factor = length / edgeLength(specification, ref);
  const chord = subtract(end, start);
  return aboutAnchor(specification, ref, subtract(scaled(chord, factor), chord), anchor);
}

/** Moves that turn an edge's chord to an angle, degrees anticlockwise from +x of the panel. */
export function movesForAngle(
  specification: Specification,
  ref: EdgeRef,
  degrees: number,
  anchor: Anchor,
): Moves {
  const { start, end } = ends(specification, ref);
  const chord = subtract(end, start);
  const wanted = turned([distance(start, end), 0], (degrees * Math.PI) / 180);
  return aboutAnchor(specification, ref, subtract(wanted, chord), anchor);
}

/** Moves that put a vertex at a place, cm in the panel's frame. */
export function movesToPlace(specification: Specification, ref: VertexRef, place: Point): Moves {
  const now = at(panelOf(specification, ref.panel).vertices, ref.vertex);
  return movesOf([ref], () => subtract(place, now));
}

export function angleOf(specification: Specification, ref: EdgeRef): number {
  const { start, end } = ends(specification, ref);
  return (Math.atan2(end[1] - start[1], end[0] - start[0]) * 180) / Math.PI;
}

/** Both vertices of an edge. */
export function verticesOf(specification: Specification, ref: EdgeRef): [VertexRef, VertexRef] {
  const count = panelOf(specification, ref.panel).vertices.length;
  return [
    { panel: ref.panel, vertex: ref.edge },
    { panel: ref.panel, vertex: (ref.edge + 1) % count },
  ];
}

function ends(specification: Specification, ref: EdgeRef): { start: Point; end: Point } {
  const panel = panelOf(specification, ref.panel);
  const [a, b] = verticesOf(specification, ref);
  return { start: at(panel.vertices, a.vertex), end: at(panel.vertices, b.vertex) };
}

function aboutAnchor(specification: Specification, ref: EdgeRef, growth: Point, anchor: Anchor): Moves {
  const [start, end] = verticesOf(specification, ref);
  const share = anchor === "start" ? 0 : anchor === "end" ? 1 : 0.5;
  const moves = new Map<number, Point>();
  if (share > 0) moves.set(start.vertex, scaled(growth, -share));
  if (share < 1) moves.set(end.vertex, add([0, 0], scaled(growth, 1 - share)));
  return new Map([[ref.panel, moves]]);
}

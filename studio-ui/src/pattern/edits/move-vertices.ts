/** Moves vertices; the edges between them follow. */

import { at } from "../geometry/at";
import { scaledShape } from "../geometry/curve";
import { add, distance } from "../geometry/point";
import { type Edge, type Panel, type Point, panelOf, type Specification } from "../specification";
import { type Edit, edited, refused, withPanels } from "./edit";

/** By panel and vertex: how far it moves, in the panel's own frame, cm. */
export type Moves = ReadonlyMap<string, ReadonlyMap<number, Point>>;

export const SHORTEST_EDGE_CM = 0.01;

/**
 * An edge with both ends moved alike keeps its shape exactly: so a hem is dragged. With one end moved it keeps
 * its bend: control points follow the chord, and so does the radius of an arc, which the format does not do.
 *
 * Refused where an edge would shrink to a point.
 */
export function moveVertices(specification: Specification, moves: Moves): Edit {
  const changed: Record<string, Panel> = {};
  for (const [name, vertices] of moves) {
    const before = panelOf(specification, name);
    const after = movedPanel(before, vertices);
    if (after === null)
      return refused(
        specification,
        `An edge of ${name} would shrink to a point. Move it less far, or delete a point.`,
      );
    if (after !== before) changed[name] = after;
  }
  return Object.keys(changed).length === 0
    ? edited(specification)
    : edited(withPanels(specification, changed));
}

function movedPanel(panel: Panel, moves: ReadonlyMap<number, Point>): Panel | null {
  const still: Point = [0, 0];
  const count = panel.vertices.length;
  const by = (vertex: number) => moves.get(vertex % count) ?? still;
  if ([...moves.values()].every(([x, y]) => x === 0 && y === 0)) return panel;
  const vertices = panel.vertices.map((p, k) => (moves.has(k) ? add(p, by(k)) : p));
  const edges: Edge[] = [];
  for (const [k, edge] of panel.edges.entries()) {
    const [a, b] = [by(k), by(k + 1)];
    if (a[0] === b[0] && a[1] === b[1]) {
      edges.push(edge);
      continue;
    }
    const before = distance(at(panel.vertices, k), at(panel.vertices, (k + 1) % count));
    const after = distance(at(vertices, k), at(vertices, (k + 1) % count));
    if (after < SHORTEST_EDGE_CM && after <= before) return null;
    const curvature = scaledShape(edge.curvature, after / before);
    edges.push(curvature === edge.curvature || curvature === undefined ? edge : { ...edge, curvature });
  }
  return { ...panel, vertices, edges };
}

/** The same move for several vertices. */
export function movesOf(
  vertices: Iterable<{ panel: string; vertex: number }>,
  by: (panel: string) => Point,
): Moves {
  const moves = new Map<string, Map<number, Point>>();
  for (const { panel, vertex } of vertices) {
    const own = moves.get(panel) ?? new Map<number, Point>();
    own.set(vertex, by(panel));
    moves.set(panel, own);
  }
  return moves;
}

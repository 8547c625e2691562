/** Adds a point: an edge becomes two, and so does the edge it is sewn to. */

import { at } from "../geometry/at";
import { splitAt } from "../geometry/curve";
import { parameterAtShare } from "../geometry/length";
import { curveOf, edgeLength } from "../geometry/outline";
import {
  type Edge,
  type EdgeRef,
  isRightWrong,
  type Panel,
  type Point,
  panelOf,
  partnerIn,
  type Specification,
  type Stitch,
  sameEdge,
  stitchOf,
} from "../specification";
import { type Edit, edited, refused, renumbered, withPanels, withStitches } from "./edit";
import { SHORTEST_EDGE_CM } from "./move-vertices";

/**
 * Splits an edge where a share of its length has been travelled. Neither outline changes. The edge that it is
 * sewn to is split at the same share, so that both pairs of halves meet as the whole edges did.
 */
export function addPoint(specification: Specification, ref: EdgeRef, share: number): Edit {
  const number = stitchOf(specification, ref);
  const stitch = number < 0 ? undefined : specification.pattern.stitches[number];
  const partner = stitch === undefined ? undefined : partnerIn(stitch, ref);
  for (const each of partner === undefined ? [ref] : [ref, partner]) {
    const length = edgeLength(specification, each);
    if (!(Math.min(share, 1 - share) * length > 2 * SHORTEST_EDGE_CM))
      return refused(
        specification,
        `There is no room for a point there: edge ${each.edge} of ${each.panel} is too short.`,
      );
  }
  if (stitch === undefined || partner === undefined) return splitOne(specification, ref, share);
  if (sameEdge(ref, partner))
    return refused(specification, "This edge is sewn to itself. Remove the stitch first.");

  const facing = isRightWrong(stitch) ? share : 1 - share;
  const first = splitOne(specification, ref, share);
  const moved = at(first.edges(partner), 0);
  const second = splitOne(first.specification, moved, facing);
  const edges = (each: EdgeRef) => first.edges(each).flatMap((one) => second.edges(one));
  const mine = edges(ref);
  const theirs = edges(partner);
  const [near, far] = isRightWrong(stitch) ? [0, 1] : [1, 0];
  const pair = (a: EdgeRef, b: EdgeRef): Stitch => (isRightWrong(stitch) ? [a, b, "right_wrong"] : [a, b]);
  const stitches = [...second.specification.pattern.stitches];
  stitches[number] = pair(at(mine, 0), at(theirs, near));
  stitches.push(pair(at(mine, 1), at(theirs, far)));
  return {
    specification: withStitches(second.specification, stitches),
    edges,
    vertex: (each) => {
      const between = first.vertex(each);
      return between === null ? null : second.vertex(between);
    },
    notes: [],
  };
}

/** Splits one edge; a stitch of it stays with the first half. */
function splitOne(specification: Specification, ref: EdgeRef, share: number): Edit {
  const panel = panelOf(specification, ref.panel);
  const curve = curveOf(panel, ref.edge);
  const { first, second, point } = splitAt(curve, parameterAtShare(curve, share));
  const whole = at(panel.edges, ref.edge);
  const piece = (curvature: Edge["curvature"]): Edge => {
    const { curvature: _, ...rest } = whole;
    return curvature === undefined ? rest : { ...rest, curvature };
  };
  const inserted = insertVertex(panel, ref.edge + 1, point, [piece(first), piece(second)]);
  const later = (edge: number) => (edge > ref.edge ? edge + 1 : edge);
  const moved = (each: EdgeRef) => (each.panel === ref.panel ? { ...each, edge: later(each.edge) } : each);
  return {
    ...edited(
      withPanels(specification, { [ref.panel]: inserted }, renumbered(specification.pattern.stitches, moved)),
    ),
    edges: (each) => (sameEdge(each, ref) ? [ref, { ...ref, edge: ref.edge + 1 }] : [moved(each)]),
    vertex: (each) =>
      each.panel === ref.panel && each.vertex > ref.edge ? { ...each, vertex: each.vertex + 1 } : each,
  };
}

function insertVertex(panel: Panel, index: number, point: Point, pieces: readonly [Edge, Edge]): Panel {
  const vertices = [...panel.vertices.slice(0, index), point, ...panel.vertices.slice(index)];
  const edges = [...panel.edges.slice(0, index - 1), ...pieces, ...panel.edges.slice(index)];
  return { ...panel, vertices, edges: inLoop(edges) };
}

/** Edges with their end points counted anew. */
export function inLoop(edges: readonly Edge[]): Edge[] {
  return edges.map((edge, k) => {
    const to = (k + 1) % edges.length;
    return edge.endpoints[0] === k && edge.endpoints[1] === to ? edge : { ...edge, endpoints: [k, to] };
  });
}

/** What lies under the pointer. */

import type { Target } from "../../state/selection";
import { bendHandlesOf } from "../edits/bend-handles";
import { at } from "../geometry/at";
import { type Box, boxOf, curveBox } from "../geometry/bounds";
import { nearestOn } from "../geometry/nearest";
import { curveOf, isInside, outlineOf, panelBox } from "../geometry/outline";
import { distance } from "../geometry/point";
import { type Arrangement, type Place, toPanel, toSheet } from "../layout/arrangement";
import {
  type EdgeRef,
  type Panel,
  type Point,
  panelNames,
  panelOf,
  type Specification,
} from "../specification";

export type Hit =
  | { readonly kind: "panel"; readonly panel: string }
  | { readonly kind: "edge"; readonly panel: string; readonly edge: number; readonly t: number }
  | { readonly kind: "vertex"; readonly panel: string; readonly vertex: number }
  | { readonly kind: "handle"; readonly panel: string; readonly edge: number; readonly handle: number };

export interface Reach {
  /** How far from a point, an edge the pointer may be, cm on the sheet. */
  readonly vertex: number;
  readonly edge: number;
}

interface Looked {
  readonly outline: readonly Point[];
  readonly box: Box;
  readonly edges: readonly Box[];
}

const looked = new WeakMap<Panel, Looked>();

function lookedAt(panel: Panel): Looked {
  let known = looked.get(panel);
  if (known === undefined) {
    known = {
      outline: outlineOf(panel, 0.05),
      box: panelBox(panel),
      edges: panel.edges.map((_, k) => curveBox(curveOf(panel, k))),
    };
    looked.set(panel, known);
  }
  return known;
}

/** The nearest handle, vertex, edge or panel, in this order; handles only of the edges given. */
export function hitAt(
  specification: Specification,
  arrangement: Arrangement,
  point: Point,
  reach: Reach,
  handlesOf: readonly EdgeRef[],
): Hit | null {
  for (const { panel: name, edge } of handlesOf) {
    const place = arrangement[name];
    if (place === undefined) continue;
    const local = toPanel(place, point);
    for (const [handle, to] of bendHandlesOf(curveOf(panelOf(specification, name), edge)).entries())
      if (distance(local, to) <= reach.vertex) return { kind: "handle", panel: name, edge, handle };
  }
  let vertex: (Hit & { off: number }) | null = null;
  let edge: (Hit & { off: number }) | null = null;
  let inside: Hit | null = null;
  for (const name of panelNames(specification)) {
    const place = arrangement[name];
    if (place === undefined) continue;
    const panel = panelOf(specification, name);
    const { box, edges, outline } = lookedAt(panel);
    const local = toPanel(place, point);
    if (!near(local, box, Math.max(reach.vertex, reach.edge))) continue;
    for (const [k, p] of panel.vertices.entries()) {
      const off = distance(p, local);
      if (off <= reach.vertex && (vertex === null || off < vertex.off))
        vertex = { kind: "vertex", panel: name, vertex: k, off };
    }
    for (const [k, own] of edges.entries()) {
      if (!near(local, own, reach.edge)) continue;
      const found = nearestOn(curveOf(panel, k), local);
      if (found.distance <= reach.edge && (edge === null || found.distance < edge.off))
        edge = { kind: "edge", panel: name, edge: k, t: found.t, off: found.distance };
    }
    if (isInside(local, outline)) inside = { kind: "panel", panel: name };
  }
  // On an edge that is short on the screen its ends would leave nothing to take hold of.
  if (vertex !== null && edge !== null && edge.kind === "edge" && crowded(specification, edge, reach)) {
    const middle = edge.t > 0.3 && edge.t < 0.7;
    if (middle && vertex.off > reach.vertex / 3) return strip(edge);
  }
  return strip(vertex ?? edge) ?? inside;
}

function strip(hit: (Hit & { off: number }) | null): Hit | null {
  if (hit === null) return null;
  const { off: _, ...rest } = hit;
  return rest as Hit;
}

function crowded(specification: Specification, ref: EdgeRef, reach: Reach): boolean {
  const curve = curveOf(panelOf(specification, ref.panel), ref.edge);
  return distance(curve.start, curve.end) < 3 * reach.vertex;
}

function near(point: Point, box: Box, by: number): boolean {
  return (
    point[0] >= box.low[0] - by &&
    point[0] <= box.high[0] + by &&
    point[1] >= box.low[1] - by &&
    point[1] <= box.high[1] + by
  );
}

/** Vertices in a rectangle of the sheet; panels that lie in it with all their vertices come as panels. */
export function within(
  specification: Specification,
  arrangement: Arrangement,
  corners: [Point, Point],
): Target[] {
  const { low, high } = boxOf(corners);
  const inBox = ([x, y]: Point) => x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1];
  return panelNames(specification).flatMap((name): Target[] => {
    const place = arrangement[name] as Place | undefined;
    if (place === undefined) return [];
    const panel = panelOf(specification, name);
    const hits = panel.vertices.flatMap((p, k) => (inBox(toSheet(place, p)) ? [k] : []));
    if (
      hits.length === panel.vertices.length &&
      lookedAt(panel).outline.every((p) => inBox(toSheet(place, p)))
    )
      return [{ kind: "panel", panel: name }];
    return hits.map((k) => ({ kind: "vertex", panel: name, vertex: at([k], 0) }));
  });
}

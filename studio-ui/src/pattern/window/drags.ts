/** What a drag does: from what was taken hold of, to the pattern for each place of the pointer. */

import type { Target } from "../../state/selection";
import type { Units } from "../../state/units";
import { lengthText } from "../../state/units";
import { reshapeEdge, shapeOfDepth } from "../edits/bend-edge";
import { bent } from "../edits/bend-handles";
import { type Edit, refused } from "../edits/edit";
import { type Hem, hemOf, movesOfHem, outwardShare } from "../edits/hem";
import { verticesOf } from "../edits/measure-edge";
import { mirroredMoves, reshapeMirrored } from "../edits/mirror";
import { type Moves, movesOf, moveVertices } from "../edits/move-vertices";
import { at } from "../geometry/at";
import { toRelative } from "../geometry/curve";
import { curveOf, edgeLength } from "../geometry/outline";
import { add, distance, subtract } from "../geometry/point";
import { type Arrangement, directionToPanel, directionToSheet, moved, toPanel } from "../layout/arrangement";
import {
  type EdgeRef,
  type Point,
  panelOf,
  partnerIn,
  type Specification,
  sameVertex,
  stitchOf,
  type VertexRef,
} from "../specification";
import type { Hit } from "./hit-test";
import { type Guide, type SnapTargets, snapLength, snapPoint, snapShift } from "./snapping";

export interface DragSetting {
  readonly specification: Specification;
  readonly arrangement: Arrangement;
  readonly selection: readonly Target[];
  readonly mirror: boolean;
  readonly hem: boolean;
  readonly units: Units;
}

export interface DragPointer {
  /** On the sheet, cm. */
  readonly to: Point;
  readonly snap: boolean;
  /** What 7 px are on the sheet, cm. */
  readonly reach: number;
  /** Step of the grid, cm. */
  readonly grid: number;
}

export interface DragState {
  /** null: the pattern stays; only the arrangement changes. */
  readonly edit: Edit | null;
  readonly arrangement: Arrangement | null;
  readonly guides: readonly Guide[];
  readonly reading: string;
}

export interface Drag {
  /** What the history says. */
  readonly label: string;
  readonly to: (pointer: DragPointer) => DragState;
}

/** The drag that begins at a place of the sheet on what is there; `bend`: an edge is bent instead of moved. */
export function dragOf(hit: Hit, from: Point, setting: DragSetting, bend: boolean): Drag {
  switch (hit.kind) {
    case "handle":
      return bendDrag(hit, hit.handle, setting);
    case "edge":
      return bend ? depthDrag(hit, setting) : edgeDrag(hit, from, setting);
    case "vertex":
      return vertexDrag(hit, from, setting);
    case "panel":
      return panelDrag(hit.panel, from, setting);
  }
}

function vertexDrag(hit: VertexRef, from: Point, setting: DragSetting): Drag {
  const selected = setting.selection.flatMap((t) => (t.kind === "vertex" ? [t] : []));
  const vertices = selected.some((t) => sameVertex(t, hit)) ? selected : [hit];
  if (vertices.length > 1)
    return shiftDrag(`Move ${vertices.length} points`, vertices, hit.panel, from, setting);
  const { specification, arrangement } = setting;
  const place = at([arrangement[hit.panel]], 0);
  const panel = panelOf(specification, hit.panel);
  const origin = at(panel.vertices, hit.vertex);
  return {
    label: `Move point of ${hit.panel}`,
    to: ({ to, snap, reach, grid }) => {
      if (place === undefined) return nothing(specification);
      const wanted = add(origin, subtract(toPanel(place, to), toPanel(place, from)));
      const snapped = snap
        ? snapPoint(wanted, targetsOf(hit, setting, grid), reach)
        : { point: wanted, guides: [] };
      const by = subtract(snapped.point, origin);
      return {
        edit: moving(
          setting,
          movesOf([hit], () => by),
        ),
        arrangement: null,
        guides: snapped.guides.map((guide) => ({ ...guide, panel: hit.panel })),
        reading: shiftText(directionToSheet(place, by), setting.units),
      };
    },
  };
}

function targetsOf(hit: VertexRef, { specification }: DragSetting, grid: number): SnapTargets {
  const panel = panelOf(specification, hit.panel);
  const count = panel.vertices.length;
  const beside = [
    { edge: hit.vertex, other: (hit.vertex + 1) % count },
    { edge: (hit.vertex + count - 1) % count, other: (hit.vertex + count - 1) % count },
  ];
  const circles = beside.flatMap(({ edge, other }) => {
    const ref = { panel: hit.panel, edge };
    const number = stitchOf(specification, ref);
    if (number < 0) return [];
    const partner = partnerIn(at(specification.pattern.stitches, number), ref);
    const curve = curveOf(panel, edge);
    const chord = distance(curve.start, curve.end);
    const radius = (chord * edgeLength(specification, partner)) / edgeLength(specification, ref);
    // The edge's present length is no aim, and a gather is not meant to vanish.
    if (Math.abs(radius - chord) < 0.02 || radius / chord > 1.2 || radius / chord < 0.8) return [];
    return [{ center: at(panel.vertices, other), radius, label: `as long as ${partner.panel}` }];
  });
  const points = panel.vertices.filter((_, k) => k !== hit.vertex);
  return { points, origin: at(panel.vertices, hit.vertex), circles, grid };
}

function edgeDrag(hit: EdgeRef, from: Point, setting: DragSetting): Drag {
  const { specification } = setting;
  const hem = setting.hem ? hemOf(specification, hit) : null;
  if (hem !== null) return hemDrag(hit, hem, from, setting);
  const selected = setting.selection.flatMap((t) => (t.kind === "edge" ? [t] : []));
  const edges = selected.some((t) => t.panel === hit.panel && t.edge === hit.edge) ? selected : [hit];
  const vertices = edges.flatMap((edge) => verticesOf(specification, edge));
  const label = edges.length > 1 ? `Move ${edges.length} edges` : `Move edge of ${hit.panel}`;
  return shiftDrag(label, vertices, hit.panel, from, setting);
}

function hemDrag(hit: EdgeRef, hem: Hem, from: Point, setting: DragSetting): Drag {
  const { specification, arrangement, units } = setting;
  const place = arrangement[hit.panel];
  const panels = new Set(hem.edges.map((edge) => edge.panel)).size;
  return {
    label: panels > 1 ? `Move the hem of ${panels} panels` : `Move the hem of ${hit.panel}`,
    to: ({ to, snap, reach, grid }) => {
      if (place === undefined) return nothing(specification);
      const by = outwardShare(specification, hem, hit.panel, directionToPanel(place, subtract(to, from)));
      const longer = snap ? snapLength(by, grid, reach) : by;
      return {
        edit: moving(setting, movesOfHem(specification, hem, longer)),
        arrangement: null,
        guides: [],
        reading: `${lengthText(Math.abs(longer), units)} ${longer < 0 ? "shorter" : "longer"}`,
      };
    },
  };
}

function shiftDrag(
  label: string,
  vertices: readonly VertexRef[],
  panel: string,
  from: Point,
  setting: DragSetting,
): Drag {
  const { specification, arrangement } = setting;
  return {
    label,
    to: ({ to, snap, reach, grid }) => {
      const shift = subtract(to, from);
      const snapped = snap ? snapShift(shift, grid, reach) : { point: shift, guides: [] };
      const own = (name: string): Point => {
        const place = arrangement[name];
        return place === undefined ? [0, 0] : directionToPanel(place, snapped.point);
      };
      const first = vertices.find((v) => v.panel === panel);
      const origin = first && at(panelOf(specification, panel).vertices, first.vertex);
      const guides = snapped.guides.flatMap(({ label: text }) =>
        origin === undefined ? [] : [{ panel, from: origin, to: add(origin, own(panel)), label: text }],
      );
      return {
        edit: moving(setting, movesOf(vertices, own)),
        arrangement: null,
        guides,
        reading: shiftText(snapped.point, setting.units),
      };
    },
  };
}

function bendDrag(ref: EdgeRef, handle: number, setting: DragSetting): Drag {
  const { specification, arrangement, mirror, units } = setting;
  const place = arrangement[ref.panel];
  const curve = curveOf(panelOf(specification, ref.panel), ref.edge);
  return {
    label: `Bend edge of ${ref.panel}`,
    to: ({ to }) => {
      if (place === undefined) return nothing(specification);
      const shape = bent(curve, handle, toPanel(place, to));
      const edit = (mirror ? reshapeMirrored : reshapeEdge)(specification, ref, shape);
      return { edit, arrangement: null, guides: [], reading: lengthNow(edit, ref, units) };
    },
  };
}

function depthDrag(ref: EdgeRef, setting: DragSetting): Drag {
  const { specification, arrangement, mirror, units } = setting;
  const place = arrangement[ref.panel];
  const curve = curveOf(panelOf(specification, ref.panel), ref.edge);
  return {
    label: `Bend edge of ${ref.panel}`,
    to: ({ to, snap, reach, grid }) => {
      if (place === undefined) return nothing(specification);
      const height = toRelative(toPanel(place, to), curve.start, curve.end)[1];
      const depth = height * distance(curve.start, curve.end);
      const shape = shapeOfDepth(curve, snap ? snapLength(depth, grid, reach) : depth);
      const edit = (mirror ? reshapeMirrored : reshapeEdge)(specification, ref, shape);
      return { edit, arrangement: null, guides: [], reading: lengthNow(edit, ref, units) };
    },
  };
}

function panelDrag(panel: string, from: Point, setting: DragSetting): Drag {
  const selected = setting.selection.flatMap((t) => (t.kind === "panel" ? [t.panel] : []));
  const panels = selected.includes(panel) ? selected : [panel];
  return {
    label: "",
    to: ({ to }) => ({
      edit: null,
      arrangement: moved(setting.arrangement, panels, subtract(to, from)),
      guides: [],
      reading: "",
    }),
  };
}

function moving(setting: DragSetting, moves: Moves): Edit {
  const all = setting.mirror ? mirroredMoves(setting.specification, moves) : moves;
  return moveVertices(setting.specification, all);
}

function nothing(specification: Specification): DragState {
  return {
    edit: refused(specification, "This panel has no place."),
    arrangement: null,
    guides: [],
    reading: "",
  };
}

function lengthNow(edit: Edit, ref: EdgeRef, units: Units): string {
  return `${lengthText(edgeLength(edit.specification, ref), units)} long`;
}

/** "10 cm down, 2 cm left". */
export function shiftText(shift: Point, units: Units): string {
  const parts = [
    Math.abs(shift[1]) < 0.005
      ? ""
      : `${lengthText(Math.abs(shift[1]), units)} ${shift[1] < 0 ? "down" : "up"}`,
    Math.abs(shift[0]) < 0.005
      ? ""
      : `${lengthText(Math.abs(shift[0]), units)} ${shift[0] < 0 ? "left" : "right"}`,
  ].filter((part) => part !== "");
  return parts.length === 0 ? "not moved" : parts.join(", ");
}

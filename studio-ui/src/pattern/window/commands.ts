/** What buttons and keys do to what is selected. */

import type { Target } from "../../state/selection";
import { useStudio } from "../../state/store";
import { addPoint } from "../edits/add-point";
import { deletePoint } from "../edits/delete-point";
import { type Edit, edited, followedBy } from "../edits/edit";
import { verticesOf } from "../edits/measure-edge";
import {
  addPointMirrored,
  deletePointMirrored,
  makeStitchMirrored,
  mirroredMoves,
  removeStitchMirrored,
} from "../edits/mirror";
import { type Moves, moveVertices } from "../edits/move-vertices";
import { makeStitch, removeStitch, turnStitch } from "../edits/stitches";
import { at } from "../geometry/at";
import { boxAround, boxOf } from "../geometry/bounds";
import { pointAt } from "../geometry/curve";
import { curveOf } from "../geometry/outline";
import {
  type Arrangement,
  arranged,
  boxOfAll,
  boxOnSheet,
  directionToPanel,
  moved,
  rotated,
  toSheet,
} from "../layout/arrangement";
import {
  type EdgeRef,
  type Point,
  panelNames,
  panelOf,
  type Specification,
  stitchOf,
  type VertexRef,
  vertexKey,
} from "../specification";
import { perform, shownSpecification } from "./document";
import { usePatternView } from "./pattern-view-state";
import { fitted, type Margins } from "./view";

/** Rulers lie along the top and the left, measures along the bottom. */
const FIT_MARGIN: Margins = { top: 36, right: 18, bottom: 70, left: 36 };
const FOCUS_MARGIN: Margins = { top: 120, right: 90, bottom: 150, left: 110 };
/** A place is looked at from no nearer than this, px per cm. */
const FOCUS_NEAREST = 40;
/** Around a place beside the list of findings, px. */
const LIST_GAP = 40;

export function selectedEdges(selection: readonly Target[]): EdgeRef[] {
  return selection.flatMap((t) => (t.kind === "edge" ? [{ panel: t.panel, edge: t.edge }] : []));
}

export function selectedVertices(selection: readonly Target[]): VertexRef[] {
  return selection.flatMap((t) => (t.kind === "vertex" ? [{ panel: t.panel, vertex: t.vertex }] : []));
}

/** Stitches that are selected, as such or by an edge of theirs. */
export function selectedStitches(specification: Specification, selection: readonly Target[]): number[] {
  const numbers = selection.flatMap((t) => {
    if (t.kind === "seam") return [t.stitch];
    if (t.kind !== "edge") return [];
    const number = stitchOf(specification, t);
    return number < 0 ? [] : [number];
  });
  return [...new Set(numbers)];
}

export function addPointAt(ref: EdgeRef, share: number): void {
  const specification = shownSpecification();
  if (specification === null) return;
  const { mirror } = usePatternView.getState();
  const edit = (mirror ? addPointMirrored : addPoint)(specification, ref, share);
  const [, second] = edit.edges(ref);
  const select: Target[] =
    second === undefined ? [] : [{ kind: "vertex", panel: second.panel, vertex: second.edge }];
  perform(`Add point to ${ref.panel}`, edit, select);
}

export function addPointsToSelected(): void {
  const edges = selectedEdges(useStudio.getState().selection);
  const [only] = edges;
  if (only === undefined || edges.length > 1) tell("Select one edge to add a point to its middle.");
  else addPointAt(only, 0.5);
}

/** Selected points are deleted; of selected seams and edges, the stitches. */
export function deleteSelected(): void {
  const specification = shownSpecification();
  if (specification === null) return;
  const { selection } = useStudio.getState();
  const vertices = selectedVertices(selection);
  if (vertices.length > 0) deletePoints(specification, vertices);
  else removeStitches(selectedStitches(specification, selection));
}

function deletePoints(specification: Specification, vertices: readonly VertexRef[]): void {
  const { mirror } = usePatternView.getState();
  let edit: Edit | null = null;
  for (const ref of vertices) {
    const now: VertexRef | null = edit === null ? ref : edit.vertex(ref);
    if (now === null) continue;
    const step = (s: Specification): Edit => (mirror ? deletePointMirrored : deletePoint)(s, now);
    edit = edit === null ? step(specification) : followedBy(edit, step);
  }
  if (edit === null) return;
  const [first] = vertices;
  perform(
    vertices.length > 1 ? `Delete ${vertices.length} points` : `Delete point of ${first?.panel}`,
    edit,
    [],
  );
}

export function removeStitches(numbers: readonly number[]): void {
  const specification = shownSpecification();
  if (specification === null) return;
  if (numbers.length === 0) {
    tell("Select a point to delete it, or a seam to remove its stitch.");
    return;
  }
  const { mirror } = usePatternView.getState();
  let edit: Edit | null = null;
  for (const ref of numbers.map((n) => at(at(specification.pattern.stitches, n), 0) as EdgeRef)) {
    // Numbers change on the way; the edges do not.
    const step = (s: Specification): Edit => {
      const number = stitchOf(s, ref);
      return number < 0 ? edited(s) : (mirror ? removeStitchMirrored : removeStitch)(s, number);
    };
    edit = edit === null ? step(specification) : followedBy(edit, step);
  }
  if (edit !== null)
    perform(numbers.length > 1 ? `Remove ${numbers.length} stitches` : "Remove stitch", edit);
}

export function sewTogether(one: EdgeRef, other: EdgeRef): boolean {
  const specification = shownSpecification();
  if (specification === null) return false;
  const { mirror } = usePatternView.getState();
  const edit = (mirror ? makeStitchMirrored : makeStitch)(specification, one, other);
  return perform(`Sew ${one.panel} to ${other.panel}`, edit, [
    { kind: "edge", ...one },
    { kind: "edge", ...other },
  ]);
}

/** Two selected free edges are sewn; with one, the next that is chosen is sewn to it. */
export function sewSelected(): void {
  const edges = selectedEdges(useStudio.getState().selection);
  const [one, other] = edges;
  if (one !== undefined && other !== undefined && edges.length === 2) sewTogether(one, other);
  else usePatternView.getState().set({ tool: "sew", sewFrom: one ?? null, message: null });
}

export function turnStitchOf(number: number): void {
  const specification = shownSpecification();
  if (specification !== null) perform("Turn stitch", turnStitch(specification, number));
}

/** Moves what is selected by so many cm of the sheet: points and edges in the pattern, panels in the window. */
export function nudge(by: Point): void {
  const specification = shownSpecification();
  if (specification === null) return;
  const { selection } = useStudio.getState();
  const { arrangement, set, mirror } = usePatternView.getState();
  const vertices = new Map<string, VertexRef>();
  for (const v of [
    ...selectedVertices(selection),
    ...selectedEdges(selection).flatMap((edge) => verticesOf(specification, edge)),
  ])
    vertices.set(vertexKey(v), v);
  if (vertices.size === 0) {
    const panels = selection.flatMap((t) => (t.kind === "panel" ? [t.panel] : []));
    if (panels.length > 0) keepArrangement("Move panels", moved(arrangement, panels, by));
    return;
  }
  const moves = new Map<string, Map<number, Point>>();
  for (const { panel, vertex } of vertices.values()) {
    const place = arrangement[panel];
    if (place === undefined) continue;
    const own = moves.get(panel) ?? new Map<number, Point>();
    own.set(vertex, directionToPanel(place, by));
    moves.set(panel, own);
  }
  set({ message: null });
  performMoves(vertices.size > 1 ? `Move ${vertices.size} points` : "Move point", moves, mirror);
}

export function performMoves(label: string, moves: Moves, mirror = usePatternView.getState().mirror): void {
  const specification = shownSpecification();
  if (specification === null) return;
  perform(label, moveVertices(specification, mirror ? mirroredMoves(specification, moves) : moves));
}

export function rotateSelected(degrees: number): void {
  const specification = shownSpecification();
  if (specification === null) return;
  let { arrangement } = usePatternView.getState();
  for (const t of useStudio.getState().selection)
    if (t.kind === "panel")
      arrangement = rotated(arrangement, t.panel, panelOf(specification, t.panel), degrees);
  keepArrangement("Turn panels", arrangement);
}

/** Shows the panels so; nothing can be undone yet. */
export function showArrangement(arrangement: Arrangement): void {
  usePatternView.getState().set({ arrangement });
}

/** The panels lie so from now on: one entry in the history. */
export function keepArrangement(
  label: string,
  after: Arrangement,
  before = usePatternView.getState().arrangement,
): void {
  if (after === before) return;
  useStudio.getState().arrange(label, before, after);
  showArrangement(after);
}

export function arrangeAnew(): void {
  const specification = shownSpecification();
  if (specification === null) return;
  keepArrangement("Arrange panels anew", arranged(specification, aspectOf(usePatternView.getState().size)));
  fitAll();
}

/** Width over height of the window, which the sheet should have too; null before it is known. */
export function aspectOf(size: Point): number | null {
  return size[0] > 0 && size[1] > 0 ? size[0] / size[1] : null;
}

export function fitAll(): void {
  const specification = shownSpecification();
  const { arrangement, size, set } = usePatternView.getState();
  if (specification === null || size[0] === 0) return;
  set({ view: fitted(boxOfAll(specification, arrangement), size, FIT_MARGIN) });
}

/** Brings something into the middle of the window. */
export function showTarget(target: Target): void {
  const specification = shownSpecification();
  const { arrangement, size, set } = usePatternView.getState();
  if (specification === null || size[0] === 0) return;
  const points = pointsOf(specification, target).flatMap(({ panel, point }) => {
    const place = arrangement[panel];
    return place === undefined ? [] : [toSheet(place, point)];
  });
  if (points.length === 0) return;
  set({ view: fitted(boxOf(points), size, besideFindings(), FOCUS_NEAREST) });
}

/** Where the list of findings is open, a place is shown beside it or below it, wherever there is more room. */
function besideFindings(): Margins {
  const box = (what: string) => document.querySelector(`.pattern-drawing ${what}`)?.getBoundingClientRect();
  const [sheet, list, inspector] = [box(".pattern-sheet"), box(".findings-body"), box(".inspector")];
  if (sheet === undefined || list === undefined) return FOCUS_MARGIN;
  const floor = inspector?.top ?? sheet.bottom;
  const bottom = Math.max(FOCUS_MARGIN.bottom, sheet.bottom - floor + LIST_GAP);
  if (list.left - sheet.left > floor - list.bottom)
    return { ...FOCUS_MARGIN, bottom, right: sheet.right - list.left + LIST_GAP };
  return { left: LIST_GAP, right: LIST_GAP, top: list.bottom - sheet.top + LIST_GAP, bottom };
}

/** Brings points of a panel, cm in its frame, into the middle of the window; without points, nothing happens. */
export function showPoints(panel: string, points: readonly Point[]): void {
  const { arrangement, size, set } = usePatternView.getState();
  const place = arrangement[panel];
  if (place === undefined || points.length === 0 || size[0] === 0) return;
  const box = boxOf(points.map((p) => toSheet(place, p)));
  set({ view: fitted(box, size, besideFindings(), FOCUS_NEAREST) });
}

function pointsOf(specification: Specification, target: Target): { panel: string; point: Point }[] {
  const { panels, stitches } = specification.pattern;
  if (target.kind === "seam") {
    const stitch = stitches[target.stitch];
    return stitch === undefined
      ? []
      : [stitch[0], stitch[1]].flatMap((side) => pointsOf(specification, { kind: "edge", ...side }));
  }
  const panel = panels[target.panel];
  if (panel === undefined) return [];
  if (target.kind === "panel") return panel.vertices.map((point) => ({ panel: target.panel, point }));
  if (target.kind === "vertex") {
    const point = panel.vertices[target.vertex];
    return point === undefined ? [] : [{ panel: target.panel, point }];
  }
  if (target.edge >= panel.edges.length) return [];
  const curve = curveOf(panel, target.edge);
  return [0, 0.25, 0.5, 0.75, 1].map((t) => ({ panel: target.panel, point: pointAt(curve, t) }));
}

export function zoomToSelection(): void {
  const specification = shownSpecification();
  const { arrangement, size, set } = usePatternView.getState();
  const [first] = useStudio.getState().selection;
  if (specification === null || first === undefined) {
    fitAll();
    return;
  }
  const panels = new Set(useStudio.getState().selection.flatMap((t) => (t.kind === "seam" ? [] : [t.panel])));
  const boxes = panelNames(specification)
    .filter((name) => panels.has(name))
    .flatMap((name) => {
      const place = arrangement[name];
      return place === undefined ? [] : [boxOnSheet(panelOf(specification, name), place)];
    });
  if (boxes.length === 0) showTarget(first);
  else set({ view: fitted(boxAround(boxes), size, FIT_MARGIN) });
}

export function selectAll(): void {
  const specification = shownSpecification();
  if (specification === null) return;
  useStudio.getState().setSelection(panelNames(specification).map((panel) => ({ kind: "panel", panel })));
}

export function tell(message: string): void {
  usePatternView.getState().set({ message });
}

/** Mouse, pen and fingers on the drawing. */

import type { Target } from "../../state/selection";
import { useStudio } from "../../state/store";
import { shareAtParameter } from "../geometry/length";
import { curveOf } from "../geometry/outline";
import { distance } from "../geometry/point";
import type { Arrangement } from "../layout/arrangement";
import { type Point, panelOf, type Specification } from "../specification";
import { addPointAt, keepArrangement, sewTogether, showArrangement, showTarget, tell } from "./commands";
import { shownSpecification, toStore } from "./document";
import { type Drag, type DragPointer, type DragState, dragOf } from "./drags";
import { type Hit, hitAt, within } from "./hit-test";
import { usePatternView } from "./pattern-view-state";
import { onSheet, panned, zoomedAt } from "./view";

const REACH_PX = { mouse: 8, pen: 10, touch: 18 } as const;
const STILL_PX = { mouse: 3, pen: 4, touch: 8 } as const;
const SNAP_PX = 7;
const WHEEL_STEP = 0.0015;
/** Steps that a drag keeps to, far away and near, cm. */
const GRID_CM = { far: 0.5, near: 0.1, from: 30 };
const GRID_INCH = { far: 2.54 / 4, near: 2.54 / 16, from: 30 };

type Kind = keyof typeof REACH_PX;
type Doing =
  | {
      readonly kind: "drag";
      readonly drag: Drag;
      readonly before: Specification;
      /** Where the panels lay when it began. */
      readonly arrangement: Arrangement;
    }
  | { readonly kind: "pan" }
  | { readonly kind: "marquee" };

interface Press {
  readonly id: number;
  readonly from: Point;
  readonly start: Point;
  readonly hit: Hit | null;
  readonly pointer: Kind;
  readonly wantsPan: boolean;
  doing: Doing | null;
  last: Point;
}

/** The step that drags snap to at a scale. */
export function snapGrid(scale: number): number {
  const steps = useStudio.getState().units === "cm" ? GRID_CM : GRID_INCH;
  return scale >= steps.from ? steps.near : steps.far;
}

/** Listens to an element until the returned function is called. */
export function listenForGestures(element: SVGSVGElement): () => void {
  const fingers = new Map<number, Point>();
  let press: Press | null = null;
  let spaceDown = false;
  let frame = 0;
  let pending: (() => void) | null = null;

  const place = (event: { clientX: number; clientY: number }): Point => {
    const box = element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const kindOf = (event: PointerEvent): Kind =>
    event.pointerType === "touch" ? "touch" : event.pointerType === "pen" ? "pen" : "mouse";

  /** At most one state a frame: the hand is faster than the screen. */
  const eachFrame = (work: () => void) => {
    pending = work;
    if (frame === 0)
      frame = requestAnimationFrame(() => {
        frame = 0;
        const now = pending;
        pending = null;
        now?.();
      });
  };
  const atOnce = () => {
    if (frame !== 0) cancelAnimationFrame(frame);
    frame = 0;
    const now = pending;
    pending = null;
    now?.();
  };
  const forget = () => {
    if (frame !== 0) cancelAnimationFrame(frame);
    frame = 0;
    pending = null;
  };

  const lookAt = (px: Point, pointer: Kind): Hit | null => {
    const specification = shownSpecification();
    const { view, arrangement, tool } = usePatternView.getState();
    if (specification === null) return null;
    const reach = REACH_PX[pointer] / view.scale;
    const { selection } = useStudio.getState();
    const bendable = tool === "select" ? selection.flatMap((t) => (t.kind === "edge" ? [t] : [])) : [];
    const hit = hitAt(
      specification,
      arrangement,
      onSheet(view, px),
      { vertex: reach, edge: reach },
      bendable,
    );
    // With the other tools only edges matter.
    if (tool !== "select" && hit?.kind === "vertex")
      return { kind: "edge", panel: hit.panel, edge: hit.vertex, t: 0 };
    return hit;
  };

  const settle = () =>
    usePatternView.getState().set({ guides: [], reading: null, marquee: null, dragging: false });

  const cancel = () => {
    forget();
    if (press?.doing?.kind === "drag") {
      useStudio.getState().cancelPreview();
      showArrangement(press.doing.arrangement);
    }
    press = null;
    settle();
  };

  const begin = (now: Press): Doing => {
    const { tool, arrangement, mirror, hem } = usePatternView.getState();
    const { selection, units } = useStudio.getState();
    const specification = shownSpecification();
    if (now.wantsPan || tool === "pan" || specification === null) return { kind: "pan" };
    if (now.hit === null) return now.pointer === "touch" ? { kind: "pan" } : { kind: "marquee" };
    if (tool !== "select") return { kind: "pan" };
    const setting = { specification, arrangement, selection, mirror, hem, units };
    return {
      kind: "drag",
      drag: dragOf(now.hit, now.start, setting, altDown),
      before: specification,
      arrangement,
    };
  };

  let altDown = false;
  let snapOff = false;

  const show = (state: DragState, before: Specification) => {
    const { set } = usePatternView.getState();
    if (state.arrangement !== null) showArrangement(state.arrangement);
    const { edit } = state;
    set({ guides: state.guides, reading: state.reading, dragging: true, message: edit?.refused ?? null });
    if (edit === null || edit.refused !== undefined) return;
    if (edit.specification === before) useStudio.getState().cancelPreview();
    else useStudio.getState().preview(toStore(edit.specification));
  };

  const follow = (now: Press, px: Point) => {
    const { view, set, snap } = usePatternView.getState();
    if (now.doing?.kind === "pan") set({ view: panned(view, [px[0] - now.last[0], px[1] - now.last[1]]) });
    if (now.doing?.kind === "marquee") set({ marquee: { from: now.start, to: onSheet(view, px) } });
    if (now.doing?.kind === "drag") {
      const pointer: DragPointer = {
        to: onSheet(view, px),
        snap: snap && !snapOff,
        reach: SNAP_PX / view.scale,
        grid: snapGrid(view.scale),
      };
      show(now.doing.drag.to(pointer), now.doing.before);
    }
    now.last = px;
  };

  const click = (now: Press, event: PointerEvent) => {
    const { tool, sewFrom, set } = usePatternView.getState();
    const { select } = useStudio.getState();
    const how = event.shiftKey || event.ctrlKey || event.metaKey ? "toggle" : "replace";
    set({ message: null });
    if (tool === "point") {
      const specification = shownSpecification();
      if (now.hit?.kind !== "edge" || specification === null)
        return tell("Click on an edge to add a point to it.");
      const curve = curveOf(panelOf(specification, now.hit.panel), now.hit.edge);
      return addPointAt(now.hit, shareAtParameter(curve, now.hit.t));
    }
    if (tool === "sew") {
      if (now.hit?.kind !== "edge") return set({ sewFrom: null });
      const edge = { panel: now.hit.panel, edge: now.hit.edge };
      if (sewFrom === null) {
        select({ kind: "edge", ...edge });
        return set({ sewFrom: edge });
      }
      sewTogether(sewFrom, edge);
      return set({ sewFrom: null });
    }
    if (now.hit === null) {
      if (how === "replace") select(null);
      return;
    }
    if (now.hit.kind !== "handle") select(targetOf(now.hit), how);
  };

  const onDown = (event: PointerEvent) => {
    const px = place(event);
    element.setPointerCapture(event.pointerId);
    if (event.pointerType === "touch") fingers.set(event.pointerId, px);
    if (fingers.size === 2) {
      // A second finger: what the first began was not meant.
      cancel();
      return;
    }
    if (press !== null || (event.button !== 0 && event.button !== 1 && event.button !== 2)) return;
    // A field that is being typed in is left first, so that its number goes where it belongs.
    if (!element.contains(document.activeElement)) element.focus({ preventScroll: true });
    const { view, tool } = usePatternView.getState();
    const pointer = kindOf(event);
    press = {
      id: event.pointerId,
      from: px,
      start: onSheet(view, px),
      hit: lookAt(px, pointer),
      pointer,
      wantsPan: event.button !== 0 || spaceDown,
      doing: null,
      last: px,
    };
    altDown = event.altKey;
    // What is taken hold of is selected at once, unless it is part of what is selected already.
    const { hit } = press;
    if (tool === "select" && hit !== null && hit.kind !== "handle" && !press.wantsPan && !event.shiftKey) {
      const target = targetOf(hit);
      const { selection, select } = useStudio.getState();
      if (
        !selection.some((t) => JSON.stringify(t) === JSON.stringify(target)) &&
        !event.ctrlKey &&
        !event.metaKey
      )
        select(target);
    }
  };

  const onMove = (event: PointerEvent) => {
    const px = place(event);
    snapOff = event.ctrlKey || event.metaKey;
    if (fingers.size === 2 && fingers.has(event.pointerId)) {
      pinch(event.pointerId, px);
      return;
    }
    if (press === null || press.id !== event.pointerId) {
      if (event.pointerType !== "touch") hover(px, kindOf(event));
      return;
    }
    if (press.doing === null) {
      if (distance(px, press.from) < STILL_PX[press.pointer]) return;
      press.doing = begin(press);
    }
    const now = press;
    eachFrame(() => follow(now, px));
  };

  const pinch = (id: number, px: Point) => {
    const other = [...fingers.entries()].find(([each]) => each !== id)?.[1];
    const before = fingers.get(id);
    fingers.set(id, px);
    if (other === undefined || before === undefined) return;
    const { view, set } = usePatternView.getState();
    const middle: Point = [(px[0] + other[0]) / 2, (px[1] + other[1]) / 2];
    const was: Point = [(before[0] + other[0]) / 2, (before[1] + other[1]) / 2];
    const factor = distance(px, other) / Math.max(distance(before, other), 1);
    set({ view: zoomedAt(panned(view, [middle[0] - was[0], middle[1] - was[1]]), middle, factor) });
  };

  const hover = (px: Point, pointer: Kind) =>
    eachFrame(() => {
      const hit = lookAt(px, pointer);
      const { set, tool } = usePatternView.getState();
      useStudio
        .getState()
        .setHover(
          hit === null
            ? null
            : hit.kind === "handle"
              ? targetOf({ ...hit, kind: "edge", t: 0 })
              : targetOf(hit),
        );
      element.style.cursor = cursorFor(hit, tool, spaceDown);
      set({
        ghost:
          tool === "point" && hit?.kind === "edge" ? { panel: hit.panel, edge: hit.edge, t: hit.t } : null,
      });
    });

  const onUp = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    if (press === null || press.id !== event.pointerId) return;
    atOnce();
    const now = press;
    press = null;
    if (now.doing === null) {
      settle();
      if (event.button === 0) click(now, event);
      return;
    }
    if (now.doing.kind === "drag") drop(now.doing.drag, now.doing.arrangement);
    if (now.doing.kind === "marquee") choose(now, event.shiftKey);
    settle();
  };

  const drop = (drag: Drag, before: Arrangement) => {
    const { draft, apply } = useStudio.getState();
    if (draft !== null) apply(drag.label, draft);
    else keepArrangement("Move panels", usePatternView.getState().arrangement, before);
  };

  const choose = (now: Press, more: boolean) => {
    const specification = shownSpecification();
    const { marquee, arrangement } = usePatternView.getState();
    if (specification === null || marquee === null) return;
    const found = within(specification, arrangement, [now.start, marquee.to]);
    const { selection, setSelection } = useStudio.getState();
    setSelection(
      more
        ? [
            ...selection,
            ...found.filter((t) => !selection.some((s) => JSON.stringify(s) === JSON.stringify(t))),
          ]
        : found,
    );
  };

  const onDoubleClick = (event: MouseEvent) => {
    const hit = lookAt(place(event), "mouse");
    const specification = shownSpecification();
    if (hit === null || specification === null || usePatternView.getState().tool !== "select") return;
    if (hit.kind === "edge")
      addPointAt(hit, shareAtParameter(curveOf(panelOf(specification, hit.panel), hit.edge), hit.t));
    else if (hit.kind === "panel") showTarget({ kind: "panel", panel: hit.panel });
  };

  const onWheel = (event: WheelEvent) => {
    event.preventDefault();
    const { view, set } = usePatternView.getState();
    const lines = event.deltaMode === 1 ? 16 : 1;
    if (event.shiftKey) set({ view: panned(view, [-(event.deltaX + event.deltaY) * lines, 0]) });
    else if (event.altKey) set({ view: panned(view, [0, -event.deltaY * lines]) });
    // Trackpads send a pinch as a wheel with Ctrl, in finer steps.
    else
      set({
        view: zoomedAt(
          view,
          place(event),
          Math.exp(-event.deltaY * lines * WHEEL_STEP * (event.ctrlKey ? 6 : 1)),
        ),
      });
  };

  const onKey = (event: KeyboardEvent) => {
    snapOff = event.ctrlKey || event.metaKey;
    if (event.code === "Space" && event.target === element) {
      spaceDown = event.type === "keydown";
      event.preventDefault();
    }
    if (event.type === "keydown" && event.key === "Escape" && press !== null) {
      cancel();
      event.preventDefault();
      event.stopPropagation();
    }
  };
  const onLost = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    if (press?.id === event.pointerId) cancel();
  };
  const onLeave = () => {
    if (press === null) useStudio.getState().setHover(null);
  };
  const onMenu = (event: Event) => event.preventDefault();

  element.addEventListener("pointerdown", onDown);
  element.addEventListener("pointermove", onMove);
  element.addEventListener("pointerup", onUp);
  element.addEventListener("pointercancel", onLost);
  element.addEventListener("pointerleave", onLeave);
  element.addEventListener("dblclick", onDoubleClick);
  element.addEventListener("wheel", onWheel, { passive: false });
  element.addEventListener("contextmenu", onMenu);
  window.addEventListener("keydown", onKey, true);
  window.addEventListener("keyup", onKey, true);
  return () => {
    forget();
    element.removeEventListener("pointerdown", onDown);
    element.removeEventListener("pointermove", onMove);
    element.removeEventListener("pointerup", onUp);
    element.removeEventListener("pointercancel", onLost);
    element.removeEventListener("pointerleave", onLeave);
    element.removeEventListener("dblclick", onDoubleClick);
    element.removeEventListener("wheel", onWheel);
    element.removeEventListener("contextmenu", onMenu);
    window.removeEventListener("keydown", onKey, true);
    window.removeEventListener("keyup", onKey, true);
  };
}

function targetOf(hit: Exclude<Hit, { kind: "handle" }>): Target {
  if (hit.kind === "edge") return { kind: "edge", panel: hit.panel, edge: hit.edge };
  if (hit.kind === "vertex") return { kind: "vertex", panel: hit.panel, vertex: hit.vertex };
  return { kind: "panel", panel: hit.panel };
}

function cursorFor(hit: Hit | null, tool: string, panning: boolean): string {
  if (panning || tool === "pan") return "grab";
  if (tool === "point" || tool === "sew") return "crosshair";
  if (hit === null) return "default";
  return hit.kind === "panel" ? "move" : "pointer";
}

import { useEffect, useLayoutEffect, useMemo, useRef, useState } from "react";
import { currentVersion, shownPattern, shownTrims, useStudio } from "../state/store";
import { arranged, hasOverlaps, kept } from "./layout/arrangement";
import { panelNames, panelOf, type Specification } from "./specification";
import { aspectOf, fitAll, showArrangement, showTarget } from "./window/commands";
import { FindingsList } from "./window/FindingsList";
import { listenForGestures } from "./window/gestures";
import { Inspector } from "./window/Inspector";
import { commandFor } from "./window/keys";
import { Overlay } from "./window/Overlay";
import { PanelShape } from "./window/PanelShape";
import { usePatternView } from "./window/pattern-view-state";
import { Grid, Rulers } from "./window/Sheet";
import { type EdgeMark, seamMarks } from "./window/seam-marks";
import { Toolbar } from "./window/Toolbar";
import { trimsByPanel } from "./window/TrimMarks";
import "./pattern.css";

const SETTLED_MS = 160;
/** Where all panels may have grown. */
const RECUT: ReadonlySet<string> = new Set(["fit", "alter", "edit"]);

/** The flat pattern: looked at, measured and changed. */
export function PatternWindow() {
  const specification: Specification | null = useStudio(shownPattern);
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: keys of what is inside, each of which has a role.
    <div
      className="pattern-window"
      onKeyDown={(event) => {
        if (event.target instanceof HTMLElement && event.target.matches("input, select, textarea")) return;
        const command = commandFor(event);
        if (command === null) return;
        event.preventDefault();
        command();
      }}
    >
      <Toolbar />
      {specification === null ? (
        <div className="pattern-empty">
          <p>Nothing is open. Describe a garment, choose an example, or open a pattern file.</p>
        </div>
      ) : (
        <Drawing specification={specification} />
      )}
    </div>
  );
}

function Drawing({ specification }: { specification: Specification }) {
  const svg = useRef<SVGSVGElement>(null);
  const { view, size, reading, message } = usePatternView();
  const units = useStudio((state) => state.units);
  const focus = useStudio((state) => state.focus);
  useSize(svg);
  useArrangement(specification);
  useEffect(() => (svg.current === null ? undefined : listenForGestures(svg.current)), []);
  useEffect(() => {
    if (focus !== null) showTarget(focus.target);
  }, [focus]);
  const { scale, corner } = view;
  const settled = useSettled(scale);
  const toScreen = `matrix(${scale} 0 0 ${-scale} ${-corner[0] * scale} ${corner[1] * scale})`;
  return (
    <div className="pattern-drawing">
      <svg
        ref={svg}
        className="pattern-sheet"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: the drawing takes keys, as its panels do.
        tabIndex={0}
        role="application"
        aria-label={`Sewing pattern of ${panelNames(specification).length} panels`}
        style={{ "--cm-per-px": 1 / settled } as React.CSSProperties}
      >
        <Grid {...{ view, size, units }} />
        <g transform={toScreen}>
          <Panels specification={specification} settled={settled} />
        </g>
        <Rulers {...{ view, size, units }} />
      </svg>
      {reading !== null && reading !== "" && <output className="reading">{reading}</output>}
      <p className="message" role="status" data-shown={message ? true : undefined}>
        {message}
      </p>
      <FindingsList />
      <Inspector specification={specification} />
    </div>
  );
}

function Panels({ specification, settled }: { specification: Specification; settled: number }) {
  const arrangement = usePatternView((state) => state.arrangement);
  // Labels appear in steps, so that a little zoom does not draw all panels anew.
  const scale = 2 ** (Math.round(2 * Math.log2(settled)) / 2);
  const numbers = usePatternView((state) => state.numbers);
  const names = usePatternView((state) => state.names);
  const theme = useStudio((state) => state.theme);
  const units = useStudio((state) => state.units);
  const selection = useStudio((state) => state.selection);
  const before = useRef<ReadonlyMap<string, readonly EdgeMark[]>>(new Map());
  const marks = useMemo(() => seamMarks(specification, before.current), [specification]);
  before.current = marks;
  const shown = useStudio(shownTrims);
  const trims = useMemo(() => trimsByPanel(shown), [shown]);
  const selected = new Set(selection.flatMap((t) => (t.kind === "panel" ? [t.panel] : [])));
  return (
    <>
      {panelNames(specification).map((name) => {
        const place = arrangement[name];
        const own = marks.get(name);
        if (place === undefined || own === undefined) return null;
        return (
          <PanelShape
            key={name}
            {...{ name, place, scale, theme, units, numbers, names, onFocus, onEnter }}
            panel={panelOf(specification, name)}
            marks={own}
            trims={trims.get(name)}
            selected={selected.has(name)}
          />
        );
      })}
      <Overlay specification={specification} arrangement={arrangement} />
    </>
  );
}

/** A value once it has not changed for a moment: while one zooms, labels grow with the sheet. */
function useSettled(value: number): number {
  const [settled, setSettled] = useState(value);
  useEffect(() => {
    const timer = setTimeout(() => setSettled(value), SETTLED_MS);
    return () => clearTimeout(timer);
  }, [value]);
  return settled;
}

function onFocus(panel: string): void {
  useStudio.getState().select({ kind: "panel", panel });
}

/** From a panel to its points and edges. */
function onEnter(panel: string): void {
  useStudio.getState().select({ kind: "panel", panel });
  requestAnimationFrame(() => {
    document.querySelector<SVGElement>(".pattern-window .active [data-target]")?.focus();
  });
}

function useSize(svg: React.RefObject<SVGSVGElement | null>): void {
  useEffect(() => {
    const element = svg.current;
    if (element === null) return;
    const observer = new ResizeObserver(() => {
      const { set, size } = usePatternView.getState();
      const first = size[0] === 0;
      set({ size: [element.clientWidth, element.clientHeight] });
      if (!first) return;
      const specification = shownPattern(useStudio.getState());
      if (specification === null) return;
      // Before its size was known the sheet had no shape; what somebody has arranged stays.
      if (currentVersion(useStudio.getState())?.arrangement === undefined)
        showArrangement(arranged(specification, aspectOf([element.clientWidth, element.clientHeight])));
      fitAll();
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, [svg]);
}

/** Panels stay where they lie while the pattern changes; another document is laid out anew and shown whole. */
function useArrangement(specification: Specification): void {
  const document = useStudio((state) => state.history?.entries[0]?.id ?? null);
  const wanted = useStudio((state) => currentVersion(state)?.arrangement);
  const recut = useStudio((state) => state.draft === null && RECUT.has(currentVersion(state)?.origin ?? ""));
  useLayoutEffect(() => {
    const { arrangement, arrangedFor, size, set } = usePatternView.getState();
    const same = arrangedFor !== null && arrangedFor.document === document;
    const aspect = aspectOf(size);
    const another = wanted !== undefined && wanted !== arrangedFor?.wanted;
    let next = another
      ? kept(wanted, specification, specification, aspect)
      : same
        ? kept(arrangement, arrangedFor.specification, specification, aspect)
        : arranged(specification, aspect);
    // What was recut may have outgrown its places or gained panels; those that somebody has chosen stay.
    const grown = recut && Object.keys(next).some((name) => arrangement[name] === undefined);
    if (recut && wanted === undefined && (grown || hasOverlaps(specification, next)))
      next = arranged(specification, aspect);
    set({ arrangement: next, arrangedFor: { document, specification, wanted } });
    const stays = Object.keys(next).some((name) => next[name] === arrangement[name]);
    if (!same || grown || (!stays && !another)) fitAll();
  }, [specification, document, wanted, recut]);
}

/** The studio's state: one document with its history, what is selected, how it is shown. See STORE.md. */

import { create } from "zustand";
import type { Finding, Version } from "./document";
import { amended, type History, movedTo, pushed, started } from "./history";
import type { PatternJson } from "./pattern-json";
import { sameTarget, type Target } from "./selection";
import type { Units } from "./units";

export type Theme = "light" | "dark";

export interface DocumentSlice {
  /** null: nothing is open. */
  history: History<Version> | null;
  /** The pattern while something is dragged: shown in place of the version's, not in the history yet. */
  draft: PatternJson | null;
  /** What the last answer to the draft said, null while none has come. */
  draftFindings: Finding[] | null;

  /** Shows this pattern and lets the garment follow, without an entry in the history. */
  preview: (pattern: PatternJson) => void;
  /** One entry in the history: ends a drag, or does the whole of a change. */
  apply: (label: string, pattern: PatternJson) => void;
  /** Back to the version as it was before the drag. */
  cancelPreview: () => void;
  /** Another document, with a history of its own. */
  open: (label: string, version: Version) => void;
  /** What was computed of the shown version has arrived. */
  amend: (change: Partial<Version>) => void;
  undo: () => void;
  redo: () => void;
  goTo: (index: number) => void;
}

export interface SelectionSlice {
  selection: Target[];
  hover: Target | null;
  /** What the windows should bring into view; `at` changes with every wish. */
  focus: { target: Target; at: number } | null;
  select: (target: Target | null, how?: "replace" | "toggle") => void;
  setSelection: (targets: Target[]) => void;
  setHover: (target: Target | null) => void;
  focusOn: (target: Target) => void;
}

export interface ViewSlice {
  units: Units;
  theme: Theme;
  setUnits: (units: Units) => void;
  setTheme: (theme: Theme) => void;
}

export type StudioState = DocumentSlice & SelectionSlice & ViewSlice;

export const useStudio = create<StudioState>()((set, get) => ({
  history: null,
  draft: null,
  draftFindings: null,
  preview: (pattern) => set({ draft: pattern }),
  apply: (label, pattern) => {
    const { history } = get();
    if (history === null) return;
    const version: Version = { pattern, findings: null, mesh: null };
    set({
      history: pushed(history, label, version),
      draft: null,
      draftFindings: null,
      selection: kept(get().selection, pattern),
    });
  },
  cancelPreview: () => set({ draft: null, draftFindings: null }),
  open: (label, version) =>
    set({ history: started(label, version), draft: null, draftFindings: null, selection: [], hover: null }),
  amend: (change) => {
    const { history } = get();
    if (history !== null) set({ history: amended(history, (version) => ({ ...version, ...change })) });
  },
  undo: () => get().goTo((get().history?.index ?? 0) - 1),
  redo: () => get().goTo((get().history?.index ?? 0) + 1),
  goTo: (index) => {
    const { history } = get();
    if (history === null) return;
    const next = movedTo(history, index);
    const pattern = next.entries[next.index]?.value.pattern;
    if (pattern === undefined) return;
    set({
      history: next,
      draft: null,
      draftFindings: null,
      hover: null,
      selection: kept(get().selection, pattern),
    });
  },

  selection: [],
  hover: null,
  focus: null,
  select: (target, how = "replace") => {
    const { selection } = get();
    if (target === null) set({ selection: [] });
    else if (how === "replace") set({ selection: [target] });
    else if (selection.some((each) => sameTarget(each, target)))
      set({ selection: selection.filter((each) => !sameTarget(each, target)) });
    else set({ selection: [...selection, target] });
  },
  setSelection: (targets) => set({ selection: targets }),
  setHover: (target) => {
    if (!sameTarget(get().hover, target)) set({ hover: target });
  },
  focusOn: (target) => set({ selection: [target], focus: { target, at: Date.now() } }),

  units: "cm",
  theme: "light",
  setUnits: (units) => set({ units }),
  setTheme: (theme) => set({ theme }),
}));

/** The version that the history shows. */
export function currentVersion(state: StudioState): Version | null {
  return state.history?.entries[state.history.index]?.value ?? null;
}

/** The pattern to draw: the draft of a drag, or the version's. */
export function shownPattern(state: StudioState): PatternJson | null {
  return state.draft ?? currentVersion(state)?.pattern ?? null;
}

/** Findings of what is drawn; null while they are not known. */
export function shownFindings(state: StudioState): Finding[] | null {
  return state.draft !== null ? state.draftFindings : (currentVersion(state)?.findings ?? null);
}

function kept(selection: Target[], pattern: PatternJson): Target[] {
  return selection.filter((target) => exists(target, pattern));
}

function exists(target: Target, { pattern }: PatternJson): boolean {
  if (target.kind === "seam") return target.stitch < pattern.stitches.length;
  const panel = pattern.panels[target.panel];
  if (panel === undefined) return false;
  if (target.kind === "edge") return target.edge < panel.edges.length;
  if (target.kind === "vertex") return target.vertex < panel.vertices.length;
  return true;
}

/** The open document with its history, what is selected, and units and theme. See STORE.md. */

import { create } from "zustand";
import type { ClothPrint, FindingInfo, Reading, SeamInfo, TrimMark } from "../api/types";
import type { Arrangement } from "../pattern/layout/arrangement";
import { changedVersion, type Version } from "./document";
import { amended, canRedo, canUndo, type History, movedTo, pushed, started } from "./history";
import type { PatternJson } from "./pattern-json";
import { sameTarget, type Target } from "./selection";
import type { Units } from "./units";

export type Theme = "light" | "dark";

/** What the last live answer said of the draft. */
export interface DraftAnswer {
  /** The pattern that the answer is about: the draft, or one just before it. */
  pattern: PatternJson;
  findings: FindingInfo[];
  seams: SeamInfo[];
  trims?: TrimMark[];
  mesh: string | null;
  /** Of the mesh, cm. */
  edge_length: number;
  /** Whether the mesh is a hasty one, to be looked at while the hand moves, and not to be kept. */
  hasty?: boolean;
}

export interface DocumentSlice {
  /** null: nothing is open. */
  history: History<Version> | null;
  /** The pattern while something is dragged: shown in place of the version's, not in the history yet. */
  draft: PatternJson | null;
  /** null while no answer to the draft has come. */
  draftAnswer: DraftAnswer | null;

  /** Shows this pattern and lets the garment follow, without an entry in the history. */
  preview: (pattern: PatternJson) => void;
  /** One entry in the history: ends a drag, or does the whole of a change. */
  apply: (label: string, pattern: PatternJson) => void;
  /** Back to the version as it was before the drag. */
  cancelPreview: () => void;
  /** Another document, with a history of its own. */
  open: (label: string, version: Version) => void;
  /** The same document after work that brought everything along, as one entry in the history. */
  add: (label: string, version: Version) => void;
  /** The panels lie otherwise in the pattern window: one entry in the history, of the same pattern. */
  arrange: (label: string, before: Arrangement, after: Arrangement) => void;
  /** All of a document with its history, as it was saved. */
  restore: (history: History<Version>) => void;
  /** What was worked out of `pattern` has arrived; dropped where that is no longer shown. */
  amend: (pattern: PatternJson, change: Partial<Version>) => void;
  answerDraft: (answer: DraftAnswer) => void;
  /** A draft that came with its garment, as when a slider is moved: nothing has to be sewn. */
  previewAnswered: (answer: DraftAnswer) => void;
  /** Another colour of the cloth, "#rrggbb": of the shown version and of what is made of it. */
  dye: (color: string) => void;
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

const ONE_STEP_MS = 1500;
const NO_TRIMS: readonly TrimMark[] = [];
const NO_DRAFT = { draft: null, draftAnswer: null } as const;

export const useStudio = create<StudioState>()((set, get) => ({
  history: null,
  ...NO_DRAFT,
  preview: (pattern) => set({ draft: pattern }),
  apply: (label, pattern) => {
    const { history, draftAnswer } = get();
    const before = currentVersion(get());
    if (history === null || before === null) return;
    const version = changedVersion(before, pattern);
    // Until the answer for the last state is there, the garment of the one before it stays in view.
    if (draftAnswer?.pattern === pattern)
      Object.assign(version, {
        findings: draftAnswer.findings,
        seams: draftAnswer.seams,
        ...(draftAnswer.trims === undefined ? {} : { trims: draftAnswer.trims }),
        // A hasty garment stays in view until the full one of the same pattern is there.
        ...(draftAnswer.hasty || draftAnswer.mesh === null
          ? {}
          : { mesh: draftAnswer.mesh, garment: "sewn", edge_length: draftAnswer.edge_length }),
      });
    set({ history: pushed(history, label, version), ...NO_DRAFT, selection: kept(get().selection, pattern) });
  },
  cancelPreview: () => set(NO_DRAFT),
  open: (label, version) =>
    set({ history: started(label, version), ...NO_DRAFT, selection: [], hover: null, focus: null }),
  add: (label, version) => {
    const { history, selection } = get();
    if (history === null) return get().open(label, version);
    set({
      history: pushed(history, label, arrangedAs(currentVersion(get()), version)),
      ...NO_DRAFT,
      selection: kept(selection, version.pattern),
    });
  },
  arrange: (label, before, after) => {
    const version = currentVersion(get());
    const { history } = get();
    if (history === null || version === null) return;
    const last = history.entries[history.index];
    const known = amended(
      history,
      (each) => each.arrangement === undefined,
      (each) => ({ ...each, arrangement: before }),
    );
    // Many small steps with the arrow keys are one.
    const goesOn = last?.label === label && Date.now() - last.at < ONE_STEP_MS && !canRedo(history);
    const from = goesOn && canUndo(known) ? movedTo(known, known.index - 1) : known;
    set({ history: pushed(from, label, { ...version, arrangement: after }) });
  },
  restore: (history) => set({ history, ...NO_DRAFT, selection: [], hover: null, focus: null }),
  amend: (pattern, change) => {
    const { history } = get();
    if (history !== null)
      set({
        history: amended(
          history,
          (version) => version.pattern === pattern,
          (version) => ({ ...version, ...change }),
        ),
      });
  },
  answerDraft: (answer) => {
    if (get().draft !== null) set({ draftAnswer: answer });
  },
  previewAnswered: (answer) => set({ draft: answer.pattern, draftAnswer: answer }),
  dye: (color) => {
    const version = currentVersion(get());
    if (version === null) return;
    const print = version.print == null ? {} : { print: recolored(version.print, version.color, color) };
    get().amend(version.pattern, { color, ...print });
  },
  undo: () => get().goTo((get().history?.index ?? 0) - 1),
  redo: () => get().goTo((get().history?.index ?? 0) + 1),
  goTo: (index) => {
    const { history, selection } = get();
    if (history === null) return;
    const next = movedTo(history, index);
    const pattern = next.entries[next.index]?.value.pattern;
    if (pattern === undefined) return;
    set({ history: next, ...NO_DRAFT, hover: null, selection: kept(selection, pattern) });
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
export function shownFindings(state: StudioState): FindingInfo[] | null {
  return state.draft !== null
    ? (state.draftAnswer?.findings ?? null)
    : (currentVersion(state)?.findings ?? null);
}

/** Seams with lengths and mismatch, of what is drawn; null while they are not known. */
export function shownSeams(state: StudioState): SeamInfo[] | null {
  return state.draft !== null ? (state.draftAnswer?.seams ?? null) : (currentVersion(state)?.seams ?? null);
}

/** Marks of pockets, buttons and zips on what is drawn; while they are worked out, where they were. */
export function shownTrims(state: StudioState): readonly TrimMark[] {
  const drafted = state.draft !== null ? state.draftAnswer?.trims : undefined;
  return drafted ?? currentVersion(state)?.trims ?? NO_TRIMS;
}

/** Name of the garment's mesh to show; null: keep what is shown until there is one. */
export function shownMesh(state: StudioState): string | null {
  return state.draftAnswer?.mesh ?? currentVersion(state)?.mesh ?? null;
}

/** What was read last, of the shown version or of the one it came from. */
export function lastReading(state: StudioState): Reading | null {
  const { history } = state;
  if (history === null) return null;
  for (let k = history.index; k >= 0; k -= 1) {
    const reading = history.entries[k]?.value.reading;
    if (reading) return reading;
  }
  return null;
}

/** The print with the cloth's colour, or else its first one, changed. */
function recolored(print: ClothPrint, before: string | null, after: string): ClothPrint {
  const place = Math.max(0, print.colors.indexOf(before ?? ""));
  return { ...print, colors: print.colors.map((color, k) => (k === place ? after : color)) };
}

function arrangedAs(before: Version | null, version: Version): Version {
  if (version.arrangement !== undefined || before?.arrangement === undefined) return version;
  return { ...version, arrangement: before.arrangement };
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

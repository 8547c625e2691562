/** What only the pattern window knows: view, tool, switches, where panels lie, what a drag shows. */

import { create } from "zustand";
import { remember, remembered } from "../../state/remembered";
import type { Arrangement } from "../layout/arrangement";
import type { EdgeRef, Point, Specification } from "../specification";
import type { Guide } from "./snapping";
import type { View } from "./view";

export type Tool = "select" | "point" | "sew" | "pan";

export interface Switches {
  /** Changes are made on both sides of the body. */
  readonly mirror: boolean;
  readonly snap: boolean;
  /** A free edge is dragged with the whole hem that it belongs to. */
  readonly hem: boolean;
  readonly numbers: boolean;
  readonly names: boolean;
}

export interface Marquee {
  readonly from: Point;
  readonly to: Point;
}

interface PatternViewState extends Switches {
  readonly tool: Tool;
  readonly view: View;
  /** Of the drawing area, px. */
  readonly size: Point;
  readonly arrangement: Arrangement;
  /** The document (its history's first entry) and the state of it that panels are arranged for. */
  readonly arrangedFor: {
    readonly document: number | null;
    readonly specification: Specification;
    /** What the shown version wanted, which is done by now. */
    readonly wanted: Arrangement | undefined;
  } | null;
  /** The edge that the next one is sewn to. */
  readonly sewFrom: EdgeRef | null;
  readonly guides: readonly Guide[];
  /** What the hand is doing, in words: "10 cm down". */
  readonly reading: string | null;
  /** Rectangle on the sheet, cm. */
  readonly marquee: Marquee | null;
  readonly dragging: boolean;
  /** Where a click would add a point. */
  readonly ghost: (EdgeRef & { readonly t: number }) | null;
  /** Why the last wish was refused, or what it brought about. */
  readonly message: string | null;
  readonly findingsOpen: boolean;
  set: (change: Partial<PatternViewState>) => void;
  flip: (name: keyof Switches) => void;
}

const SWITCHES: Switches = { mirror: true, snap: true, hem: true, numbers: true, names: true };

export const usePatternView = create<PatternViewState>()((set, get) => ({
  ...SWITCHES,
  ...remembered<Partial<Switches>>("pattern-window", {}),
  tool: "select",
  view: { scale: 4, corner: [0, 0] },
  size: [0, 0],
  arrangement: {},
  arrangedFor: null,
  sewFrom: null,
  guides: [],
  reading: null,
  marquee: null,
  dragging: false,
  ghost: null,
  message: null,
  findingsOpen: false,
  set: (change) => set(change),
  flip: (name) => {
    set({ [name]: !get()[name] });
    const { mirror, snap, hem, numbers, names } = get();
    remember("pattern-window", { mirror, snap, hem, numbers, names });
  },
}));

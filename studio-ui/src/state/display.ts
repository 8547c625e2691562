/** How the garment is shown, and how the window is divided. Kept in the browser. */

import { create } from "zustand";
import { remember, remembered } from "./remembered";

export type Coloring = "cloth" | "panels" | "strain";
export type Print = "plain" | "stripes" | "checks" | "dots" | "ruler";
export type Side = "front" | "back" | "left" | "right";
export type Layout = "both" | "pattern" | "garment";

export interface DisplayOptions {
  coloring: Coloring;
  /** A print to look at in place of the garment's own; null: its own. */
  trialPrint: Print | null;
  body: boolean;
  wireframe: boolean;
  /** Whether the cloth shows which way it faces, in place of its colour. */
  normals: boolean;
  seams: boolean;
  layout: Layout;
  /** Whether the column on the left is shown, and how wide it is, px. */
  sidebar: boolean;
  sidebarWidth: number;
  /** Share of the pattern window of what is right of the column. */
  split: number;
}

interface DisplayState extends DisplayOptions {
  change: (options: Partial<DisplayOptions>) => void;
}

const DEFAULTS: DisplayOptions = {
  coloring: "cloth",
  trialPrint: null,
  body: true,
  wireframe: false,
  normals: false,
  seams: true,
  layout: "both",
  sidebar: true,
  sidebarWidth: window.innerWidth < 1200 ? 272 : 336,
  split: 0.5,
};

export const useDisplay = create<DisplayState>()((set, get) => ({
  ...DEFAULTS,
  ...remembered<Partial<DisplayOptions>>("display", {}),
  change: (options) => {
    set(options);
    const { change: _, ...kept } = get();
    remember("display", kept);
  },
}));

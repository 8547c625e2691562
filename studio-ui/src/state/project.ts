/** The project that is open: where it is kept, and whether all is saved. */

import { create } from "zustand";

export type SaveState = "unsaved" | "saving" | "autosaved" | "saved" | "failed";

export interface ProjectState {
  /** null: not kept on the server yet. */
  id: string | null;
  name: string;
  folder: string | null;
  revision: number;
  save: SaveState;
  set: (change: Partial<Omit<ProjectState, "set">>) => void;
}

export const UNTITLED = "Untitled garment";

export const useProject = create<ProjectState>()((set) => ({
  id: null,
  name: UNTITLED,
  folder: null,
  revision: 0,
  save: "saved",
  set: (change) => set(change),
}));

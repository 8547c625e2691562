/** What is asked for: words, pictures, seed, number of variants. */

import { create } from "zustand";
import type { FileInfo, Part } from "../api/types";

export interface PromptState {
  text: string;
  /** At most two: front and back. */
  pictures: FileInfo[];
  part: Part | null;
  seed: number;
  /** Whether the next garment is made with the same seed. */
  keepSeed: boolean;
  variants: 1 | 4;
  finish: boolean;
  set: (change: Partial<Omit<PromptState, "set">>) => void;
}

export const usePrompt = create<PromptState>()((set) => ({
  text: "",
  pictures: [],
  part: null,
  seed: 0,
  keepSeed: true,
  variants: 1,
  finish: false,
  set: (change) => set(change),
}));

/** A seed that people can read and type. */
export function randomSeed(): number {
  return Math.floor(Math.random() * 100_000);
}

/** Two garments of the same words, of which one is shown at a time. */

import type { Document, Part } from "../api/types";
import type { Version } from "./document";
import type { History } from "./history";
import type { ProjectState } from "./project";

export interface Piece {
  document: Document;
  /** Its history and project, once something else of the outfit is shown; null before it was opened. */
  left: { history: History<Version>; project: Omit<ProjectState, "set"> } | null;
}

export interface Outfit {
  pieces: Piece[];
  /** Index of the one that is shown. */
  shown: number;
}

export const PART_NAMES: Record<Part, string> = { upper: "Top", lower: "Bottom", whole: "Garment" };

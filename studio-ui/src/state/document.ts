import type { PatternJson } from "./pattern-json";

/** One observation about a pattern, as `swifttailor check` makes it. */
export interface Finding {
  code: string;
  severity: "error" | "warning" | "info";
  message: string;
  panel: string;
  edge: number | null;
  stitch: number | null;
  value: number | string | null;
  why: string;
  /** What mends it, in words; empty where nobody knows. */
  repair: string;
}

/** The state of the document at one point of its history. Never changed in place. */
export interface Version {
  pattern: PatternJson;
  /** null until the server has looked at this pattern. */
  findings: Finding[] | null;
  /** The garment sewn of this pattern: the mesh's name (a digest of its content), null until it is there. */
  mesh: string | null;
}

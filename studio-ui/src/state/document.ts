import type { DimensionInfo, Document, FindingInfo, Reading, SeamInfo } from "../api/types";
import type { Arrangement } from "../pattern/layout/arrangement";
import { fromWire, type PatternJson } from "./pattern-json";

/** One observation about a pattern, as `swifttailor check` makes it. */
export type Finding = FindingInfo;

/**
 * The document at one point of its history. Never changed in place.
 *
 * What is null has not been worked out yet for this pattern; the server's answer brings it.
 */
export interface Version extends Omit<Document, "pattern" | "findings" | "seams" | "reading" | "dimensions"> {
  pattern: PatternJson;
  findings: FindingInfo[] | null;
  seams: SeamInfo[] | null;
  reading: Reading | null;
  dimensions: DimensionInfo[] | null;
  /** Where the panels lie in the pattern window, once somebody has arranged them; no part of the pattern. */
  arrangement?: Arrangement;
}

export function versionOf(document: Document): Version {
  return { ...document, pattern: fromWire(document.pattern) };
}

/**
 * A changed pattern: what was said about the one before no longer holds, but for who made it and its cloth. Marks of
 * its pockets and the like stay where they are until the server's answer moves them.
 */
export function changedVersion(before: Version, pattern: PatternJson): Version {
  return {
    ...before,
    origin: "live",
    pattern,
    findings: null,
    seams: null,
    mesh: null,
    unsewable: null,
    reading: null,
    dimensions: null,
    notes: [],
    warnings: [],
    changes: [],
    open: [],
    quality: null,
    garment: "none",
    seconds: {},
  };
}

const NOTHING_READ: Reading = {
  made: [],
  assumed: [],
  cannot: [],
  unknown: [],
  shown: [],
  language: null,
  color: null,
  fabric: null,
};

/** As the server keeps it; what is not known yet is empty. */
export function documentOf({ arrangement: _, ...version }: Version): Document {
  return {
    ...version,
    findings: version.findings ?? [],
    seams: version.seams ?? [],
    reading: version.reading ?? NOTHING_READ,
    dimensions: version.dimensions ?? [],
  };
}

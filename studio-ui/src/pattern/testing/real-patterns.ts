/** The 20 patterns of GarmentCode that lie beside the Python tests. Only for tests. */

import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { gunzipSync } from "node:zlib";
import type { Specification } from "../specification";

export interface RealPattern {
  readonly id: string;
  readonly pattern: Specification;
}

let loaded: readonly RealPattern[] | null = null;

export function realPatterns(): readonly RealPattern[] {
  loaded ??= gunzipSync(readFileSync(resolve("../tests/garmentcode_patterns/patterns.jsonl.gz")))
    .toString("utf8")
    .split("\n")
    .filter((line) => line !== "")
    .map((line) => JSON.parse(line) as RealPattern);
  return loaded;
}

/** The pattern of that id. */
export function realPattern(id: string): Specification {
  const found = realPatterns().find((each) => each.id === id);
  if (found === undefined) throw new RangeError(`There is no pattern ${id}.`);
  return found.pattern;
}

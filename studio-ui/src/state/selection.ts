/** What is selected or pointed at, in either window. Both windows show the same. */

export type Target =
  | { kind: "panel"; panel: string }
  | { kind: "edge"; panel: string; edge: number }
  | { kind: "vertex"; panel: string; vertex: number }
  /** An index into `pattern.stitches`. */
  | { kind: "seam"; stitch: number };

export function sameTarget(a: Target | null, b: Target | null): boolean {
  if (a === null || b === null) return a === b;
  if (a.kind !== b.kind) return false;
  switch (a.kind) {
    case "panel":
      return a.panel === (b as typeof a).panel;
    case "edge":
      return a.panel === (b as typeof a).panel && a.edge === (b as typeof a).edge;
    case "vertex":
      return a.panel === (b as typeof a).panel && a.vertex === (b as typeof a).vertex;
    case "seam":
      return a.stitch === (b as typeof a).stitch;
  }
}

/** What an edit gives back. Edits are pure: the pattern that went in is as it was. */

import type { EdgeRef, Panel, Specification, Stitch, VertexRef } from "../specification";

export interface Edit {
  /** The new pattern; the very object that went in where nothing was changed. */
  readonly specification: Specification;
  /** Where an edge went: to itself, to its pieces, or nowhere. */
  readonly edges: (ref: EdgeRef) => readonly EdgeRef[];
  /** Where a vertex went; null: it is gone. */
  readonly vertex: (ref: VertexRef) => VertexRef | null;
  /** What a person should be told, such as a seam that has opened. */
  readonly notes: readonly string[];
  /** Why nothing was changed; absent where something was. */
  readonly refused?: string;
}

const sameEdges = (ref: EdgeRef): readonly EdgeRef[] => [ref];
const sameVertex = (ref: VertexRef): VertexRef => ref;

/** An edit that renumbers nothing. */
export function edited(specification: Specification, notes: readonly string[] = []): Edit {
  return { specification, edges: sameEdges, vertex: sameVertex, notes };
}

export function refused(specification: Specification, reason: string): Edit {
  return { specification, edges: sameEdges, vertex: sameVertex, notes: [], refused: reason };
}

/** One edit after another; a refused one leaves the first as it is and adds its reason as a note. */
export function followedBy(first: Edit, next: (specification: Specification) => Edit): Edit {
  const second = next(first.specification);
  if (second.refused !== undefined) return { ...first, notes: [...first.notes, second.refused] };
  return {
    specification: second.specification,
    edges: (ref) => first.edges(ref).flatMap((each) => second.edges(each)),
    vertex: (ref) => {
      const between = first.vertex(ref);
      return between === null ? null : second.vertex(between);
    },
    notes: [...first.notes, ...second.notes],
    ...(first.refused === undefined ? {} : { refused: first.refused }),
  };
}

/** The specification with some panels replaced; their order stays. */
export function withPanels(
  specification: Specification,
  panels: Readonly<Record<string, Panel>>,
  stitches: readonly Stitch[] = specification.pattern.stitches,
): Specification {
  return {
    ...specification,
    pattern: { ...specification.pattern, panels: { ...specification.pattern.panels, ...panels }, stitches },
  };
}

export function withStitches(specification: Specification, stitches: readonly Stitch[]): Specification {
  return withPanels(specification, {}, stitches);
}

/** The stitches without one. The last takes its place, so that all others keep their number and colour. */
export function withoutStitch(stitches: readonly Stitch[], number: number): Stitch[] {
  const kept = [...stitches];
  const last = kept.pop();
  if (last !== undefined && number < kept.length) kept[number] = last;
  return kept;
}

/** The stitches with both sides of each passed through a function. */
export function renumbered(stitches: readonly Stitch[], to: (ref: EdgeRef) => EdgeRef): Stitch[] {
  return stitches.map((s) => (s.length === 3 ? [to(s[0]), to(s[1]), s[2]] : [to(s[0]), to(s[1])]));
}

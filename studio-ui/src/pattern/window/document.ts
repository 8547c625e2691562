/** The way from the store's pattern to ours and back, and edits as entries of its history. */

import type { PatternJson } from "../../state/pattern-json";
import type { Target } from "../../state/selection";
import { shownPattern, useStudio } from "../../state/store";
import type { Edit } from "../edits/edit";
import type { Specification } from "../specification";
import { usePatternView } from "./pattern-view-state";

/** The two types differ in one thing: ours cannot be written to. */
export function toStore(specification: Specification): PatternJson {
  return specification as unknown as PatternJson;
}

export function shownSpecification(): Specification | null {
  return shownPattern(useStudio.getState());
}

/** One entry in the history, or the reason why there is none as a message. Returns whether there is one. */
export function perform(label: string, edit: Edit, select?: readonly Target[]): boolean {
  const before = shownSpecification();
  const { set } = usePatternView.getState();
  set({ message: edit.refused ?? edit.notes[0] ?? null });
  if (edit.refused !== undefined || edit.specification === before) return false;
  const { apply, selection, setSelection } = useStudio.getState();
  const kept = select ?? selection.flatMap((target) => followed(target, edit));
  apply(label, toStore(edit.specification));
  setSelection([...kept]);
  return true;
}

/** Where something selected is after an edit. */
export function followed(target: Target, edit: Edit): Target[] {
  if (target.kind === "edge") {
    const [first] = edit.edges(target);
    return first === undefined ? [] : [{ kind: "edge", ...first }];
  }
  if (target.kind === "vertex") {
    const vertex = edit.vertex(target);
    return vertex === null ? [] : [{ kind: "vertex", ...vertex }];
  }
  // Only a rename moves a panel, and with it its first vertex.
  if (target.kind === "panel")
    return [{ kind: "panel", panel: edit.vertex({ panel: target.panel, vertex: 0 })?.panel ?? target.panel }];
  return target.stitch < edit.specification.pattern.stitches.length ? [target] : [];
}

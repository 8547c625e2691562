/** Gives a panel another name. */

import { panelOf, type Specification } from "../specification";
import { type Edit, edited, refused, renumbered } from "./edit";

const LONGEST_NAME = 100;

/** Everything that names the panel follows; refs of edges and vertices come back under the new name. */
export function renamePanel(specification: Specification, from: string, to: string): Edit {
  const { panels, stitches, panel_order } = specification.pattern;
  panelOf(specification, from);
  const name = to.trim();
  if (name === from) return edited(specification);
  if (name === "") return refused(specification, "A panel needs a name.");
  if (name.length > LONGEST_NAME)
    return refused(specification, `The name has ${name.length} letters; at most ${LONGEST_NAME} fit.`);
  if (Object.hasOwn(panels, name)) return refused(specification, `Another panel is named '${name}'.`);
  const renamed = <T extends { readonly panel: string }>(ref: T): T =>
    ref.panel === from ? { ...ref, panel: name } : ref;
  const after: Specification = {
    ...specification,
    pattern: {
      ...specification.pattern,
      panels: Object.fromEntries(
        Object.entries(panels).map(([key, panel]) => [key === from ? name : key, panel]),
      ),
      stitches: renumbered(stitches, renamed),
      panel_order: panel_order.map((key) => (key === from ? name : key)),
    },
  };
  return { ...edited(after), edges: (ref) => [renamed(ref)], vertex: renamed };
}

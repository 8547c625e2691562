/** Whether a specification is a pattern that can be read back: what every edit must leave true. */

import { at } from "../geometry/at";
import { distance } from "../geometry/point";
import { edgeKey, type Panel, type Specification } from "../specification";

const ROUNDING = 1e-9;

/** What is wrong, in words; empty where nothing is. Crossings are no matter of this: they are findings. */
export function problemsOf(specification: Specification): string[] {
  const { panels, stitches, panel_order } = specification.pattern;
  const problems = Object.entries(panels).flatMap(([name, panel]) =>
    panelProblems(panel).map((problem) => `${name}: ${problem}`),
  );
  if (JSON.stringify([...panel_order].sort()) !== JSON.stringify(Object.keys(panels).sort()))
    problems.push("panel_order does not name every panel once");
  const sewn = new Set<string>();
  stitches.forEach((stitch, number) => {
    for (const side of [stitch[0], stitch[1]]) {
      const panel = Object.hasOwn(panels, side.panel) ? panels[side.panel] : undefined;
      if (panel === undefined || !(side.edge >= 0 && side.edge < panel.edges.length))
        problems.push(`stitch ${number}: there is no edge ${side.edge} of ${side.panel}`);
      if (sewn.has(edgeKey(side)))
        problems.push(`stitch ${number}: edge ${side.edge} of ${side.panel} is sewn twice`);
      sewn.add(edgeKey(side));
    }
  });
  return problems;
}

function panelProblems(panel: Panel): string[] {
  const { vertices, edges } = panel;
  const problems: string[] = [];
  if (vertices.length < 2) problems.push("fewer than two vertices");
  if (edges.length !== vertices.length) problems.push(`${edges.length} edges, ${vertices.length} vertices`);
  if (![...vertices.flat(), ...panel.translation, ...panel.rotation].every(Number.isFinite))
    problems.push("a coordinate is not a finite number");
  edges.forEach((edge, k) => {
    const [from, to] = edge.endpoints;
    if (from !== k || to !== (k + 1) % vertices.length) {
      problems.push(`edge ${k} joins ${from} to ${to}`);
      return;
    }
    const chord = distance(at(vertices, from), at(vertices, to));
    if (chord === 0) problems.push(`edge ${k} has no length`);
    const { curvature } = edge;
    if (curvature === undefined) return;
    if (!curvature.params.flat().every(Number.isFinite)) problems.push(`edge ${k}: curvature is not finite`);
    if (curvature.type !== "circle") return;
    const [radius, large, right] = curvature.params;
    if (!(radius * 2 >= chord * (1 - ROUNDING)))
      problems.push(`edge ${k}: the radius does not span the chord`);
    for (const flag of [large, right])
      if (flag !== 0 && flag !== 1) problems.push(`edge ${k}: a flag is neither 0 nor 1`);
  });
  return problems;
}

/** Edges as exact SVG path commands, in cm, in the panel's own frame (y up; the drawing turns it over). */

import type { Panel, Point } from "../specification";
import { at } from "./at";
import { arcOf, type Curve, controlPolygon } from "./curve";
import { curveOf } from "./outline";

export function edgePath(panel: Panel, edge: number): string {
  const curve = curveOf(panel, edge);
  return `M${written(curve.start)}${command(curve)}`;
}

export function outlinePath(panel: Panel): string {
  const commands = panel.edges.map((_, k) => command(curveOf(panel, k)));
  return `M${written(at(panel.vertices, 0))}${commands.join("")}Z`;
}

function command(curve: Curve): string {
  const { shape, start, end } = curve;
  if (shape === undefined) return `L${written(end)}`;
  if (shape.type === "circle") {
    if (start[0] === end[0] && start[1] === end[1]) return `L${written(end)}`;
    const { radius } = arcOf(shape.params, start, end);
    // With y up, as here, SVG's sweep flag is the format's "right".
    return `A${radius} ${radius} 0 ${shape.params[1] ? 1 : 0} ${shape.params[2] ? 1 : 0} ${written(end)}`;
  }
  const letter = shape.type === "quadratic" ? "Q" : "C";
  return letter + controlPolygon(curve).slice(1).map(written).join(" ");
}

function written(point: Point): string {
  return `${point[0]},${point[1]}`;
}

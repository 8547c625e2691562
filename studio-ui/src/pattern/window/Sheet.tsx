/** The paper below the panels: grid lines, and rulers along two sides of the window. */

import { fromCm, trimmed, type Units } from "../../state/units";
import type { Point } from "../specification";
import { gridStep, type View } from "./view";

const LINE_PX = 10;
const RULER_PX = 20;
const LABEL_PX = 56;

interface SheetProps {
  view: View;
  size: Point;
  units: Units;
}

function lines(view: View, size: Point, step: number, axis: 0 | 1): { px: number; cm: number }[] {
  const first = axis === 0 ? view.corner[0] : view.corner[1] - size[1] / view.scale;
  const span = size[axis] / view.scale;
  const found: { px: number; cm: number }[] = [];
  for (let k = Math.ceil(first / step); k * step <= first + span; k++) {
    const cm = k * step;
    found.push({
      cm,
      px: axis === 0 ? (cm - view.corner[0]) * view.scale : (view.corner[1] - cm) * view.scale,
    });
  }
  return found;
}

export function Grid({ view, size, units }: SheetProps) {
  const unit = units === "cm" ? 1 : 2.54;
  const fine = gridStep(view.scale, unit, LINE_PX, units === "inch");
  const strong = gridStep(view.scale, unit, LABEL_PX, units === "inch");
  const path = (step: number) =>
    lines(view, size, step, 0)
      .map(({ px }) => `M${px.toFixed(1)} 0V${size[1]}`)
      .concat(lines(view, size, step, 1).map(({ px }) => `M0 ${px.toFixed(1)}H${size[0]}`))
      .join("");
  return (
    // biome-ignore lint/a11y/noAriaHiddenOnFocusable: a group of lines cannot have the focus.
    <g className="grid" aria-hidden="true">
      <path className="fine" d={path(fine)} />
      <path className="strong" d={path(strong)} />
    </g>
  );
}

export function Rulers({ view, size, units }: SheetProps) {
  const unit = units === "cm" ? 1 : 2.54;
  const fine = gridStep(view.scale, unit, LINE_PX, units === "inch");
  const strong = gridStep(view.scale, unit, LABEL_PX, units === "inch");
  const text = (cm: number) => trimmed(fromCm(cm, units), 3);
  const across = lines(view, size, fine, 0).map(({ px }) => `M${px.toFixed(1)} ${RULER_PX}V${RULER_PX - 5}`);
  const down = lines(view, size, fine, 1).map(({ px }) => `M${RULER_PX} ${px.toFixed(1)}H${RULER_PX - 5}`);
  return (
    // biome-ignore lint/a11y/noAriaHiddenOnFocusable: a group of lines cannot have the focus.
    <g className="rulers" aria-hidden="true">
      <rect width={size[0]} height={RULER_PX} />
      <rect width={RULER_PX} height={size[1]} />
      <path d={[...across, ...down].join("")} />
      {lines(view, size, strong, 0).map(({ px, cm }) =>
        px < RULER_PX + 8 ? null : (
          <g key={`x${cm}`}>
            <path d={`M${px.toFixed(1)} ${RULER_PX}V${RULER_PX - 10}`} />
            <text x={px + 3} y={10}>
              {text(cm)}
            </text>
          </g>
        ),
      )}
      {lines(view, size, strong, 1).map(({ px, cm }) =>
        px < RULER_PX + 8 ? null : (
          <g key={`y${cm}`}>
            <path d={`M${RULER_PX} ${px.toFixed(1)}H${RULER_PX - 10}`} />
            <text transform={`translate(10 ${px - 3}) rotate(-90)`}>{text(-cm)}</text>
          </g>
        ),
      )}
      <rect width={RULER_PX} height={RULER_PX} />
      <text x={3} y={13} className="unit">
        {units === "cm" ? "cm" : "in"}
      </text>
    </g>
  );
}

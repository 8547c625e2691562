/** What part of the sheet is seen. The sheet is in cm with y up, the screen in px with y down. */

import { type Box, boxSize } from "../geometry/bounds";
import type { Point } from "../specification";

export interface View {
  /** Pixels per cm. */
  readonly scale: number;
  /** The sheet's point at the upper left corner of the window, cm. */
  readonly corner: Point;
}

export const PX_PER_CM_TRUE = 96 / 2.54;
const NEAREST = 400;
const FARTHEST = 0.4;

export function onScreen(view: View, point: Point): Point {
  return [(point[0] - view.corner[0]) * view.scale, (view.corner[1] - point[1]) * view.scale];
}

export function onSheet(view: View, px: Point): Point {
  return [view.corner[0] + px[0] / view.scale, view.corner[1] - px[1] / view.scale];
}

/** Nearer or farther by a factor; what is under a point of the screen stays there. */
export function zoomedAt(view: View, px: Point, factor: number): View {
  const scale = Math.min(Math.max(view.scale * factor, FARTHEST), NEAREST);
  const fixed = onSheet(view, px);
  return { scale, corner: [fixed[0] - px[0] / scale, fixed[1] + px[1] / scale] };
}

export function panned(view: View, by: Point): View {
  return {
    ...view,
    corner: [view.corner[0] - by[0] / view.scale, view.corner[1] + by[1] / view.scale],
  };
}

/** Room to leave along the sides of the window, px. */
export interface Margins {
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

/** The view that shows a box in the middle of what the margins leave, no nearer than `nearest` px per cm. */
export function fitted(box: Box, size: Point, margins: Margins, nearest = NEAREST): View {
  const [width, height] = boxSize(box);
  const free = [
    Math.max(size[0] - margins.left - margins.right, 20),
    Math.max(size[1] - margins.top - margins.bottom, 20),
  ] as const;
  const fit = Math.min(free[0] / Math.max(width, 1e-3), free[1] / Math.max(height, 1e-3));
  const scale = Math.min(Math.max(fit, FARTHEST), nearest);
  return {
    scale,
    corner: [
      (box.low[0] + box.high[0]) / 2 - (margins.left + free[0] / 2) / scale,
      (box.low[1] + box.high[1]) / 2 + (margins.top + free[1] / 2) / scale,
    ],
  };
}

/** The least distance of lines, in cm, that are at least `px` apart: 1, 2 or 5 times a power of ten of a unit. */
export function gridStep(scale: number, unitCm: number, px: number, halves: boolean): number {
  const least = px / scale / unitCm;
  if (halves) {
    // Inches are halved down to eighths.
    for (const step of [1 / 8, 1 / 4, 1 / 2, 1, 2, 6, 12, 60, 120]) if (step >= least) return step * unitCm;
    return 600 * unitCm;
  }
  const power = 10 ** Math.floor(Math.log10(least));
  const step = [1, 2, 5, 10].find((each) => each * power >= least * (1 - 1e-9)) ?? 10;
  return step * power * unitCm;
}

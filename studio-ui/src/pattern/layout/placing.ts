/** How much room a panel takes on the sheet, and where its name fits. The same as the package's drawing, in cm. */

import { at } from "../geometry/at";
import { type Box, boxOf, boxSize } from "../geometry/bounds";
import { isInside, outlineOf, panelBox, signedArea } from "../geometry/outline";
import type { Panel, Point } from "../specification";

/** Mean width of a letter as a share of the font size. */
const LETTER = 0.58;
/** Places tried along each side of a panel's box when looking for its middle. */
const GRID = 17;

export interface Caption {
  /** Middle of the text, in the panel's own frame as drawn (mirrored or not), cm, y up. */
  readonly middle: Point;
  /** Font size, cm. */
  readonly size: number;
  readonly inside: boolean;
}

export interface PlacedPanel {
  /** Whether it is turned over, so that the right side of the cloth is seen: its loop runs clockwise. */
  readonly mirrored: boolean;
  /** Lower left corner of what it takes up with its name, in the frame as drawn, cm. */
  readonly low: Point;
  readonly size: Point;
  readonly caption: Caption;
}

export function placePanel(name: string, panel: Panel, font: number): PlacedPanel {
  const mirrored = signedArea(panel) < 0;
  const drawn = (p: Point): Point => (mirrored ? [-p[0], p[1]] : p);
  const own = panelBox(panel);
  const box = boxOf([drawn(own.low), drawn(own.high)]);
  const { middle, room } = deepest(outlineOf(panel, 0.2).map(drawn));
  const width = LETTER * [...name].length;
  const inside = Math.min(font, (1.6 * room) / Math.hypot(width, 1));
  if (inside >= 0.55 * font)
    return { mirrored, low: box.low, size: boxSize(box), caption: { middle, size: inside, inside: true } };
  const size = 0.75 * font;
  const center = (box.low[0] + box.high[0]) / 2;
  const half = (width * size) / 2;
  const low: Point = [Math.min(box.low[0], center - half), box.low[1] - 1.8 * size];
  const high: Point = [Math.max(box.high[0], center + half), box.high[1]];
  return {
    mirrored,
    low,
    size: [high[0] - low[0], high[1] - low[1]],
    caption: { middle: [center, box.low[1] - 1.1 * size], size, inside: false },
  };
}

/** The point of a grid that lies deepest inside a polygon, and how deep. */
export function deepest(outline: readonly Point[]): { middle: Point; room: number } {
  const box: Box = boxOf(outline);
  const [width, height] = boxSize(box);
  let best: { middle: Point; room: number } | null = null;
  for (let row = 0; row < GRID; row++)
    for (let column = 0; column < GRID; column++) {
      const middle: Point = [
        box.low[0] + ((column + 0.5) / GRID) * width,
        box.low[1] + ((row + 0.5) / GRID) * height,
      ];
      const room = isInside(middle, outline) ? borderDistance(middle, outline) : 0;
      if (best === null || room > best.room) best = { middle, room };
    }
  return best ?? { middle: [0, 0], room: 0 };
}

function borderDistance(point: Point, outline: readonly Point[]): number {
  let nearest = Number.POSITIVE_INFINITY;
  for (let k = 0; k < outline.length; k++) {
    const [x, y] = at(outline, k);
    const [u, v] = at(outline, (k + 1) % outline.length);
    const [dx, dy] = [u - x, v - y];
    const squared = Math.max(dx * dx + dy * dy, 1e-14);
    const t = Math.min(Math.max(((point[0] - x) * dx + (point[1] - y) * dy) / squared, 0), 1);
    nearest = Math.min(nearest, Math.hypot(point[0] - x - t * dx, point[1] - y - t * dy));
  }
  return nearest;
}

/** Puts boxes on shelves. The same as the package's drawing (swifttailor.pattern.svg.placing), in cm. */

import { at } from "../geometry/at";
import type { Point } from "../specification";

export interface Shelves {
  /** Upper left corner of each box, y down. */
  readonly corners: readonly Point[];
  /** Width and height of the sheet. */
  readonly sheet: Point;
}

/** Boxes `gap` apart, in their order but for height, on a sheet a little wider than high, or of a given aspect. */
export function shelves(sizes: readonly Point[], gap: number, aspect: number | null = null): Shelves {
  if (sizes.length === 0) return { corners: [], sheet: [0, 0] };
  const total = sizes.reduce((sum, [w, h]) => sum + (w + gap) * (h + gap), 0);
  const widest = Math.max(...sizes.map(([w]) => w));
  let best: (Shelves & { cost: number }) | null = null;
  const [tall, wide] = aspect === null ? [1 / 0.8, 1.8] : [aspect, aspect];
  const low = Math.max(widest, 0.9 * Math.sqrt(total * (aspect === null ? 1 : Math.min(aspect, 1))));
  const high = Math.max(widest, 2.2 * Math.sqrt(total * (aspect === null ? 1 : Math.max(aspect, 1))));
  for (let k = 0; k < 24; k++) {
    const strip = low * (high / low) ** (k / 23);
    const corners = fill(sizes, strip, gap);
    const sheet: Point = [
      Math.max(...corners.map(([x], n) => x + at(sizes, n)[0])),
      Math.max(...corners.map(([, y], n) => y + at(sizes, n)[1])),
    ];
    // Little empty space, and a shape between a square and a screen.
    const shape = Math.max(sheet[0] / sheet[1] / wide, (sheet[1] / sheet[0]) * tall, 1);
    const cost = sheet[0] * sheet[1] * shape;
    if (best === null || cost < best.cost * (1 - 1e-9)) best = { corners, sheet, cost };
  }
  return best ?? { corners: [], sheet: [0, 0] };
}

function fill(sizes: readonly Point[], strip: number, gap: number): Point[] {
  // Tall boxes first; those of about the same height (2 cm) stay in their order.
  const height = (k: number) => roundHalfEven(at(sizes, k)[1] / 2);
  const order = sizes.map((_, k) => k).sort((a, b) => height(b) - height(a) || a - b);
  const corners: Point[] = sizes.map(() => [0, 0]);
  let [x, y, shelf] = [0, 0, 0];
  for (const k of order) {
    const [w, h] = at(sizes, k);
    if (x > 0 && x + w > strip * (1 + 1e-12)) [x, y, shelf] = [0, y + shelf + gap, 0];
    corners[k] = [x, y];
    x += w + gap;
    shelf = Math.max(shelf, h);
  }
  return corners;
}

function roundHalfEven(value: number): number {
  const down = Math.floor(value);
  const rest = value - down;
  return rest === 0.5 ? down + (down % 2) : Math.round(value);
}

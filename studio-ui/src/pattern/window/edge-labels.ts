/** Where the numbers of seams stand: inside their panel, beside their edge, and on no other words. */

import { at } from "../geometry/at";
import { derivativeAt, pointAt } from "../geometry/curve";
import { curveOf, signedArea } from "../geometry/outline";
import { add, leftOf, scaled, unit } from "../geometry/point";
import { directionToSheet, type Place, toSheet } from "../layout/arrangement";
import type { Panel, Point } from "../specification";

export type Anchor = "start" | "middle" | "end";

export interface Words {
  readonly edge: number;
  readonly text: string;
}

export interface EdgeLabel extends Words {
  /** In the panel's frame, cm. */
  readonly point: Point;
  readonly anchor: Anchor;
}

/** On the screen, px, y up. */
interface Extent {
  readonly low: Point;
  readonly high: Point;
}

/** Of numbers, which are bold and 10.5 px high. */
const LETTER_PX = 6.6;
const LINE_PX = 12;
const BESIDE_PX = 6;
const ABOVE_PX = 9;
/** Shares of the edge at which its number may stand, the first that is free. */
const SHARES = [0.5, 0.36, 0.64, 0.24, 0.76] as const;
/** Beyond this share of sideways a number begins or ends at its edge. */
const SIDEWAYS = 0.55;

/** Places for the words of edges; those for which there is none are left out. `scale`: px per cm. */
export function edgeLabels(
  panel: Panel,
  place: Place,
  wanted: readonly Words[],
  scale: number,
  name: Extent | null,
): EdgeLabel[] {
  const taken: Extent[] = name === null ? [] : [name];
  const into = signedArea(panel) >= 0 ? 1 : -1;
  const labels: EdgeLabel[] = [];
  for (const { edge, text } of wanted) {
    const curve = curveOf(panel, edge);
    for (const share of SHARES) {
      const inward = unit(scaled(leftOf(derivativeAt(curve, share)), into));
      const across = directionToSheet(place, inward)[0];
      const anchor: Anchor = across > SIDEWAYS ? "start" : across < -SIDEWAYS ? "end" : "middle";
      const away = anchor === "middle" ? ABOVE_PX : BESIDE_PX;
      const point = add(pointAt(curve, share), scaled(inward, away / scale));
      const extent = extentOf(scaled(toSheet(place, point), scale), text, anchor);
      if (taken.some((other) => touches(extent, other))) continue;
      taken.push(extent);
      labels.push({ edge, text, point, anchor });
      break;
    }
  }
  return labels;
}

/** What words in the middle of a panel cover. */
export function nameExtent(place: Place, point: Point, scale: number, width: number, height: number): Extent {
  const [x, y] = scaled(toSheet(place, point), scale);
  return { low: [x - width / 2, y - height / 2], high: [x + width / 2, y + height / 2] };
}

function extentOf([x, y]: Point, text: string, anchor: Anchor): Extent {
  const width = LETTER_PX * text.length;
  const left = anchor === "start" ? x : anchor === "end" ? x - width : x - width / 2;
  return { low: [left, y - LINE_PX / 2], high: [left + width, y + LINE_PX / 2] };
}

function touches(one: Extent, other: Extent): boolean {
  return [0, 1].every(
    (k) => at([...one.low], k) < at([...other.high], k) && at([...other.low], k) < at([...one.high], k),
  );
}

/** Makes, removes and turns stitches. */

import { at } from "../geometry/at";
import {
  type EdgeRef,
  partnerIn,
  type Specification,
  type Stitch,
  sameEdge,
  stitchOf,
} from "../specification";
import { type Edit, edited, refused, withoutStitch, withStitches } from "./edit";

/** Sews two edges together, start to end; both must be free. */
export function makeStitch(specification: Specification, one: EdgeRef, other: EdgeRef): Edit {
  if (sameEdge(one, other))
    return refused(
      specification,
      "An edge cannot be sewn to itself. To fold it in half, add a point to it first.",
    );
  for (const ref of [one, other]) {
    const number = stitchOf(specification, ref);
    if (number < 0) continue;
    const partner = partnerIn(at(specification.pattern.stitches, number), ref);
    return refused(
      specification,
      `Edge ${ref.edge} of ${ref.panel} is already sewn to edge ${partner.edge} of ${partner.panel}. Remove that stitch first.`,
    );
  }
  return edited(withStitches(specification, [...specification.pattern.stitches, [one, other]]));
}

export function removeStitch(specification: Specification, number: number): Edit {
  if (!(number >= 0 && number < specification.pattern.stitches.length))
    return refused(specification, `There is no stitch ${number}.`);
  return edited(withStitches(specification, withoutStitch(specification.pattern.stitches, number)));
}

/** Sews the same two edges the other way round: start to start instead of start to end, or back. */
export function turnStitch(specification: Specification, number: number): Edit {
  const stitches = specification.pattern.stitches.map((stitch, k): Stitch => {
    if (k !== number) return stitch;
    return stitch.length === 3 ? [stitch[0], stitch[1]] : [stitch[0], stitch[1], "right_wrong"];
  });
  return edited(withStitches(specification, stitches));
}

"""Cuts at armholes and sleeves by given amounts; each returns None where the pattern does not allow it."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.measuring.parts import Part, Side
from swifttailor.describing.measuring.wings import find_wing
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts.cuts import add_cuffs, remove_parts
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.armholes import lengthen_shoulders, lower_underarms
from swifttailor.recutting.ways.sleeve_width import (
    Half,
    gather_heads,
    keep_heads,
    sleeve_halves,
    stretch_sleeves,
)
from swifttailor.recutting.ways.sleeves import ARM_EASE_CM, Hole, find_hole
from swifttailor.recutting.ways.sleeves import add_sleeves as sew_in_sleeves
from swifttailor.recutting.ways.sleeves import mirror_sleeve as mirrored

_SIDES: tuple[Side, Side] = ("left", "right")
_ALIKE_CM = 2.0
"""Sleeves that differ by more are not cut anew together."""


def _sleeve_halves(cutter: Cutter) -> list[Half]:
    """Halves of all sleeves; none where one is not cut in two halves."""
    found: list[Half] = []
    for side in _SIDES:
        if cutter.anatomy.panels(Part.SLEEVE, side):
            halves = sleeve_halves(cutter.anatomy, side)
            if halves is None:
                return []
            found += halves
    return found


def widen_sleeves(cutter: Cutter, factor: float, end: float) -> Pattern | None:
    """Makes the sleeves wider at the underarm and at the end by factors, their heads staying as long."""
    halves = _sleeve_halves(cutter)
    return keep_heads(cutter.pattern, halves, factor, end) if halves else None


def gather_sleeve_heads(cutter: Cutter, factor: float, least_end: float) -> Pattern | None:
    """Makes the heads of the sleeves longer by a factor, the sleeves as much wider as that asks for.

    Their ends stay where they get wider and go along where they get narrower, to `least_end` of their width.
    """
    halves = _sleeve_halves(cutter)
    if not halves:
        return None
    return gather_heads(cutter.pattern, halves, factor, lambda wide: max(min(wide, 1.0), least_end))


def gather_sleeve_ends(cutter: Cutter, factor: float) -> Pattern | None:
    """Makes the ends of the sleeves wider by a factor, cuffs staying as they are."""
    halves = _sleeve_halves(cutter)
    return stretch_sleeves(cutter.pattern, halves, 1.0, factor) if halves else None


def free_armholes(cutter: Cutter) -> list[Hole]:
    """Those of a garment without sleeves; none where one is of another shape."""
    if (
        cutter.anatomy.has(Part.SLEEVE)
        or find_wing(cutter.anatomy, "left")
        or find_wing(cutter.anatomy, "right")
    ):
        return []
    holes = [
        find_hole(cutter.anatomy, "left" if k == 0 else "right")
        for k, shoulder in enumerate(cutter.worn.shoulders)
        if shoulder
    ]
    found = [h for h in holes if h is not None]
    return found if len(found) == len(holes) else []


def deepen_armholes(cutter: Cutter, distance: float) -> Pattern | None:
    """Moves the lower ends of free armholes down the side seams, cm."""
    holes = free_armholes(cutter)
    return lower_underarms(cutter.pattern, holes, distance) if holes else None


def widen_shoulders(cutter: Cutter, distance: float) -> Pattern | None:
    """Makes the shoulder seams of a garment without sleeves longer at the armholes, cm."""
    holes = free_armholes(cutter)
    return lengthen_shoulders(cutter.pattern, holes, distance) if holes else None


def renew_sleeves(cutter: Cutter, width: float) -> Pattern | None:
    """Cuts both sleeves anew for the same armholes, smooth and as long as they were, cuffs as high.

    Args:
        cutter: The pattern.
        width: Around the sleeves at the underarm, cm; more where an armhole asks for it.
    """
    left, right = cutter.facts.left_sleeve, cutter.facts.right_sleeve
    if left is None or right is None or abs(left.length - right.length) > _ALIKE_CM:
        return None
    cuff, length = left.cuff, (left.length + right.length) / 2
    bare = remove_parts(cutter, Part.SLEEVE, Part.CUFF)
    if bare is None or (cuff is None) != (right.cuff is None):
        return None
    ease = width - cutter.facts.body.upper_arm_girth
    sewn = add_sleeves(cutter.with_pattern(bare), length - (cuff.length if cuff else 0.0), ease=ease)
    if sewn is None or cuff is None:
        return sewn
    return add_cuffs(cutter.with_pattern(sewn), cuff.length, 1.0, cuff.flare)


def add_sleeves(
    cutter: Cutter, length: float, sides: Sequence[Side] = _SIDES, *, ease: float = ARM_EASE_CM
) -> Pattern | None:
    """Sews sleeves into the free armholes of some sides, cm from the shoulder tip to the end.

    None where there is nothing to do, or an armhole is not free or not of a shape that a sleeve fits.
    """
    holes = []
    for side in sides:
        if side == "middle" or cutter.anatomy.panels(Part.SLEEVE, side) or find_wing(cutter.anatomy, side):
            continue
        hole = find_hole(cutter.anatomy, side) if cutter.worn.shoulders[side == "right"] else None
        if hole is None:
            return None
        holes.append(hole)
    return sew_in_sleeves(cutter.pattern, cutter.anatomy, holes, length, ease) if holes else None


def mirror_sleeve(cutter: Cutter) -> Pattern | None:
    """Sews on the second of two sleeves, like the one that there is."""
    bare = [s for s in _SIDES if not cutter.anatomy.panels(Part.SLEEVE, s)]
    if len(bare) != 1 or not cutter.worn.shoulders[bare[0] == "right"]:
        return None
    hole = find_hole(cutter.anatomy, "left" if bare[0] == "left" else "right")
    return mirrored(cutter.pattern, cutter.anatomy, hole) if hole else None

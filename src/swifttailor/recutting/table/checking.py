"""Whether a recut pattern can be kept: no new faults, seams that fit, lengths that are worn."""

from __future__ import annotations

from swifttailor.describing.facts import GarmentFacts
from swifttailor.pattern import Pattern
from swifttailor.pattern.check.stitch_checks import judge_lengths
from swifttailor.recutting.table.cutter import Cutter

SEAM_TOLERANCE = 0.02
"""How far a recut seam's ratio of lengths may move; gathers that are meant to change excepted."""
LOWEST_HEM_CM = -3.0
"""An edit that lengthens does not go below the floor."""
SHORTEST_SLEEVE_CM = 6.0


def accepted(
    cutter: Cutter, edited: Pattern | None, *, gathers: bool = False, as_before: bool = False
) -> Cutter | None:
    """Looks at what came of recutting a pattern.

    Args:
        cutter: The pattern as it was.
        edited: As it is; None where it could not be cut.
        gathers: Whether seams are meant to join other lengths than before.
        as_before: Whether lengths that are not such as are worn may be left as they were.

    Returns:
        The edited pattern, in which the checker finds no error or warning that was not there before, every
        seam fits as well as it did, and lengths are such as are worn; None where that is not so.
    """
    if edited is None or edited == cutter.pattern:
        return None
    after = cutter.with_pattern(edited)
    if after.faults - cutter.faults or not plausible(cutter.facts, after.facts, as_before=as_before):
        return None
    return after if gathers or seams_kept(cutter, after) else None


def seams_kept(before: Cutter, after: Cutter) -> bool:
    """Whether every two panels are sewn with the same ratio of lengths as before, new panels left out."""
    known = before.seam_ratios
    return all(
        abs(ratio / known[pair] - 1.0) <= SEAM_TOLERANCE or judge_lengths(ratio, 1.0) == "equal"
        for pair, ratio in after.seam_ratios.items()
        if pair in known
    )


def plausible(before: GarmentFacts, after: GarmentFacts, *, as_before: bool = False) -> bool:
    """Whether an edit keeps to what is worn: no hem drags, no sleeve hides the hands entirely."""
    if after.kind == "other":
        return False
    lowest = min(LOWEST_HEM_CM, before.hem.level) if before.hem else LOWEST_HEM_CM
    if after.hem is not None and after.hem.level < lowest:
        return False
    longest, shortest = 1.2 * after.body.arm_length, SHORTEST_SLEEVE_CM
    highest = after.body.bust
    if as_before:
        lengths = [s.length for s in (before.left_sleeve, before.right_sleeve) if s]
        longest, shortest = max([longest, *lengths]) + 0.1, min([shortest, *lengths]) - 0.1
        highest = max(highest, before.hem.level + 0.1) if before.hem and before.torso else highest
    sleeves = [s.length for s in (after.left_sleeve, after.right_sleeve) if s]
    if any(length > longest for length in sleeves) or any(length < shortest for length in sleeves):
        return False
    return not (after.hem and after.torso and after.hem.level > highest)

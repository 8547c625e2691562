"""Panels that are on one side of the body only, and completing what lacks its other side."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.differences import Change, Gain
from swifttailor.pattern import Pattern, Severity, check_pattern
from swifttailor.pattern.tidying.even_sides import even_sides
from swifttailor.pattern.tidying.from_one_side import are_unlike, from_one_side, sides_of
from swifttailor.pattern.tidying.symmetry import OTHER_SIDE

_ONE_SIDED = {
    "sides": {"different"},
    "sleeves": {"left only", "right only", "unequal"},
    "shoulders": {"bare left", "bare right"},
}
_OF_ONE_SIDE = ("left_", "right_")
UNASKED_CM = 15.0
"""So far halves of a panel may differ to be made alike where nobody asked that anything be uneven."""


def one_sided_panels(pattern: Pattern) -> tuple[str, ...]:
    """Panels whose counterpart on the other side of the body is missing."""
    names = {p.name for p in pattern.panels}
    return tuple(p.name for p in pattern.panels if OTHER_SIDE.get(p.name, p.name) not in names)


def asks_for_one_side(wishes: Sequence[Change]) -> bool:
    """Whether wishes speak of sides that differ."""
    claims = [wish.claim for wish in wishes if isinstance(wish, Gain)]
    return any(c.name.startswith(_OF_ONE_SIDE) or c.value in _ONE_SIDED.get(c.name, ()) for c in claims)


def is_of_one_side(wish: Change) -> bool:
    """Whether a wish speaks of one side of the body alone, or of sides that differ."""
    return asks_for_one_side([wish])


def made_of_one_side(pattern: Pattern, unsewn: bool = False) -> Pattern:
    """The pattern with both sides alike where they are not and that leaves less to find fault with.

    Each side is tried as the one that is right. Only for garments of which nobody asked that they be
    otherwise.

    Args:
        pattern: What was written.
        unsewn: Whether edges of it lack what they were to be sewn to.
    """
    evened, changes = even_sides(pattern, UNASKED_CM)
    if changes and _faults(evened) <= _faults(pattern):
        pattern = evened
    sides = sides_of(pattern)
    if not sides[0]:
        return pattern
    if not (unsewn or one_sided_panels(pattern) or _faults(pattern) != (0, 0) or are_unlike(pattern)):
        return pattern
    best, least = pattern, _faults(pattern)
    lonely = bool(one_sided_panels(pattern)) or are_unlike(pattern)
    for side in sides:
        made = from_one_side(pattern, side)
        if made is None:
            continue
        faults = _faults(made)
        # What is as sound with both sides alike is better for it.
        if faults < least or (faults == least and best is pattern and (lonely or unsewn)):
            best, least = made, faults
    return best


def _faults(pattern: Pattern) -> tuple[int, int]:
    """Errors and warnings of a check."""
    severities = [finding.severity for finding in check_pattern(pattern)]
    return severities.count(Severity.ERROR), severities.count(Severity.WARNING)

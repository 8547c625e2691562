"""Claims about a garment as a whole: what it is, how it fits, whether its sides are alike."""

from __future__ import annotations

from swifttailor.describing.claims.judgement import (
    Judgement,
    Predicate,
    above,
    all_of,
    below,
    between,
    is_one_of,
    missing,
    there,
)
from swifttailor.describing.claims.upper import halves_differ
from swifttailor.describing.facts import GarmentFacts

_UPPER = all_of(there("torso"), missing("trousers"))


def _legs(*, upper: bool, long: bool) -> Predicate:
    # Knee-length legs are shorts to most and trousers to some.
    ends = below if long else above
    level = ends("hem.level", lambda f: f.body.knee - 4.0, 3.0)
    return all_of(there("trousers"), there("torso") if upper else missing("torso"), level)


def _alike(facts: GarmentFacts, by: Judgement) -> bool:
    """Whether left and right side are cut alike, hems and slits apart."""
    torso = facts.torso
    if torso is None:
        return True
    left, right = torso.left_shoulder, torso.right_shoulder
    if (left is None) != (right is None) or (facts.left_sleeve is None) != (facts.right_sleeve is None):
        return False
    if left is not None and right is not None and not by.below(abs(left - right), 2.0, 1.0):
        return False
    if facts.left_sleeve and facts.right_sleeve:
        a, b = facts.left_sleeve, facts.right_sleeve
        return by.below(abs(a.length - b.length), 5.0, 2.5) and by.below(
            abs(a.upper_width - b.upper_width), 10.0, 5.0
        )
    halves = [n for n in (facts.front_neck, facts.back_neck) if n and n.left and n.right]
    return all(n.shape is not None or by.strictness < 0 for n in halves)


def _different(facts: GarmentFacts, by: Judgement) -> bool:
    """Plainly different sides: one bare, one sleeve only, or sleeves or necklines that differ."""
    torso = facts.torso
    if torso is None:
        return False
    if (torso.left_shoulder is None) != (torso.right_shoulder is None):
        return True
    if (facts.left_sleeve is None) != (facts.right_sleeve is None):
        return True
    if facts.left_sleeve and facts.right_sleeve:
        a, b = facts.left_sleeve, facts.right_sleeve
        if by.above(abs(a.length - b.length), 8.0, 2.0):
            return True
    return halves_differ(facts.front_neck, by)


WHOLE_CLAIMS: dict[str, tuple[str, dict[str, Predicate]]] = {
    "kind": (
        "what the garment is",
        {
            "top": all_of(_UPPER, above("hem.level", lambda f: f.body.crotch - 5.0, 3.5)),
            # Too long for a top, too short for a dress: the hem within a hand of the crotch.
            "tunic": all_of(
                _UPPER,
                between("hem.level", lambda f: f.body.crotch - 12.0, lambda f: f.body.crotch + 6.0, 3.0),
            ),
            "dress": all_of(_UPPER, below("hem.level", lambda f: f.body.crotch - 5.0, 3.5)),
            "skirt": is_one_of("kind", "skirt"),
            "trousers": _legs(upper=False, long=True),
            "shorts": _legs(upper=False, long=False),
            "jumpsuit": _legs(upper=True, long=True),
            "playsuit": _legs(upper=True, long=False),
        },
    ),
    "fit": (
        "room at the chest",
        {
            "close": below("torso.chest_ease", 4.0, 2.0),
            "easy": between("torso.chest_ease", 2.0, 13.0, 2.0),
            "loose": above("torso.chest_ease", 12.0, 2.5),
            "oversized": above("torso.chest_ease", 26.0, 3.0),
        },
    ),
    "sides": (
        "whether left and right are cut alike",
        {"alike": _alike, "different": _different},
    ),
}
"""About, and the values with their tests."""

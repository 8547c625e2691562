"""Claims about a garment as a whole: what it is, how it fits, whether its sides are alike."""

from __future__ import annotations

from swifttailor.describing.claims.judgement import Judgement, Predicate
from swifttailor.describing.facts import GarmentFacts

_KNEE_TOLERANCE_CM = 3.0


def _upper(facts: GarmentFacts) -> bool:
    return facts.torso is not None and facts.trousers is None and facts.hem is not None


def _is_top(facts: GarmentFacts, by: Judgement) -> bool:
    body = facts.body
    return _upper(facts) and facts.hem is not None and by.above(facts.hem.level, body.crotch - 5.0, 3.5)


def _is_dress(facts: GarmentFacts, by: Judgement) -> bool:
    body = facts.body
    return _upper(facts) and facts.hem is not None and by.below(facts.hem.level, body.crotch - 5.0, 3.5)


def _is_tunic(facts: GarmentFacts, by: Judgement) -> bool:
    """Too long for a top, too short for a dress: the hem within a hand of the crotch."""
    body = facts.body
    return (
        _upper(facts)
        and facts.hem is not None
        and by.between(facts.hem.level, body.crotch - 12.0, body.crotch + 6.0, 3.0)
    )


def _is_skirt(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.kind == "skirt"


def _legs(facts: GarmentFacts, upper: bool, long: bool, by: Judgement) -> bool:
    if facts.trousers is None or facts.hem is None or (facts.torso is not None) != upper:
        return False
    knee = facts.body.knee
    # Knee-length legs are shorts to most and trousers to some.
    return (
        by.below(facts.hem.level, knee - 4.0, _KNEE_TOLERANCE_CM)
        if long
        else by.above(facts.hem.level, knee - 4.0, _KNEE_TOLERANCE_CM)
    )


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
    neck = facts.front_neck
    if neck and neck.left and neck.right:
        shapes = {neck.left.shape, neck.right.shape}
        return len(shapes) == 2 and (by.strictness < 0 or "other" not in shapes)
    return False


def _close(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.torso is not None and by.below(facts.torso.chest_ease, 4.0, 2.0)


def _easy(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.torso is not None and by.between(facts.torso.chest_ease, 2.0, 13.0, 2.0)


def _loose(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.torso is not None and by.above(facts.torso.chest_ease, 12.0, 2.5)


def _oversized(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.torso is not None and by.above(facts.torso.chest_ease, 26.0, 3.0)


WHOLE_CLAIMS: dict[str, tuple[str, dict[str, Predicate]]] = {
    "kind": (
        "what the garment is",
        {
            "top": _is_top,
            "tunic": _is_tunic,
            "dress": _is_dress,
            "skirt": _is_skirt,
            "trousers": lambda f, by: _legs(f, upper=False, long=True, by=by),
            "shorts": lambda f, by: _legs(f, upper=False, long=False, by=by),
            "jumpsuit": lambda f, by: _legs(f, upper=True, long=True, by=by),
            "playsuit": lambda f, by: _legs(f, upper=True, long=False, by=by),
        },
    ),
    "fit": (
        "room at the chest",
        {"close": _close, "easy": _easy, "loose": _loose, "oversized": _oversized},
    ),
    "sides": (
        "whether left and right are cut alike",
        {"alike": _alike, "different": _different},
    ),
}
"""About, and the values with their tests."""

"""Claims about sleeves: length, width, gathers, cuffs."""

from __future__ import annotations

import math
from collections.abc import Callable

from swifttailor.describing.claims.judgement import Judgement, Predicate
from swifttailor.describing.facts import CuffKind, GarmentFacts, Sleeve

_LENGTHS: dict[str, tuple[float, float]] = {
    "cap": (0.0, 0.24),
    "short": (0.19, 0.46),
    "elbow": (0.42, 0.64),
    "three-quarter": (0.6, 0.86),
    "long": (0.84, math.inf),
    "extra-long": (1.1, math.inf),
}
"""Parts of the arm's length."""
LENGTH_TOLERANCE = 0.035
"""Part of the arm's length: 2 cm."""

SleeveTest = Callable[[Sleeve, GarmentFacts, Judgement], bool]


def _pair(facts: GarmentFacts) -> tuple[Sleeve, Sleeve] | None:
    return (facts.left_sleeve, facts.right_sleeve) if facts.left_sleeve and facts.right_sleeve else None


def _both(test: SleeveTest) -> Predicate:
    """True of both sleeves, where there are two."""

    def check(facts: GarmentFacts, by: Judgement) -> bool:
        pair = _pair(facts)
        return pair is not None and all(test(s, facts, by) for s in pair)

    return check


def _one(side: str, test: SleeveTest) -> Predicate:
    def check(facts: GarmentFacts, by: Judgement) -> bool:
        sleeve = facts.left_sleeve if side == "left" else facts.right_sleeve
        return sleeve is not None and test(sleeve, facts, by)

    return check


def _length(word: str) -> SleeveTest:
    low, high = _LENGTHS[word]

    def test(sleeve: Sleeve, facts: GarmentFacts, by: Judgement) -> bool:
        return by.between(sleeve.length / facts.body.arm_length, low, high, LENGTH_TOLERANCE)

    return test


def _slim(sleeve: Sleeve, facts: GarmentFacts, by: Judgement) -> bool:
    return by.below(max(sleeve.upper_width, sleeve.end_width), 1.3 * facts.body.upper_arm_girth, 2.0)


def _wide(sleeve: Sleeve, facts: GarmentFacts, by: Judgement) -> bool:
    return by.above(max(sleeve.upper_width, sleeve.end_width), 1.85 * facts.body.upper_arm_girth, 3.0)


def _puffed(sleeve: Sleeve, facts: GarmentFacts, by: Judgement) -> bool:
    return by.above(sleeve.head_gather, 1.22, 0.08)


def _ungathered_head(sleeve: Sleeve, facts: GarmentFacts, by: Judgement) -> bool:
    return by.below(sleeve.head_gather, 1.1, 0.05)


def _gathered_end(sleeve: Sleeve, facts: GarmentFacts, by: Judgement) -> bool:
    return sleeve.cuff is not None and by.above(sleeve.end_gather, 1.25, 0.08)


def _balloon(sleeve: Sleeve, facts: GarmentFacts, by: Judgement) -> bool:
    """Wide, and gathered into a cuff at the end."""
    return _gathered_end(sleeve, facts, by) and by.above(
        max(sleeve.upper_width, sleeve.end_width), 1.5 * facts.body.upper_arm_girth, 3.0
    )


def _bell(sleeve: Sleeve, facts: GarmentFacts, by: Judgement) -> bool:
    return (
        sleeve.cuff is None
        and by.above(sleeve.end_width / max(sleeve.upper_width, 1.0), 1.18, 0.06)
        and by.above(sleeve.end_width, 1.25 * facts.body.upper_arm_girth, 3.0)
    )


def _tapered(sleeve: Sleeve, facts: GarmentFacts, by: Judgement) -> bool:
    return sleeve.cuff is None and by.below(sleeve.end_width / max(sleeve.upper_width, 1.0), 0.72, 0.06)


def _cuff(kind: CuffKind) -> SleeveTest:
    return lambda sleeve, facts, by: sleeve.cuff is not None and sleeve.cuff.kind == kind


def _deep_cuff(sleeve: Sleeve, facts: GarmentFacts, by: Judgement) -> bool:
    return sleeve.cuff is not None and by.above(sleeve.cuff.length, 12.0, 2.0)


def _sleeveless(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.torso is not None and facts.left_sleeve is None and facts.right_sleeve is None


def _only(side: str) -> Predicate:
    def check(facts: GarmentFacts, by: Judgement) -> bool:
        own, other = facts.left_sleeve, facts.right_sleeve
        if side == "right":
            own, other = other, own
        return own is not None and other is None

    return check


def _unequal(facts: GarmentFacts, by: Judgement) -> bool:
    pair = _pair(facts)
    return pair is not None and by.above(abs(pair[0].length - pair[1].length), 7.5, 2.0)


SLEEVE_CLAIMS: dict[str, tuple[str, dict[str, Predicate]]] = {
    "sleeves": (
        "how long both sleeves are",
        {"none": _sleeveless}
        | {word: _both(_length(word)) for word in _LENGTHS}
        | {"left only": _only("left"), "right only": _only("right"), "unequal": _unequal},
    ),
    "left_sleeve": (
        "how long the wearer's left sleeve is",
        {word: _one("left", _length(word)) for word in _LENGTHS},
    ),
    "right_sleeve": (
        "how long the wearer's right sleeve is",
        {word: _one("right", _length(word)) for word in _LENGTHS},
    ),
    "sleeve_shape": (
        "shape of both sleeves",
        {
            "slim": _both(_slim),
            "wide": _both(_wide),
            "puffed": _both(_puffed),
            "set smooth": _both(_ungathered_head),
            "balloon": _both(_balloon),
            "gathered end": _both(_gathered_end),
            "bell": _both(_bell),
            "tapered": _both(_tapered),
        },
    ),
    "cuffs": (
        "what ends both sleeves",
        {
            "none": _both(lambda s, f, by: s.cuff is None),
            "band": _both(_cuff("band")),
            "flounce": _both(_cuff("flounce")),
            "band and flounce": _both(_cuff("band and flounce")),
            "deep": _both(_deep_cuff),
        },
    ),
}
"""About, and the values with their tests."""

"""Claims about sleeves: length, width, gathers, cuffs."""

from __future__ import annotations

import math
from collections.abc import Callable

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
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.facts_paths import Measure, measure_of

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
_LEFT, _RIGHT = "left_sleeve", "right_sleeve"

SleeveTest = Callable[[str], Predicate]
"""A test of the sleeve in one of these places."""


def _both(test: SleeveTest) -> Predicate:
    """True of both sleeves, where there are two."""
    return all_of(test(_LEFT), test(_RIGHT))


def _length(word: str) -> SleeveTest:
    low, high = _LENGTHS[word]

    def test(side: str) -> Predicate:
        length = measure_of(side, lambda sleeve: sleeve.length)

        def of_arm(facts: GarmentFacts) -> float | None:
            own = length(facts)
            return None if own is None else own / facts.body.arm_length

        return between(of_arm, low, high, LENGTH_TOLERANCE)

    return test


def _widest(side: str) -> Measure:
    return measure_of(side, lambda sleeve: max(sleeve.upper_width, sleeve.end_width))


def _flare(side: str) -> Measure:
    return measure_of(side, lambda sleeve: sleeve.end_width / max(sleeve.upper_width, 1.0))


def _arms(times: float) -> Callable[[GarmentFacts], float]:
    return lambda facts: times * facts.body.upper_arm_girth


def _gathered_end(side: str) -> Predicate:
    return all_of(there(f"{side}.cuff"), above(f"{side}.end_gather", 1.25, 0.08))


def _unequal(facts: GarmentFacts, by: Judgement) -> bool:
    left, right = facts.left_sleeve, facts.right_sleeve
    return left is not None and right is not None and by.above(abs(left.length - right.length), 7.5, 2.0)


SLEEVE_CLAIMS: dict[str, tuple[str, dict[str, Predicate]]] = {
    "sleeves": (
        "how long both sleeves are",
        {"none": all_of(there("torso"), missing(_LEFT), missing(_RIGHT))}
        | {word: _both(_length(word)) for word in _LENGTHS}
        | {
            "left only": all_of(there(_LEFT), missing(_RIGHT)),
            "right only": all_of(there(_RIGHT), missing(_LEFT)),
            "unequal": _unequal,
        },
    ),
    "left_sleeve": (
        "how long the wearer's left sleeve is",
        {word: _length(word)(_LEFT) for word in _LENGTHS},
    ),
    "right_sleeve": (
        "how long the wearer's right sleeve is",
        {word: _length(word)(_RIGHT) for word in _LENGTHS},
    ),
    "sleeve_shape": (
        "shape of both sleeves",
        {
            "slim": _both(lambda side: below(_widest(side), _arms(1.3), 2.0)),
            "wide": _both(lambda side: above(_widest(side), _arms(1.85), 3.0)),
            "puffed": _both(lambda side: above(f"{side}.head_gather", 1.22, 0.08)),
            "set smooth": _both(lambda side: below(f"{side}.head_gather", 1.1, 0.05)),
            # Wide, and gathered into a cuff at the end.
            "balloon": _both(lambda side: all_of(_gathered_end(side), above(_widest(side), _arms(1.5), 3.0))),
            "gathered end": _both(_gathered_end),
            "bell": _both(
                lambda side: all_of(
                    missing(f"{side}.cuff"),
                    above(_flare(side), 1.18, 0.06),
                    above(f"{side}.end_width", _arms(1.25), 3.0),
                )
            ),
            "tapered": _both(lambda side: all_of(missing(f"{side}.cuff"), below(_flare(side), 0.72, 0.06))),
        },
    ),
    "cuffs": (
        "what ends both sleeves",
        {
            "none": _both(lambda side: all_of(there(side), missing(f"{side}.cuff"))),
            "band": _both(lambda side: is_one_of(f"{side}.cuff.kind", "band")),
            "flounce": _both(lambda side: is_one_of(f"{side}.cuff.kind", "flounce")),
            "band and flounce": _both(lambda side: is_one_of(f"{side}.cuff.kind", "band and flounce")),
            "deep": _both(lambda side: above(f"{side}.cuff.length", 12.0, 2.0)),
        },
    ),
}
"""About, and the values with their tests."""

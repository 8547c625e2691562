"""What was drafted, drafted anew for a large body that wears it, and cut again as it was cut.

What grows with the trunk gets sleeves and necks that are too large for a large person: with half as much
again around the bust sleeves would be 10 cm longer, and necks would slip from the shoulders.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from swifttailor.body import Body, BodyMeasurements
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.dimensions import STATED
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.recutting.alter import alter
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.redrafted import redrafted

_LARGE = 1.2
"""Times the bust of the default body."""
_OVER_BELLIES_CM, _VERY_LARGE = 4.0, 1.5
"""By how much longer tops are for those who are so much larger: a belly takes up length in front."""
_SEEN_CM = 1.5
_ENDS = frozenset({"skirt_hem", "top_hem", "leg_hem"})
_HUNG = ("top",)
"""Kinds of garments that hang from the shoulders; dresses that are drafted so catch the arms as they fall."""
_CLOSE_LEGS = ("leggings", "jeans")
"""Whose ends would be as wide beside the ankles as thighs are beside those of the default body."""


def drafted_for_large(answer: Answer, body: Body) -> Pattern | None:
    """The draft of an answer for a large body; None where it is to be refitted.

    Args:
        answer: What was drafted for the default body, and cut to what was asked for.
        body: Who wears it.
    """
    begun, wanted, usual = answer.drafted, answer.wanted, Body.default().measurements
    if begun is None or wanted is None or wanted.order.edit is not None:
        return None
    if body.measurements.bust < _LARGE * usual.bust:
        return None
    try:
        facts = measure_facts(answer.pattern)
        hung = facts.kind in _HUNG and facts.torso is not None and facts.left_sleeve is not None
        if not hung and begun.name not in _CLOSE_LEGS:
            return None
        pattern = redrafted(answer.pattern, begun.made_for(body.measurements), body)
        if pattern is None:
            return None
        gains = [w.change for w in wanted.wishes if isinstance(w.change, Gain)]
        gains = [gain for gain in gains if gain.holds(facts, facts)]
        if not _is_as_drafted(answer.pattern, begun.made_for(None)):
            cut = alter(pattern, gains, body=body.measurements)
            if cut.open:
                return None
            pattern = cut.pattern
        return _as_long(pattern, facts, gains, body.measurements)
    except SwiftTailorError:
        return None


def _is_as_drafted(pattern: Pattern, drafted: Pattern) -> bool:
    """Whether nothing was cut in a pattern."""
    return all(
        one.vertices.shape == other.vertices.shape and np.allclose(one.vertices, other.vertices)
        for one, other in zip(pattern.panels, drafted.panels, strict=True)
    )


def _as_long(
    pattern: Pattern, before: GarmentFacts, asked: Sequence[Gain], body: BodyMeasurements
) -> Pattern:
    """A pattern that ends as low as on the default body, where nothing says how long it is."""
    if any(g.claim.name in _ENDS or (g.claim.name in STATED and "length" in g.claim.name) for g in asked):
        return pattern
    after = measure_facts(pattern, body)
    if before.hem is None or after.hem is None:
        return pattern
    share = min(body.bust / Body.default().measurements.bust, _VERY_LARGE) - 1.0
    lower = _OVER_BELLIES_CM * share / (_VERY_LARGE - 1.0)
    longer = after.hem.level - before.hem.level * after.body.waist / before.body.waist + lower
    if longer < _SEEN_CM:
        return pattern
    cut = alter(pattern, [Step("length", 1, round(longer, 1))], original=after, body=body)
    return pattern if cut.open else cut.pattern

"""When a word is true of a garment: facts compared with bounds that have a tolerance zone.

A claim is made only well inside its bounds and still holds a little outside of them. So a pattern on the
border between two words is called neither, and whoever asked for one of them is content with it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.facts_paths import Measure, fact_at, measure_at


@dataclass(frozen=True)
class Judgement:
    """Compares measures with bounds that are moved by their tolerance."""

    strictness: int
    """+1 narrows all bounds by their tolerance, -1 widens them."""

    def above(self, value: float, bound: float, tolerance: float) -> bool:
        """Whether `value` lies above `bound`."""
        return value >= bound + self.strictness * tolerance

    def below(self, value: float, bound: float, tolerance: float) -> bool:
        """Whether `value` lies below `bound`."""
        return value <= bound - self.strictness * tolerance

    def between(self, value: float, low: float, high: float, tolerance: float) -> bool:
        """Whether `value` lies between both bounds."""
        return self.above(value, low, tolerance) and self.below(value, high, tolerance)


CLAIMING = Judgement(+1)
"""For making claims."""
HOLDING = Judgement(-1)
"""For judging whether a claim holds."""

Predicate = Callable[[GarmentFacts, Judgement], bool]
"""Whether a garment is what a word says, strictly or leniently."""
Bound = float | Callable[[GarmentFacts], float]
"""The same for all garments, or one that depends on the body."""


def between(of: str | Measure, low: Bound, high: Bound, tolerance: float) -> Predicate:
    """Whether a measure lies between bounds; never where the garment has no such thing.

    Args:
        of: The measure, or the place of a fact such as ``hem.level``.
        low: In its unit.
        high: In its unit.
        tolerance: Of both bounds.
    """
    measure = measure_at(of) if isinstance(of, str) else of

    def test(facts: GarmentFacts, by: Judgement) -> bool:
        value = measure(facts)
        if value is None:
            return False
        lowest, highest = (end if isinstance(end, (float, int)) else end(facts) for end in (low, high))
        return by.between(value, lowest, highest, tolerance)

    return test


def above(of: str | Measure, bound: Bound, tolerance: float) -> Predicate:
    """Whether a measure lies above a bound; see `between`."""
    return between(of, bound, math.inf, tolerance)


def below(of: str | Measure, bound: Bound, tolerance: float) -> Predicate:
    """Whether a measure lies below a bound; see `between`."""
    return between(of, -math.inf, bound, tolerance)


def where(place: str, test: Callable[[Any], object]) -> Predicate:
    """Whether there is something in a place such as ``trousers.cuff``, and a plain test holds of it."""
    fact = fact_at(place)
    return lambda facts, by: (found := fact(facts)) is not None and bool(test(found))


def there(place: str) -> Predicate:
    """Whether there is something in a place."""
    return where(place, lambda found: True)


def missing(place: str) -> Predicate:
    """Whether there is nothing in a place, or not even what it would be a part of."""
    fact = fact_at(place)
    return lambda facts, by: fact(facts) is None


def is_one_of(place: str, *values: str) -> Predicate:
    """Whether a fact such as ``collar.kind`` has one of some values."""
    return where(place, lambda found: found in values)


def all_of(*tests: Predicate) -> Predicate:
    """Whether all tests hold."""
    return lambda facts, by: all(test(facts, by) for test in tests)


def any_of(*tests: Predicate) -> Predicate:
    """Whether one of the tests holds."""
    return lambda facts, by: any(test(facts, by) for test in tests)

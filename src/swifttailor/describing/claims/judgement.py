"""Bounds with a tolerance zone: strict when a claim is made, lenient when one is judged."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from swifttailor.describing.facts import GarmentFacts


@dataclass(frozen=True)
class Judgement:
    """Compares measures with bounds that are moved by their tolerance.

    A claim is made only well inside its bounds and still holds a little outside of them. So a pattern on
    the border between two words is called neither, and whoever asked for one of them is content with it.
    """

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

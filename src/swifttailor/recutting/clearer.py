"""What is asked for and so already, but only just: trousers that end between calf and ankle, "to the ankle".

Who asks for that does not see it. Where nothing else is to be done, it is cut until it can be seen.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from swifttailor.describing.claims.claim import CLAIM_TYPES
from swifttailor.describing.claims.judgement import CLAIMING
from swifttailor.describing.differences import Change, Gain
from swifttailor.describing.facts import GarmentFacts

_WHOLE = frozenset({"kind", "sides", "shoulders"})
"""Of these nothing is so by a little."""


@dataclass(frozen=True)
class Clearly(Gain):
    """A claim that is to hold well within its bounds."""

    def holds(self, before: GarmentFacts, after: GarmentFacts) -> bool:
        """Whether it can safely be said of an edited garment."""
        return CLAIM_TYPES[self.claim.name].words[str(self.claim.value)](after, CLAIMING)


def is_clear(change: Change, facts: GarmentFacts) -> bool:
    """Whether a garment is so already, and visibly: not within what is tolerated."""
    if not isinstance(change, Gain) or not change.holds(facts, facts):
        return False
    barely = isinstance(change.claim.value, str) and change.claim.name not in _WHOLE
    return not barely or Clearly(change.claim).holds(facts, facts)


def clearer(changes: Sequence[Change], facts: GarmentFacts) -> list[Change]:
    """What is asked for, to be seen clearly where all of it holds already and some of it only just.

    Args:
        changes: All that is asked for.
        facts: Of the garment as it is.

    Returns:
        Nothing where something does not hold, or all of it is clear.
    """
    if not all(change.holds(facts, facts) for change in changes):
        return []
    found = [
        Clearly(change.claim) if isinstance(change, Gain) and not is_clear(change, facts) else change
        for change in changes
    ]
    return found if any(isinstance(change, Clearly) for change in found) else []

"""Slits that a text asks for, cut so that they are seen."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.describing.differences import Gain
from swifttailor.recutting.ways.parted_slits import parted_front, parted_sides, parted_slit, slit_over_leg
from swifttailor.tailor.answer import Answer

_OF_SLITS = frozenset({"slit", "slit_size", "slit_cm"})


def with_slit_seen(answer: Answer) -> Answer:
    """The answer; where a text asks for slits, with them over the leg, a wedge, or beside a front cut away.

    Patterns to edit keep theirs.
    """
    wanted = answer.wanted
    if wanted is None or wanted.order.edit is not None or answer.is_given:
        return answer
    asked = [wish.change.claim for wish in wanted.heard.sure if isinstance(wish.change, Gain)]
    if not any(claim.name in _OF_SLITS and claim.value != "none" for claim in asked):
        return answer
    before = answer.pattern
    ways = (slit_over_leg, parted_slit, parted_sides, parted_front)
    pattern = next((done for way in ways if (done := way(before)) is not None), None)
    return answer if pattern is None else replace(answer, pattern=pattern)

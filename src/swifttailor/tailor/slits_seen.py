"""Slits that a text asks for, cut so that they are seen."""

from __future__ import annotations

import re
from dataclasses import replace

from swifttailor.describing.differences import Gain
from swifttailor.recutting.ways.parted_slits import parted_slit, slit_over_leg
from swifttailor.tailor.answer import Answer

_OF_SLITS = frozenset({"slit", "slit_size", "slit_cm"})
_AT_SIDE = re.compile(r"(?<!\w)sides?(?!\w)", re.IGNORECASE)
"""Who says so wants it in the seam."""


def with_slit_seen(answer: Answer) -> Answer:
    """The answer; where a text asks for a slit, with it over the leg, or at the side with the front cut away.

    Patterns to edit keep theirs.
    """
    wanted = answer.wanted
    if wanted is None or wanted.order.edit is not None or answer.is_given:
        return answer
    asked = [wish.change.claim for wish in wanted.heard.sure if isinstance(wish.change, Gain)]
    if not any(claim.name in _OF_SLITS and claim.value != "none" for claim in asked):
        return answer
    at_side = bool(_AT_SIDE.search(wanted.heard.text))
    pattern = (None if at_side else slit_over_leg(answer.pattern)) or parted_slit(answer.pattern)
    return answer if pattern is None else replace(answer, pattern=pattern)

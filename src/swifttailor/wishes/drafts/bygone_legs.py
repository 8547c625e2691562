"""Trousers of the 1920s to the 1940s: high, full in the leg, and pleated at the waist."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import NamedDraft

_DECADES = re.compile(
    r"(?<![\w£$€])(?:(?:19)?[234]0['’]?s|twenties|thirties|forties|wartime|land girl|zwanziger ?jahre"
    r"|dreißiger ?jahre|vierziger ?jahre|années (?:vingt|trente|quarante|[234]0))(?!\w)",
    re.IGNORECASE,
)
_LEGS: Mapping[str, float] = {"hip_ease": 7.0, "leg_ease": 34.0, "flare": -4.0}
_BAND: Mapping[str, float] = {"below_waist": -3.5, "band_height": 5.0}
_LONG_CM, _NARROW_CM = 90.0, 30.0
PLEATED = ("trousers", "pull-on-trousers")
"""Drafts whose legs were cut so."""


def is_bygone(text: str) -> bool:
    """Whether a text names these decades."""
    return _DECADES.search(text) is not None


def legs_of_their_time(draft: NamedDraft, text: str, *, told: bool) -> NamedDraft:
    """Long trousers as they were cut in the decade that a text names; others as they are.

    Args:
        draft: As it was asked for otherwise.
        text: All of it.
        told: Whether the text tells how wide the legs are: then they are so.
    """
    options = dict(draft.options)
    if draft.name != PLEATED[0] or float(options.get("length", _LONG_CM)) < _LONG_CM or not is_bygone(text):
        return draft
    legs = _LEGS if not told and float(options.get("leg_ease", 0.0)) < _NARROW_CM else {}
    return replace(draft, options=tuple({**options, **_BAND, **legs}.items()))

"""Jumpsuits and dresses with the collar of a shirt, where a text asks for a collar and for no flatter one."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import NamedDraft

_FLAT = ("collar", "folded")
_FLATTER = re.compile(
    r"lapel|revers|shawl|tuxedo|peter[- ]?pan|sailor|flat collar|bubikragen|claudine|bebé", re.IGNORECASE
)
_SHIRT = {"collar": "shirt", "neck_widening": 1.0, "neck_depth": 10.0}
"""The collar of boiler suits, and the close neck that it stands on, cm."""
_DRESS, _SHIRT_COLLAR = "shirt-dress", "shirt_collar"
_OF_DRESSES = {"collar": "shirt", "neck_depth": 9.0}
"""The same of dresses, where the key of what they lack is that one."""


def with_shirt_collar(draft: NamedDraft, text: str, lacks: Collection[str]) -> NamedDraft:
    """A jumpsuit whose collar is that of a shirt; others, and those of flatter collars, as they are.

    So is a shirt dress of which a collar like that of shirts or polo shirts is asked for in so many words.

    Args:
        draft: As it was asked for otherwise.
        text: All of it.
        lacks: Keys of ``cannot.txt`` that it asks for.
    """
    options = dict(draft.options)
    flatter = "flat_collar" in lacks or _FLATTER.search(text) is not None
    if draft.name == _DRESS and _FLAT in draft.options and _SHIRT_COLLAR in lacks and not flatter:
        return replace(draft, options=tuple({**_OF_DRESSES, **options, "collar": "shirt"}.items()))
    if draft.name != "jumpsuit" or _FLAT not in draft.options or "neck_depth" in options:
        return draft
    if flatter:
        return draft
    return replace(draft, options=tuple({**options, **_SHIRT}.items()))

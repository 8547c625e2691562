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


def with_shirt_collar(draft: NamedDraft, text: str, lacks: Collection[str]) -> NamedDraft:
    """A jumpsuit whose collar is that of a shirt; others, and those of flatter collars, as they are.

    So is a dress of which such a collar is said in so many words: a polo collar.

    Args:
        draft: As it was asked for otherwise.
        text: All of it.
        lacks: Keys of ``cannot.txt`` that it asks for.
    """
    options = dict(draft.options)
    named = draft.name == "shirt-dress" and "shirt_collar" in lacks
    if not (named or draft.name == "jumpsuit") or _FLAT not in draft.options or "neck_depth" in options:
        return draft
    if "flat_collar" in lacks or _FLATTER.search(text):
        return draft
    return replace(draft, options=tuple({**options, **_SHIRT}.items()))

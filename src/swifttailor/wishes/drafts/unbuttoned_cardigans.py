"""Cardigans that are to have no buttons: nothing closes them, so that they hang open."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import NamedDraft

_CARDIGAN, _SHAWL, _BUTTONS = "cardigan", ("lapels", "shawl"), "buttons"
_OPEN = {"opening": 7.0, "closed_to": -30.0}
"""How far the edges have moved back from the middle at the hem, and how high up the fronts are joined, cm."""
_LEAST_CM = 2.0
"""What opens by so much is open already."""
_INSTEAD = frozenset({"zip", "ties", "belt", "toggles"})


def open_without_buttons(
    draft: NamedDraft, lacks: Collection[str], denied: Collection[str], *, knitted: bool
) -> NamedDraft:
    """A cardigan whose fronts part where a text refuses its buttons; others as they are.

    Args:
        draft: As it was asked for otherwise.
        lacks: Keys of ``cannot.txt`` that the text itself asks for.
        denied: Those that it refuses.
        knitted: Whether the text names a cardigan, which may be cut as a jacket.
    """
    options = dict(draft.options)
    shawl = knitted and _SHAWL in draft.options
    if _BUTTONS not in denied or not _INSTEAD.isdisjoint(lacks) or not (draft.name == _CARDIGAN or shawl):
        return draft
    if float(options.get("opening", 1.0)) >= _LEAST_CM:
        return draft
    kept = {name: value for name, value in options.items() if name != "ribbed"}
    return replace(draft, options=tuple({**kept, **_OPEN}.items()))

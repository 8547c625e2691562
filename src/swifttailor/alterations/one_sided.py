"""Panels that are on one side of the body only."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.data.edits.differences import Change, Gain
from swifttailor.pattern import Pattern
from swifttailor.pattern_maker.panel_tokens import TWINS
from swifttailor.pattern_maker.vocabulary import PANEL_NAMES

_TWIN_NAMES = {
    PANEL_NAMES[a]: PANEL_NAMES[b] for pair in TWINS.items() for a, b in (pair, (pair[1], pair[0]))
}
_ONE_SIDED = {
    "sides": {"different"},
    "sleeves": {"left only", "right only", "unequal"},
    "shoulders": {"bare left", "bare right"},
}
_OF_ONE_SIDE = ("left_", "right_")


def one_sided_panels(pattern: Pattern) -> tuple[str, ...]:
    """Panels whose counterpart on the other side of the body is missing."""
    names = {p.name for p in pattern.panels}
    return tuple(p.name for p in pattern.panels if _TWIN_NAMES.get(p.name, p.name) not in names)


def asks_for_one_side(wishes: Sequence[Change]) -> bool:
    """Whether wishes speak of sides that differ."""
    claims = [wish.claim for wish in wishes if isinstance(wish, Gain)]
    return any(c.name.startswith(_OF_ONE_SIDE) or c.value in _ONE_SIDED.get(c.name, ()) for c in claims)

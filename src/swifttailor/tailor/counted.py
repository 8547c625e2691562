"""Skirts of so many gores, tiers or godets, drafted by GarmentCode's programs where no known pattern does."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.pattern import Pattern
from swifttailor.pattern_maker.maker import WrittenPattern
from swifttailor.programs import DesignError, complete_design, make_pattern
from swifttailor.tailor.candidates import Candidate
from swifttailor.tailor.reading import Wanted

_USUAL: Mapping[str, int] = {"gored": 6, "godets": 6, "tiered": 3, "gathered tiers": 3}
"""How many there are where nobody says."""
_NUMBERS = {"gores": "gored", "godets": "godets", "tiers": "tiered"}
_KINDS: Mapping[str, Mapping[str, Any]] = {
    "skirt": {"meta.upper": None, "meta.wb": "StraightWB"},
    "dress": {"meta.upper": "FittedShirt", "meta.wb": None},
}
_GORED: Mapping[str, Any] = {
    "meta.bottom": "SkirtManyPanels",
    "flare-skirt.length": 0.5,  # longer ones are refused without a bodice: they would slide down
    "flare-skirt.suns": 0.4,
}
_WITH_GODETS: Mapping[str, Any] = {
    "meta.bottom": "GodetSkirt",
    "pencil-skirt.length": 0.55,
    "godet-skirt.insert_w": 25,
    "godet-skirt.insert_depth": 30,
}
_TIERED: Mapping[str, Any] = {
    "meta.bottom": "SkirtLevels",
    "levels-skirt.base": "Skirt2",
    "levels-skirt.length": 0.6,
    "levels-skirt.base_length_frac": 0.35,
    "levels-skirt.level_ruffle": 1.35,
}


def counted_design(changes: Sequence[Change], kind: str) -> dict[str, Any] | None:
    """Design parameters of a skirt or dress of as many gores, tiers or godets as are asked for.

    Args:
        changes: What is asked for.
        kind: Of the garment.

    Returns:
        None where nothing of the sort is asked for, or there is no design of so many.
    """
    own = _KINDS.get(kind)
    claims = [change.claim for change in changes if isinstance(change, Gain)]
    shape, count = _shape_and_count(claims)
    if own is None or not shape:
        return None
    if shape == "gored":
        values = {**_GORED, "flare-skirt.skirt-many-panels.n_panels": count}
    elif shape == "godets":
        values = {**_WITH_GODETS, "godet-skirt.num_inserts": count}
    else:
        values = {**_TIERED, "levels-skirt.num_levels": count - 1}  # the first row is none of them
    values |= own
    try:
        complete_design(values)
    except DesignError:
        return None
    return values


def _shape_and_count(claims: Sequence[Claim]) -> tuple[str, int]:
    for claim in claims:
        if claim.name in _NUMBERS:
            return _NUMBERS[claim.name], round(float(claim.value))
    for claim in claims:
        if claim.name == "skirt" and claim.value in _USUAL:
            return str(claim.value), _USUAL[str(claim.value)]
    return "", 0


def counted_pattern(changes: Sequence[Change], kind: str) -> tuple[Pattern, dict[str, Any]] | None:
    """The draft of `counted_design`, with its parameters; None where there is none."""
    design = counted_design(changes, kind)
    if design is None:
        return None
    try:
        return make_pattern(design).canonical(), design
    except DesignError:
        return None


class CountedCandidate:
    """Such a draft for one garment that is described in words, to be tried where known patterns fail."""

    def __init__(self, wanted: Wanted) -> None:
        """Drafts it.

        Args:
            wanted: What is wanted.
        """
        order = wanted.order
        asked = order.source == "both" and order.edit is None and order.alter and wanted.part is None
        changes = [wish.change for wish in wanted.wishes]
        found = counted_pattern(changes, wanted.heard.kind or "") if asked else None
        self._found: list[Candidate] = []
        if found is not None:
            pattern, design = found
            self._found.append(Candidate(WrittenPattern(pattern), design=design))

    def __len__(self) -> int:
        return len(self._found)

    def fit(self, number: int) -> float:
        """No better than any known pattern."""
        return -float("inf")

    def take(self, number: int) -> Candidate:
        """The draft."""
        return self._found[number]

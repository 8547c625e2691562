"""Named drafts whose gathered hem is drawn into a band, where a text asks for a bubble hem."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import HEM_BAND, PUFFBALL, NamedDraft
from swifttailor.wording.lexicon import Lack

_FULLNESS: Mapping[str, tuple[str, float]] = {
    "gathered-skirt": ("fullness", 2.2),
    "skater-dress": ("gathers", 2.0),
    "strapless-dress": ("gathers", 2.0),
    "strappy-dress": ("gathers", 2.0),
    "drop-waist-dress": ("fullness", 1.6),
}
"""Drafts with that option, the option of their gathers, and what they have of them at least."""
_CUT_AS = {"circle-skirt": "gathered-skirt"}
"""Skirts without gathers, and what they are drafted as instead; of them only the length stays."""
_DROPPED = Claim("waist_seam", "dropped")
_LENGTH, _BAND_CM = "length", 2.0
_USUAL_CM = 50.0
_LENGTHS: Mapping[str, float] = {
    "micro": 38.0,
    "mini": 46.0,
    "above the knee": 53.0,
    "knee": 61.0,
    "below the knee": 68.0,
    "midi": 80.0,
    "maxi": 96.0,
    "ankle": 96.0,
    "floor": 100.0,
}
"""Waist to hem, cm, by where the skirt ends: what is cut on afterwards would make the band higher."""


def bubble_as_asked(draft: NamedDraft, lacks: Sequence[Lack], sure: Sequence[Claim]) -> NamedDraft:
    """A draft with a bubble hem where that is asked for and it can have one; others as they are.

    Args:
        draft: As it goes with what else is asked for.
        lacks: What the text asks for, and what names in it mean, that is not made otherwise.
        sure: What is told of the garment.
    """
    if not any(lack.what == PUFFBALL for lack in lacks):
        return draft
    if draft.name in _CUT_AS:
        kept = tuple([option for option in draft.options if option[0] == _LENGTH])
        draft = NamedDraft(_CUT_AS[draft.name], kept)
    if draft.name == "skater-dress" and _DROPPED in sure:
        draft = NamedDraft("drop-waist-dress")
    if draft.name not in _FULLNESS:
        return draft
    option, least = _FULLNESS[draft.name]
    options = dict(draft.options)
    length = _LENGTH if draft.kind == "skirt" else f"skirt_{_LENGTH}"
    told = [_LENGTHS[str(claim.value)] for claim in sure if claim.name == "skirt_hem"]
    if told or length not in options:
        options[length] = told[0] if told else _USUAL_CM
    fullness = max(float(options.get(option, 0.0)), least)
    return replace(draft, options=tuple({**options, option: fullness, HEM_BAND: _BAND_CM}.items()))

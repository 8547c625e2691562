"""Named drafts of dresses whose skirt is laid in pleats, where a text or a name means some."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import PLEATED, PLEATS, NamedDraft
from swifttailor.wording.lexicon import Lack

_STRIPS = 6.0
"""Seen in front, as those of skirts are."""
_ROUND = ("skater-dress", "shirt-dress", "strappy-dress", "strapless-dress", "drop-waist-dress")
"""Drafts of dresses whose skirts are no closer at the hips than at the waist."""
_PINAFORE, _PINAFORE_EASE_CM = "pinafore", 1.5
"""Under a wide waistband pleats stand off."""
_CUT_AS: Mapping[str, str] = {
    "shift-dress": "skater-dress",
    "fitted-dress": "skater-dress",
    "slip-dress": "strappy-dress",
}
"""Dresses without such a skirt, and what they are drafted as instead."""
_KEPT = (
    *("bust_ease", "waist_ease", "skirt_length", "stretch", "neckline", "neck_widening", "neck_depth"),
    *("back_neck_depth", "armhole_drop", "sleeves", "sleeve_length", "arm_ease", "sleeve_end"),
    *("sleeve_shape", "strap_width"),
)
_OF_STRAPPY = ("bust_ease", "waist_ease", "skirt_length", "stretch", "strap_width")
_RENAMED = {"length": "skirt_length", "chest_ease": "bust_ease"}
_MOST_EASE_CM, _USUAL_CM = 12.0, 56.0
_NOT_WITH = frozenset({"gathers", "hem_band", "hem_dip", "scallop_width", "hem_points"})
_CLOSE_SKIRTS = frozenset({Claim("skirt", value) for value in ("pencil", "narrowing", "tiered", "gathered")})
"""Dresses with such a skirt have their pleats elsewhere, if any."""


def pleats_as_asked(draft: NamedDraft, lacks: Sequence[Lack], sure: Sequence[Claim]) -> NamedDraft:
    """A dress whose skirt is pleated where that is asked for and it can be; other drafts as they are.

    Args:
        draft: As it goes with what else is asked for.
        lacks: What the text asks for, and what names in it mean, that is not made otherwise.
        sure: What is told of the garment.
    """
    if not any(lack.what == PLEATED for lack in lacks) or not _CLOSE_SKIRTS.isdisjoint(sure):
        return draft
    options = dict(draft.options)
    if draft.name == _PINAFORE:
        return replace(
            draft, options=tuple({**options, PLEATS: _STRIPS, "waist_ease": _PINAFORE_EASE_CM}.items())
        )
    if options.get("collar") in ("none", None) and draft.name in _CUT_AS:
        name = _CUT_AS[draft.name]
        kept = _KEPT if name == "skater-dress" else _OF_STRAPPY
        named = {_RENAMED.get(option, option): value for option, value in options.items()}
        options = {option: value for option, value in named.items() if option in kept}
        options |= {o: min(float(options[o]), _MOST_EASE_CM) for o in ("bust_ease",) if o in options}
        draft = NamedDraft(name, tuple({"skirt_length": _USUAL_CM, **options}.items()))
        options = dict(draft.options)
    if draft.name not in _ROUND or options.get("fitted") or options.get("flounce"):
        return draft
    plain = {option: value for option, value in options.items() if option not in _NOT_WITH}
    return replace(draft, options=tuple({**plain, PLEATS: _STRIPS}.items()))

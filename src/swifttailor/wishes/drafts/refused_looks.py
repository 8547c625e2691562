"""Named drafts without what a text refuses: not clingy, no low back."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts import find_draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wording.lexicon import WordReading

_INSTEAD: Mapping[Claim, Mapping[str, float]] = {
    Claim("fit", "close"): {"bust_ease": 11.0, "waist_ease": 10.0},
    Claim("fit", "loose"): {"chest_ease": 4.0, "bust_ease": 6.0, "waist_shaping": 4.0},
    Claim("hips", "close"): {"hip_ease": 11.0},
    Claim("back_depth", "low"): {"back_neck_depth": 3.5},
    Claim("back_depth", "open"): {"back_neck_depth": 3.5},
    Claim("neck_depth", "low"): {"neck_depth": 9.0},
    Claim("neck_depth", "plunging"): {"neck_depth": 11.0},
    Claim("legs", "slim"): {"leg_ease": 18.0},
    Claim("legs", "wide"): {"leg_ease": 20.0, "flare": 0.0},
}
"""Options of drafts, in cm, with which they are not so."""


_LOW, _SHALLOW_V_CM = Claim("neck_depth", "low"), 12.5
_SWIMSUIT = "swimsuit"
_LOW_BACKS = frozenset({Claim("back_depth", "low"), Claim("back_depth", "open")})
"""What a swimsuit on straps has, and one cut like a bodysuit has not."""


_MINI = Claim("skirt_hem", "mini")
_SKIRT_LENGTHS: Mapping[str, str] = {
    "circle-skirt": "length",
    "fitted-skirt": "length",
    "gathered-skirt": "length",
    "skater-dress": "skirt_length",
    "fitted-dress": "skirt_length",
}
"""Drafts with skirts, and their option of the length."""
_SHORT_CM = 51.0
"""Of skirts that are to be short, but not too short: they end above the knee."""


def as_not_refused(draft: NamedDraft, never: Collection[Claim]) -> NamedDraft:
    """A draft with the options that keep it from being what is refused, where it has such options.

    Args:
        draft: As a table names it; what that sets stays.
        never: What the text refuses.
    """
    if draft.name == _SWIMSUIT and not _LOW_BACKS.isdisjoint(never):
        draft = NamedDraft("bodysuit", (("stretch", 8.0), ("sleeves", False), ("neck_depth", 14.0)))
    if _MINI in never and draft.name in _SKIRT_LENGTHS:
        draft = _no_mini(draft)
    draft = _with_shallow_v(draft) if _LOW in never else draft
    wanted = {name: value for claim in never for name, value in _INSTEAD.get(claim, {}).items()}
    if not wanted:
        return draft
    own = {field.name: field.option for field in find_draft(draft.name).options}
    set_already = {name for name, _ in draft.options}
    more = []
    for name, value in wanted.items():
        if name in own and name not in set_already:
            low, high = own[name].low, own[name].high
            more.append(
                (
                    name,
                    min(max(value, low if low is not None else value), high if high is not None else value),
                )
            )
    return replace(draft, options=(*draft.options, *more)) if more else draft


_FRILLS = (Claim("cuffs", "flounce"), Claim("skirt", "gathered tiers"))


def refused_frills(words: WordReading) -> tuple[Claim, ...]:
    """What is like frills, where a text wants none: "frills no"."""
    denied = [entry for mark in words.marks if mark.denied for entry in mark.entries]
    return _FRILLS if any("frills" in entry.cannot for entry in denied) else ()


def _with_shallow_v(draft: NamedDraft) -> NamedDraft:
    """A V that is no deeper than one that is still seen for a V."""
    options = dict(draft.options)
    if options.get("neckline") != "v" or float(options.get("neck_depth", 0.0)) <= _SHALLOW_V_CM:
        return draft
    return replace(draft, options=tuple({**options, "neck_depth": _SHALLOW_V_CM}.items()))


def _no_mini(draft: NamedDraft) -> NamedDraft:
    """A short skirt, a little longer: "a mini skirt, but not too short"."""
    options, name = dict(draft.options), _SKIRT_LENGTHS[draft.name]
    if not 0.0 < float(options.get(name, 0.0)) < _SHORT_CM:
        return draft
    return replace(draft, options=tuple({**options, name: _SHORT_CM}.items()))

"""Named drafts with sleeves of the shape that a text asks for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import ARMHOLE, NamedDraft

_SET_IN = (
    "skater-dress",
    "fitted-dress",
    "mermaid-dress",
    "empire-dress",
    "drop-waist-dress",
    "shift-dress",
    "swing-dress",
    "jumpsuit",
    "peplum-top",
    "fitted-top",
    "bodysuit",
    "wrap-top",
    "wrap-dress",
    "wrap-jumpsuit",
)
"""Drafts that have sleeves where an option says so."""
_BELOW_SHOULDERS = ("off-shoulder-top", "off-shoulder-dress")
_ALWAYS = ("t-shirt", "shirt", "turtleneck", "shirt-dress", "cardigan")
_CUFFED = ("sweatshirt", "hoodie", "bomber-jacket", "denim-jacket")
"""Their sleeves end in cuffs, into which full ones are gathered."""
_OVER_OTHERS = ("coat", "blazer", "hooded-coat", "robe")
"""What is worn over other clothes and has sleeves."""
_TAILORED = ("coat", "blazer")
"""Of these, what has sleeves of other shapes, as long as its own where nothing is said."""
_WITH_CUFFS = ("shirt", "shirt-dress", *_CUFFED)
_SHAPES: Mapping[str, str] = {
    "balloon": "balloon",
    "puffed": "puffed",
    "bell": "bell",
    "gathered end": "balloon",
    "wide": "plain",
}
_FLOUNCED = frozenset({Claim("cuffs", "flounce"), Claim("cuffs", "band and flounce")})
"""Of several that are asked for, the first decides."""
_LENGTHS: Mapping[str, float] = {
    "cap": 16.0,
    "short": 22.0,
    "elbow": 34.0,
    "three-quarter": 44.0,
    "long": 60.0,
    "extra-long": 71.0,
}
_EXTRA_LONG, _THREE_QUARTERS = Claim("sleeves", "extra-long"), Claim("sleeves", "three-quarter")
_OF_ONE_ARM = ("left_sleeve", "right_sleeve")
_ONE_ARM = frozenset({Claim("sleeves", "left only"), Claim("sleeves", "right only")})
"""Where there is only one, how long that is tells how long both are drafted."""
_LONGEST_BARE_CM = 64.0
"""Of sleeves that begin below the shoulder."""
_SLIM, _DEEP = Claim("sleeve_shape", "slim"), Claim("cuffs", "deep")
_SLIM_ARM = 3.5
"""Room around the arm of sleeves that are to be close, cm."""
_SLIM_ENDS: Mapping[float, float] = {16.0: 31.0, 22.0: 30.0, 34.0: 27.0, 44.0: 24.0, 60.0: 20.0, 71.0: 20.0}
"""Width around at their end, by their length, cm."""
_PULLED_ON, _PULLED_ON_CM = "t-shirt", 41.0
"""What is pulled on has three-quarter sleeves so long that nobody calls them long."""
_OWN_LENGTHS: Mapping[str, float] = {_PULLED_ON: 22.0}
"""From the shoulder tip, cm, of drafts with sleeves that are not long unless told."""
_DEEP_CM = 14.0
"""Height of cuffs that are to be deep."""
_USUAL = {"puffed": 22.0, "bell": 44.0, "balloon": 60.0, "plain": 44.0, "flounced": 60.0}
"""From the shoulder tip, cm, where nothing is said of the length."""
_SLIM_END = 21.0
"""Width around at the end of long puffed sleeves, cm."""
_OPEN_ENDS: Mapping[str, Mapping[str, float | str]] = {
    "plain": {"sleeve_shape": "wide", "arm_ease": 14.0},
    "bell": {"sleeve_shape": "bell", "arm_ease": 10.0},
}
"""Sleeves of jumpers that are to be wide, or wide at their ends."""
_FULL_ABOVE_RIBS = {"arm_ease": 15.0, "sleeve_end": 34.0}
"""Wide sleeves of cardigans, which end in ribbed cuffs all the same."""
_WIDE = {"arm_ease": 18.0, "sleeve_end": 46.0}
_LONG_WIDE = {"arm_ease": 18.0, "sleeve_shape": "wide"}
"""Of sleeves that are to be wide; long ones so wide all the way would turn around the wrists."""
_SHORT_WIDE: Mapping[str, float | bool] = {"arm_ease": 10.0, "sleeve_end": 42.0, "cuffs": False}
"""Of short ones of shirts: cuffs would gather them, and wider tops fold over as puffed ones do."""
_ENDS: Mapping[float, float] = {16.0: 33.0, 22.0: 33.0, 34.0: 31.0, 44.0: 28.0, 60.0: 24.0, 71.0: 28.0}
"""Width around at the end of plain sleeves of those lengths, cm."""
_SHIRT_END = 34.0
"""The same of the short sleeves of shirts, which have no cuffs."""
_WIDE_END = 34.0
"""The same of sleeves that are cut in one with a coat."""


def sleeves_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A draft with puffed, balloon or bell sleeves where those are asked for; others as they are.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
    """
    asked = {claim.value for claim in claims if claim.name == "sleeve_shape"}
    shape = next((made for named, made in _SHAPES.items() if named in asked), None)
    if shape is None and not _FLOUNCED.isdisjoint(claims):
        shape = "flounced"
    if Claim("sleeves", "none") in claims:
        return draft
    options = dict(draft.options)
    if options.get(ARMHOLE) == "cut-in-one":  # wide where they begin
        return _cut_in_one(draft, claims)
    draft = _with_deep_cuffs(draft, claims)
    options = dict(draft.options)
    if shape is None:
        return _slim(_with_plain_sleeves(draft, claims), claims)
    if draft.name in _CUFFED and shape == "balloon":
        return replace(draft, options=tuple({**options, "sleeve_shape": shape}.items()))
    if draft.name == "sweatshirt" and shape in _OPEN_ENDS:
        told = {"sleeve_length": _told_lengths(claims)[0]} if _told_lengths(claims) else {}
        return replace(draft, options=tuple({**options, **_OPEN_ENDS[shape], **told}.items()))
    if draft.name == "cardigan" and options.get("ribbed") and shape == "plain":
        return replace(draft, options=tuple({**options, **_FULL_ABOVE_RIBS}.items()))
    if draft.name in _TAILORED and shape != "plain":
        long = {"sleeve_length": _told_lengths(claims)[0]} if _told_lengths(claims) else {}
        return replace(draft, options=tuple({**options, "sleeve_shape": shape, **long}.items()))
    if draft.name not in (*_SET_IN, *_ALWAYS):
        return draft
    told = _told_lengths(claims)
    options |= {"sleeve_shape": shape, "sleeve_length": told[0] if told else _USUAL[shape]}
    if shape == "plain":
        long = float(options["sleeve_length"]) >= _LENGTHS["long"] and draft.name not in _WITH_CUFFS
        options |= _LONG_WIDE if long else _WIDE
        if draft.name == "shirt" and float(options["sleeve_length"]) <= _LENGTHS["elbow"]:
            options |= _SHORT_WIDE
    if shape == "puffed":
        options["sleeve_end"] = _SLIM_END
    elif shape == "flounced":
        options["sleeve_end"] = _ENDS.get(options["sleeve_length"], _ENDS[_LENGTHS["long"]])
    if draft.name in _SET_IN:
        options["sleeves"] = True
    return replace(draft, options=tuple(options.items()))


def _with_plain_sleeves(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A draft that has sleeves where an option says so, and shirts, with plain ones as long as is told."""
    told, options = _told_lengths(claims), dict(draft.options)
    if _EXTRA_LONG in claims and draft.name in (*_ALWAYS, *_CUFFED, *_OVER_OTHERS):
        return replace(draft, options=tuple({**options, "sleeve_length": _LENGTHS["extra-long"]}.items()))
    if _THREE_QUARTERS in claims and draft.name in (*_OVER_OTHERS, "cardigan"):
        wide = max(float(options.get("sleeve_end", 0.0)), _ENDS[_LENGTHS["three-quarter"]])
        shorter = {"sleeve_length": _LENGTHS["three-quarter"], "sleeve_end": wide}
        return replace(draft, options=tuple({**options, **shorter}.items()))
    if draft.name == "shirt" and told and told[0] <= _LENGTHS["elbow"]:
        short = {"sleeve_length": told[0], "sleeve_end": _SHIRT_END, "cuffs": False}
        return replace(draft, options=tuple({**options, **short}.items()))
    if told and draft.name in _BELOW_SHOULDERS and told[0] >= _LENGTHS["three-quarter"]:
        options |= {"sleeve_length": min(told[0], _LONGEST_BARE_CM), "sleeve_end": _ENDS[told[0]]}
        return replace(draft, options=tuple(options.items()))
    if told and draft.name == _PULLED_ON and told[0] > _OWN_LENGTHS[_PULLED_ON]:
        length = _PULLED_ON_CM if _THREE_QUARTERS in claims else told[0]
        ends = {"sleeve_length": length, "sleeve_end": _ENDS[told[0]]}
        return replace(draft, options=tuple({**ends, **options}.items()))
    if not told or draft.name not in _SET_IN or options.get("sleeves"):
        return draft
    options |= {"sleeves": True, "sleeve_length": told[0], "sleeve_end": _ENDS[told[0]]}
    return replace(draft, options=tuple(options.items()))


def _slim(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A draft with sleeves close to the arm, where those are asked for and nothing of their ends is told."""
    options = dict(draft.options)
    worn = draft.name in _ALWAYS or (draft.name in _SET_IN and options.get("sleeves"))
    if _SLIM not in claims or not worn:
        return draft
    length = float(options.get("sleeve_length", _OWN_LENGTHS.get(draft.name, _LENGTHS["long"])))
    nearest = min(_SLIM_ENDS, key=lambda known: abs(known - length))
    close = {"arm_ease": _SLIM_ARM, "sleeve_end": _SLIM_ENDS[nearest]}
    return replace(draft, options=tuple({**options, **close}.items()))


def _with_deep_cuffs(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A draft whose sleeves end in cuffs, with deep ones where those are asked for."""
    if _DEEP not in claims or draft.name not in _WITH_CUFFS:
        return draft
    deep = {"cuffs": True, "cuff_height": _DEEP_CM}
    return replace(draft, options=tuple({**dict(draft.options), **deep}.items()))


def _cut_in_one(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A draft whose sleeves are cut in one with the body, with sleeves of the length that is told."""
    told = _told_lengths(claims)
    if not told:
        return draft
    end = _WIDE_END if draft.name == "coat" else _ENDS[told[0]]
    long = {"sleeve_length": told[0], "sleeve_end": end}
    return replace(draft, options=tuple({**dict(draft.options), **long}.items()))


def _told_lengths(claims: Sequence[Claim]) -> list[float]:
    arms = ("sleeves", *(_OF_ONE_ARM if not _ONE_ARM.isdisjoint(claims) else ()))
    found = [_LENGTHS[str(c.value)] for c in claims if c.name in arms and c.value in _LENGTHS]
    return [_LENGTHS["extra-long"]] if _EXTRA_LONG in claims else found

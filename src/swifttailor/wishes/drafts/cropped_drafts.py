"""Named drafts of tops that are to end above the hips."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import ARMHOLE, NamedDraft
from swifttailor.wishes.drafts.close_drafts import SHAPED_TO_CM

_LOOSE = frozenset({"easy", "loose", "oversized"})
_CROPPED: Mapping[str, tuple[str, Mapping[str, float]]] = {
    **dict.fromkeys(
        ("denim-jacket", "bomber-jacket"),
        ("chest_ease", {"cropped": 3.5, "waist": 5.5}),
    ),
    **dict.fromkeys(("sweatshirt", "hoodie"), ("chest_ease", {"cropped": 6.0, "waist": 7.0})),
    **dict.fromkeys(("camisole", "off-shoulder-top"), ("chest_ease", {"cropped": -4.0})),
    "cardigan": ("chest_ease", {"cropped": 4.0, "waist": 6.0}),
    "blazer": ("chest_ease", {"cropped": 4.0, "waist": 6.0}),
    **dict.fromkeys(
        ("t-shirt", "shirt", "turtleneck", "tank-top"), ("chest_ease", {"cropped": -2.0, "waist": 4.0})
    ),
}
"""Where the hems of drafts are that are asked to end above the hips, cm below the waist, and their room."""
_CLOSE_AT_BUST = ("camisole", "off-shoulder-top")
_WITH_WINGS_CM: Mapping[str, float] = {"t-shirt": 8.0, "sweatshirt": 12.0}
"""Hems of tops whose sleeves are cut in one lie at least so far below the waist, cm: above shorter ones such
sleeves do not follow the arm."""
_OVER_OTHERS_CM, _LIFTED_CM = 18.0, 6.0
"""Jackets with so much room are lifted so far by the arms."""
_CROPPED_EASE_CM = 12.0
"""Wider ones stand off where they end."""
_HIGH_HIP, _SHORT_JACKET_CM = Claim("top_hem", "high hip"), 13.0
_SHORT = frozenset({_HIGH_HIP, Claim("top_hem", "cropped"), Claim("top_hem", "waist")})
_BARE_ARMS = Claim("sleeves", "none")
_JACKETS = frozenset({"turtleneck", "blazer", "cardigan", "shirt", "denim-jacket", "bomber-jacket"})
"""Jackets that are asked for short end so far below the waist."""
_BANDED = frozenset({"denim-jacket", "bomber-jacket", "sweatshirt", "hoodie"})
_CROPPED_BANDED: Mapping[str, float] = {"chest_ease": 11.0, "hem_band_ease": 1.0}
"""Room of what a band ends at the waist: bands that are higher or wider stand off like a shelf."""
_BARELY_CM = 2.0
"""Fronts that have moved back by more are worn open."""
_SHORT_CARDIGAN: Mapping[str, float] = {
    "neck_depth": 18.0,
    "chest_ease": 6.0,
    "opening": 0.0,
    "closed_to": 0.0,
    "waist_shaping": 2.0,
    "armhole_drop": 4.0,
    "arm_ease": 9.0,
}
_SHORT_BLAZER: Mapping[str, float] = {
    **{"neck_depth": 24.0, "lapel_width": 6.5, "chest_ease": 7.0, "opening": 0.0},
    **{"waist_shaping": 3.0, "sleeve_end": 25.0},
}
_SHORT_SHIRT: Mapping[str, float] = {"chest_ease": 13.0, "waist_shaping": 1.5}
"""Darts keep the back of a short shirt from standing off."""
_SHAPED_JACKET: Mapping[str, float] = {
    **{"chest_ease": 8.0, "waist_shaping": 3.0, "armhole_drop": 4.0},
    **{"arm_ease": 9.0, "sleeve_end": 25.0},
}
"""Of jackets on a standing collar that end at the waist, without which their backs hang like capes."""
_AT_WAIST_CM = 6.0
"""Where such jackets end that are to end at the waist: arms that are raised lift them above it."""
_HIGH_HIP_JACKET: Mapping[str, float] = {**_SHAPED_JACKET, "waist_shaping": 2.5, "length": 14.0}
_PADDED_CM, _BOMBER, _WARM_CM = 18.0, "bomber-jacket", 11.0
"""Jackets on a standing collar with so much room are padded; where they are short, a band draws them in, and
arms lift them: those that are to end at the waist are cut so long, cm, that they cover it."""
_KEPT: Mapping[str, tuple[float, float]] = {
    "chest_ease": (0.0, 11.0),
    "sleeve_length": (12.0, 74.0),
    "arm_ease": (0.0, 16.0),
    "sleeve_end": (24.0, 32.0),
    "collar_height": (4.0, 6.0),
}
"""What a banded jacket has of one that was drafted without a band, at least and at most."""


def cropped_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A top drafted short: one that is cut off there is as wide at the hem as it was at the chest.

    Args:
        draft: As it is named.
        claims: What is asked for.
    """
    if draft.name == "fitted-top" and any(c.name == "fit" and c.value in _LOOSE for c in claims):
        bare = not any(c.name == "sleeves" and c.value != "none" for c in claims)
        draft = NamedDraft("tank-top" if bare else "t-shirt", ())
        claims = [*claims, Claim("top_hem", "cropped")]
    padded = _is_padded(draft) and not _SHORT.isdisjoint(claims) and _BARE_ARMS not in claims
    draft = _banded(draft) if padded else draft
    if draft.name in _JACKETS and _HIGH_HIP in claims and _SHORT.isdisjoint({*claims} - {_HIGH_HIP}):
        if _is_jacket(draft) and not any(c.name == "fit" and c.value in _LOOSE for c in claims):
            return replace(draft, options=tuple({**dict(draft.options), **_HIGH_HIP_JACKET}.items()))
        length = min(float(dict(draft.options).get("length", _SHORT_JACKET_CM)), _SHORT_JACKET_CM)
        return replace(draft, options=tuple({**dict(draft.options), "length": length}.items()))
    if draft.name not in _CROPPED:
        return draft
    room, lengths = _CROPPED[draft.name]
    asked = [lengths[str(c.value)] for c in claims if c.name == "top_hem" and str(c.value) in lengths]
    if not asked:
        return draft
    own = dict(draft.options)
    if draft.name == "cardigan":
        return _buttoned_short(draft, asked[0], _SHORT_CARDIGAN)
    if draft.name == "blazer":
        return _buttoned_short(draft, asked[0], _SHORT_BLAZER)
    if own.get("waist_shaping") and 0.0 <= asked[0] <= float(own.get("length", 99.0)) <= SHAPED_TO_CM:
        return draft
    options = {**own, "length": asked[0]}
    if asked[0] == lengths["cropped"] and float(own.get("length", 0.0)) < 0:  # so by name: a sports bra
        options["length"] = min(asked[0], float(own["length"]))
    if padded and asked[0] > 0:
        options["length"] = max(asked[0], _WARM_CM)
    if draft.name == "turtleneck" and float(own.get(room, 0.0)) >= _OVER_OTHERS_CM:
        options["length"] = asked[0] + _LIFTED_CM
    if options.get(ARMHOLE) == "cut-in-one":
        options["length"] = max(asked[0], _WITH_WINGS_CM.get(draft.name, 8.0))
    elif draft.name in _BANDED and asked[0] == lengths["cropped"]:
        options |= {k: min(float(options.get(k, most)), most) for k, most in _CROPPED_BANDED.items()}
    elif _is_jacket(draft) and not any(c.name == "fit" and c.value in _LOOSE for c in claims):
        length = max(asked[0], _AT_WAIST_CM) if asked[0] > 0 else asked[0]
        options = {**options, **_SHAPED_JACKET, "length": length}
    elif _may_be_darted(draft, claims):
        ease = min(float(options.get(room, _SHORT_SHIRT[room])), _SHORT_SHIRT[room])
        options = {**options, **_SHORT_SHIRT, room: ease, "length": max(asked[0], 0.0)}
        options.pop("hem_rise", None)
    elif asked[0] < 0 and draft.name not in _CLOSE_AT_BUST:  # which are close at the bust by themselves
        options[room] = min(float(options.get(room, _CROPPED_EASE_CM)), _CROPPED_EASE_CM)
    return replace(draft, options=tuple(options.items()))


def _may_be_darted(draft: NamedDraft, claims: Sequence[Claim]) -> bool:
    """Whether darts may shape it: a shirt with short sleeves would seem to be too tight with them."""
    loose = any(c.name == "fit" and c.value in _LOOSE for c in claims)
    short = any(c.name == "sleeves" and c.value in ("short", "cap", "none") for c in claims)
    return draft.name == "shirt" and not loose and not short


def _is_jacket(draft: NamedDraft) -> bool:
    """Whether it is a jacket on a collar that stands, without room for others below: darts shape it."""
    own = dict(draft.options)
    close = float(own.get("chest_ease", 0.0)) < _OVER_OTHERS_CM and not own.get("stretch")
    stands = draft.name == "turtleneck" and own.get("rolled") is False
    return stands and close and bool(own.get("sleeves", True))


def _is_padded(draft: NamedDraft) -> bool:
    """Whether it is a wide jacket that is closed up to a standing collar."""
    own = dict(draft.options)
    stands = draft.name == "turtleneck" and own.get("rolled") is False and not own.get("waist_shaping")
    set_in = own.get(ARMHOLE, "set-in") == "set-in" and own.get("sleeves", True)
    return stands and bool(set_in) and float(own.get("chest_ease", 0.0)) >= _PADDED_CM


def _banded(draft: NamedDraft) -> NamedDraft:
    """The same jacket with a band at its hem and cuffs."""
    own = dict(draft.options)
    kept = {n: min(max(float(own[n]), low), high) for n, (low, high) in _KEPT.items() if n in own}
    return NamedDraft(_BOMBER, tuple(kept.items()))


def _buttoned_short(cardigan: NamedDraft, length: float, short: Mapping[str, float]) -> NamedDraft:
    """A cardigan or blazer that ends at the waist, buttoned to the hem; open ones stay open."""
    own = dict(cardigan.options)
    if float(own.get("opening", _BARELY_CM)) > _BARELY_CM or float(own.get("length", length + 1.0)) <= length:
        return cardigan
    return replace(cardigan, options=tuple({**short, **own, "length": length}.items()))

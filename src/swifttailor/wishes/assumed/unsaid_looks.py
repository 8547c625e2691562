"""What nobody expects who has not asked for it: puffed sleeves, bare backs, tops that blouse over a band.

Patterns to begin from are chosen by this; nothing is cut away for it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.reader import Wish
from swifttailor.wording.claim_kinds import fits_kind
from swifttailor.wording.lexicon import SURENESS

_UPPER = frozenset({"top", "tunic", "dress", "jumpsuit", "playsuit"})
_TOPS = frozenset({"top", "tunic"})
_SKIRTS = frozenset({"skirt", "dress"})
_LEGS = frozenset({"trousers", "shorts", "jumpsuit", "playsuit"})


@dataclass(frozen=True)
class _Unexpected:
    """Values of one claim that surprise."""

    kinds: frozenset[str]
    """Of the garments where they do."""
    name: str
    values: tuple[str, ...]
    unless: frozenset[str]
    """Names of claims: a text that speaks of any of these may mean them."""


def _unexpected(kinds: frozenset[str], name: str, values: str, unless: str = "") -> _Unexpected:
    return _Unexpected(kinds, name, tuple(values.split(",")), frozenset([name, *unless.split()]))


_BARE = "shoulders straps"
_NECK = "left_neckline right_neckline neck_depth neck_depth_cm shoulders collar hood"
_SAYS_NOTHING_MORE = frozenset([("shoulders", "both")])
"""Who says so does not speak of straps and bare backs."""
_FULLNESS = "hem_cm gores tiers godets godet_cm"
_ALL = (
    _unexpected(_UPPER, "sleeve_shape", "puffed,balloon,bell", "sleeve_width_cm"),
    _unexpected(_UPPER, "sleeve_shape", "gathered end", "cuffs cuff_cm"),
    _unexpected(_UPPER, "sleeve_shape", "wide", "fit chest_cm sleeve_width_cm"),
    _unexpected(_UPPER, "shoulders", "strapless,bare left,bare right", "straps left_sleeve right_sleeve"),
    _unexpected(_UPPER, "cuffs", "flounce,band and flounce", "cuff_cm"),
    _unexpected(_UPPER, "neck_depth", "plunging", f"neck_depth_cm {_BARE}"),
    _unexpected(_UPPER, "back_depth", "low,open", f"back_depth_cm back_neckline {_BARE}"),
    _unexpected(_UPPER, "neckline", "trapezoid,s-curve,pointed,asymmetric", _NECK),
    _unexpected(_UPPER, "collar", "stand,turtleneck,lapel", "neckline neck_depth shoulders hood collar_cm"),
    _unexpected(_UPPER, "armholes", "square,angled,deep", "sleeves shoulders straps"),
    _unexpected(_UPPER, "fit", "loose,oversized", "chest_cm bodice sleeve_shape"),
    _unexpected(_UPPER, "bodice", "gathered", "fit chest_cm waist_seam"),
    _unexpected(_UPPER, "waist_seam", "dropped", "waistband"),
    _unexpected(_TOPS | {"dress"}, "waistband", "hem", "waistband_cm waist_seam"),
    _unexpected(_TOPS, "skirt", "peplum", "waist_seam"),
    _unexpected(
        _SKIRTS,
        "skirt",
        "more than a circle,godets,tiered,gathered tiers",
        _FULLNESS,
    ),
    _Unexpected(_SKIRTS, "skirt", ("fitted base",), frozenset(["hips"])),
    _unexpected(_SKIRTS, "waistband", "wide,loose", "waistband_cm"),
    _unexpected(_SKIRTS, "skirt_hem", "micro,mini", "skirt_length_cm length_cm"),
    _unexpected(_LEGS, "legs", "flared", "leg_width_cm"),
)


def unexpected_looks(wishes: Iterable[Wish], kind: str | None) -> tuple[Claim, ...]:
    """What a garment should rather not show, as nothing that was said is about it.

    Args:
        wishes: What is asked for, and what is likely. What is less than usual is not unexpected itself, but
            leaves other values of its claim so.
        kind: Of the garment; nothing is unexpected where it is not known.
    """
    if kind is None:
        return ()
    told = [(wish.change.claim, wish.certainty) for wish in wishes if isinstance(wish.change, Gain)]
    names = {
        claim.name
        for claim, certainty in told
        if certainty >= SURENESS["usual"] and (claim.name, claim.value) not in _SAYS_NOTHING_MORE
    }
    maybe = {claim for claim, _ in told}
    return tuple(
        [
            Claim(each.name, value)
            for each in _ALL
            if kind in each.kinds and not each.unless & names and fits_kind(each.name, kind)
            for value in each.values
            if Claim(each.name, value) not in maybe
        ]
    )

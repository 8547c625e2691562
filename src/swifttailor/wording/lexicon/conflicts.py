"""Which claims exclude each other: a skirt is not mini and maxi, and what has no sleeves has no cuffs."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations

from swifttailor.describing.claims import Claim

_Steps = tuple[tuple[str, ...], ...]

SCALES: Mapping[str, _Steps] = {
    "skirt_hem": (
        *(("micro",), ("mini",), ("above the knee",), ("knee",), ("below the knee",)),
        *(("midi",), ("maxi", "ankle", "floor")),
    ),
    "top_hem": (("bra",), ("cropped",), ("waist",), ("high hip",), ("hip",), ("long",)),
    "leg_hem": (("very short",), ("mid-thigh",), ("thigh",), ("knee",), ("calf",), ("ankle",), ("full",)),
    "sleeves": (("cap",), ("short",), ("elbow",), ("three-quarter",), ("long",), ("extra-long",)),
    "fit": (("close",), ("easy",), ("loose",), ("oversized",)),
    "neck_depth": (("high",), (), ("low",), ("plunging",)),
    "back_depth": (("high",), (), ("low",), ("open",)),
}
"""Values in their order; those two and more steps apart exclude each other."""
_APART: Mapping[str, tuple[tuple[str, ...], ...]] = {
    "neckline": (
        ("round", "crew"),
        ("round", "scoop"),
        ("boat", "round"),
        ("v",),
        ("square",),
        ("trapezoid",),
        ("s-curve",),
        ("pointed",),
        ("asymmetric",),
    ),
    "back_neckline": (("round",), ("v",), ("square",)),
    "collar": (("none",), ("stand", "turtleneck"), ("lapel",)),
    "hood": (("none",), ("hood",)),
    "shoulders": (("both",), ("strapless",), ("bare left",), ("bare right",)),
    "straps": (("narrow",), ("wide",)),
    "waist_seam": (("empire",), ("natural",), ("dropped",)),
    "rise": (("high",), ("mid",), ("low",)),
    "hips": (("close",), ("loose",)),
    "sides": (("alike",), ("different",)),
    "kind": (
        ("top",),
        ("tunic",),
        ("dress",),
        ("skirt",),
        ("trousers",),
        ("shorts",),
        ("jumpsuit",),
        ("playsuit",),
    ),
}
"""Groups of values that can be true together; values that share no group exclude each other."""
_CIRCLES = ("half circle", "three-quarter circle", "circle", "more than a circle")
_SKIRTS = (
    *[
        (narrow, wide)
        for narrow in ("pencil", "narrowing")
        for wide in ("a-line", "flared", "gathered", *_CIRCLES)
    ],
    *[("straight", wide) for wide in ("flared", *_CIRCLES)],
    *combinations(_CIRCLES, 2),
)
_PAIRS: Mapping[str, tuple[tuple[str, str], ...]] = {
    "skirt": _SKIRTS,
    "legs": (
        ("wide", "slim"),
        ("tapered", "flared"),
        ("slim", "flared"),
        ("straight", "flared"),
        ("straight", "tapered"),
    ),
    "sleeve_shape": (
        ("slim", "wide"),
        ("slim", "puffed"),
        ("slim", "balloon"),
        ("slim", "bell"),
        ("tapered", "bell"),
        ("puffed", "set smooth"),
        ("slim", "gathered end"),
        ("bell", "gathered end"),
        ("bell", "balloon"),
    ),
    "bodice": (("darted", "undarted"), ("flared", "tapered")),
    "waistband": (("narrow", "wide"), ("shaped", "straight")),
    "hem_shape": (("lower left", "lower right"),),
}
_DIRECTED = frozenset(
    [
        *(
            "micro",
            "mini",
            "above the knee",
            "below the knee",
            "maxi",
            "floor",
            "bra",
            "cropped",
            "very short",
        ),
        *(
            "full",
            "short",
            "long",
            "extra-long",
            "close",
            "loose",
            "oversized",
            "high",
            "low",
            "plunging",
            "open",
        ),
    ]
)
"""Values that whoever denies them denies together with those beyond."""
_NEGATIVE = ("none", "level")
_ONE_SIDED = ("left only", "right only", "unequal")
_ARMS = frozenset(
    ["cuffs", "sleeve_shape", "left_sleeve", "right_sleeve", "sleeve_cm", "sleeve_width_cm", "cuff_cm"]
)
_NECKS = frozenset(["neckline", "left_neckline", "right_neckline", "back_neckline", "back_depth"])
"""Claims that are true of garments without collar and hood only."""


def opposed(a: Claim, b: Claim) -> bool:
    """Whether nobody would call a garment both: two values of one claim that are far apart."""
    if a.name != b.name or a.value == b.value:
        return False
    if not isinstance(a.value, str) or not isinstance(b.value, str):
        return True
    if a.value in _NEGATIVE or b.value in _NEGATIVE:
        return True
    if a.name == "sleeves" and (a.value in _ONE_SIDED or b.value in _ONE_SIDED):
        return a.value in _ONE_SIDED and b.value in _ONE_SIDED
    scale = SCALES.get(a.name)
    if scale is not None:
        return abs(_step(scale, a.value) - _step(scale, b.value)) > 1
    groups = _APART.get(a.name)
    if groups is not None:
        return not any(a.value in group and b.value in group for group in groups)
    pairs = _PAIRS.get(a.name, ())
    return (a.value, b.value) in pairs or (b.value, a.value) in pairs


def exclude(a: Claim, b: Claim) -> bool:
    """Whether two claims cannot both be true of a pattern, either way round."""
    return opposed(a, b) or _of_parts(a, b) or _of_parts(b, a)


def _of_parts(a: Claim, b: Claim) -> bool:
    if a.name == "sleeves" and a.value == "none":
        return b.name in _ARMS and b.value != "none"
    if a.name == "shoulders" and a.value == "strapless":
        if b.name in ("collar", "hood", "sleeves"):
            return b.value != "none"
        return b.name in ("straps", "left_sleeve", "right_sleeve", "neckline")
    if a.name == "shoulders" and a.value in ("bare left", "bare right"):
        side = str(a.value).removeprefix("bare ")
        return b.name == f"{side}_sleeve" or b == Claim("sleeves", f"{side} only")
    if a.name == "sleeves" and a.value != "none":
        return b.name in ("straps", "armholes")
    if a.name == "collar" and a.value != "none":
        return (
            b.name in _NECKS
            or (b.name == "neck_depth" and a.value != "lapel")
            or (b.name == "hood" and b.value == "hood")
        )
    if a.name == "hood" and a.value == "hood":
        return b.name in _NECKS or b.name == "neck_depth"
    return False


def beyond(claim: Claim) -> tuple[Claim, ...]:
    """A claim, and those that go farther the same way: "not too short" is neither mini nor micro.

    Of values that differ little those before it stay: what is not to reach the floor may be a maxi.
    """
    scale = SCALES.get(claim.name)
    if scale is None or not isinstance(claim.value, str):
        return (claim,)
    step = _step(scale, claim.value)
    if claim.value not in _DIRECTED:
        return (claim,)
    middle = (len(scale) - 1) / 2
    own = scale[step][scale[step].index(claim.value) :]
    wanted = scale[: step + 1] if step < middle else (own, *scale[step + 1 :])
    return tuple([Claim(claim.name, value) for values in wanted for value in values])


def _step(scale: _Steps, value: str) -> int:
    return next((k for k, values in enumerate(scale) if value in values), -1)

"""Claims and dimensions as the client shows them: short labels, units, groups, choices."""

from __future__ import annotations

from functools import cache
from typing import Any

from swifttailor.describing.claims import CLAIM_TYPES
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.recutting.levers.all_levers import LEVERS_OF
from swifttailor.wording.claim_kinds import fits_kind

KINDS = ("dress", "skirt", "top", "trousers", "shorts", "jumpsuit", "playsuit")
_LABELS = {
    "skirt_hem": "hem",
    "top_hem": "hem",
    "leg_hem": "legs end",
    "hem_shape": "hem shape",
    "hem_cm": "hem width",
    "waistband_cm": "waistband height",
    "collar_cm": "collar width",
    "slit_cm": "slit height",
    "godet_cm": "godet height",
    "cuff_cm": "cuff length",
    "leg_cuff_cm": "leg cuff length",
    "sleeve_cm": "sleeve length",
    "kind": "garment",
    "back_neckline": "back",
    "neck_depth": "neck depth",
    "left_neckline": "left neckline",
    "right_neckline": "right neckline",
    "legs": "leg shape",
    "waist_seam": "waist seam",
}
_GROUPS = {
    "length": ("length", "bodice length", "leg length", "dip"),
    "width": (
        "chest",
        "top width",
        "skirt hem",
        "skirt gathers",
        "bodice gathers",
        "thigh",
        "leg end",
        "base width",
    ),
    "sleeves": (
        *("sleeve length", "sleeve width", "sleeve end", "sleeve head", "sleeve gathers"),
        *("cuff length", "cuff opening", "armholes"),
    ),
    "neck": (
        "neck depth",
        "neck width",
        "back depth",
        "shoulders",
        "collar height",
        "hood depth",
        "hood height",
    ),
}
_GROUP_OF = {name: group for group, names in _GROUPS.items() for name in names}


def claim_label(name: str) -> str:
    """A claim's name for people."""
    return _LABELS.get(name, name.removesuffix("_cm").replace("_", " "))


def claim_unit(name: str) -> str:
    """Of a claim's number; empty for words."""
    measure = CLAIM_TYPES[name].measure
    return "" if measure is None else measure.unit


def dimension_group(name: str) -> str:
    """What sliders a dimension stands with."""
    return _GROUP_OF.get(name, "details")


@cache
def claim_options() -> list[dict[str, Any]]:
    """All claims that chips can make."""
    return [
        {
            "name": name,
            "label": claim_label(name),
            "about": kind.about,
            "choices": list(kind.words),
            "unit": claim_unit(name),
            "kinds": [garment for garment in KINDS if fits_kind(name, garment)],
        }
        for name, kind in CLAIM_TYPES.items()
    ]


@cache
def dimension_options() -> list[dict[str, Any]]:
    """All dimensions that sliders can move."""
    return [
        {
            "name": name,
            "about": dimension.about,
            "unit": dimension.unit,
            "step": min(lever.step for lever in LEVERS_OF[name]),
            "group": dimension_group(name),
        }
        for name, dimension in QUANTITIES.items()
        if LEVERS_OF[name]
    ]

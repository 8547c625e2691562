"""Which part of a garment a panel is, as far as its name says it."""

from __future__ import annotations

import re
from enum import StrEnum


class Part(StrEnum):
    """What a panel is in a garment."""

    TORSO = "torso"
    SLEEVE = "sleeve"
    CUFF = "cuff"
    """Below a sleeve."""
    HOOD = "hood"
    COLLAR = "collar"
    WAISTBAND = "waistband"
    SKIRT = "skirt"
    GODET = "godet"
    """A wedge let into the hem of a skirt."""
    TROUSER = "trouser"
    LEG_CUFF = "leg cuff"
    """Below a trouser leg."""


# Tried in this order: a cuff of GarmentCode may be called `sl_left_cuff_skirt_f`.
_NAMES: tuple[tuple[re.Pattern[str], Part], ...] = tuple(
    (re.compile(pattern, re.IGNORECASE), part)
    for pattern, part in (
        (r"hood", Part.HOOD),
        (r"pant.*cuff|leg.*cuff|trouser.*cuff", Part.LEG_CUFF),
        (r"cuff", Part.CUFF),
        (r"sleeve", Part.SLEEVE),
        (r"collar|lapel", Part.COLLAR),
        (r"(^|_)wb(_|$)|waist_?band|belt", Part.WAISTBAND),
        (r"(^|_)ins_|godet", Part.GODET),
        (r"pant|trouser|shorts", Part.TROUSER),
        (r"skirt", Part.SKIRT),
        (r"torso|bodice|yoke", Part.TORSO),
    )
)


def named_part(name: str) -> Part | None:
    """The part that a panel's name speaks of; None when it says nothing."""
    return next((part for pattern, part in _NAMES if pattern.search(name)), None)

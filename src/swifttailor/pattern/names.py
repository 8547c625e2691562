"""GarmentCode's panel names, and rules that place unknown names beside them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache
from typing import Literal

BodyRegion = Literal["body", "arm", "leg"]

# Order of the class ids in AIpparel's list for GarmentCodeData, which covers GarmentCode exactly.
# fmt: off
PANEL_NAMES: tuple[str, ...] = (
    "left_btorso", "left_ftorso", "right_ftorso", "right_btorso", "skirt_front", "skirt_back",
    "wb_back", "wb_front", "left_sleeve_b", "left_sleeve_f", "right_sleeve_f", "right_sleeve_b",
    "sl_left_cuff_skirt_f", "sl_left_cuff_skirt_b", "sl_right_cuff_skirt_b",
    "sl_right_cuff_skirt_f", "sl_left_cuff_b", "sl_left_cuff_f", "sl_right_cuff_f",
    "sl_right_cuff_b", "pant_f_l", "pant_b_l", "pant_f_r", "pant_b_r", "left_collar_front",
    "left_collar_back", "right_collar_front", "right_collar_back", "ins_skirt_front_0",
    "ins_skirt_back_0", "ins_skirt_back_1", "ins_skirt_front_1", "skirt_panel_2", "skirt_panel_0",
    "skirt_panel_1", "skirt_panel_3", "skirt_panel_4", "skirt_panel_5", "ins_skirt_back_2",
    "ins_skirt_front_2", "skirt_panel_6", "skirt_front_0", "skirt_back_0", "left_hood",
    "right_hood", "skirt_panel_7", "skirt_panel_8", "pant_l_cuff_skirt_f", "pant_l_cuff_skirt_b",
    "pant_r_cuff_skirt_b", "pant_r_cuff_skirt_f", "ins_skirt_front_3", "ins_skirt_back_3",
    "pant_l_cuff_f", "pant_l_cuff_b", "pant_r_cuff_f", "pant_r_cuff_b", "skirt_back_1",
    "skirt_front_1", "skirt_panel_9", "skirt_panel_10", "ins_skirt_back_4", "ins_skirt_front_4",
    "skirt_front_2", "skirt_back_2", "skirt_panel_11", "skirt_panel_12", "skirt_back_3",
    "skirt_front_3", "skirt_panel_13", "ins_skirt_front_5", "ins_skirt_back_5", "skirt_back_4",
    "skirt_front_4", "skirt_panel_14",
)
# fmt: on
"""The 75 panel names of GarmentCode; the position is the class id."""

OF_DRAFTS = re.compile(
    r"(left|right)_(btorso_strap|collar_fall_(front|back))|skirt_(pleat|under)_\d+_(front|back)"
)
"""Panels that drafts have and GarmentCode has no name for: straps of halters, collars that are turned down,
pleats. PatternMaker cannot write them."""

UNDER_FRONT = "skirt_under_0_front"
"""The lower one of two fronts of a skirt that overlap; under pleats there are others of that name."""

EDGE_LABELS: tuple[str, ...] = (
    "lower_interface",
    "left_armhole",
    "right_armhole",
    "left_collar",
    "right_collar",
    "strapless_top",
)
"""Attachment labels that GarmentCode puts on edges."""

_SIDES = (("left_", "right_"), ("_l_", "_r_"), ("_l ", "_r "))
_CLASS_ID = {name: k for k, name in enumerate(PANEL_NAMES)}
_ARM = re.compile(r"(^|_)(sl|sleeve|sleeves|arm|hand)(_|\d|$)|sleeve", re.IGNORECASE)
_LEG = re.compile(r"pant|skirt|trouser|leg|short|godet|(^|_)ins_|^bottom_panel", re.IGNORECASE)
_BODY = re.compile(r"torso|bodice|yoke|hood|collar|lapel|waist_?band|belt|(^|_)wb(_|\d|$)", re.IGNORECASE)
_NUMBER = re.compile(r"(\d+)")


@lru_cache(maxsize=4096)
def body_region(name: str, label: str = "") -> BodyRegion:
    """The part of the body a panel covers: its label where it has a known one, else judged by its name.

    Sleeve names are tried first, because cuffs such as ``sl_left_cuff_skirt_f`` also contain ``skirt``. A
    panel whose label and name say nothing counts as ``body``; `check.panel_regions` looks at its place too.
    """
    return said_region(name, label) or "body"


@lru_cache(maxsize=4096)
def said_region(name: str, label: str = "") -> BodyRegion | None:
    """The part of the body that a panel's label, or else its name, speaks of; None when neither does."""
    if label in ("body", "arm", "leg"):
        return label
    if _ARM.search(name):
        return "arm"
    if _LEG.search(name):
        return "leg"
    return "body" if _BODY.search(name) else None


def canonical_key(name: str) -> tuple[int, tuple[tuple[int, str], ...]]:
    """Sort key: known names by class id, unknown ones after them in natural order (``p2`` before ``p10``)."""
    natural = tuple((int(s), "") if s.isdigit() else (-1, s) for s in _NUMBER.split(name))
    return _CLASS_ID.get(name, len(PANEL_NAMES)), natural


def _twins() -> Iterator[tuple[int, int]]:
    for number, name in enumerate(PANEL_NAMES):
        padded = f"{name} "
        for left, right in _SIDES:
            other = padded.replace(left, right).strip()
            if other != name and other in PANEL_NAMES:
                yield number, PANEL_NAMES.index(other)


TWINS: dict[int, int] = {max(pair): min(pair) for pair in _twins()}
"""Class ids of panels and of those on the other side of the body, which are written before them."""

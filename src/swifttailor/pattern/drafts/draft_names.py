"""What the drafts are called and what they are, for who does not load the garments."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

DraftKind = Literal["top", "dress", "jumpsuit", "trousers", "skirt"]

DRAFT_KINDS: Mapping[str, DraftKind] = {
    "t-shirt": "top",
    "polo-shirt": "top",
    "tank-top": "top",
    "camisole": "top",
    "bandeau": "top",
    "bustier": "top",
    "halter-top": "top",
    "off-shoulder-top": "top",
    "turtleneck": "top",
    "wrap-top": "top",
    "blazer": "top",
    "waistcoat": "top",
    "hoodie": "top",
    "fitted-dress": "dress",
    "shirt-dress": "dress",
    "wrap-dress": "dress",
    "slip-dress": "dress",
    "strapless-dress": "dress",
    "halter-dress": "dress",
    "off-shoulder-dress": "dress",
    "swing-dress": "dress",
    "kaftan": "dress",
    "robe": "dress",
    "jumpsuit": "jumpsuit",
    "trousers": "trousers",
    "jeans": "trousers",
    "leggings": "trousers",
    "fitted-skirt": "skirt",
    "wrap-skirt": "skirt",
    "sarong": "skirt",
    "circle-skirt": "skirt",
    "gathered-skirt": "skirt",
    "pleated-skirt": "skirt",
}
"""What each is measured to be."""
DRAFT_NAMES = tuple(DRAFT_KINDS)
DRAFTS_SHOW: Mapping[str, tuple[str, ...]] = {
    "pleated-skirt": ("pleats",),
    "strapless-dress": ("sweetheart",),
    "bustier": ("sweetheart",),
    "polo-shirt": ("shirt_collar", "flat_collar"),
    "halter-top": ("halter",),
    "halter-dress": ("halter",),
    "off-shoulder-top": ("off_shoulder",),
    "off-shoulder-dress": ("off_shoulder",),
}
"""What a draft shows that no way to cut makes: keys of the lexicon's ``cannot.txt``."""
DRAFTS_ARE: Mapping[str, tuple[tuple[str, str], ...]] = {
    "halter-top": (("back_depth", "open"), ("back_depth", "low"), ("straps", "narrow")),
    "halter-dress": (("back_depth", "open"), ("back_depth", "low"), ("straps", "narrow")),
}
"""Claims that are true of a draft to the eye, though not as they are measured between two shoulders."""
_CROSSED = "Its fronts do not overlap: a seam runs where the edge of the upper one would lie."
_OPEN = "Its front is open below where the edges of a wound skirt would part; nothing overlaps."
STANDS_IN: Mapping[str, str] = {
    "wrap-dress": _CROSSED,
    "wrap-top": _CROSSED,
    "wrap-skirt": _OPEN,
    "sarong": _OPEN,
}
"""What a draft has in place of what cannot be made, for people."""

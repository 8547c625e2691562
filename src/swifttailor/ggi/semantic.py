"""The semantic image (paper, Alg. 2): what kind of panel each pixel belongs to."""

from __future__ import annotations

import re
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from swifttailor.ggi.layout import Layout
from swifttailor.pattern.names import PANEL_NAMES, body_region

EMPTY = 0
_REGION_TYPES = {"body": len(PANEL_NAMES) + 1, "arm": len(PANEL_NAMES) + 2, "leg": len(PANEL_NAMES) + 3}
PANEL_TYPES: tuple[str, ...] = ("", *PANEL_NAMES, "other_body", "other_arm", "other_leg")
"""Name of each panel type; the position is its id in the semantic image."""

_TYPE_ID = {name: k for k, name in enumerate(PANEL_TYPES)}
_NUMBERED = re.compile(r"^(.*_)(\d+)$")


@lru_cache(maxsize=4096)
def panel_type(name: str, label: str = "") -> int:
    """The type id of a panel, 1 to 78.

    GarmentCode's names have a type each, in the order of `PANEL_NAMES`. Any other name is mapped by rule: one
    that differs from a known name in upper and lower case alone is that name; a number beyond those that
    GarmentCode uses (``skirt_panel_20``) counts as the last of its family; and what is left is
    ``other_body``, ``other_arm`` or ``other_leg``, by its label or else by its words (`body_region`).
    """
    known = _TYPE_ID.get(name) or _TYPE_ID.get(name.lower())
    if known:
        return known
    numbered = _NUMBERED.match(name.lower())
    if numbered:
        family = [t for t in PANEL_NAMES if re.fullmatch(re.escape(numbered[1]) + r"\d+", t)]
        if family:
            return _TYPE_ID[max(family, key=lambda t: int(t.rsplit("_", 1)[1]))]
    return _REGION_TYPES[body_region(name, label)]


def semantic_image(layout: Layout) -> NDArray[np.uint8]:
    """(N, N) panel type ids, 0 where there is no panel."""
    types = np.array([panel_type(p.name, p.label) for p in layout.pattern.panels] + [EMPTY], np.uint8)
    return types[layout.raster.panel]

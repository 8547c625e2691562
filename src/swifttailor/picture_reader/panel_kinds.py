"""Kinds of panels that a picture can tell apart, a cell at a time."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from swifttailor.pattern.names import PANEL_NAMES

_BEGINNINGS: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("front bodice", ("left_ftorso", "right_ftorso")),
    ("back bodice", ("left_btorso", "right_btorso")),
    ("sleeve", ("left_sleeve", "right_sleeve")),
    ("cuff flounce", ("sl_left_cuff_skirt", "sl_right_cuff_skirt")),
    ("cuff", ("sl_left_cuff", "sl_right_cuff")),
    ("collar", ("left_collar", "right_collar")),
    ("hood", ("left_hood", "right_hood")),
    ("waistband", ("wb_",)),
    ("inset", ("ins_skirt",)),
    ("gore", ("skirt_panel_",)),
    ("tier", tuple(f"skirt_{side}_{k}" for side in ("front", "back") for k in range(5))),
    ("skirt", ("skirt_",)),
    ("leg cuff flounce", ("pant_l_cuff_skirt", "pant_r_cuff_skirt")),
    ("leg cuff", ("pant_l_cuff", "pant_r_cuff")),
    ("leg", ("pant_",)),
)
PANEL_KINDS: tuple[str, ...] = tuple(kind for kind, _ in _BEGINNINGS)
"""What pieces of cloth are for."""


@cache
def kinds_of_panels() -> NDArray[np.uint8]:
    """(P,) number of `PANEL_KINDS` of each of `PANEL_NAMES`."""
    found = [
        next(k for k, (_, starts) in enumerate(_BEGINNINGS) if name.startswith(starts))
        for name in PANEL_NAMES
    ]
    return np.array(found, np.uint8)

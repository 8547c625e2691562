"""The colours in which people see the panel types of a semantic image (paper, Alg. 2)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import InputError
from swifttailor.ggi.semantic import PANEL_TYPES

# fmt: off
_HEX = (
    "000000", "f428f4", "28f428", "f42828", "70f4f4", "f4d058", "4088f4", "f4a0b8", "287028", "2840f4",
    "702870", "885828", "287088", "f42894", "28f4a0", "f4e8c4", "e888f4", "88c434", "ac2840", "f48834",
    "acc4f4", "704c58", "7cac88", "e8f428", "8828b8", "344c34", "888828", "b8f4a0", "28407c", "e8a07c",
    "a07cb8", "aca0a0", "3440ac", "28b8dc", "c45894", "28d04c", "f47064", "d034b8", "28ac70", "a028f4",
    "a0f428", "f42858", "9470f4", "34a0e8", "c4e8e8", "702828", "a09464", "7cf4c4", "b86464", "dcf470",
    "7cac58", "d0d07c", "f46488", "282840", "287c70", "b85828", "e8b8f4", "c49440", "f4dcf4", "586428",
    "34a034", "28b8ac", "883458", "a058b8", "584028", "7c88ac", "94f47c", "707064", "d058f4", "6464b8",
    "ac94f4", "2858e8", "f4ac28", "ac7c94", "c43428", "7cacb8", "f4c4b8", "acb840", "f46434",
)
# fmt: on
"""sRGB of each type id. Each was chosen as far from those before it as possible in CIELAB; the nearest two
are 20 apart, where 2.3 can just be told apart. Pictures are read by them: they do not change."""

PANEL_COLORS: NDArray[np.uint8] = np.frombuffer(bytes.fromhex("".join(_HEX)), np.uint8).reshape(-1, 3)
"""(79, 3) sRGB of each type id; 0, no panel, is black."""


def color_types(types: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Colours (..., 3) of type ids (...)."""
    return PANEL_COLORS[types]


def types_of_colors(colors: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Type ids (...) of colours (..., 3): the inverse of `color_types`.

    Raises:
        InputError: A colour is not in the map.
    """
    code = np.asarray(colors, np.int64) @ [65536, 256, 1]
    known = PANEL_COLORS.astype(np.int64) @ [65536, 256, 1]
    order = np.argsort(known)
    types = order[np.clip(np.searchsorted(known[order], code), 0, len(known) - 1)]
    unknown = known[types] != code
    if unknown.any():
        first = np.asarray(colors)[unknown][0]
        raise InputError(
            f"The colour #{bytes(first.tolist()).hex()} belongs to no panel type ({int(unknown.sum())} "
            f"pixels have such colours). A semantic image has the {len(PANEL_TYPES)} colours of docs/ggi.md, "
            "without blending or compression."
        )
    return types.astype(np.uint8)

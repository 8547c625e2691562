"""Which colour a garment has in previews and files: one of a few, chosen by how it is built."""

from __future__ import annotations

import zlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from swifttailor.pattern import Pattern

PALETTE = (
    "#527788",  # petrol
    "#a2614c",  # terracotta
    "#747c5c",  # olive
    "#b8965a",  # ochre
    "#7c566b",  # plum
    "#62709a",  # cornflower
    "#4b6a5e",  # bottle green
    "#b07a82",  # rosewood
    "#4a5266",  # ink
)
"""sRGB; each can be told from the mannequin and its backdrop."""


def cloth_color(pattern: Pattern) -> str:
    """The colour of a garment's right side, ``#rrggbb``.

    It depends on the panels and the kinds of their edges, not on lengths. So the same pattern always has the
    same colour, different garments mostly have different ones, and a garment that is only made longer keeps
    its own.

    Args:
        pattern: What the garment is sewn from.
    """
    built = sorted(
        f"{panel.name} {' '.join(type(edge.curve).__name__ for edge in panel.edges)}"
        for panel in pattern.panels
    )
    return PALETTE[zlib.crc32("\n".join(built).encode()) % len(PALETTE)]

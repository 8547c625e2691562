"""Which colour a garment has in previews and files: one of a few, chosen by how it is built.

An edited garment keeps the colour of the garment that it was made from, and its report states it.
"""

from __future__ import annotations

import re
import zlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from swifttailor.pattern import Pattern

PALETTE = (
    "#527788",  # petrol
    "#5c7c9c",  # denim
    "#76836b",  # sage
    "#8a8f98",  # dove
    "#5d6480",  # dusk
    "#62709a",  # cornflower
    "#4b6a5e",  # bottle green
    "#7c8fa6",  # cloud
    "#4a5266",  # ink
)
"""sRGB; each can be told from the mannequin and its backdrop."""
COLOR = "color"
"""What a report calls it."""


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


def stated_color(report: Mapping[str, Any]) -> str | None:
    """The colour that the report of an edited garment states; None of a garment in its pattern's own."""
    color = report.get(COLOR)
    return color if isinstance(color, str) and re.fullmatch("#[0-9a-f]{6}", color) else None

"""The ribs of knitted cloth and corduroy, which are seen where nothing is printed on it."""

from __future__ import annotations

import re

from swifttailor.garment.cloth_print import ClothPrint
from swifttailor.wording.lexicon import WordReading

RIBBED = ("knit", "nap")
"""Keys of what cloth cannot have by itself, and ribs stand for."""
_CHUNKY = re.compile(
    r"(?<!\w)(?:chunky|cable|aran|thick|heavy|grob\w*|dick\w*|grosse? maille)(?!\w)", re.IGNORECASE
)
_CORDS = re.compile(
    r"(?<!\w)(?:cord|cords|corduroy\w*|needlecord|jumbo cord|cord\w*|velours côtelé|pana)(?!\w)",
    re.IGNORECASE,
)
_PART = re.compile(
    r"(?:collar|cuff|hem|neck|waist|band|trim|edge|welt|bündchen|kragen|col|poignet)", re.IGNORECASE
)
"""What is ribbed alone, where it stands behind the word."""
_FINE, _COARSE, _CORD = (0.9, 0.6), (1.3, 0.9), (1.5, 0.9)
"""Widths of ribs and of what lies between them, cm."""
_SHADE, _SHADE_OF_DARK, _DARK = 0.72, 0.5, 90
"""How light the hollows between ribs are beside them, and beside dark ones; which count as dark, 0 to 255."""


def ribs(words: WordReading) -> tuple[float, float] | None:
    """Widths of the ribs, and of what lies between them, of cloth that has any, cm.

    Args:
        words: Of a text, by the lexicon.

    Returns:
        None where words name no such cloth.
    """
    marks = [
        mark
        for k, mark in enumerate(words.marks)
        if not mark.denied and not any(_PART.match(near.word) for near in words.marks[k + 1 : k + 2])
    ]
    lacking = {what for mark in marks for entry in mark.entries for what in entry.cannot}
    said = " ".join(mark.word for mark in marks)
    if "nap" in lacking and _CORDS.search(said):
        return _CORD
    if "knit" not in lacking:
        return None
    return _COARSE if _CHUNKY.search(said) else _FINE


def ribbed(color: str, widths: tuple[float, float]) -> ClothPrint:
    """Ribs down the cloth.

    Args:
        color: ``#rrggbb``.
        widths: See `ribs`.
    """
    parts = [int(color[k : k + 2], 16) for k in (1, 3, 5)]
    shade = _SHADE if max(parts) > _DARK else _SHADE_OF_DARK
    hollow = "#" + "".join(f"{round(shade * part):02x}" for part in parts)
    return ClothPrint("stripes", (color, hollow), {"width": widths[0], "gap": widths[1], "angle": 90.0})

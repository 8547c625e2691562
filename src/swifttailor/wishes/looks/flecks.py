"""The flecks of tweed, which are seen where nothing is printed on it."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.garment.cloth_print import ClothPrint
from swifttailor.wording.lexicon import WordReading

_FLECKED = ("tweed", "donegal", "homespun")
"""Words that such cloth is named by."""
_SIDE_CM = 0.9
_LIGHTER, _DARKER = 1.3, 0.68
"""How light the threads are beside the colour of the whole."""


def is_flecked(words: WordReading) -> bool:
    """Whether a text names such cloth."""
    said = " ".join(mark.word.lower() for mark in words.marks if not mark.denied)
    return any(word in said for word in _FLECKED)


def flecked(color: str) -> ClothPrint:
    """Threads of two shades that cross.

    Args:
        color: Of the whole, ``#rrggbb``.
    """
    parts = [int(color[k : k + 2], 16) for k in (1, 3, 5)]
    dark, light = (_shaded(parts, share) for share in (_DARKER, _LIGHTER))
    return ClothPrint("checks", (dark, light), {"width": _SIDE_CM, "angle": 45.0})


def _shaded(parts: Sequence[int], share: float) -> str:
    return "#" + "".join(f"{min(255, round(share * part)):02x}" for part in parts)

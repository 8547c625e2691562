"""Colours that a text names, as sRGB."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from swifttailor.wording.lexicon.entries import Entry

_WHITE, _BLACK, _GREY = (255, 255, 255), (0, 0, 0), (128, 128, 128)
_TOWARDS: dict[str, tuple[tuple[int, int, int], float]] = {
    "lighter": (_WHITE, 0.45),
    "darker": (_BLACK, 0.4),
    "duller": (_GREY, 0.35),
    "warmer": ((255, 140, 60), 0.15),
    "cooler": ((60, 120, 255), 0.15),
}
"""What a shade moves a colour to, and how far."""


class NamedColor(NamedTuple):
    """A colour that a text names."""

    words: str
    """As the text has them: "dusty pink"."""
    rgb: str
    """sRGB as ``rrggbb``."""


def named_colors(words: Sequence[tuple[str, Sequence[Entry]]]) -> tuple[NamedColor, ...]:
    """The colours among some words, shades before them taken in.

    Args:
        words: Of a text in their order, with their entries.
    """
    found = []
    for k, (word, entries) in enumerate(words):
        rgb = next((entry.color for entry in entries if entry.category == "colors" and entry.color), None)
        if rgb is None:
            continue
        shade = next((e.shade for e in words[k - 1][1] if e.shade is not None), None) if k else None
        if shade is None:
            found.append(NamedColor(word, rgb))
        else:
            found.append(NamedColor(f"{words[k - 1][0]} {word}", shaded(rgb, shade)))
    return tuple(found)


def shaded(rgb: str, shade: str) -> str:
    """A colour made lighter, darker, brighter, duller, warmer or cooler; as it is for other shades.

    Args:
        rgb: sRGB as ``rrggbb``.
        shade: As the tables name it.
    """
    parts = [int(rgb[k : k + 2], 16) for k in (0, 2, 4)]
    if shade == "brighter":
        middle = sum(parts) / 3
        moved = [part + 0.4 * (part - middle) for part in parts]
    elif shade in _TOWARDS:
        end, share = _TOWARDS[shade]
        moved = [part + share * (aim - part) for part, aim in zip(parts, end, strict=True)]
    else:
        return rgb
    return "".join([f"{min(255, max(0, round(part))):02x}" for part in moved])

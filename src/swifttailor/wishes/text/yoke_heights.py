"""How high the yoke of a skirt is told to be: "yoke 12 cm deep", "a 4 inch yoke"."""

from __future__ import annotations

import re
from collections.abc import Mapping

_LEAST_CM, _MOST_CM = 7.0, 20.0
_NUMBER = r"(?P<{0}number>\d+(?:[.,]\d+)?) ?(?P<{0}unit>cm|centimet(?:er|re)s?|mm|inch(?:es)?|in\b|\")"
_BEHIND, _BEFORE = _NUMBER.format(""), _NUMBER.format("b_")
_HEIGHT = re.compile(
    rf"\byoke(?: (?:of|is|should|be|about|around|some|a|the|hip|depth|height|deep|high))*[,:]? {_BEHIND}"
    rf"|{_BEFORE}(?:[- ](?:deep|high|wide|hip|shaped|fitted|smooth))* yoke\b",
    re.IGNORECASE,
)
_IN_CM: Mapping[str, float] = {"mm": 0.1, "i": 2.54, '"': 2.54, "c": 1.0}


def told_yoke_cm(text: str) -> float | None:
    """How high a yoke is told to be, within what can be cut, cm; None where no figure says it."""
    found = _HEIGHT.search(text)
    if found is None:
        return None
    part = "" if found["number"] else "b_"
    unit = found[f"{part}unit"].lower()
    factor = next(value for name, value in _IN_CM.items() if unit.startswith(name))
    return min(max(factor * float(found[f"{part}number"].replace(",", ".")), _LEAST_CM), _MOST_CM)


def yoke_figures(text: str) -> tuple[tuple[int, int], ...]:
    """Where figures stand that tell how high a yoke is: start and end of each."""
    return tuple([found.span() for found in _HEIGHT.finditer(text)])

"""Legs of wearers: who asks for trousers that would drag on the usual body's feet has longer ones."""

from __future__ import annotations

import re

from swifttailor.inches import CM_PER_INCH
from swifttailor.wishes.wearers.body_said import SaidBody, number

_INCHES_BELOW = 45.0
"""No inseam of an adult is so small in cm."""
_INSEAM = re.compile(
    r"(?<![\w.])(?:(?P<before>\d{2,3}(?:[.,]\d)?)[\s-]*(?P<unit>cm|inch(?:es)?|in|[\"”″]|'')?[\s-]*"
    r"(?:inseam|inside[- ]leg|inner[- ]leg)"
    r"|(?:inseam|inside[- ]leg|inner[- ]leg|innenbeinlänge)(?:\s+length)?\s*(?:of|is|:|=)?\s*"
    r"(?P<after>\d{2,3}(?:[.,]\d)?)\s*(?P<unit2>cm|inch(?:es)?|in\b|[\"”″]|'')?)",
    re.IGNORECASE,
)
_DRAGS = re.compile(r"(?<!\w)(?:drag|puddl|pool|trail|stack)\w*", re.IGNORECASE)
_SHARE, _TO_FLOOR_CM = (0.44, 0.5), 2.0
"""Inseams beyond this part of the height are for legs that are long for it, and how long these are at most;
how far above the floor trousers end that are asked for so long, cm."""
_LONG_LEGS_CM, _ABOVE_FLOOR_CM = (73.0, 100.0), 7.0
"""Inseams that the usual body is too short for; how far above the floor trousers end."""


def hear_legs(said: SaidBody) -> None:
    """Reads how long the legs are. The words stay: they are the length of the trousers as well.

    Args:
        said: What was read so far; nothing is added where a size says how long they are, or a height does and
            they are not longer.
    """
    match = _INSEAM.search(said.text)
    if match is None or said.size or _DRAGS.search(said.text):
        return
    value = number(match["before"] or match["after"])
    unit = (match["unit"] or match["unit2"] or "").lower()
    value *= 1.0 if unit == "cm" or (not unit and value >= _INCHES_BELOW) else CM_PER_INCH
    height = said.measures.get("height")
    if height is not None:  # of a tall person they may be longer yet
        if _SHARE[0] * height < value <= _LONG_LEGS_CM[1]:
            said.measures["inseam"] = round(min(value + _TO_FLOOR_CM, _SHARE[1] * height), 1)
    elif _LONG_LEGS_CM[0] < value <= _LONG_LEGS_CM[1]:
        said.measures["inseam"] = round(value + _ABOVE_FLOOR_CM, 1)

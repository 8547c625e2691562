"""The colour of a garment of which a text tells none but those of parts: of its body, or of what has none."""

from __future__ import annotations

from collections.abc import Iterable

from swifttailor.garment.part_looks import PARTS
from swifttailor.wording.lexicon import WordReading
from swifttailor.wording.lexicon.said_look import SaidLook

_BETWEEN = frozenset({"sizes", "fabrics", "fits"})
"""What may stand between a garment's name and its colour."""


def color_of_body(looks: Iterable[SaidLook]) -> str | None:
    """The body's, ``rrggbb``: collar, cuffs and bands are of it, too; None where not both are told."""
    told = {look.part: look.color.rgb for look in looks if look.said and look.color is not None}
    return told.get("bodice") if "sleeves" in told else None


def color_behind_name(words: WordReading) -> str | None:
    """The colour right behind the name of a garment, ``rrggbb``, where what follows has none of its own.

    "Trousers navy elasticated waist" are navy: nobody asks for a waist of another colour so.
    """
    for look in words.looks:
        if not look.said or look.color is None or not look.part or look.part in PARTS:
            continue
        before = [mark for mark in words.marks if mark.end <= look.marks[0].start]
        while before and before[-1].entries and before[-1].entries[0].category in _BETWEEN:
            before.pop()
        if before and before[-1].entries and before[-1].entries[0].category == "garments":
            return look.color.rgb
    return None

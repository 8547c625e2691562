"""The colour of both garments of a set, where a text names none: a suit is of one cloth."""

from __future__ import annotations

import zlib
from typing import TYPE_CHECKING

from swifttailor.garment.cloth_color import PALETTE
from swifttailor.wishes.heard import Heard
from swifttailor.wording.lexicon import read_words

if TYPE_CHECKING:
    from swifttailor.wishes.outfits.two_garments import TwoGarments


def color_of_set(outfit: TwoGarments | None) -> str | None:
    """The colour that goes with one of the names, else one of the usual ones, ``#rrggbb``.

    Args:
        outfit: Two garments; None where there is one.

    Returns:
        None where they are no set, or one of them has a colour or a print of its own.
    """
    if outfit is None or not outfit.alike:
        return None
    pieces = [Heard(text, words=read_words(text)) for text in (outfit.upper, outfit.lower)]
    if any(piece.says_color for piece in pieces):
        return None
    usual = next((piece.color for piece in pieces if piece.color is not None), None)
    besides = next((piece.color_besides for piece in pieces if piece.color_besides is not None), None)
    return usual or besides or PALETTE[zlib.crc32(outfit.upper.encode()) % len(PALETTE)]

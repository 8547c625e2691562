"""Blocks of two colours: the first that a text names is the garment's, the second that of its blocks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from swifttailor.wording.lexicon.colors import NamedColor
from swifttailor.wording.lexicon.look_words import category_of, is_look

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.reading import WordMark
    from swifttailor.wording.lexicon.said_look import SaidLook

BLOCKS = "blocks"
"""The part of a garment that is in a second colour, wherever that may be."""


def blocks_named(marks: Sequence[WordMark]) -> WordMark | None:
    """The word for blocks of colour, where a text asks for them on cloth without a print."""
    if any(e.print is not None and e.print.kind != "plain" for m in marks if not m.denied for e in m.entries):
        return None
    wanted = [m for m in marks if not m.denied and any(e.part == BLOCKS for e in m.entries)]
    return wanted[0] if wanted else None


def own_colors(
    marks: Sequence[WordMark], found: Sequence[SaidLook], colors: Sequence[NamedColor | None]
) -> list[int]:
    """The places of the colours that are said of no part but the blocks.

    Args:
        marks: Words of the text.
        found: What is said of parts.
        colors: The colour that each word names.
    """
    apart = {id(mark) for look in found if look.part not in ("", BLOCKS) for mark in look.marks}
    return [
        k
        for k, mark in enumerate(marks)
        if category_of(mark) == "colors"
        and is_look(mark)
        and not mark.denied
        and mark.role != "theirs"
        and id(mark) not in apart
        and colors[k] is not None
    ]


def second_color(
    marks: Sequence[WordMark], found: Sequence[SaidLook], colors: Sequence[NamedColor | None]
) -> int | None:
    """The place of the second colour that is said of no part but the blocks; None where there is none.

    Args:
        marks: Words of the text.
        found: What is said of parts.
        colors: The colour that each word names.
    """
    own = own_colors(marks, found, colors)
    return own[1] if len(own) > 1 else None

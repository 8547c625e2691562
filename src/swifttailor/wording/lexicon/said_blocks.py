"""Blocks of two colours: the first that a text names is the garment's, the second that of its blocks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from swifttailor.wording.lexicon.colors import NamedColor
from swifttailor.wording.lexicon.look_words import category_of, color_of_word, contrasting, is_look
from swifttailor.wording.lexicon.said_look import SaidLook

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.reading import WordMark

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


def with_blocks(found: list[SaidLook], marks: Sequence[WordMark]) -> list[SaidLook]:
    """The looks with a second colour on blocks, or on what is said to contrast.

    Where none is named it is another than the garment's.
    """
    blocks = blocks_named(marks)
    parts = [] if blocks is None else [(BLOCKS, blocks)]
    parts += [(str(of), mark) for mark in marks if not mark.denied and (of := contrasting(mark)) is not None]
    told = [look for look in found if look.cloth == "contrast" and look.color is None]
    parts += [(look.part, mark) for look in told for mark in look.noun_marks]
    if not parts:
        return found
    colors = [color_of_word(marks, k) for k in range(len(marks))]
    second = second_color(marks, found, colors)
    if blocks is not None and len(own_colors(marks, found, colors)) > 2:
        return [look for look in found if blocks not in look.noun_marks]  # bands, as a print
    of_blocks = [look for look in found if blocks is not None and blocks in look.noun_marks]
    found = [look for look in found if look not in of_blocks]
    colored = {mark for look in found if look.color is not None for mark in look.noun_marks}
    if second is not None:
        shade = [marks[second - 1]] if second and any(e.shade for e in marks[second - 1].entries) else []
        color, of = color_of_word(marks, second), (*shade, marks[second])
        new = [SaidLook(part, m.word, color, None, True, of, (m,)) for part, m in parts if m not in colored]
        return [*[look for look in found if look not in told], *new]
    if blocks is None or colored:  # "two tone, with cream sleeves"
        return found
    return [*found, SaidLook(BLOCKS, blocks.word, None, "contrast", True, (), (blocks,))]

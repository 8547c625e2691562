"""What words about the looks of parts tell besides: the nouns they are about, and that sleeves are sheer."""

from __future__ import annotations

from swifttailor.garment.part_looks import OPACITIES
from swifttailor.wishes.looks.printed_parts import printed_parts
from swifttailor.wording.lexicon import WordReading


def spans_of_looks(text: str, words: WordReading) -> list[tuple[int, int]]:
    """Where nouns stand whose looks are said: whether the garment has them is seen when it is made."""
    marks = [mark for look in words.looks for mark in look.noun_marks if look.said]
    marks += printed_parts(text, words).nouns
    return [(mark.start, mark.end) for mark in marks if mark.role == "word"]


def has_sheer_sleeves(words: WordReading) -> bool:
    """Whether sleeves are of a cloth that is seen through, which usually go down to the wrist."""
    return any(look.part == "sleeves" and look.cloth in OPACITIES for look in words.looks)

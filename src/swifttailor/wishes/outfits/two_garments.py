"""Wishes for two garments that are worn together, each put into a text of its own.

"A white blouse and a black skirt" is a blouse and a skirt; a navy trouser suit is a navy blazer and navy
trousers; a cardigan over a top is both, one worn over the other. A dress with a wide skirt is one garment.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from swifttailor.wishes.descriptions.sayings_of_wishes import without_asides
from swifttailor.wishes.outfits.aprons import with_apron_put_on
from swifttailor.wishes.outfits.first_piece import first_piece
from swifttailor.wishes.outfits.hooded_outfits import with_hooded_top
from swifttailor.wishes.outfits.named_again import told_behind_names
from swifttailor.wishes.outfits.names_among_words import in_english
from swifttailor.wishes.outfits.one_cloth import is_a_mood
from swifttailor.wishes.outfits.outfit_chunks import Chunk, bare, chunks_of
from swifttailor.wishes.outfits.outfit_halves import HALVES, Half, half_named
from swifttailor.wishes.outfits.outfit_pieces import Pieces, are_asked_for, joined_up, names_of, pieces_of
from swifttailor.wishes.outfits.parted_text import LayeredText, PartedText
from swifttailor.wishes.outfits.side_remarks import without_side_remarks
from swifttailor.wishes.outfits.suits_of_two_colors import parted_by_color
from swifttailor.wishes.outfits.worn_over import layered_pieces, said_plainly, without_places
from swifttailor.wishes.text.complaints import without_complaints
from swifttailor.wishes.text.one_half import of_one_half
from swifttailor.wishes.text.text_as_read import text_as_read
from swifttailor.wishes.wearers.wearer_words import hear_wearer
from swifttailor.wording.lexicon import WordMark, WordReading, read_words

_PLUS = re.compile(r"(?<=[^\W\d_])(?:\s*[&+]\s*|\s+w/\s*|\s+['’]?n['’]?\s+)(?=[^\W\d_])")
_SUIT_OF = re.compile(r"(?<!\w)(suits?|sets?)\s*(?::|=|[-–—](?=\s))\s*", re.IGNORECASE)
"""What would be read with the word behind it: the jacket of "suit: jacket and trousers" is no suit jacket."""
_A_SET = re.compile(r"(?<!\w)(?:outfit|suit|set|ensemble|costume|uniform)(?!\w)", re.IGNORECASE)
"""What names two garments and may be put more plainly for one."""


@dataclass(frozen=True, slots=True)
class TwoGarments:
    """What is said of each."""

    upper: str
    lower: str
    third: str = ""
    """What is said of one worn with both: the waistcoat of a suit; empty where there is none."""
    third_alike: bool = False
    """Whether that is of their cloth and colour."""
    besides: tuple[str, ...] = ()
    """Names of further garments, of which nothing is said in any, and none is made."""
    layered: bool = False
    """Whether one is worn over the other: ``upper`` is what is on top, ``lower`` what is beneath."""
    alike: bool = False
    """Whether both are of one cloth and colour, as those of a suit are."""
    guessed: bool = False
    """Whether no garment is named: they are what is worn in a mood, or for an occasion."""

    def of(self, half: Half) -> str:
        """What is said of the garment on a half of the body."""
        return self.upper if half == "upper" else self.lower


@lru_cache(maxsize=64)
def two_garments(text: str) -> TwoGarments | None:
    """The garments for the upper and the lower body that a description asks for; None where it asks for one.

    What it says of who wears them is in neither text (`hear_wearer`).

    Args:
        text: In any language that is read.
    """
    own = of_one_half(without_complaints(text))
    plain = without_asides(own)  # "something sleeveless with a jacket" is a dress with one
    found = _two_garments(plain)
    return _two_garments(own) if found is None and plain != own and _A_SET.search(own) else found


def _two_garments(text: str) -> TwoGarments | None:
    text = said_plainly(told_behind_names(first_piece(text)))
    text = _PLUS.sub(lambda found: " with " if "w" in found[0] else " and ", text)
    text = _SUIT_OF.sub(r"\1, ", with_hooded_top(with_apron_put_on(text)))
    text = joined_up(text, read_words(text))
    text = parted_by_color(text, read_words(text))
    words = read_words(text)
    if _pieces(text, words) is None:
        if not words.unknown:
            return None
        text, words = text_as_read(text)  # a name may be misspelt
        if _pieces(text, words) is None:
            return None
    text = without_side_remarks(hear_wearer(text).rest)
    return _parted(text, read_words(text))


def _pieces(text: str, words: WordReading) -> Pieces | None:
    return pieces_of(text, words) or layered_pieces(text, words, _chunks_of_layers(text, words))


def _chunks_of_layers(text: str, words: WordReading) -> list[Chunk]:
    return chunks_of(text, words, lambda marks: sum(map(_is_garment, marks)) > 1)


def _parted(text: str, words: WordReading) -> TwoGarments | None:
    pieces = pieces_of(text, words)
    if pieces is not None and pieces.besides and (plain := without_places(text)) != text:
        return _parted(plain, read_words(plain))  # where a third is worn is no detail of it
    if pieces is None:
        chunks = _chunks_of_layers(text, words)
        pieces = layered_pieces(text, words, chunks)
    else:
        chunks = chunks_of(text, words, lambda marks: _name_both(marks, pieces))
    if pieces is None or not are_asked_for(text, pieces, chunks):
        return None
    layered = pieces.layered or (pieces.is_one_name and _is_for_one_half(pieces))
    wish = (LayeredText if layered else PartedText)(text, words, pieces, chunks)
    said = [in_english(bare(wish.said_of(half), words.language), words.language) for half in HALVES]
    third = wish.third()
    besides = [mark.word for mark in pieces.besides if third is None or mark is not third.mark]
    if layered:
        said = [bare(without_places(one), words.language) for one in said]
    more = ("", False) if third is None else (third.said, third.alike)
    guessed = pieces.is_one_name and is_a_mood(pieces.two["upper"].mark)
    found = TwoGarments(*said, *more, tuple(besides), layered, wish.is_set, guessed)
    are_one = _names_one if layered else _is_one
    return found if all(are_one(found.of(half), half) for half in HALVES) else None


def _is_for_one_half(pieces: Pieces) -> bool:
    """Whether what a name of two stands for is worn one over the other, as a twinset is."""
    names = [piece.name or "" for piece in pieces.two.values()]
    return len({half for name in names for _, half in names_of(read_words(name)) or ()}) == 1


def _name_both(marks: Sequence[WordMark], pieces: Pieces) -> bool:
    halves = {half for mark, half in pieces.named if mark in marks}
    halves |= {half for half, piece in pieces.two.items() if piece.mark in marks and not pieces.is_one_name}
    named = [mark for mark in pieces.besides if mark in marks]
    return len(halves) > 1 or (bool(halves) and bool(named))


def _is_one(text: str, half: Half) -> bool:
    """Whether a text names garments of that half alone."""
    words = read_words(text)
    names = names_of(words)
    if names:
        return {name for _, name in names} == {half}
    named = [mark for mark in words.marks if mark.role == "garment"]
    return names is not None and any(half_named(mark) == half for mark in named)


def _names_one(text: str, half: Half) -> bool:
    """Whether a text names one garment, of whatever half."""
    del half
    marks = [m for m in read_words(text).marks if not m.denied]
    other = any(m.role == "second" for m in marks)
    return not other and len({m.word.lower() for m in marks if m.role == "garment"}) == 1


def _is_garment(mark: WordMark) -> bool:
    return bool(mark.entries) and mark.entries[0].category == "garments"

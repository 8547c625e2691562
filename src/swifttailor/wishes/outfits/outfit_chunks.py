"""Texts in chunks, each of which is about one of two garments: "a blouse", "with sleeves", "and a skirt"."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache

from swifttailor.wording.lexicon import WordMark, WordReading
from swifttailor.wording.lexicon.inflection import Language

_JOINERS: dict[Language, str] = {
    "en": "and|with|over|under|plus|while|but|both|all in|everything in|also|then",
    "de": "und|mit|über|unter|sowie|dazu|beides?",
    "fr": "et|avec|sur|sous|les deux",
    "es": "y|e|con|sobre|ambos|ambas",
    "it": "e|ed|con|sopra",
    "nl": "en|met|over",
    "pt": "e|com|sobre",
}
_ADJECTIVE_ENDS = ("ed", "less", "y", "ing", "al", "e")
"""Of words for details that stand before what they are said of: pleated, floaty, flowing."""
_IN_ING = ("piping", "edging", "binding", "braiding", "lacing", "smocking", "ruching")
"""Endings of things that would be taken for such."""
_ADDS = re.compile(
    r"(?<!\w)(?:over|under|with|plus|then|also)(?!\w)|[,;]\s*(?:and|und|et|y)(?!\w)", re.IGNORECASE
)
"""What joins another garment or a detail, and no adjective to others."""
_SAID_OF_BOTH = re.compile(
    r"[\s,;:.(]*(?:and |und |et |y )?(?:both|all|everything|each|the (?:whole )?set|beides?|alles|les deux"
    r"|ambos|ambas|todo)(?!\w)",
    re.IGNORECASE,
)
_BESIDE = re.compile(r"(?<!\w)(?:over|under|über|unter|sur|sous|sobre|sopra)(?!\w)", re.IGNORECASE)
"""What adjectives do not go on behind: "knee length, over brown breeches"."""
LOOKS = frozenset({"colors", "prints", "fabrics", "shades"})
_ADJECTIVES = LOOKS | {"lengths", "fits", "styles", "degrees", "occasions"}
DETERMINERS = frozenset(
    "a an the one some another pair of ein eine einen einem einer eines der die das den dem une un des la le "
    "les una uno unos unas el los las uma um een".split()
)


@dataclass(frozen=True, slots=True)
class Chunk:
    """A piece of a text, with the comma or the word that joins it to what stands before."""

    start: int
    end: int
    joined: bool
    """Whether something joins it: of the first nothing does."""
    marks: tuple[WordMark, ...]
    """Its words, without the one that joins it."""

    def has(self, mark: WordMark) -> bool:
        """Whether it holds a word."""
        return self.start <= mark.start < self.end


def chunks_of(text: str, words: WordReading, apart: Callable[[Sequence[WordMark]], bool]) -> list[Chunk]:
    """The chunks of a text, in its order.

    Args:
        text: That was read.
        words: Of it.
        apart: Whether some words are about two garments, and so in no one chunk.
    """
    cuts = [
        found
        for found in _separator(words.language).finditer(text)
        if not any(mark.start < found.start(1) < mark.end for mark in words.marks)
    ]
    starts = [(0, 0), *[(found.start(), found.end()) for found in cuts if found.start() > 0]]
    ends = [*[start for start, _ in starts[1:]], len(text)]
    found: list[Chunk] = []
    for (start, begun), end in zip(starts, ends, strict=True):
        marks = tuple([mark for mark in words.marks if begun <= mark.start < end])
        if not marks and found:  # a joining word alone belongs to what it stands before or behind
            found[-1] = Chunk(found[-1].start, end, found[-1].joined, found[-1].marks)
            continue
        chunk = Chunk(start, end, start > 0, marks)
        between = text[start:begun]
        goes_on = found and not _BESIDE.search(between) and _goes_on(found[-1], chunk, between)
        if goes_on and not apart((*found[-1].marks, *marks)):
            found[-1] = Chunk(found[-1].start, end, found[-1].joined, (*found[-1].marks, *marks))
        else:
            found.append(chunk)
    return found


def is_of_both(text: str, chunk: Chunk) -> bool:
    """Whether a chunk says that it is about both garments: "both in navy"."""
    return _SAID_OF_BOTH.match(text, chunk.start, chunk.end) is not None


def bare(text: str, language: Language) -> str:
    """A text without words that join it to something before or behind."""
    text, before = " ".join(text.split()), ""
    while text != before:
        before = text
        text = _ends(language).sub("", text).strip(" ,;:.+&/|()-–—")
    return text


@lru_cache(maxsize=16)
def _separator(language: Language) -> re.Pattern[str]:
    words = "|".join(dict.fromkeys([_JOINERS["en"], _JOINERS[language]]))
    return re.compile(
        rf"((?:\s*(?:[;:!?\n()|+&]|[.,](?!\d)|(?<!\d)/|(?<=\s)[-–—](?=\s)|(?<!\w)w/"
        rf"|(?<![\w'’-])(?:{words})(?![\w'’-])))+)",
        re.IGNORECASE,
    )


@lru_cache(maxsize=16)
def _ends(language: Language) -> re.Pattern[str]:
    words = "|".join(dict.fromkeys([_JOINERS["en"], _JOINERS[language]]))
    tail = "to wear|worn|teamed|paired|along|together|to go|that goes|that go|going"
    return re.compile(rf"^(?:w/|(?:{words})(?![\w'’-]))|(?<![\w'’-])(?:{words}|{tail})$", re.IGNORECASE)


def _goes_on(before: Chunk, chunk: Chunk, joined: str) -> bool:
    """Whether adjectives of one noun stand on both sides of what joins them: "a long, pleated skirt"."""
    if not before.marks or not chunk.marks:
        return False
    last, first = before.marks[-1], chunk.marks[0]
    if _category(last) in LOOKS and _category(first) in LOOKS:
        return True
    if _ADDS.search(joined) is not None:  # "a tunic, knee length, over breeches"
        return False
    determined = before.joined or before.marks[0].word.lower() in DETERMINERS
    adjectives = all(
        _category(mark) in _ADJECTIVES or mark.word.lower() in DETERMINERS for mark in before.marks
    )
    return determined and adjectives and not any(map(_is_noun, before.marks)) and _may_follow(first)


def _is_noun(mark: WordMark) -> bool:
    """Whether it is a detail by itself: a bow, a V neck."""
    named = not mark.word.lower().endswith(_ADJECTIVE_ENDS) or mark.word.lower().endswith(_IN_ING)
    return _category(mark) == "styles" and named


def _may_follow(mark: WordMark) -> bool:
    return _category(mark) in (*_ADJECTIVES, "garments")


def _category(mark: WordMark) -> str | None:
    return mark.entries[0].category if mark.entries else None

"""Which words of a text name the two garments of an outfit, and whether these are asked for."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from swifttailor.wishes.outfits.outfit_chunks import DETERMINERS, LOOKS, Chunk
from swifttailor.wishes.outfits.outfit_halves import HALVES, Half, half_named
from swifttailor.wording.lexicon import WordMark, WordReading
from swifttailor.wording.lexicon.outfits import NamedOutfit, named_outfit
from swifttailor.wording.lexicon.tokens import words_of
from swifttailor.wording.lexicon.vocabulary import vocabulary

_MODIFIERS = frozenset(
    "colors shades prints fabrics lengths fits styles occasions sizes degrees polite numbers".split()
)
_FILLERS = DETERMINERS | frozenset(
    "also then maybe perhaps possibly please both matching two and with over under plus in i we want need "
    "would like id i'd to wear go it on underneath bit of kind sort really very quite "
    "dazu auch noch passend passende passender passendem passendes passenden "
    "assorti assortie assortis assorties aussi juego también".split()
)
"""Words between what joins a garment and its name."""
_OWN = frozenset("my her his their our your have has had own got bought like from or".split())
_PLACES = frozenset(
    "pocket pockets button buttons zip zips zipper stitching front fronts part parts bit bits section "
    "sections panel panels shape effect style styles look lining length half band bands "
    "layer layers".split()
)
"""What makes a name of it: a top pocket is no top."""
_OF_THE_CUT = ("garments", "parts", "styles", "lengths", "fits")
_ADJECTIVES_FIRST = ("en", "de", "nl")
_BESIDES = ("garment", "second", "like")
_ASIDE = ("theirs", "like")
_GOES_WELL = re.compile(r"(?<!\w)(?:good|well|nice|nicely|great|best|fine|lovely)\s*$", re.IGNORECASE)
"""Before what joins a garment: that the other is worn with it, as it may be there already."""
_ONE = re.compile(
    r"(?<!\w)(?:one[- ]pieces?|all[- ]in[- ]one|(?:two |2 )?in (?:one|1)(?! of)|attached|joined|combined"
    r"|with (?:an? )?(?:\w+ )?peplum skirt|built[- ]in|sewn (?:on|to|together)"
    r"|looks? like (?:a )?(?:two|2)|faux (?:two|2)"
    r"|only one (?:garment|piece|thing))(?!\w)",
    re.IGNORECASE,
)
"""What says that both are one garment."""


@dataclass(frozen=True, slots=True)
class Piece:
    """A garment of two."""

    mark: WordMark
    name: str | None
    """What stands for the word, where it names both; None where it names this garment."""


@dataclass(frozen=True, slots=True)
class Pieces:
    """The garments that a text names."""

    named: tuple[tuple[WordMark, Half], ...]
    """Single ones."""
    outfits: tuple[WordMark, ...]
    """Names of several at once."""
    two: dict[Half, Piece]
    """The one of each half; one word twice where it names both."""
    besides: tuple[WordMark, ...] = ()
    """Further garments, worn over or under one of the two: the waistcoat of a suit."""
    layered: bool = False
    """Whether one is worn over the other: ``upper`` is then what is on top."""

    @property
    def is_one_name(self) -> bool:
        """Whether one word names both."""
        return self.two["upper"].mark is self.two["lower"].mark


def names_of(words: WordReading) -> tuple[tuple[WordMark, Half], ...] | None:
    """The garments that are named, each with its half; None where one of them covers both halves."""
    found = []
    for k, mark in enumerate(words.marks):
        if mark.denied or _category(mark) != "garments":
            continue
        of_a_set = mark.role in ("part", "like") and any(map(_is_outfit, words.marks))
        if not of_a_set and mark.role not in ("garment", "second", "theirs"):
            continue
        if named_outfit(mark.word, mark.entries) is not None:
            continue
        if not is_alone(mark, words.marks[k:]):
            continue
        half = half_named(mark)
        if half is None and (of_a_set or mark.role == "theirs"):
            continue
        if half is None:
            return None
        found.append((mark, half))
    return tuple(found)


def pieces_of(text: str, words: WordReading) -> Pieces | None:
    """The two garments that a text names; None where it names one, or it is not clear which they are."""
    names = names_of(words)
    if names is None or is_in_one(text):
        return None
    sets = [m for m in words.marks if not m.denied and _is_several(m)]
    first: dict[Half, Piece] = {}
    for mark, half in names:
        first.setdefault(half, Piece(mark, None))
    if len(first) < len(HALVES):
        meant = [(m, o) for m in sets if (o := named_outfit(m.word, m.entries)) and m.role not in _ASIDE]
        if names or _says_more(words):  # a T-shirt of a film is no half of what is worn in it
            meant = [(mark, outfit) for mark, outfit in meant if _category(mark) != "occasions"]
        meant = [(mark, outfit) for mark, outfit in meant if _tells_most(mark, words)]
        if not meant:
            return None
        mark, outfit = meant[0]
        whole: dict[Half, Piece] = {"upper": Piece(mark, outfit.upper), "lower": Piece(mark, outfit.lower)}
        first = whole if _is_beside(outfit, names) else {**whole, **first}
    mine = [piece.mark for piece in first.values()]
    besides = [
        m
        for m in words.marks
        if _category(m) == "garments" and not m.denied and m not in (*mine, *sets)
        if m.role in _BESIDES or m in [mark for mark, _ in names]
    ]
    besides = [m for m in besides if half_named(m) is not None]
    return Pieces(names, tuple(sets), first, tuple(besides))


def _says_more(words: WordReading) -> bool:
    """Whether a text tells of the cut of what it wants, or what it does not want: then that is looked for."""
    return any(
        mark.denied or (_category(mark) in _OF_THE_CUT and mark.role != "astray") for mark in words.marks
    )


def _tells_most(mark: WordMark, words: WordReading) -> bool:
    """Whether a mood stands before every other one in its table: a barn dance on a weekend is a dance.

    So is what guests wear at weddings a dress in every mood.
    """
    if _category(mark) != "occasions":
        return True
    moods = [(m, e.place[1]) for m in words.marks for e in m.entries if e.worn and e.category == "occasions"]
    told = any(i.claim.name == "kind" for i in words.implications)
    return not told and mark is min(moods, key=lambda mood: mood[1])[0]


def is_in_one(text: str) -> bool:
    """Whether a text says that all it names is one garment."""
    return _ONE.search(text) is not None


def is_alone(mark: WordMark, marks: Sequence[WordMark]) -> bool:
    """Whether no word behind a garment's name makes a part of it: a jacket pocket is no jacket.

    Args:
        mark: The name.
        marks: Words of the text, it and what stands behind it among them.
    """
    k = marks.index(mark)
    after = marks[k + 1] if k + 1 < len(marks) else None
    return after is None or after.start - mark.end > 1 or not _makes_a_part(after)


def joined_up(text: str, words: WordReading) -> str:
    """A text of two garments with a comma between them, where none joins them: "white shirt black trousers".

    What stands between two names is of the second, in languages whose adjectives follow of the first.
    """
    names = [m for m in words.marks if _category(m) == "garments" and not m.denied and m.role in _BESIDES]
    if len(names) != len(HALVES) or {half_named(mark) for mark in names} != set(HALVES):
        return text
    before, behind = names
    between = [mark for mark in words.marks if before.end <= mark.start < behind.start]
    looks = [mark for mark in between if _category(mark) in LOOKS]
    if not (looks or looks_within(behind)) or any(_category(mark) not in _MODIFIERS for mark in between):
        return text
    if re.search(r"[^\w\s-]", text[before.end : behind.start]):
        return text
    cut = before.end if words.language in _ADJECTIVES_FIRST else behind.start
    return f"{text[:cut].rstrip()}, {text[cut:].lstrip()}"


def are_asked_for(text: str, pieces: Pieces, chunks: Sequence[Chunk]) -> bool:
    """Whether both garments are what is to be made: joined to each other, and nobody's already."""
    if pieces.is_one_name:
        return not _is_owned(pieces.two["upper"].mark, chunks)
    before, behind = sorted([one.mark for one in pieces.two.values()], key=lambda mark: mark.start)
    chunk = next(one for one in chunks if one.has(behind))
    if not chunk.joined or chunk.has(before) or "?" in text[chunk.start : behind.start]:
        return False
    if _GOES_WELL.search(text[: chunk.start]):
        return False
    return not _is_owned(before, chunks) and all(may_lead(mark) for mark in lead(behind, chunk))


def lead(mark: WordMark, chunk: Chunk) -> list[WordMark]:
    """The words of a chunk before one of them."""
    return [other for other in chunk.marks if other.start < mark.start]


def _is_owned(mark: WordMark, chunks: Sequence[Chunk]) -> bool:
    """Whether it is spoken of as somebody's: right before its adjectives stands "my" or "have a"."""
    before = lead(mark, next(one for one in chunks if one.has(mark)))
    while before and _category(before[-1]) in _MODIFIERS:
        before.pop()
    while before and before[-1].word.lower() in DETERMINERS:
        before.pop()
    if not before or _category(before[-1]) == "polite":  # "I'd like"
        return False
    return not _OWN.isdisjoint(before[-1].word.lower().split()[-1:])


def may_lead(mark: WordMark) -> bool:
    """Whether a word may stand between what joins a garment and its name: a look, a length, "matching"."""
    if mark.entries and mark.entries[0].category in _MODIFIERS:
        return not mark.denied
    words = mark.word.lower().replace("’", "'").split()
    return set(words) <= _FILLERS or (not mark.entries and _OWN.isdisjoint(words))


def looks_within(mark: WordMark) -> list[tuple[int, int]]:
    """The cloth that a name begins with: "linen shirt"."""
    first, _, rest = mark.word.partition(" ")
    senses = vocabulary("en").find(words_of(first.lower(), "en")) if rest else ()
    return [(mark.start, mark.start + len(first))] if any(s.entry.category in LOOKS for s in senses) else []


def _is_outfit(mark: WordMark) -> bool:
    return not mark.denied and mark.role not in _ASIDE and named_outfit(mark.word, mark.entries) is not None


def _is_several(mark: WordMark) -> bool:
    if named_outfit(mark.word, mark.entries) is not None:
        return True
    return any(e.category == "accessories" and "separate_pieces" in e.cannot for e in mark.entries)


def _is_beside(outfit: NamedOutfit, names: Sequence[tuple[WordMark, Half]]) -> bool:
    said = [mark.word.lower() for mark, _ in names]
    return all(word.removesuffix("s") in outfit.beside or word in outfit.beside for word in said)


def _makes_a_part(mark: WordMark) -> bool:
    return _category(mark) == "parts" or mark.word.lower() in _PLACES


def _category(mark: WordMark) -> str | None:
    return mark.entries[0].category if mark.entries else None

"""A text of two garments, and which of its words are about which."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from swifttailor.wishes.outfits.one_cloth import (
    CLOTHS,
    COLORS,
    LEGS_TOO,
    MATCHING,
    in_the_set,
    is_one_cloth,
    like_the_other,
    says,
    set_words,
)
from swifttailor.wishes.outfits.outfit_chunks import DETERMINERS, LOOKS, Chunk, bare, is_of_both
from swifttailor.wishes.outfits.outfit_halves import HALVES, Half, half_told, subjects
from swifttailor.wishes.outfits.outfit_pieces import Pieces, lead, looks_within, may_lead
from swifttailor.wording.lexicon import WordMark, WordReading, read_words
from swifttailor.wording.lexicon.outfits import named_outfit

_WAISTCOAT = "waistcoat"
_OF_ITS_DRESS = re.compile(r"(?:cape|capelet|bolero|shrug)$", re.IGNORECASE)
"""What a dress comes "with" is of its cloth, unless it has a colour of its own."""
_THREE = re.compile(r"(?:three|3)[- ]piece", re.IGNORECASE)
_BOTH = re.compile(r"(?<!\w)(?:both|beides?|les deux|ambos|ambas)(?!\w)", re.IGNORECASE)
_ADDED = re.compile(r"\s*(?:,|/|(?:and|plus|und|sowie|et|y|e|ed|en)(?!\w))", re.IGNORECASE)
_IN = re.compile(r"(?<!\w)(?:in|of|made|from|aus|en|de|con|em)(?!\w)", re.IGNORECASE)
_DENIM = re.compile(r"jean|denim", re.IGNORECASE)
_OF = re.compile(r"\s+(?:of|consisting of|made up of|aus|de)(?!\w)", re.IGNORECASE)
_SAID_BEFORE = ("fits", "occasions", "styles")
_NAMES = ("garments", *LOOKS)
_JOINED = ("", "and", "&", "und", "et", "y")
_PRINTED = ("with", "on", "mit", "auf", "avec", "sur", "con", "sobre")
_WITH = re.compile(r"\s*(?:with|mit|avec|con|met|com)(?!\w)", re.IGNORECASE)
_LISTED = re.compile(r"\s*[,;:.(–—-]")
"""What stands before a colour that is said of all that is named before."""
_SINGULAR = frozenset("a an one ein eine einen un une una uno een um uma".split())
_OTHER: dict[Half, Half] = {"upper": "lower", "lower": "upper"}
_SAID_OF_ALL = frozenset({"occasions", "polite", "function", "sizes", "generic"})


@dataclass(frozen=True, slots=True)
class Third:
    """A garment that is worn with two others."""

    mark: WordMark | None
    """Its name; None where the name of the others means it."""
    said: str
    alike: bool
    """Whether it is of their cloth."""


class PartedText:
    """A text, its two garments, and which of its chunks are about which."""

    def __init__(self, text: str, words: WordReading, pieces: Pieces, chunks: Sequence[Chunk]) -> None:
        self._text, self._words, self._pieces, self._chunks = text, words, pieces, chunks
        whole = {id(one.mark) for one in pieces.two.values()}
        elsewhere = [look for look in words.looks if look.part not in ("", "all")]
        elsewhere = [look for look in elsewhere if not any(id(mark) in whole for mark in look.noun_marks)]
        self._of_parts = {id(mark) for look in elsewhere for mark in look.marks}
        self._garments = [mark for mark, _ in pieces.named]
        self._garments += [*pieces.outfits, *[one.mark for one in pieces.two.values()]]
        self.is_set = is_one_cloth(text, pieces.outfits) or self._names_its_like()
        self._owners = self._find_owners()

    def _names_its_like(self) -> bool:
        """Whether a name says no more than where it is worn, and means one like the other: "bottoms"."""
        upper, lower = (self._mark(half).word for half in HALVES)
        return like_the_other(lower, upper) != lower or like_the_other(upper, lower) != upper

    def said_of(self, half: Half) -> str:
        """What the text says of one of the garments."""
        edits, shown, before = self._edits(half), list[str](), ""
        behind: list[str] = []
        for chunk, owner in zip(self._chunks, self._owners, strict=True):
            if owner not in (half, "both"):
                continue
            words = self._edited(chunk, edits)
            if owner == "both" and chunk.end <= self._mark(half).start and _WITH.match(words):
                behind.append(words)  # "pyjamas with piping: a shirt and trousers"
                continue
            if before == "both" and chunk.has(self._pieces.two[half].mark):  # "for work: blouse and skirt"
                words = f" {bare(words, self._words.language)}"
            shown.append(words)
            before = owner
        return re.sub(r"\s+(?=,)", "", "".join([*shown, *behind]))

    def third(self) -> Third | None:
        """The further garment that is asked for as those two are; None where there is none."""
        if any(_THREE.match(mark.word) and _has_waistcoat(mark) for mark in self._pieces.outfits):
            own = next((m for m in self._pieces.besides if m.word.lower() == _WAISTCOAT), None)
            if own is None or self._looks_beside(own) == "":
                return Third(own, self._of_their_cloth(_WAISTCOAT), alike=True)
        for mark in self._pieces.besides:
            looks = self._looks_beside(mark)
            if looks is None:
                continue
            if not looks and self.is_set and any(map(_has_waistcoat, self._pieces.outfits)):
                if mark.word.lower() == _WAISTCOAT:
                    return Third(mark, self._of_their_cloth(mark.word), alike=True)
            return Third(mark, f"{looks} {mark.word}".strip(), alike=False)
        return None

    def _looks_beside(self, mark: WordMark) -> str | None:
        """The looks before a further garment's name; None where it is not asked for as those two are."""
        for chunk, owner in zip(self._chunks, self._owners, strict=True):
            if owner == "beside" and chunk.joined and chunk.has(mark):
                before = lead(mark, chunk)
                if not all(map(may_lead, before)):
                    return None
                looks = [one for one in before if _category(one) in LOOKS and not self._is_same(one)]
                return "" if not looks else self._text[looks[0].start : mark.start].strip()
        return None

    def _of_their_cloth(self, name: str) -> str:
        looks = sorted([(mark.start, mark.end) for mark in self._look_marks("upper", beside=True)])
        return f"{self._joined(looks)} {name}" if looks else name

    def _find_owners(self) -> list[str]:
        """For each chunk a half, ``both``, ``none``, or ``beside`` where it only names a further garment."""
        owners, now = [], "both"
        for chunk in self._chunks:
            if (own := self._named_in(chunk)) is None:
                told = {self._told(mark) for mark in chunk.marks if not mark.denied} - {None}
                if is_of_both(self._text, chunk) or len(told) > 1:
                    own = "both"
                elif now in HALVES and self._is_length_before(chunk):
                    own = now
                elif told:
                    own = str(told.pop())
                elif all(_category(mark) in _SAID_OF_ALL for mark in chunk.marks):
                    own = "both"
                else:
                    own = now
            now = own if own not in ("none", "beside") else now
            owners.append(own)
        told_of_both = False
        for k, chunk in enumerate(self._chunks):
            goes_on = told_of_both and _WITH.match(self._text, chunk.start) is not None  # "blue with clouds"
            told_of_both = owners[k] in HALVES and self._are_looks_of_both(chunk, owners, owners[k], goes_on)
            owners[k] = "both" if told_of_both else owners[k]
        return owners

    def _are_looks_of_both(self, chunk: Chunk, owners: Sequence[str], owner: str, goes_on: bool) -> bool:
        """Whether a colour that stands behind both names is said of both: "top and shorts, navy"."""
        pieces = [one.mark for one in self._pieces.two.values()]
        if any(chunk.has(mark) for mark in pieces) or self._named_in(chunk) is not None:
            return False
        if chunk.start < max(mark.start for mark in pieces) or not says(chunk, COLORS, self._of_parts):
            return False
        if not self.is_set and not goes_on:
            if _LISTED.match(self._text, chunk.start) is None:
                return False
            if any(_DENIM.search(mark.word) for mark in pieces):
                return False
        other = "lower" if owner == "upper" else "upper"
        named = next(one for one in self._chunks if one.has(self._mark(owner)))
        theirs = [one for one, whose in zip(self._chunks, owners, strict=True) if whose == other]
        return not any(says(one, COLORS, self._of_parts) for one in (*theirs, named))

    def _mark(self, half: str) -> WordMark:
        """The name of the garment on a half."""
        return self._pieces.two["upper" if half == "upper" else "lower"].mark

    def _is_length_before(self, chunk: Chunk) -> bool:
        """Whether it says how long the first garment is: "a tunic, knee length, over breeches"."""
        behind = max(one.mark.start for one in self._pieces.two.values())
        lengths = bool(chunk.marks) and all(_category(mark) == "lengths" for mark in chunk.marks)
        return lengths and chunk.end <= behind

    def _named_in(self, chunk: Chunk) -> str | None:
        """Whose a chunk is by the names in it; None where it has none."""
        if self._pieces.is_one_name and chunk.has(self._pieces.two["upper"].mark):
            return "both"
        halves: set[str] = {half for half, piece in self._pieces.two.items() if chunk.has(piece.mark)}
        if not halves and any(chunk.has(mark) for mark in self._pieces.besides):
            details = [m for m in chunk.marks if m not in self._pieces.besides]
            if all(_category(m) in LOOKS or m.word.lower() in DETERMINERS for m in details):
                return "beside"
        halves |= {half for mark, half in self._pieces.named if chunk.has(mark)}
        if len(halves) == 1:
            return halves.pop()
        if not halves and any(chunk.has(mark) for mark in self._pieces.outfits):
            return "none"
        return "both" if halves else None

    def _edits(self, half: Half) -> list[tuple[int, int, str]]:
        """What is put in the place of what, by where it stands in the text."""
        piece = self._pieces.two[half]
        put = " ".join([*self._of_the_set(half), *self._taken_over(half)])
        put = f"{put} " if put else ""
        name = self._as_told(half) if piece.name is None else self._usual(half, piece.name)
        edits = [(piece.mark.start, piece.mark.end, put + name)]
        if piece.name is not None and name.endswith("s"):
            before = lead(piece.mark, next(chunk for chunk in self._chunks if chunk.has(piece.mark)))
            edits += [(m.start, m.end, "") for m in before if m.word.lower() in _SINGULAR]
        for mark in self._pieces.outfits:
            if mark not in [one.mark for one in self._pieces.two.values()]:
                of = _OF.match(self._text, mark.end)
                edits.append((mark.start, mark.end if of is None else of.end(), ""))
        edits += [(start, end, "") for start, end in set_words(self._text)]
        for found in LEGS_TOO.finditer(self._text):
            if found.start("lower") <= self._mark("lower").start < found.end("lower"):
                continue  # "pyjamas, short sleeves and trousers"
            edits += [(*found.span("upper"), found["upper"] if half == "upper" else found["lower"])]
            edits += [(found.start("and"), found.end(), "")]
        edits += [(found.start(), found.end(), "") for found in _BOTH.finditer(self._text)]
        for chunk, owner in zip(self._chunks, self._owners, strict=True):
            if owner == "both":
                told = [m for m in chunk.marks if self._told(m) == _OTHER[half]]
                edits += [(mark.start, mark.end, "") for mark in told]
        return sorted(edits, key=lambda edit: (edit[0], -edit[1]))

    def _edited(self, chunk: Chunk, edits: Sequence[tuple[int, int, str]]) -> str:
        shown, end = [], chunk.start
        for start, stop, put in edits:
            if end <= start < chunk.end:
                shown += [self._text[end:start], put]
                end = stop
        return "".join([*shown, self._text[end : chunk.end]])

    def _of_the_set(self, half: Half) -> list[str]:
        """What stands before a name of several, where both garments are named beside it."""
        found = []
        for chunk, owner in zip(self._chunks, self._owners, strict=True):
            if owner == "none":
                own = {_category(mark) for mark in self._look_marks(half, beside=True)}
                own |= {*CLOTHS} if looks_within(self._mark(half)) else set()
                of = [one for part in (COLORS, CLOTHS) if own.isdisjoint(part) for one in part]
                of += _SAID_BEFORE
                marks = [m for m in chunk.marks if _category(m) in of and self._told(m) != _OTHER[half]]
                found += [mark.word for mark in marks if not self._is_same(mark)]
        return found

    def _as_told(self, half: Half) -> str:
        """The name of a garment, with that of the set that it is of: the trousers of pyjamas."""
        word = self._pieces.two[half].mark.word
        for mark in self._pieces.outfits:
            if (outfit := named_outfit(mark.word, mark.entries)) is None:
                continue
            usual = outfit.upper if half == "upper" else outfit.lower
            told = in_the_set(word, usual, mark.word)
            if told != word:
                marks = read_words(self._usual(half, usual)).marks
                word = " ".join([*[m.word for m in marks if _category(m) == "styles"], told])
        return like_the_other(word, self._mark(_OTHER[half]).word)

    def _usual(self, half: Half, name: str) -> str:
        """What a name of both stands for, without what is usual where the text has details of its own."""
        own = [mark for mark in self._words.marks if self._told(mark) == half and mark not in self._garments]
        named = read_words(" ".join(self._mark(half).word.split()[:-1])).marks  # "a strappy top"
        told = set().union(*[subjects(mark) for mark in (*own, *named)])
        dyed = bool(self._words.colors)  # "old money, in green"
        marks = [m for m in read_words(name).marks if not (dyed and _category(m) in COLORS)]
        kept = [
            m.word
            for m in marks
            if half_told(m, "en") is None or _category(m) in _NAMES or told.isdisjoint(subjects(m))
        ]
        return " ".join(kept)

    def _taken_over(self, half: Half) -> list[str]:
        """The colours and cloths of the other garment, where they are said of both."""
        if self._pieces.is_one_name:
            return []
        looks = self._of_one_cloth(half) if self.is_set else self._of_one_phrase(half)
        return [self._joined(looks)] if looks else []

    def _of_one_cloth(self, half: Half) -> list[tuple[int, int]]:
        """Looks of the other garment of a set, of a sort that this one has none of its own of."""
        mine, other = (looks_within(self._mark(one)) for one in (half, _OTHER[half]))
        own = {_category(mark) for mark in self._look_marks(half, beside=True)}
        theirs = self._look_marks(_OTHER[half], beside=True)
        spans = []
        if own.isdisjoint(COLORS):
            spans += [(mark.start, mark.end) for mark in theirs if _category(mark) in COLORS]
        if own.isdisjoint(CLOTHS) and not mine:
            spans += [*other, *[(mark.start, mark.end) for mark in theirs if _category(mark) in CLOTHS]]
        return sorted(spans)

    def _of_one_phrase(self, half: Half) -> list[tuple[int, int]]:
        """Looks of the other garment that one phrase says of both: "a white blouse and skirt"."""
        if self._looks(half) or not (looks := self._looks(_OTHER[half])):
            return []
        mine, other = self._mark(half), self._mark(_OTHER[half])
        behind = max(mine, other, key=lambda mark: mark.start)
        if self._is_determined(behind) or _DENIM.search(mine.word) or not self._is_added(behind):
            return []
        if behind is mine:
            plural = mine.word.lower().endswith("s") and self._is_determined(other)
            return [] if plural else [(start, end) for start, end in looks if end <= other.end]
        return [
            (start, end)
            for start, end in looks
            if start > other.end and _IN.search(self._text[other.end : start])
        ]

    def _looks(self, half: Half) -> list[tuple[int, int]]:
        """Where colours, prints and cloths of a garment stand."""
        marks = self._look_marks(half)
        return sorted([*[(mark.start, mark.end) for mark in marks], *looks_within(self._mark(half))])

    def _look_marks(self, half: Half, *, beside: bool = False) -> list[WordMark]:
        """Colours, prints and cloths in the phrase of a garment's name; and `beside` it."""
        mark = self._mark(half)
        chunks = [
            chunk
            for chunk, owner in zip(self._chunks, self._owners, strict=True)
            if chunk.has(mark) or (beside and owner in (half, "both"))
        ]
        return [
            m
            for chunk in chunks
            for m in chunk.marks
            if _category(m) in LOOKS and not m.denied and id(m) not in self._of_parts and not self._is_same(m)
        ]

    def _told(self, mark: WordMark) -> Half | None:
        return half_told(mark, self._words.language)

    def _is_same(self, mark: WordMark) -> bool:
        """Whether it says that one is like the other: the fabric of "in the same fabric"."""
        return any(found.start() <= mark.start < found.end() for found in MATCHING.finditer(self._text))

    def _joined(self, looks: Sequence[tuple[int, int]]) -> str:
        """Looks with what stands between those that an "and" joins."""
        said = [self._text[looks[0][0] : looks[0][1]]]
        for (_, end), (start, stop) in pairwise(looks):
            between = self._text[end:start]
            said.append(between if between.strip(" ,-").lower() in (*_JOINED, *_PRINTED) else " ")
            said.append(self._text[start:stop])
        return "".join(said)

    def _is_added(self, mark: WordMark) -> bool:
        """Whether "and" joins it to the other: "with" makes it another thing of its own."""
        chunk = next(one for one in self._chunks if one.has(mark))
        return _ADDED.match(self._text, chunk.start) is not None

    def _is_determined(self, mark: WordMark) -> bool:
        chunk = next(one for one in self._chunks if one.has(mark))
        return any(not DETERMINERS.isdisjoint(m.word.lower().split()) for m in lead(mark, chunk))


class LayeredText(PartedText):
    """The same where one garment is worn over the other: both have sleeves, lengths and collars."""

    def __init__(self, text: str, words: WordReading, pieces: Pieces, chunks: Sequence[Chunk]) -> None:
        super().__init__(text, words, pieces, chunks)
        on_top = self._mark("upper")
        chunk = next(one for one in chunks if one.has(on_top))
        names = [entry.english or on_top.word for entry in on_top.entries]
        with_it = chunk.joined and _WITH.search(text[chunk.start : on_top.start]) is not None
        self.is_set = self.is_set or (with_it and any(map(_OF_ITS_DRESS.search, names)))

    def _told(self, mark: WordMark) -> Half | None:
        return None


def _has_waistcoat(mark: WordMark) -> bool:
    outfit = named_outfit(mark.word, mark.entries)
    return outfit is not None and _WAISTCOAT in outfit.beside


def _category(mark: WordMark) -> str | None:
    return mark.entries[0].category if mark.entries else None

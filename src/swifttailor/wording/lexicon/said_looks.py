"""Which words of a text say how parts look: a white collar, sleeves in navy, a skirt of tulle.

A colour or a sheer cloth is said of the noun that it stands before, adjectives between; of a part that it
stands behind in "sleeves in black", "the collar is white" and "sleeves of lace"; else of the whole garment.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from swifttailor.wording.lexicon.colors import NamedColor
from swifttailor.wording.lexicon.inflection import Language
from swifttailor.wording.lexicon.look_words import (
    MOTIF,
    PUT_ON,
    SIDE_PANELS,
    STRIPES,
    category_of,
    color_of_word,
    holds_up,
    is_cloth,
    is_detail,
    is_look,
    is_outfit,
    is_way_of_cutting,
    own_looks,
    part_in_english,
    part_of_garment,
    put_on,
)
from swifttailor.wording.lexicon.said_blocks import BLOCKS, own_colors, with_blocks
from swifttailor.wording.lexicon.said_look import OPAQUE, OTHER, WHOLE, SaidLook
from swifttailor.wording.lexicon.said_sides import with_sides

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.reading import WordMark

_RGB = re.compile("[0-9a-f]{6}")
_BETWEEN = frozenset(
    {
        *("styles", "fits", "lengths", "occasions", "colors", "shades", "prints", "fabrics", "sizes"),
        *("degrees", "numbers"),
    }
)
"""Categories of words between a look and its noun."""
_AND = frozenset({"and", "&", "und", "et", "y", "e", "en", "plus"})
_LINKS = frozenset(
    "in of from made out is are be being should must become to look as a an the only all entirely completely "
    "aus von ist sind en de sont est di sono van zijn um uma com both each please turn stay go".split()
)
"""Words between a part and how it looks behind it."""
_SAYS_SO = frozenset("is are be should must become of ist sind sont est sono zijn aus de di van".split())
_MADE_OF = frozenset("de en em di".split())
"""Words before the cloth that something is made of."""
_ARTICLES = frozenset("a an the its his her my".split())
_DEFINITE = frozenset("the its his her my".split())
_NOUN_FIRST: frozenset[Language] = frozenset({"fr", "es", "it", "pt"})
"""Languages in which colours stand behind their noun."""
_WITH_ENDINGS: frozenset[Language] = frozenset({"de", "nl"})
_ENDINGS = ("e", "er", "es", "em", "en")
_ON_MOST = frozenset({"pockets", "bow", "zip"})
"""What is put on most garments in their own colour: "cardigan grey pockets" is a grey cardigan."""
_WITH = frozenset("with mit met con col com avec à au aux in im ad al da mid og".split())
"""First words of names of details that another noun stands before: "met wijde pijpen"."""
_PLURAL_PRINT = re.compile(r"s$", re.IGNORECASE)
_REST = re.compile(r"(?<!\w)(?:the )?(?:rest|remainder) (?:of|in|is|plain)(?!\w)", re.IGNORECASE)
_APART = re.compile(r"[,;:.!?\n()|]")
_MOST_BETWEEN = 6


def said_looks(text: str, marks: Sequence[WordMark], language: Language) -> tuple[SaidLook, ...]:
    """The looks that a text says, in its order.

    Args:
        text: That was read.
        marks: Its words.
        language: Of the text.
    """
    if not any(is_look(m) or is_cloth(m) or own_looks(m) or m.part == BLOCKS for m in marks):
        return ()
    reader = _Reader(text, marks, language)
    found: list[SaidLook] = []
    for k, mark in enumerate(marks):
        if mark.role == "theirs":
            continue
        found += reader.by_name(k)
        if is_look(mark) or is_cloth(mark):
            found += reader.of_word(k)
    return tuple(with_blocks(with_sides(text, found, _of_no_part(found, marks)), marks))


def _of_no_part(found: Sequence[SaidLook], marks: Sequence[WordMark]) -> list[SaidLook]:
    """The colours that are said of no part."""
    colors = [color_of_word(marks, k) for k in range(len(marks))]
    return [SaidLook("", "", colors[k], None, True, (marks[k],)) for k in own_colors(marks, found, colors)]


class _Reader:
    """One text, and what its words are said of."""

    def __init__(self, text: str, marks: Sequence[WordMark], language: Language) -> None:
        self._text, self._marks, self._language = text, marks, language
        self._names_garment = any(mark.role == "garment" for mark in marks)
        self._colors = [mark for mark in marks if category_of(mark) == "colors" and is_look(mark)]
        self._cloths = [mark for mark in marks if is_cloth(mark)]

    def by_name(self, k: int) -> list[SaidLook]:
        """What the word k says together with its noun: "illusion sleeves", or implies: a tulle skirt."""
        mark = self._marks[k]
        part = part_of_garment(mark)
        found = []
        for entry in mark.entries:
            for cloth, own in () if mark.denied or mark.role in ("second", "like") else entry.looks:
                if is_look(mark):
                    continue
                where = own or part or (mark.part if mark.role == "word" else None) or WHOLE
                said = mark.role != "garment" or own is None
                color = NamedColor("", cloth) if _RGB.fullmatch(cloth) else None
                kept = None if color is not None else cloth
                found.append(SaidLook(where, mark.word, color, kept, said, (), (mark,)))
        return found

    def of_word(self, k: int) -> list[SaidLook]:
        """What the look k says, and of what."""
        mark = self._marks[k]
        cloth = next((cloth for entry in mark.entries for cloth, _ in entry.looks), None)
        color = color_of_word(self._marks, k)
        if mark.denied:
            if cloth is None or cloth == "contrast":
                return []
            color, cloth = None, OPAQUE
        nouns = [] if self._is_behind_its_noun(k) else self._before(k)
        nouns = self._behind(k) if nouns is None else nouns
        if cloth is None and color is None:  # of another cloth, which is not seen
            cloth, nouns = OTHER, [] if mark.denied else [(j, part) for j, part in nouns if part]
            if not nouns:
                return []
        if not nouns:
            return [] if cloth in (None, "contrast") else [SaidLook(WHOLE, "", None, cloth, True, (mark,))]
        shade = self._shade(k)
        return [
            SaidLook(part, self._marks[j].word, color, cloth, True, (*shade, mark), (self._marks[j],))
            for j, part in nouns
        ]

    def _shade(self, k: int) -> tuple[WordMark, ...]:
        before = self._marks[k - 1] if k else None
        return (before,) if before is not None and any(e.shade for e in before.entries) else ()

    def _before(self, k: int) -> list[tuple[int, str]] | None:
        """Places and parts of the nouns that a look stands before; [] of the garment, None: before none."""
        j = k + 1
        if self._is_made_of(k):  # "mangas de encaje y espalda abierta"
            return None
        if self._language in _NOUN_FIRST and (noun := self._right_before(k)) is not None:
            part = self._part(self._marks[noun])
            return [] if part is None else [(noun, part)]
        while j < len(self._marks) and j - k <= _MOST_BETWEEN and not self._is_apart(j):
            mark = self._marks[j]
            if self._is_noun(mark):
                return self._nouns_from(j, k)
            if category_of(mark) == "prints" and _PLURAL_PRINT.search(mark.word):
                return []
            if self._counts(j) and self._is_the_only_one(k):
                return []  # "polo shirt navy 3 button"
            joins = mark.word.lower() in _AND and j + 1 < len(self._marks) and is_look(self._marks[j + 1])
            if not joins and mark.entries and category_of(mark) not in _BETWEEN:
                return [] if category_of(mark) == "generic" else None
            j += 1
        return None

    def _counts(self, j: int) -> bool:
        """Whether a number in figures stands there, behind the garment: "3 button"."""
        behind = any(mark.role == "garment" for mark in self._marks[:j])
        return behind and category_of(self._marks[j]) == "numbers" and self._marks[j].word.isdigit()

    def _is_the_only_one(self, k: int) -> bool:
        """Whether no other colour is named, or, of a cloth, no other cloth."""
        return (self._cloths if is_cloth(self._marks[k]) else self._colors) == [self._marks[k]]

    def _is_made_of(self, k: int) -> bool:
        """Whether a cloth stands behind "de" or "en" in a language in which it is said of what is before."""
        before = self._marks[k - 1].word.lower() if k else ""
        return self._language in _NOUN_FIRST and before in _MADE_OF and bool(own_looks(self._marks[k]))

    def _right_before(self, k: int) -> int | None:
        """The noun that a look follows, other looks between: "col blanc"."""
        for j in range(k - 1, -1, -1):
            mark = self._marks[j]
            if self._is_apart(j + 1):
                return None
            if self._is_noun(mark):
                return j
            if not (is_look(mark) or any(e.shade for e in mark.entries)):
                return None
        return None

    def _nouns_from(self, j: int, k: int) -> list[tuple[int, str]]:
        """The noun j with those that are joined to it: "white collar and cuffs"."""
        last = j
        for after, mark in enumerate(self._marks[j + 1 :], j + 1):
            is_noun = self._is_noun(mark)
            if not self._is_close(after) or not (is_noun or category_of(mark) == "lengths"):
                break
            if is_noun and (after == last + 1 or mark.role == "garment"):  # "boat neck maxi slip dress"
                last = after
        first, noun = self._marks[j], self._marks[last]
        if last > j and noun.entries[0].category == "garments":
            bare = category_of(first) == "parts" and " " not in first.word and j == k + 1
            return [(j, first.part or "")] if bare else []
        if any(mark.role == "garment" for mark in self._marks[j:last]):
            return []  # "black jumpsuit wide legs" is black, as what is typed without commas goes on
        part = self._part(noun)
        listed = is_way_of_cutting(noun) or put_on(noun) in _ON_MOST
        if part is None or (listed and self._is_of_garment_before(k)):
            return []
        found = [(last, part)]
        while part != STRIPES and (after := self._joined(last)) is not None:
            last = after
            found.append((last, self._part(self._marks[last]) or ""))
        return found

    def _is_of_garment_before(self, k: int) -> bool:
        """Whether the only look of its kind stands behind the garment: "jumper navy crew neck"."""
        return self._is_behind_garment(k) and self._is_the_only_one(k)

    def _is_behind_garment(self, k: int) -> bool:
        """Whether it stands right behind the garment, or behind other looks there: "shirt linen blue"."""
        for j in range(k - 1, -1, -1):
            mark = self._marks[j]
            if self._is_apart(j + 1) or mark.role == "garment":
                return not self._is_apart(j + 1)
            beside = category_of(mark) in ("lengths", "fits", "shades")
            if not (beside or is_look(mark) or is_cloth(mark)):
                return False
        return False

    def _is_behind_its_noun(self, k: int) -> bool:
        """Whether it has no ending where colours before nouns have one: "Bluse weiß Rüschenkragen"."""
        return (
            self._language in _WITH_ENDINGS
            and self._is_behind_garment(k)
            and self._marks[k].word.lower() not in _AND
            and not self._marks[k].word.lower().endswith(_ENDINGS)
        )

    def _joined(self, k: int) -> int | None:
        """The bare part that is joined to the noun k, and has no look of its own."""
        j = k + 1
        between = []
        while j < len(self._marks) and self._marks[j].word.lower() in _AND | _ARTICLES:
            between.append(self._marks[j].word.lower())
            j += 1
        if j >= len(self._marks) or not self._is_bare_part(j) or set(between) & {"a", "an"}:
            return None
        apart = _APART.search(self._text[self._marks[k].end : self._marks[j].start])
        if apart is not None or not set(between) & _AND:
            listed = apart is not None and apart[0] == "," and not between and self._joined(j) is not None
            return j if listed else None
        return None if self._has_look_behind(j) else j

    def _has_look_behind(self, j: int) -> bool:
        rest = self._marks[j + 1 : j + 4]
        links = [mark.word.lower() in _LINKS for mark in rest]
        return any(is_look(mark) and all(links[:n]) and n for n, mark in enumerate(rest))

    def _behind(self, k: int) -> list[tuple[int, str]]:
        """The part that a look stands behind; none where it is said of the garment."""
        links = []
        for j in range(k - 1, max(-1, k - _MOST_BETWEEN), -1):
            if self._is_apart(j + 1):
                return []
            mark, word = self._marks[j], self._marks[j].word.lower()
            if j == k - 2 and self._is_made_of(k) and (part := part_in_english(mark)) is not None:
                return [(j, part)]
            if self._is_noun(mark):
                part = self._part(mark)
                return [] if part is None or not self._is_said(j, links, k) else self._all_before(j, part)
            if word in _LINKS:
                links.append(word)
            elif not (is_look(mark) or any(e.shade for e in mark.entries) or word in _AND):
                if category_of(mark) not in ("degrees", "negations"):
                    return []
        return []

    def _all_before(self, j: int, part: str) -> list[tuple[int, str]]:
        """The part j with those that it is joined to: "make the collar and cuffs white"."""
        found = [(j, part)]
        for k in range(j - 2, max(-1, j - 4), -1):
            if self._is_bare_part(k) and self._joins(k, j):
                return [*self._all_before(k, self._part(self._marks[k]) or ""), *found]
        return found

    def _joins(self, k: int, j: int) -> bool:
        words = {mark.word.lower() for mark in self._marks[k + 1 : j]}
        return bool(words & _AND) and words <= _AND | _DEFINITE and not self._is_said_before(k)

    def _is_said_before(self, k: int) -> bool:
        """Whether the part k has a look of its own: "a red collar and sleeves in white"."""
        return k > 0 and is_look(self._marks[k - 1])

    def _is_said(self, j: int, links: Sequence[str], k: int) -> bool:
        """Whether a look behind the part j is its own: that of "a dress with long sleeves in navy" is not."""
        if (
            set(links) & _SAYS_SO
            or self._is_made_of(k)
            or not self._names_garment
            or (links == [] and not self._goes_on(j, k))
        ):
            return True
        if j and self._marks[j - 1].word.lower().split()[-1] in _DEFINITE:
            return True
        if _REST.search(self._text):
            return True  # "sleeves in lace, the rest in satin"
        mine = category_of(self._marks[k])
        return any(
            is_look(mark) and category_of(mark) == mine and self._before(n) == []
            for n, mark in enumerate(self._marks)
            if n != k
        ) or any(
            mark.role == "garment" and n + 1 < len(self._marks) and is_look(self._marks[n + 1])
            for n, mark in enumerate(self._marks)
        )

    def _goes_on(self, j: int, k: int) -> bool:
        """Whether the only colour or cloth stands behind a detail: "coveralls short sleeve orange" are."""
        mark = self._marks[j]
        detail = category_of(mark) == "styles" and (" " in mark.word or is_way_of_cutting(mark))
        return detail and self._is_the_only_one(k) and any(m.role == "garment" for m in self._marks[:j])

    def _is_bare_part(self, j: int) -> bool:
        mark = self._marks[j]
        return category_of(mark) == "parts" and self._is_noun(mark) and bool(self._part(mark))

    def _is_noun(self, mark: WordMark) -> bool:
        """Whether looks can be said of it; of what is not there, as "no sleeves", none can."""
        if not mark.entries:
            return False
        if self._is_worn_over(mark):
            return True
        if any(claim.value == "none" for entry in mark.entries for claim in entry.claims("certain")):
            return False
        category = category_of(mark)
        if category in ("garments", "accessories", "parts"):
            return True
        if self._covers_all(mark):
            return False
        if category == "styles" and (mark.part is not None or put_on(mark) or is_detail(mark)):
            said = mark.entries[0].english or mark.word.lower()  # "plissada" is "pleated", and no noun
            return not said.endswith(("ed", "less", "puffy", "frilly", "lacy", "fluffy", "knit"))
        return False

    def _covers_all(self, mark: WordMark) -> bool:
        """Whether it is the cloth that one sees: gold sequins, where nothing else has a colour."""
        return len(self._colors) == 1 and any("sequins" in entry.cannot for entry in mark.entries)

    def _is_worn_over(self, mark: WordMark) -> bool:
        """Whether it is put on another garment: the apron of "a dirndl with a white apron"."""
        others = self._names_garment and mark.role != "garment" and category_of(mark) == "garments"
        return others and any("apron" in entry.cannot for entry in mark.entries)

    def _part(self, mark: WordMark) -> str | None:
        """What a noun is of the garment: a part, something that is put on, or a thing of its own (``""``)."""
        if category_of(mark) in ("garments", "accessories"):
            if self._is_worn_over(mark):
                return PUT_ON["apron"]
            if holds_up(mark, self._marks):
                return "bodice"
            apart = mark.role in ("second", "theirs") and not is_outfit(mark)
            return part_of_garment(mark) or ("" if apart else None)
        over = put_on(mark)
        return over if over in (STRIPES, SIDE_PANELS, MOTIF) else mark.part or over or ""

    def _is_apart(self, j: int) -> bool:
        first, _, more = self._marks[j].word.lower().partition(" ")
        return (bool(more) and first in _WITH) or bool(
            _APART.search(self._text[self._marks[j - 1].end : self._marks[j].start])
        )

    def _is_close(self, j: int) -> bool:
        return (
            not self._is_apart(j)
            and self._text[self._marks[j - 1].end : self._marks[j].start].strip(" -") == ""
        )

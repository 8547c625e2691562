"""The words of one language, to be looked up: read from the tables when they are first asked for."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from pathlib import Path
from typing import NamedTuple

from swifttailor.describing.claims import CLAIM_TYPES
from swifttailor.wording.lexicon.entries import CATEGORIES, Entry, entry_of
from swifttailor.wording.lexicon.inflection import Language, base_forms
from swifttailor.wording.lexicon.tokens import words_of
from swifttailor.wording.word_tables import Dialect, Row, read_table

WORDS = Path(__file__).with_name("words")
CANNOT = "cannot.txt"
TABLES: Mapping[Language, tuple[str, ...]] = {
    "en": (
        *("tops.txt", "outerwear.txt", "dresses.txt", "skirts.txt", "trousers.txt", "all_in_ones.txt"),
        *("underwear.txt", "traditional.txt", "historical.txt", "uniforms.txt"),
        *("shops.txt", "accessories.txt"),
        *(
            "parts.txt",
            "necklines.txt",
            "sleeves.txt",
            "shapes.txt",
            "details.txt",
            "fits.txt",
            "lengths.txt",
        ),
        *(
            "persons.txt",
            "occasions.txt",
            "colors.txt",
            "prints.txt",
            "fabrics.txt",
            "sizes.txt",
            "function_words.txt",
        ),
    ),
    "de": (
        "german.txt",
        "german_lengths.txt",
        "german_spoken.txt",
        "german_details.txt",
        "german_colors.txt",
        "german_everyday.txt",
    ),
    "fr": (
        "french.txt",
        "french_lengths.txt",
        "french_spoken.txt",
        "french_details.txt",
        "french_colors.txt",
        "french_everyday.txt",
    ),
    "es": (
        "spanish.txt",
        "spanish_lengths.txt",
        "spanish_spoken.txt",
        "spanish_details.txt",
        "spanish_colors.txt",
        "spanish_everyday.txt",
    ),
    "it": (
        "italian.txt",
        "italian_lengths.txt",
        "italian_spoken.txt",
        "italian_details.txt",
        "italian_colors.txt",
        "italian_everyday.txt",
    ),
    "nl": (
        "dutch.txt",
        "dutch_lengths.txt",
        "dutch_spoken.txt",
        "dutch_details.txt",
        "dutch_colors.txt",
        "dutch_everyday.txt",
    ),
    "pt": (
        "portuguese.txt",
        "portuguese_lengths.txt",
        "portuguese_spoken.txt",
        "portuguese_details.txt",
        "portuguese_colors.txt",
        "portuguese_everyday.txt",
    ),
}
_TRANSLATIONS = "words"
"""Section of the tables of other languages."""
PARTS = frozenset(
    [
        *(
            "sleeves",
            "left_sleeve",
            "right_sleeve",
            "left_leg",
            "right_leg",
            "left_half",
            "right_half",
            "sleeve_head",
            "neckline",
            "back_neckline",
            "collar",
            "hood",
        ),
        *(
            "cuffs",
            "leg_cuffs",
            "waistband",
            "hem_band",
            "waist",
            "waist_seam",
            "skirt",
            "bodice",
            "legs",
            "hem",
        ),
        *("slit", "straps", "shoulders", "back", "front", "sides", "armholes", "tiers", "gores", "godets"),
        *("darts", "bust", "hips", "seat", "thigh", "knee", "crotch", "peplum", "panels", "seam", "yoke"),
    ]
)
"""Parts of garments that words can name, and be said of."""
SAID_OF = frozenset([*CLAIM_TYPES["kind"].words, *PARTS, "color", "size"])
_NOUNS = frozenset(["garments", "accessories", "generic", "parts", "styles", "prints", "fabrics"])
"""Categories of English words that have a plural."""
WORN = frozenset(["garments", "accessories"])
"""Categories of what is worn."""
NUMBER = "#"
"""Stands for any number in a word of a table."""
_CLOSED = 3
"""Up to so many parts of a word may be written as one."""


class Sense(NamedTuple):
    """A meaning of a word."""

    entry: Entry
    word: str
    """As its table has it."""
    dialect: Dialect | None
    """Where the word has this meaning; anywhere when None."""


@dataclass(frozen=True, slots=True, eq=False)
class Vocabulary:
    """The entries of a language, and its words with all their meanings."""

    language: Language
    entries: tuple[Entry, ...]
    senses: Mapping[str, tuple[Sense, ...]]
    """By the word's parts with a space between them: ``t shirt``."""
    closed: Mapping[str, str]
    """Other spellings: several parts written as one, ``tshirt``, and letters without their accents."""
    longest: Mapping[str, int]
    """How many parts the longest word has that begins with a part."""

    def find(self, parts: list[str]) -> tuple[Sense, ...]:
        """The meanings of some words of a text taken together: as they stand, or as a form of a word.

        Args:
            parts: In lower case.
        """
        if not parts:
            return ()
        key = " ".join(parts)
        found = self.senses.get(key)
        if found is not None:
            return found
        if len(parts) == 1 and key in self.closed:
            return self.senses[self.closed[key]]
        before = key[: len(key) - len(parts[-1])]
        for base, noun in base_forms(parts[-1], self.language):
            senses = self.senses.get(before + base)
            if senses is None and not before and base in self.closed:
                senses = self.senses[self.closed[base]]
            fitting = tuple([s for s in senses or () if noun is None or self._is_noun(s) == noun])
            if fitting:
                return fitting
        return ()

    def part(self, word: str) -> str | None:
        """The part of a garment that a single word names."""
        return next((sense.entry.part for sense in self.find([word]) if sense.entry.part is not None), None)

    def _is_noun(self, sense: Sense) -> bool:
        if self.language == "de":
            return sense.word.split()[-1][0].isupper()
        return sense.entry.category in _NOUNS


@lru_cache(maxsize=16)
def vocabulary(language: Language) -> Vocabulary:
    """The words of a language.

    Raises:
        InputError: A table is wrong; the message names file and line.
    """
    rows = [row for name in TABLES[language] for row in read_table(WORDS / name)]
    return vocabulary_of(rows, language)


def vocabulary_of(rows: Iterable[Row], language: Language = "en") -> Vocabulary:
    """The words of tables.

    Raises:
        InputError: A row is wrong, or a word has two meanings and nothing tells them apart; the message names
            file and line.
    """
    senses: dict[str, list[Sense]] = {}
    closed: dict[str, str] = {}
    longest: dict[str, int] = {}
    entries: list[Entry] = []
    cannot = cannot_texts()
    for row in rows:
        for entry in _entries(row, language, cannot):
            entries.append(entry)
            only = dict(entry.only) if entry.only else {}
            for word in entry.words:
                parts = words_of(word, language)
                if not parts:
                    row.wrong(f"'{word}' holds no word.")
                key = " ".join(parts)
                sense = Sense(entry, word, only.get(word))
                known = senses.get(key)
                if known is None:
                    senses[key] = [sense]
                    first, count = parts[0], len(parts)
                    if longest.get(first, 0) < count:
                        longest[first] = count
                    for other in _other_spellings(key, count, language):
                        closed.setdefault(other, key)
                else:
                    _check_apart(row, sense, known)
                    known.append(sense)
    found = {key: tuple(each) for key, each in senses.items()}
    for other, key in closed.items():
        if other in found and other != key:
            known = [sense.entry for sense in found[key]]
            found[other] = found[key] = (*found[key], *[s for s in found[other] if s.entry not in known])
    return Vocabulary(language, tuple(entries), found, closed, longest)


def _entries(row: Row, language: Language, cannot: Mapping[str, str]) -> Iterator[Entry]:
    """The entries of a row; several where it stands for an English word with several meanings."""
    if row.section != _TRANSLATIONS:
        yield entry_of(row, cannot, SAID_OF)
        return
    names = row.options.get("is", ())
    if language == "en" or len(names) != 1 or len(row.options) > 1 or row.claims or row.words or row.numbers:
        row.wrong("in a table of another language, one mark is:english_word stands on the left.")
    name = names[0].replace("_", " ")
    meant = vocabulary("en").senses.get(" ".join(words_of(name, "en")))
    if meant is None:
        row.wrong(f"is:{names[0]} is no word of the English tables.")
    for sense in meant:
        yield replace(sense.entry, words=row.texts, place=row.place, english=name, only=())


def _other_spellings(key: str, count: int, language: Language) -> Iterator[str]:
    if 1 < count <= _CLOSED:
        yield key.replace(" ", "")
    if not key.isascii():
        spelling = _without_umlauts(key) if language == "de" else _without_accents(key)
        if spelling != key and count <= _CLOSED:
            yield spelling.replace(" ", "")


def _without_accents(word: str) -> str:
    return "".join([c for c in unicodedata.normalize("NFKD", word) if not unicodedata.combining(c)])


def _without_umlauts(word: str) -> str:
    for letter, spelled in (("ä", "ae"), ("ö", "oe"), ("ü", "ue"), ("ß", "ss")):
        word = word.replace(letter, spelled)
    return word


def _check_apart(row: Row, sense: Sense, known: list[Sense]) -> None:
    """Refuses a second meaning that nothing tells from the first.

    What tells them apart: what they are said of; the dialect; that one is a garment and the other is not;
    or that one is marked as ambiguous, and so the second choice. Two meanings that are said of the same
    thing may hold together if they speak of different claims.
    """
    for other in known:
        mine, its = sense.entry, other.entry
        if mine is its:
            row.wrong(f"'{sense.word}' and '{other.word}' are one word; leave one out.")
        if mine.place == its.place:
            continue
        both = mine.of & its.of
        apart = not both and bool(mine.of or its.of)
        together = both and not {c.name for c in mine.claims()} & {c.name for c in its.claims()}
        dialects = sense.dialect is not None and other.dialect is not None and sense.dialect != other.dialect
        garment = (mine.category in WORN) != (its.category in WORN)
        if not (apart or together or dialects or garment or mine.ambiguous or its.ambiguous):
            row.wrong(
                f"'{sense.word}' stands in {its.place[0]}, line {its.place[1]}, too. Say with 'of:' or '@uk' "
                "and '@us' when each is meant, or mark one of them as 'ambiguous'."
            )


@cache
def cannot_texts() -> Mapping[str, str]:
    """What cannot be made, in words for people, by the key that entries name."""
    found: dict[str, str] = {}
    for row in read_table(WORDS / CANNOT):
        if len(row.words) != 1 or row.options or row.claims or len(row.texts) != 1 or row.words[0] in found:
            row.wrong("one key that no other row has stands on the left, one text on the right.")
        found[row.words[0]] = row.texts[0]
    return found


def all_entries(language: Language = "en") -> tuple[Entry, ...]:
    """The entries of a language, table after table."""
    return vocabulary(language).entries


def entries_in(category: str, language: Language = "en") -> tuple[Entry, ...]:
    """The entries of one of `CATEGORIES`."""
    assert category in CATEGORIES
    return tuple([entry for entry in vocabulary(language).entries if entry.category == category])

"""What a text asks for, by the lexicon of clothes and the network together.

What words mean by definition and what details say comes first, then what the network reads, then what the
names of garments usually imply. The network alone reads numbers, changes of measures, and how words hang
together.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache, cached_property

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.wishes.mentions import find_mentions
from swifttailor.wishes.reader import Wish, WishReader
from swifttailor.wishes.spelling import put_right
from swifttailor.wishes.sureness import likely_wishes, sure_wishes
from swifttailor.wishes.unread import not_understood, says_nothing_else, unread_numbers
from swifttailor.wording.claim_kinds import fits_kind, implied_kind
from swifttailor.wording.lexicon import (
    SURENESS,
    Entry,
    Lack,
    WordReading,
    all_entries,
    cannot_texts,
    exclude,
    read_words,
)

SURE_IN_KNOWN_WORDS = 0.7
"""Enough for an edit whose words are all known ones for what was read: 147 of 162 such wishes
are meant (instructions between validation patterns, written as for the training)."""
SURE_OF_EVERY_WORD = 0.96
"""Enough for the network to come before the lexicon, where it leaves no word out."""
_DETAIL = {"certain": SURENESS["certain"], "usual": 0.92}
"""How sure what is said of a detail is: it is asked for, whatever is usual."""
_OF_BOTH_SIDES = {"neckline": "neckline", "sleeve": "sleeves"}
_ENGLISH = "en"
_NEAR, _MOST_NEAR = 0.72, 3
_LONGEST_WORD = 40
_DIGIT = re.compile(r"\d")


@dataclass(frozen=True)
class Heard:
    """What a text asks for."""

    text: str
    """As it was read: with slips of the fingers put right."""
    sure: tuple[Wish, ...] = ()
    likely: tuple[Wish, ...] = ()
    """What names of garments usually imply, and what may be meant."""
    never: tuple[Claim, ...] = ()
    """What it refuses."""
    unread: tuple[str, ...] = ()
    """What of it was not understood, in its own words."""
    lacks: tuple[Lack, ...] = ()
    """What it asks for and cannot be made."""
    words: WordReading | None = None
    """By the lexicon; None where there is no text."""

    @property
    def color(self) -> str | None:
        """The first colour that it names, ``#rrggbb``, or that a name implies: a little black dress."""
        named = self.words.colors if self.words is not None else ()
        rgb = named[0].rgb if named else next((e.color for e in self._meant if e.color is not None), None)
        return None if rgb is None else f"#{rgb}"

    @property
    def cloth(self) -> str | None:
        """The fabric that comes nearest to what it names, or to what a name implies: a denim skirt."""
        named = self.words.cloths if self.words is not None else ()
        return named[0] if named else next((e.cloth for e in self._meant if e.cloth is not None), None)

    @property
    def _meant(self) -> list[Entry]:
        marks = () if self.words is None else self.words.marks
        return [entry for mark in marks if not mark.denied for entry in mark.entries]

    @cached_property
    def cannot(self) -> tuple[str, ...]:
        """What it asks for and cannot be made, in words."""
        return tuple([cannot_texts()[lack.what] for lack in self.lacks if lack.said])

    @cached_property
    def left_out(self) -> tuple[str, ...]:
        """What the names of garments in it mean and cannot be made, in words."""
        return tuple([cannot_texts()[lack.what] for lack in self.lacks if not lack.said])

    @property
    def contradictions(self) -> tuple[tuple[str, str], ...]:
        """Pairs of words in it that cannot both be true."""
        found = () if self.words is None else self.words.contradictions
        return tuple([(pair.first.word, pair.second.word) for pair in found])

    @property
    def kind(self) -> str | None:
        """The kind of garment that is asked for, or that details tell; None where nothing does."""
        claims = [w.change.claim for w in (*self.sure, *self.likely) if isinstance(w.change, Gain)]
        named = next((str(claim.value) for claim in claims if claim.name == "kind"), None)
        return named or next(iter(implied_kind(claims)), None)

    @cached_property
    def near(self) -> tuple[str, ...]:
        """Names of garments that are spelt like words that were not understood."""
        found = [
            difflib.get_close_matches(word[:_LONGEST_WORD].lower(), _garment_names(), _MOST_NEAR, _NEAR)
            for word in self.unread[:_MOST_NEAR]
        ]
        return tuple(dict.fromkeys([name for names in found for name in names]))


HEARD_NOTHING = Heard("")
"""Where there is no text."""


def hear_description(text: str, reader: WishReader) -> Heard:
    """What garment a text describes.

    Args:
        text: In English, or of German, French and Spanish what the lexicon knows.
        reader: The network.
    """
    if not text.strip():
        return HEARD_NOTHING
    text, words = _put_right(text)
    network = reader.read(text, instruction=False) if words.language == _ENGLISH else ()
    found = _explained(text, words, network) or united(text, words, network)
    changes = [wish.change for wish in found]
    sizes = " ".join(words.sizes)
    unread = *words.unknown, *[n for n in unread_numbers(text, changes) if n not in sizes]
    sure, likely = sure_wishes(found), likely_wishes(found)
    return Heard(text, sure, likely, words.never, unread, _lacks(words, changes), words)


def hear_instruction(text: str, reader: WishReader, kind: str | None = None) -> Heard:
    """How a text wants a garment to be changed.

    What the network is sure of counts; where it is sure of nothing, details that the lexicon knows do.

    Args:
        text: In English, or of German, French and Spanish what the lexicon knows.
        reader: The network.
        kind: Of the garment.
    """
    text, words = _put_right(text, kind)

    def sure_changes(found: Iterable[Wish]) -> list[Change]:
        return [wish.change for wish in sure_wishes(tuple(found))]

    found = reader.read(text, instruction=True) if words.language == _ENGLISH else ()
    sure, likely = sure_wishes(found), likely_wishes(found)
    plain = tuple(w for w in likely if w.certainty >= SURE_IN_KNOWN_WORDS)
    if plain and says_nothing_else(text, [w.change for w in (*sure, *plain)]):
        rest = tuple(w for w in likely if w not in plain)
        lacks = _lacks(words, [w.change for w in (*sure, *plain)])
        return Heard(text, (*sure, *plain), rest, lacks=lacks, words=words)
    if not sure:
        sure = tuple(
            Wish(Gain(each.claim), SURENESS["certain"])
            for each in words.implications
            if each.said and each.certainty == "certain"
        )
        if sure:
            return Heard(text, sure, (), words.never, words.unknown, _lacks(words, ()), words)
    unread = not_understood(
        text, sure_changes(found), lambda other: sure_changes(reader.read(other, instruction=True))
    )
    lacks = _lacks(words, [wish.change for wish in found])
    return Heard(text, sure, likely, (), _not_answered(unread, words), lacks, words)


def united(text: str, words: WordReading, network: Iterable[Wish]) -> tuple[Wish, ...]:
    """What lexicon and network say together, surest first.

    Args:
        text: In which "long" behind a length is no claim: "60 cm long".
        words: By the lexicon.
        network: What the network reads of the same text, surest first.
    """
    lengths = {mention.end for mention in find_mentions(text) if mention.is_length}
    implied = [i for i in words.implications if len(text[: i.mark.start].rstrip(" -")) not in lengths]
    found = [
        Wish(Gain(each.claim), _DETAIL[each.certainty])
        for each in implied
        if each.certainty == "certain" or (each.said and each.certainty == "usual")
    ]
    told = [wish.change.claim for wish in found if isinstance(wish.change, Gain)]
    kind = next((str(claim.value) for claim in told if claim.name == "kind"), None)
    names = [Wish(Gain(each.claim), SURENESS[each.certainty]) for each in implied if each.claim not in told]
    for wish in (*network, *names):
        if not isinstance(wish.change, Gain):
            continue
        claim = wish.change.claim
        if claim in told or claim in words.never or any(exclude(claim, other) for other in told):
            continue
        if kind is not None and not fits_kind(claim.name, kind):
            continue
        found.append(wish)
        told.append(claim)
    return tuple(sorted(found, key=lambda wish: -wish.certainty))


def _explained(text: str, words: WordReading, network: Iterable[Wish]) -> tuple[Wish, ...]:
    """What both say where the network is sure of something for every word: it knows how they hang together.

    Returns:
        Surest first: what it is sure of, and of the rest what does not contradict that; nothing where there
        are words that it has no wish for.
    """
    sure = [w for w in network if isinstance(w.change, Gain) and w.certainty >= SURE_OF_EVERY_WORD]
    if not sure or not says_nothing_else(text, [wish.change for wish in sure]):
        return ()
    told = [wish.change.claim for wish in sure if isinstance(wish.change, Gain)]
    if any(claim in words.never for claim in told):
        return ()
    names = {claim.name for claim in told}
    for side in ("left_", "right_"):  # who tells one side has told of both
        names |= {plural for one, plural in _OF_BOTH_SIDES.items() if side + one in names}
    for wish in united(text, words, network):
        claim = wish.change.claim if isinstance(wish.change, Gain) else None
        if claim is None or claim.name in names or any(exclude(claim, other) for other in told):
            continue
        sure.append(wish)
    return tuple(sorted(sure, key=lambda wish: -wish.certainty))


def _put_right(text: str, kind: str | None = None) -> tuple[str, WordReading]:
    """The text with typing errors put right, and its words.

    They are so in words that nobody knows, where the first letter stays, and in those that the lexicon has as
    another spelling. What is not English stays as it is, but typing errors look foreign.
    """
    pieces, end = [], 0
    for mark in read_words(text, language=_ENGLISH, kind=kind).marks:
        better = put_right(mark.word)
        known = any(better.lower() == word.lower() for entry in mark.entries for word in entry.words)
        if better[:1].lower() == mark.word[:1].lower() and (known or not mark.entries):
            pieces += [text[end : mark.start], better]
            end = mark.end
    shown = "".join([*pieces, text[end:]])
    words = read_words(shown, kind=kind)
    if shown == text or words.language == _ENGLISH:
        return shown, words
    return text, read_words(text, kind=kind)


def _lacks(words: WordReading, changes: Sequence[Change]) -> tuple[Lack, ...]:
    """What cannot be made; a number that was read is no size."""
    return tuple(
        [
            lack
            for lack in words.lacks
            if lack.what != "sizes"
            or not _DIGIT.search(lack.mark.word)
            or unread_numbers(lack.mark.word, changes)
        ]
    )


def _not_answered(unread: Sequence[str], words: WordReading) -> tuple[str, ...]:
    """What was not understood, without what the lexicon answers: colours, fabrics, what cannot be."""
    answered = [color.words for color in words.colors] + [lack.mark.word for lack in words.lacks if lack.said]
    answered += [mark.word for mark in words.marks if any(_is_fabric(entry) for entry in mark.entries)]
    known = {part.lower() for word in answered for part in word.split()}
    return tuple([text for text in unread if not {part.lower() for part in text.split()} <= known])


def _is_fabric(entry: Entry) -> bool:
    return entry.category == "fabrics" and entry.cloth is not None


@cache
def _garment_names() -> list[str]:
    return [word.lower() for entry in all_entries() if entry.category == "garments" for word in entry.words]

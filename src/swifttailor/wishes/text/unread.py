"""What of a text no wish came from, so that nobody takes it for done.

A word counts as understood if it is among the words for something that was read, or if without it something
would not have been read. No word is taken for the nearest known one.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from swifttailor.describing.differences import Change, Gain, Step, subject_of
from swifttailor.wishes.text.clauses import clauses
from swifttailor.wishes.text.flare_starts import flare_figures
from swifttailor.wishes.text.leg_figures import leg_figures
from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wishes.text.text_tokens import LONGEST_TEXT
from swifttailor.wishes.text.tier_heights import tier_figures
from swifttailor.wishes.text.yoke_heights import yoke_figures
from swifttailor.wording.instructions.requests import gain_words, step_words
from swifttailor.wording.wordings import all_wordings

MOST_TESTED = 16
"""Different words of a text that are looked into; nobody reads a longer list, and time is bounded."""
_SAME_CM = 0.05
_WORD = re.compile(r"[^\W\d_]+(?:['’][^\W\d_]+)*")
_PLACE = re.compile(r"{[^}]*}")
_BETWEEN = re.compile(r"[\s-]*")
_MEANT = re.compile(r"\b(?:the|this|that|my|its)[\s-]+$", re.IGNORECASE)
"""Before what a garment is called it is no wish: "make the dress longer", but "make it a dress"."""
_KEEPING = re.compile(r"\W*(?:please\W+)?(?:keep|leave|don['’]?t|do not|never)\b", re.IGNORECASE)
"""Asks for no change."""
_FUNCTION_WORDS = Path(__file__).with_name("function_words.txt")


@dataclass(frozen=True)
class _Place:
    """Something said in a text."""

    start: int
    end: int
    said: str
    """In lower case."""


def not_understood(
    text: str, wishes: Collection[Change], read: Callable[[str], Collection[Change]]
) -> tuple[str, ...]:
    """What of a text no wish came from: words and numbers, those that stand side by side together.

    Args:
        text: As it was read.
        wishes: What was read of it.
        read: Reads another text in the same way: the clauses of this one, and this one without a word.
    """
    text = text[:LONGEST_TEXT]
    asked = frozenset(wishes)
    tested: dict[str, bool] = {}
    missed = list(_numbers(text, wishes))
    parts = clauses(text)
    for start, end in parts:
        words = [word for word in _content_words(text) if start <= word.start < end]
        if all(_may_mean(word.said, asked) for word in words):
            continue
        own = asked if len(parts) == 1 else asked.intersection(read(text[start:end]))
        if not own and _KEEPING.match(text, start, end):
            continue
        for word in words:
            if _may_mean(word.said, asked) or _leads(word.said, own):
                continue
            if word.said not in tested and len(tested) < MOST_TESTED:
                tested[word.said] = asked <= frozenset(read(_without(text, word.said)))
            if tested.get(word.said):
                missed.append(word)
    return tuple(dict.fromkeys(_joined(text, sorted(missed, key=lambda place: place.start))))


def says_nothing_else(text: str, wishes: Collection[Change]) -> bool:
    """Whether all of a text is numbers of wishes and words that are used for their subjects.

    Then it can hardly mean something else, even if the network is not sure of each.
    """
    text = text[:LONGEST_TEXT]
    known = all(_may_mean(word.said, wishes) for word in _content_words(text))
    return known and not any(_numbers(text, wishes))


def _may_mean(word: str, wishes: Collection[Change]) -> bool:
    """Whether a word is used for the subject of a wish."""
    subjects = _subjects_of_words().get(word, frozenset())
    return any(subject_of(wish) in subjects for wish in wishes)


def _leads(word: str, wishes: Collection[Change]) -> bool:
    """Whether a word says that something grows, as "wider" does, and so does a wish of the same clause."""
    directions = _directions_of_words().get(word, frozenset())
    return any(isinstance(wish, Step) and wish.direction in directions for wish in wishes)


def _content_words(text: str) -> Iterator[_Place]:
    numbers = [(m.start, m.end) for m in find_mentions(text)]
    for found in _WORD.finditer(text):
        word = found[0].lower().replace("’", "'")
        if any(start <= found.start() < end for start, end in numbers):
            continue
        if word in _function_words() or (len(word) == 1 and word not in _subjects_of_words()):
            continue
        if word in _garments() and _MEANT.search(text[: found.start()]):
            continue
        yield _Place(found.start(), found.end(), word)


def unread_numbers(text: str, wishes: Collection[Change]) -> tuple[str, ...]:
    """Numbers of a text that are in no wish, as it has them."""
    return tuple(dict.fromkeys(place.said for place in _numbers(text[:LONGEST_TEXT], wishes)))


def _numbers(text: str, wishes: Collection[Change]) -> Iterator[_Place]:
    """Numbers that are in no wish, but "one" and "3/4", which are words."""
    asked = [
        wish.amount if isinstance(wish, Step) else wish.claim.value
        for wish in wishes
        if isinstance(wish, Gain | Step)
    ]
    elsewhere = (*tier_figures(text), *flare_figures(text), *leg_figures(text), *yoke_figures(text))
    for mention in find_mentions(text):
        said = text[mention.start : mention.end]
        if any(start <= mention.start < end for start, end in elsewhere):
            continue
        if not mention.is_length and not re.fullmatch(r"[\d.,]+", said):
            continue
        if not any(isinstance(one, float | int) and abs(one - mention.value) < _SAME_CM for one in asked):
            yield _Place(mention.start, mention.end, said)


def _without(text: str, word: str) -> str:
    return _WORD.sub(lambda found: "" if found[0].lower().replace("’", "'") == word else found[0], text)


def _joined(text: str, places: list[_Place]) -> Iterator[str]:
    start = end = -1
    for place in places:
        if start >= 0 and _BETWEEN.fullmatch(text, end, place.start):
            end = place.end
            continue
        if start >= 0:
            yield text[start:end]
        start, end = place.start, place.end
    if start >= 0:
        yield text[start:end]


@cache
def _subjects_of_words() -> dict[str, frozenset[str]]:
    """What each word of captions and instructions may be about: names of claims and quantities."""
    found: dict[str, set[str]] = {}

    def note(texts: Collection[str], subjects: Collection[str]) -> None:
        for word in _WORD.findall(_PLACE.sub(" ", " ".join(texts)).lower()):
            found.setdefault(word, set()).update(subjects)

    for wording in all_wordings():
        claimed = {claim.name for claim in wording.needs}.union(wording.numbers)
        for texts in wording.texts.values():
            note(texts, claimed)
    for gain in gain_words():
        note(gain.texts, {claim.name for claim in gain.claims})
    for (quantity, _), step in step_words().items():
        note((*step.texts, *step.texts_by), {quantity})
    return {word: frozenset(subjects) for word, subjects in found.items()}


@cache
def _directions_of_words() -> dict[str, frozenset[int]]:
    """The directions that a word leads measures in: of "longer" up, of "narrow" down."""
    found: dict[str, set[int]] = {}
    for (_, direction), step in step_words().items():
        for word in _WORD.findall(_PLACE.sub(" ", " ".join((*step.texts, *step.texts_by))).lower()):
            found.setdefault(word, set()).add(direction)
    return {word: frozenset(directions) for word, directions in found.items() if len(directions) == 1}


@cache
def _garments() -> frozenset[str]:
    """What garments are called."""
    heads = (wording for wording in all_wordings() if wording.form == "head")
    texts = (text for head in heads for some in head.texts.values() for text in some)
    return frozenset(word for text in texts for word in _WORD.findall(_PLACE.sub(" ", text).lower()))


def is_function_word(word: str) -> bool:
    """Whether a word asks for nothing by itself."""
    small = word.lower().replace("’", "'")
    return len(small) == 1 or small in _function_words()


@cache
def _function_words() -> frozenset[str]:
    lines = _FUNCTION_WORDS.read_text(encoding="utf-8").splitlines()
    return frozenset(word for line in lines if not line.startswith("#") for word in line.split())

"""Phrases whose meaning is known: those that instructions are written with, looked up as they stand.

The network generalises, and is unsure about what it has seldom read; a phrase found word for word in a text
needs no guessing. One that can mean two things, or that is negated, is left to the network.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.wishes.text.mentions import Mention
from swifttailor.wording.instructions.requests import gain_words, step_words
from swifttailor.wording.speech import with_articles

_NUMBER = "\0"
"""Stands for a length in a text."""
_GARMENTS = ("garment", "top", "dress", "skirt")
_BANDS = ("waistband", "hem band")
_NEGATED = re.compile(
    r"\b(?:not|never|no|without|don't|doesn't|do not|instead of|rather than)\W+(?:\w+\W+)?$"
)
_VERBS = ("end", "reach", "cover")
"""Before these verbs it is "let the legs", not "make the legs"."""


@dataclass(frozen=True)
class Phrase:
    """A phrase in a text."""

    start: int
    end: int
    changes: tuple[Change, ...]
    """What it asks for."""


def find_phrases(text: str, mentions: list[Mention]) -> list[Phrase]:
    """Known phrases of an instruction, the longest where they overlap.

    Args:
        text: Of any length; the time is in proportion to it.
        mentions: The numbers in it.
    """
    found, origin = [], list(range(len(text) + 1))
    plain = text.lower()
    for mention in reversed([m for m in mentions if m.is_length and m.value > 0]):
        plain = plain[: mention.start] + _NUMBER + plain[mention.end :]
        origin = [*origin[: mention.start + 1], *origin[mention.end :]]
    values = {m.start: m.value for m in mentions}
    for match in _any_phrase().finditer(plain):
        if _NEGATED.search(plain[: match.start()]):
            continue
        changes = _meanings()[match[0]]
        at = match.start() + match[0].find(_NUMBER)
        if _NUMBER in match[0]:
            value = round(values[origin[at]], 2)
            changes = tuple(
                Step(c.quantity, c.direction, value) if isinstance(c, Step) else c for c in changes
            )
        found.append(Phrase(origin[match.start()], origin[match.end()], changes))
    return found


@cache
def _meanings() -> dict[str, tuple[Change, ...]]:
    """What each phrase asks for, without those that are used for two things."""
    meant: dict[str, set[tuple[Change, ...]]] = {}
    for text, changes in _wordings():
        for garment in _GARMENTS:
            for band in _BANDS:
                phrase = text.replace("{garment}", garment).replace("{band}", band).replace("{by}", _NUMBER)
                meant.setdefault(with_articles(_spoken(phrase)).lower(), set()).add(changes)
    return {phrase: next(iter(asked)) for phrase, asked in meant.items() if len(asked) == 1}


def _spoken(phrase: str) -> str:
    for verb in _VERBS:
        phrase = phrase.replace(f"make the legs {verb}", f"let the legs {verb}")
    return phrase


def _wordings() -> Iterator[tuple[str, tuple[Change, ...]]]:
    for (quantity, direction), words in step_words().items():
        for text in (*words.texts, *words.texts_by):
            yield text, (Step(quantity, direction),)
    for wording in gain_words():
        for text in wording.texts:
            yield text, tuple(Gain(claim) for claim in wording.claims)


@cache
def _any_phrase() -> re.Pattern[str]:
    longest_first = sorted(_meanings(), key=len, reverse=True)
    return re.compile(rf"(?<!\w)(?:{'|'.join(map(re.escape, longest_first))})(?!\w)")

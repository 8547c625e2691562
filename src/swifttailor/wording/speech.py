"""Choosing among wordings: what can be said of a garment, in one dialect, without repeating itself."""

from __future__ import annotations

import random
import re
from collections.abc import Collection, Sequence
from functools import lru_cache
from typing import NamedTuple

from swifttailor.describing.claims import Claim
from swifttailor.wording.numbers import Units, is_length, say_measure
from swifttailor.wording.word_tables import Dialect
from swifttailor.wording.wordings import Form, Wording, all_wordings

_MINOR = 0.21
"""Wordings of less weight say what hardly needs saying, such as "no hood"; they are mostly passed over."""
_MINOR_SHARE = 0.07
_PLACE = re.compile(r"\{(\w+)(-?)\}")
_BEFORE_VOWEL = re.compile(r"\b([Aa]) (?=(?!one|uni|U\b)[AEIOUaeiou]|8|11\b|18\b|S-|X|F\b)")


class Phrase(NamedTuple):
    """Something said, and the claims it makes."""

    text: str
    claims: tuple[Claim, ...]
    topics: frozenset[str]
    plural: bool = False


class Speech:
    """One speaker on one garment."""

    def __init__(
        self,
        rng: random.Random,
        claims: Collection[Claim],
        dialect: Dialect,
        units: Units,
        *,
        numbers: bool,
    ) -> None:
        """Prepares to speak.

        Args:
            rng: Chooses the words.
            claims: All that may be claimed.
            dialect: British or American English.
            units: Which system of measures.
            numbers: Whether lengths are stated.
        """
        self.rng, self.dialect, self.units = rng, dialect, units
        self.topics: set[str] = set()
        """What has been spoken of."""
        self.kind = ""
        """What the garment has been called, once that is said."""
        words = frozenset(c for c in claims if isinstance(c.value, str))
        self._measures = {c.name: float(c.value) for c in claims if not isinstance(c.value, str)}
        self._true = _sayable(words, frozenset(self._measures), dialect, numbers)

    def say(self, *forms: Form, about: Collection[str] | None = None) -> Phrase | None:
        """Says one thing that has not been said; None when there is nothing left.

        Args:
            forms: Accepted forms.
            about: Only topics among these; any when None.
        """
        options = [w for w in self._true if w.form in forms and self._fits(w, about)]
        if self.rng.random() > _MINOR_SHARE:
            options = [w for w in options if w.weight >= _MINOR] or [w for w in options if w.form == "head"]
        if not options:
            return None
        chosen = self.rng.choices(options, [w.weight for w in options])[0]
        phrase = self._speak(chosen)
        self.topics |= chosen.topics
        return phrase

    def say_head(self) -> Phrase:
        """Names the garment."""
        phrase = self.say("head")
        assert phrase is not None, "there is a head that claims nothing"
        self.kind = next((str(c.value) for c in phrase.claims if c.name == "kind"), "")
        return phrase

    def say_several(self, count: int, *forms: Form) -> list[Phrase]:
        """Says up to `count` things."""
        said = []
        for _ in range(count):
            phrase = self.say(*forms)
            if phrase is None:
                break
            said.append(phrase)
        return said

    def pick(self, *options: str) -> str:
        """One of some texts."""
        return self.rng.choice(options)

    def listed(self, texts: Sequence[str]) -> str:
        """Texts as a list in words; Americans may put a comma before the last."""
        if len(texts) < 3:
            return " and ".join(texts)
        comma = "," if self.dialect == "us" and self.rng.random() < 0.7 else ""
        return f"{', '.join(texts[:-1])}{comma} and {texts[-1]}"

    def _fits(self, wording: Wording, about: Collection[str] | None) -> bool:
        """Whether it may be said after what was said so far."""
        if wording.topics & self.topics or (about is not None and not wording.topics <= set(about)):
            return False
        return not (wording.kinds and self.kind and self.kind not in wording.kinds)

    def _speak(self, wording: Wording) -> Phrase:
        claims = list(wording.needs)

        def number(place: re.Match[str]) -> str:
            name = place[1]
            if name not in self._measures:
                return place[0]
            said = say_measure(name, self._measures[name], self.units, self.rng, before_noun=place[2] == "-")
            claims.append(said.claim)
            return said.text

        text = _PLACE.sub(number, self.rng.choice(wording.texts[self.dialect]))
        return Phrase(with_articles(text), tuple(claims), wording.topics, wording.plural)


@lru_cache(maxsize=32)
def _sayable(
    words: frozenset[Claim], measures: frozenset[str], dialect: Dialect, numbers: bool
) -> tuple[Wording, ...]:
    """What may be said of a garment at all; kept, since several captions are written of each."""
    return tuple(
        each
        for each in all_wordings()
        if words.issuperset(each.needs)
        and words.isdisjoint(each.avoids)
        and measures.issuperset(each.numbers)
        and (numbers or not any(map(is_length, each.numbers)))
        and each.texts[dialect]
    )


def with_articles(text: str) -> str:
    """Puts ``an`` for ``a`` where it is spoken so."""
    return _BEFORE_VOWEL.sub(r"\1n ", text)


def without_article(text: str) -> str:
    """Leaves out an article at the beginning of a text."""
    for article in ("a ", "an ", "the "):
        if text.startswith(article):
            return text[len(article) :]
    return text

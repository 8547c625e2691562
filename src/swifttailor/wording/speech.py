"""Choosing among wordings: what can be said of a garment, in one dialect, without repeating itself."""

from __future__ import annotations

import random
import re
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field

from swifttailor.describing.claims import Claim
from swifttailor.wording.numbers import Units, is_length, say_measure
from swifttailor.wording.phrases import heads, lower_words, sleeve_words, upper_words
from swifttailor.wording.phrases.phrase import Dialect, Form, Wording

_WORDINGS: tuple[Wording, ...] = (
    *heads.HEADS,
    *upper_words.ADJECTIVES,
    *lower_words.ADJECTIVES,
    *upper_words.FEATURES,
    *sleeve_words.FEATURES,
    *lower_words.FEATURES,
    *upper_words.SENTENCES,
    *sleeve_words.SENTENCES,
    *lower_words.SENTENCES,
    *upper_words.TAGS,
)
_MINOR = 0.21
"""Wordings of less weight say what hardly needs saying, such as "no hood"; they are mostly passed over."""
_MINOR_SHARE = 0.07
_PLACE = re.compile(r"\{(\w+)(-?)\}")
_BEFORE_VOWEL = re.compile(r"\b([Aa]) (?=(?!one|uni|U\b)[AEIOUaeiou]|8|11\b|18\b|S-|X|F\b)")


@dataclass(frozen=True)
class Phrase:
    """Something said, and the claims it makes."""

    text: str
    claims: tuple[Claim, ...]
    topics: frozenset[str]
    plural: bool = False


def all_wordings() -> tuple[Wording, ...]:
    """Everything that captions are written of."""
    return _WORDINGS


@dataclass
class Speech:
    """One speaker on one garment."""

    rng: random.Random
    claims: Collection[Claim]
    """All that may be claimed."""
    dialect: Dialect
    units: Units
    numbers: bool
    """Whether lengths are stated."""
    topics: set[str] = field(default_factory=set)
    """What has been spoken of."""
    kind: str = ""
    """What the garment has been called, once that is said."""

    def __post_init__(self) -> None:
        self._words = {c for c in self.claims if isinstance(c.value, str)}
        self._measures = {c.name: float(c.value) for c in self.claims if not isinstance(c.value, str)}
        self._true = [w for w in _WORDINGS if self._holds(w)]

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

    def say_several(self, count: int, *forms: Form, about: Collection[str] | None = None) -> list[Phrase]:
        """Says up to `count` things."""
        said = []
        for _ in range(count):
            phrase = self.say(*forms, about=about)
            if phrase is None:
                break
            said.append(phrase)
        return said

    def pick(self, *options: str) -> str:
        """One of some texts, those of the other dialect left out."""
        return self.rng.choice(self._in_dialect(options))

    def listed(self, texts: Sequence[str], last: str = "and") -> str:
        """Texts as a list in words; Americans may put a comma before the last."""
        if len(texts) < 3:
            return f" {last} ".join(texts)
        comma = "," if self.dialect == "us" and self.rng.random() < 0.7 else ""
        return f"{', '.join(texts[:-1])}{comma} {last} {texts[-1]}"

    def _holds(self, wording: Wording) -> bool:
        """Whether it may be said of the garment in this dialect at all."""
        return (
            self._words.issuperset(wording.needs)
            and self._words.isdisjoint(wording.avoids)
            and all(n in self._measures for n in wording.numbers)
            and (self.numbers or not any(map(is_length, wording.numbers)))
            and bool(self._in_dialect(wording.texts))
        )

    def _fits(self, wording: Wording, about: Collection[str] | None) -> bool:
        """Whether it may be said after what was said so far."""
        if wording.topics & self.topics or (about is not None and not wording.topics <= set(about)):
            return False
        return not (wording.kinds and self.kind and self.kind not in wording.kinds)

    def _in_dialect(self, texts: Iterable[str]) -> list[str]:
        kept = []
        for text in texts:
            bare, _, dialect = text.partition("@")
            if dialect in ("", self.dialect):
                kept.append(bare)
        return kept

    def _speak(self, wording: Wording) -> Phrase:
        claims = list(wording.needs)

        def number(place: re.Match[str]) -> str:
            name = place[1]
            if name not in self._measures:
                return place[0]
            said = say_measure(name, self._measures[name], self.units, self.rng, before_noun=place[2] == "-")
            claims.append(said.claim)
            return said.text

        text = _PLACE.sub(number, self.pick(*wording.texts))
        return Phrase(with_articles(text), tuple(claims), wording.topics, wording.plural)


def with_articles(text: str) -> str:
    """Puts ``an`` for ``a`` where it is spoken so."""
    return _BEFORE_VOWEL.sub(r"\1n ", text)


def without_article(text: str) -> str:
    """Leaves out an article at the beginning of a text."""
    for article in ("a ", "an ", "the "):
        if text.startswith(article):
            return text[len(article) :]
    return text

"""Words of a text and their places. Hyphens part words; apostrophes do so in French and Italian elisions."""

from __future__ import annotations

import re
from typing import Literal, NamedTuple

from swifttailor.wording.lexicon.inflection import Language

Gap = Literal["space", "hyphen", "pause", "stop"]
"""What stands behind a word: a blank or nothing, a hyphen, a comma or the like, the end of a sentence."""
_EMOJI = "\U0001f300-\U0001faff\u2600-\u27bf"
_TOKEN = re.compile(
    rf"[^\W_]+(?:(?:['\u2019\u02bc](?=[^\W_])|(?<=\d)[./,](?=\d))[^\W_]+)*|[{_EMOJI}]|[-=]>|\u2192"
)
_ELISIONS = {
    "fr": re.compile(r"(?:[cdjlmnst]|qu|jusqu|lorsqu|puisqu)'(?=.)"),
    "it": re.compile(
        r"(?:[cdlmstv]|un|[ds]?all|dell|nell|sull|coll|quell|quest|senz|mezz|tutt|com|bell)'(?=.)"
    ),
}
_HYPHENS = frozenset("-\u2010\u2011\u00ad_")
_OPEN = frozenset(["/", '"', "'", "*", ":", "&"])
_STOPS = frozenset(".;!?\n()[]\u2014\u2013|")


class Token(NamedTuple):
    """A word in a text."""

    word: str
    """In lower case."""
    start: int
    end: int
    gap: Gap


def tokens_of(text: str, language: Language) -> list[Token]:
    """The words of a text in their order.

    Args:
        text: Of any length; the time is in proportion to it.
        language: French parts ``d'été``, Italian ``all'anca``.
    """
    places: list[tuple[int, int]] = []
    elision = _ELISIONS.get(language)
    for found in _TOKEN.finditer(text):
        start, end = found.span()
        if elision is not None:
            elided = elision.match(_lower(found[0]))
            if elided:
                places.append((start, start + elided.end()))
                start += elided.end()
        places.append((start, end))
    tokens = []
    for k, (start, end) in enumerate(places):
        following = places[k + 1][0] if k + 1 < len(places) else len(text)
        tokens.append(Token(_lower(text[start:end]).rstrip("'"), start, end, _gap(text[end:following])))
    return tokens


def words_of(word: str, language: Language) -> list[str]:
    """The parts of a word of a table, in lower case."""
    if word.isascii() and "'" not in word and "/" not in word and "." not in word:
        return word.lower().replace("-", " ").split()
    if "#" in word:
        return [part for piece in word.split("#") for part in (*words_of(piece, language), "#")][:-1]
    return [token.word for token in tokens_of(word, language)]


def _gap(between: str) -> Gap:
    if between in ("", " "):
        return "space"
    if between.strip("'\u2019") in _HYPHENS:
        return "hyphen"
    if not _STOPS.isdisjoint(between):
        return "stop"
    return "space" if between.isspace() or between.strip() in _OPEN else "pause"


def _lower(word: str) -> str:
    return (
        word.lower()
        .replace("\u2019", "'")
        .replace("\u02bc", "'")
        .replace("->", "\u2192")
        .replace("=>", "\u2192")
    )

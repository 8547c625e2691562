"""Which words of a text belong to which entries, in the language of the text and in English."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

from swifttailor.wording.lexicon.inflection import LANGUAGES, SHORTEST, Language
from swifttailor.wording.lexicon.interposed import colors_first, lengths_first, names_together, with_dress
from swifttailor.wording.lexicon.tokens import Gap, Token, tokens_of
from swifttailor.wording.lexicon.vocabulary import NUMBER, Sense, Vocabulary, vocabulary

_FEW = 0.25
"""Where a larger share of the words is unknown in English, other languages are tried."""
_NEARLY_ALL = 0.75
"""Where at least as many words are of one other language, it is tried beside a few unknown ones as well."""
_HALF = 0.5
"""Some languages share so many words with English that at least so many have to be theirs."""
_SHARING: frozenset[Language] = frozenset(["it", "nl", "pt"])
"""These languages: "in", "over", "top" and "is" are Dutch, "no" and "in" Italian."""
_ALSO_FOREIGN: Mapping[str, Language] = {"gonna": "it", "rock": "de"}
"""Words of English that name garments elsewhere: English where not all of the text is of that language."""
_NOUNS_FIRST: Mapping[str, Language] = {"robe": "fr", "salopette": "fr"}
"""Words of English that name other garments where they stand first: "robe bustier", not "satin robe"."""
_ROMANCE: frozenset[Language] = frozenset(["es", "fr", "it", "pt"])
"""Their adjectives stand behind nouns, within names: "vestido rojo de flamenca"."""
_JOINED = 3
"""Letters of each of two words that may be one word of the tables: "jump suit"."""
_LINKS: Mapping[Language, tuple[str, ...]] = {
    "de": ("", "s", "n", "en", "es", "er"),
    "nl": ("", "s", "en", "e", "n"),
}
"""Between the words of a compound, of those languages that write it as one."""
_SHORTEST_HALF = 3
_SAYS_NOTHING = frozenset(["function", "polite", "negations", "degrees", "numbers"])
"""Categories of short words, of which one language has what is a slip in another: "em", "ad", "nee"."""
LONGEST_TEXT = 20_000
"""Characters; what stands behind them is not read."""


_Piece = tuple[int, tuple[Sense, ...]]
"""How many words, and what they mean."""


class Found(NamedTuple):
    """A stretch of a text that is one word of the tables, or unknown."""

    start: int
    end: int
    word: str
    """In lower case."""
    senses: tuple[Sense, ...]
    """All of its meanings; none where it is unknown."""
    gap: Gap
    """What stands behind it."""


@lru_cache(maxsize=32)
def find_words(text: str, language: Language | None = None) -> tuple[Language, tuple[Found, ...]]:
    """The words of a text with their meanings, each exactly once and in their order.

    Args:
        text: Its first `LONGEST_TEXT` characters are read.
        language: Its language; when None, the one that knows most of its words, and English where several do.
    """
    text = text[:LONGEST_TEXT]
    if language is not None:
        return language, _found(text, language)
    english = _found(text, "en")
    unknown = sum(not found.senses for found in english)
    alike = next((_ALSO_FOREIGN[found.word] for found in english if found.word in _ALSO_FOREIGN), None)
    if alike is None and len(english) > 1:
        alike = _NOUNS_FIRST.get(text.split()[0].lower()) if text.split() else None
    if alike is not None and _is_wholly_of(text, alike):
        return alike, _found(text, alike)
    others = LANGUAGES[1:]
    if unknown <= _FEW * len(english):
        others = tuple([each for each in others if unknown and _share_of(text, each) >= _NEARLY_ALL])
    readings: dict[Language, tuple[Found, ...]] = {"en": english}
    readings |= {other: _found(text, other) for other in others}
    best = min(
        [each for each in readings if each not in _SHARING or _is_of(readings[each])],
        key=lambda each: (_unknown(readings[each]), each != "en", not _has_own(readings[each])),
    )
    return best, readings[best]


def _is_of(words: Sequence[Found]) -> bool:
    """Whether a text is of a language that shares words with English.

    Half of it is, and more than a quarter, something of clothes among it, are words that English has not.
    """
    own = [found for found in words if any(sense.entry.english is not None for sense in found.senses)]
    if len(own) == len(words) > 1:
        return True
    alone = [f for f in own if not vocabulary("en").find(f.word.replace("-", " ").split())]
    told = any(
        found.senses[0].entry.category not in _SAYS_NOTHING and max(map(len, found.word.split())) >= SHORTEST
        for found in alone
    )
    return told and len(own) >= _HALF * len(words) and len(alone) > _FEW * len(words)


def _is_wholly_of(text: str, language: Language) -> bool:
    tokens = [token for token in tokens_of(text, language) if not token.word[0].isdigit()]
    return all(senses for _, senses in _parted(tokens, [vocabulary(language)]))


def _share_of(text: str, language: Language) -> float:
    """The share of the words of a text that are those of a language."""
    pieces = _parted(tokens_of(text, language), [vocabulary(language)])
    return sum(bool(senses) for _, senses in pieces) / max(len(pieces), 1)


def _unknown(words: Sequence[Found]) -> int:
    return sum(len(found.word) for found in words if not found.senses)


def _has_own(words: Sequence[Found]) -> bool:
    """Whether more than short words are no English: "costume de pirate" is French, "de" alone German."""
    return any(
        sense.entry.english is not None and sense.entry.category not in _SAYS_NOTHING
        for found in words
        for sense in found.senses
    )


@lru_cache(maxsize=32)
def _found(text: str, language: Language) -> tuple[Found, ...]:
    tokens = tokens_of(text, language)
    vocabularies = [vocabulary(language)] + ([] if language == "en" else [vocabulary("en")])
    if language == "en":
        tokens = lengths_first(with_dress(tokens, vocabularies[0]), vocabularies[0])
        tokens = colors_first(tokens, vocabularies[0])
    elif language in _ROMANCE:
        tokens = names_together(tokens, vocabularies[0])
    found: list[Found] = []
    k = 0
    for count, senses in _parted(tokens, vocabularies):
        first, last = tokens[k], tokens[k + count - 1]
        halves = _halves(first, vocabularies[0]) if not senses and language in _LINKS else ()
        if halves:
            found += halves
        elif senses or first.word.isalnum() or "'" in first.word:
            word = " ".join([token.word for token in tokens[k : k + count]])
            found.append(Found(first.start, last.end, word, senses, last.gap))
        k += count
    return tuple(found)


def _parted(tokens: Sequence[Token], vocabularies: Sequence[Vocabulary]) -> list[_Piece]:
    """The text in pieces: the fewest unknown ones, then the fewest, then the longest at the end.

    English compounds have their head at the end: "sleeveless shirt dress" is a sleeveless shirt dress.
    """
    costs = [(0, 0)] * (len(tokens) + 1)
    pieces: list[_Piece] = [(1, ())] * len(tokens)
    for k in range(len(tokens) - 1, -1, -1):
        best = None
        for count, senses in _candidates(tokens, k, vocabularies):
            unknown, number = costs[k + count]
            cost = unknown + (not senses), number + 1
            if best is None or cost < best:
                best, pieces[k] = cost, (count, senses)
        assert best is not None
        costs[k] = best
    found, k = [], 0
    while k < len(tokens):
        found.append(pieces[k])
        k += pieces[k][0]
    return found


def _candidates(tokens: Sequence[Token], k: int, vocabularies: Sequence[Vocabulary]) -> list[_Piece]:
    """The words of the tables that begin with the k-th word, and it alone."""
    word = tokens[k].word
    longest = max([v.longest.get(word, 1) for v in vocabularies])
    if word[0].isdigit():
        longest = max([longest, *[v.longest.get(NUMBER, 1) for v in vocabularies]])
    found = []
    parts: list[str] = []
    for count in range(1, min(longest, len(tokens) - k) + 1):
        parts.append(tokens[k + count - 1].word)
        senses = _senses(parts, vocabularies)
        if senses or count == 1:
            found.append((count, senses))
        if tokens[k + count - 1].gap not in ("space", "hyphen"):
            return found
    if longest < 2 or len(found) < 2:
        senses = _as_one(tokens, k, vocabularies)
        if senses:
            found.append((2, senses))
    return found


def _senses(parts: list[str], vocabularies: Sequence[Vocabulary]) -> tuple[Sense, ...]:
    """The meanings of some words in the first vocabulary that has any, as they stand or with any number."""
    figures = any(part[0].isdigit() for part in parts)
    for known in vocabularies:
        senses = known.find(parts) or (known.find(_numbered(parts)) if figures else ())
        if senses:
            return senses
    return ()


def _as_one(tokens: Sequence[Token], k: int, vocabularies: Sequence[Vocabulary]) -> tuple[Sense, ...]:
    """The meanings of two words that the tables write as one.

    What is worn beside a garment is none of them where both are known: "high neck lace blouse".
    """
    if k + 1 >= len(tokens) or tokens[k].gap not in ("space", "hyphen"):
        return ()
    first, second = tokens[k].word, tokens[k + 1].word
    if min(len(first), len(second)) < _JOINED or not (first + second).isalpha():
        return ()
    for known in vocabularies:
        senses = known.find([first + second])
        if senses and known.find([first]) and known.find([second]):
            senses = tuple([sense for sense in senses if sense.entry.category != "accessories"])
        if senses:
            return senses
    return ()


def _numbered(parts: list[str]) -> list[str]:
    """Any number in place of those in figures."""
    return [NUMBER if part[0].isdigit() else part for part in parts]


def _halves(token: Token, known: Vocabulary) -> tuple[Found, ...]:
    """The two words that a compound is made of: both known, or an unknown one before a garment."""
    word = token.word
    garment: tuple[Found, ...] = ()
    for cut in range(_SHORTEST_HALF, len(word) - _SHORTEST_HALF + 1):
        tail = known.find([word[cut:]])
        if not tail or tail[0].entry.category in _SAYS_NOTHING:
            continue
        middle = token.start + cut
        behind = Found(middle, token.end, word[cut:], tail, token.gap)
        if (
            not garment
            and tail[0].entry.category == "garments"
            and min(cut, len(word) - cut) > _SHORTEST_HALF
        ):
            garment = (Found(token.start, middle, word[:cut], (), "space"), behind)
        for link in _LINKS[known.language]:
            stem = word[: cut - len(link)]
            if word[:cut].endswith(link) and len(stem) >= _SHORTEST_HALF:
                head = known.find([stem]) or known.find([stem + "e"])
                if head and head[0].entry.category not in ("function", "polite", "negations", "numbers"):
                    return Found(token.start, middle, word[:cut], head, "space"), behind
    return garment

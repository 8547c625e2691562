"""Words within names: a "milkmaid midi dress" is a midi milkmaid dress, "cropped white jeans" are white."""

from __future__ import annotations

import re
from collections.abc import Sequence

from swifttailor.wording.lexicon.tokens import Token
from swifttailor.wording.lexicon.vocabulary import Sense, Vocabulary

_LENGTHS = frozenset(["micro", "mini", "midi", "midaxi", "maxi", "short", "long", "cropped", "crop"])
"""Words for how long a garment is that shops put right before its noun."""
_OF_SKIRTS = frozenset(["mini", "midi", "midaxi", "maxi"])
"""Those that stand for a dress where no noun follows: "a corset midi"."""
_COATS = frozenset(["coat", "jacket"])
"""What stays itself before such a length: a coat midi is no coat dress."""
_LENGTH = "length"
"""Ends a length of two words: "knee length"."""
_TOGETHER = ("space", "hyphen")
_LONGEST = 3
"""Words of a name before its noun, at most."""
_DRESS, _SKIRT = "dress", "skirt"
_OWNED = re.compile(r"(?:'s|s')$")
"""Of words for wearers: "a girl's red dress" is a red dress for a girl."""
_OF = frozenset(["de", "du", "des", "d'", "da", "do", "di", "della", "a", "à", "con", "com", "en", "in"])
"""What joins a noun and what tells of it in Romance languages."""
_WITHIN, _BEHIND = 2, 4
"""How many words may part them, and how many a name goes on for behind its noun, at most."""


def lengths_first(tokens: Sequence[Token], known: Vocabulary) -> list[Token]:
    """The words of a text, with lengths before the names that they stand in.

    Nothing is moved where the words are a name as they stand: a denim mini skirt.

    Args:
        tokens: In the order of the text.
        known: The words of the language.
    """
    moved = list(tokens)
    for k in range(1, len(moved)):
        if moved[k].word not in _LENGTHS and moved[k].word != _LENGTH:
            continue
        first = k - 1 if moved[k].word == _LENGTH else k  # of the words of the length
        if first < 1 or not all(token.gap in _TOGETHER for token in moved[first - 1 : k]):
            continue
        begin = _begin_of_name(moved, first, k, known)
        if begin is not None:
            name, length = moved[begin:first], moved[first : k + 1]
            length[-1] = length[-1]._replace(gap="space")
            moved[begin : k + 1] = [*length, *name]
    return moved


def colors_first(tokens: Sequence[Token], known: Vocabulary) -> list[Token]:
    """The words of a text, with colours before the names that they stand in: "cropped white jeans".

    Not behind what is a garment itself: a "shirt white dress" may be two.

    Args:
        tokens: In the order of the text.
        known: The words of the language.
    """
    moved = list(tokens)
    for k in range(1, len(moved) - 1):
        spans = [end for end in (k + 2, k + 1) if end < len(moved) and _is_color(moved[k:end], known)]
        if not spans:
            continue
        noun = moved[spans[0]].word
        for begin in range(max(0, k - _LONGEST), k):
            before = [token.word for token in moved[begin:k]]
            colored = [token.word for token in moved[begin : spans[0]]]
            if any(token.gap not in _TOGETHER for token in moved[begin : spans[0]]):
                continue
            if _names(known.find(before[-1:])) or _names(known.find([*colored, noun])):
                continue
            # "Dark green" is one colour; "hi vis" of "hi vis orange" is of the jacket that is so called.
            if len(before) == 1 and _is_color(moved[begin : spans[0]], known):
                continue
            if any(_OWNED.search(word) for word in before):
                continue
            if _names(known.find([*before, noun])) and _names(known.find([noun])):
                color = moved[k : spans[0]]
                color[-1] = color[-1]._replace(gap="space")
                moved[begin : spans[0]] = [*color, *moved[begin:k]]
                break
    return moved


def _is_color(tokens: Sequence[Token], known: Vocabulary) -> bool:
    senses = known.find([token.word for token in tokens])
    return bool(senses) and all(sense.entry.category == "colors" for sense in senses)


def names_together(tokens: Sequence[Token], known: Vocabulary) -> list[Token]:
    """The words of a text of a Romance language, with adjectives behind the names that they stand in.

    So a "falda negra de flamenca" is one, and black. Nothing is moved where a noun and its adjective are a
    name themselves, as "vestido largo".

    Args:
        tokens: In the order of the text.
        known: The words of the language.
    """
    moved = list(tokens)
    for k in range(1, len(moved)):
        for within in range(1, _WITHIN + 1):
            link = k + within
            if link >= len(moved) or moved[link].word not in _OF:
                continue
            end = _end_of_name(moved, k, link, known)
            if end is None:
                continue
            within_name, behind = moved[k:link], moved[link:end]
            last = behind[-1].gap
            behind[-1] = behind[-1]._replace(gap="space")
            within_name[-1] = within_name[-1]._replace(gap=last)
            moved[k:end] = [*behind, *within_name]
            break
    return moved


def _end_of_name(tokens: Sequence[Token], first: int, link: int, known: Vocabulary) -> int | None:
    """Where the longest name ends whose noun stands before `first` and goes on at `link`."""
    noun, within = tokens[first - 1].word, [token.word for token in tokens[first:link]]
    if not _names(known.find([noun])) or _names(known.find([noun, *within])):
        return None
    if any(word in _OF or _says_nothing(known.find([word])) for word in within):
        return None
    for end in range(min(link + _BEHIND, len(tokens)), link + 1, -1):
        if any(token.gap not in _TOGETHER for token in tokens[first - 1 : end - 1]):
            continue
        if _names(known.find([noun, *[token.word for token in tokens[link:end]]])):
            return end
    return None


def _begin_of_name(tokens: Sequence[Token], first: int, last: int, known: Vocabulary) -> int | None:
    """Where the longest name begins that a length parts from its noun."""
    if last + 1 >= len(tokens) or tokens[last].gap not in _TOGETHER:
        return None
    noun = tokens[last + 1].word
    for begin in range(max(0, first - _LONGEST), first):
        before = [token.word for token in tokens[begin:first]]
        if any(token.gap not in _TOGETHER for token in tokens[begin:first]) or before[-1] in _LENGTHS:
            continue
        as_it_stands = [token.word for token in tokens[begin : last + 1]] + [noun]
        if _names(known.find(as_it_stands)):
            return None
        if _names(known.find([*before, noun])):
            return begin
    return None


def with_dress(tokens: Sequence[Token], known: Vocabulary) -> list[Token]:
    """The words of a text, with the noun that shops leave away behind a length: "a corset midi".

    Only where what stands before is worn itself, or is said of dresses and not of skirts.
    """
    whole: list[Token] = []
    for k, token in enumerate(tokens):
        whole.append(token)
        if k < 1 or token.word not in _OF_SKIRTS or tokens[k - 1].gap not in _TOGETHER:
            continue
        behind = tokens[k + 1].word if token.gap in _TOGETHER and k + 1 < len(tokens) else None
        if behind is not None and not _says_nothing(known.find([behind])):
            continue
        before = tokens[k - 1].word
        if before in _COATS:
            continue
        worn = _names(known.find([before])) or not known.find([before, _SKIRT])
        if worn and _names(known.find([before, _DRESS])) and not known.find([before, token.word]):
            whole[-1] = token._replace(gap="space")
            whole.append(Token(_DRESS, token.end, token.end, token.gap))
    return whole


def _says_nothing(senses: Sequence[Sense]) -> bool:
    """Whether a word only joins: "in", "with"."""
    return any(sense.entry.category in ("function", "negations") for sense in senses)


def _names(senses: Sequence[Sense]) -> bool:
    return any(sense.entry.category == "garments" for sense in senses)

"""Lengths that stand within names, as shops write them: a "milkmaid midi dress" is a midi milkmaid dress."""

from __future__ import annotations

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

"""Sets: two garments of one cloth, colour and print, unless each has its own."""

from __future__ import annotations

import re
from collections.abc import Sequence, Set

from swifttailor.wishes.outfits.outfit_chunks import Chunk
from swifttailor.wording.lexicon import WordMark
from swifttailor.wording.lexicon.outfits import named_outfit
from swifttailor.wording.lexicon.tokens import words_of
from swifttailor.wording.lexicon.vocabulary import vocabulary

MATCHING = re.compile(
    r"(?<!\w)(?:(?:all |both )?(?:in|of|from|out of) (?:the|a) same "
    r"(?:fabric|cloth|material|print|pattern|colou?r)s?(?: as (?:the|it)(?: \w+)?)?|(?:made )?to match"
    r"|(?:an? )?(?:matching |co-?ordinated )?set of(?= an? )|(?:matching )?set of|co-?ordinat(?:ing|ed)"
    r"|matching|passend\w*|assortie?s?|a juego|aus demselben stoff)(?!\w)",
    re.IGNORECASE,
)
"""What says that one is in the colour and the cloth of the other."""
_SET = re.compile(
    r"(?<!\w)(?:(?:as|for) (?:an? )?)?(?:matching |(?:two|2)[- ]?piece )?(?:sets?|twin ?set)"
    r"(?![\w-]|[ -]in (?:sleeve|arm)|[ -]in$)",
    re.IGNORECASE,
)
"""What says the same behind their names: "hoodie and joggers set"."""
COLORS, CLOTHS = ("colors", "shades", "prints"), ("fabrics",)
_MOODS = "occasions"
"""What tells of two garments as people wear them, each of its own cloth: "old money"."""
_NIGHTWEAR = "pyjama"
"""What sets are of whose other names have nothing of it: PJs, jammies, pajamas."""
_SWIMWEAR = ("tankini", "bikini", "swim", "rash")
"""First words of tops to swim in: skirts and shorts beside them are to swim in, too."""
_MERE = ("bottoms", "bottom", "top")
"""Names of garments that say where they are worn, and no more."""
LEGS_TOO = re.compile(
    r"(?P<upper>(?<!\w)(?:sleeves|arms))(?P<and>\s*(?:and|&|\+)\s*)"
    r"(?P<lower>(?:the |both )?(?:legs|trousers)(?!\w))",
    re.IGNORECASE,
)
"""Places on both, in one phrase: stripes down the sleeves and legs."""


def is_one_cloth(text: str, outfits: Sequence[WordMark]) -> bool:
    """Whether both garments are of one cloth: a suit, pyjamas, a set.

    Args:
        text: That was read.
        outfits: Names of several garments in it.
    """
    sets = [mark for mark in outfits if not is_a_mood(mark)]
    named = any(named_outfit(mark.word, mark.entries) is not None for mark in sets)
    return named or MATCHING.search(text) is not None or _SET.search(text) is not None


def is_a_mood(mark: WordMark) -> bool:
    """Whether a word tells how people are dressed, and names no clothes."""
    return bool(mark.entries) and all(entry.category == _MOODS for entry in mark.entries)


def set_words(text: str) -> list[tuple[int, int]]:
    """Where the words stand that say so, and mean nothing in a text of one garment."""
    return [(found.start(), found.end()) for of in (MATCHING, _SET) for found in of.finditer(text)]


def in_the_set(word: str, name: str, called: str) -> str:
    """The name of a garment as one of its set: of pyjamas, trousers are pyjama trousers.

    Args:
        word: As the text has it.
        name: Of what the set usually has there: "pyjama bottoms".
        called: The name of the set: "pyjamas".
    """
    kind, _, _ = name.rpartition(" ")
    kind = kind.split()[-1] if kind else ""
    if not kind or (kind not in called.lower() and kind != _NIGHTWEAR):
        return word
    return _named_as(kind, word)


def like_the_other(word: str, other: str) -> str:
    """The name of a garment that says nothing but where it is worn, as one of a set with the other.

    Args:
        word: As the text has it: "bottoms".
        other: Name of the other garment: "scrub top".
    """
    first = other.lower().split()[0]
    if first in _SWIMWEAR and word.lower() in ("skirt", "shorts"):
        return _named_as("swim", word)
    return _named_as(other.split()[0], word) if word.lower() in _MERE and " " in other else word


def _named_as(kind: str, word: str) -> str:
    """A name with a kind before its noun, where that is a name, too."""
    *before, noun = word.split()
    told = " ".join([kind, noun])
    senses = vocabulary("en").find(words_of(told.lower(), "en"))
    known = any(sense.entry.category == "garments" for sense in senses)
    return " ".join([*before, told]) if known and kind.lower() not in word.lower().split() else word


def says(chunk: Chunk, of: Sequence[str], apart: Set[int] = frozenset()) -> bool:
    """Whether a chunk has looks of some categories that are said of all of a garment.

    Args:
        chunk: Of a text.
        of: Categories of words: `COLORS`, `CLOTHS`.
        apart: Identities of words that are said of parts of it.
    """
    return any(
        m.entries and m.entries[0].category in of and not m.denied and id(m) not in apart for m in chunk.marks
    )

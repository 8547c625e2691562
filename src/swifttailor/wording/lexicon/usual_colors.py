"""The colours that names usually go with, where a text names none: a gymslip is navy."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

from swifttailor.wording.lexicon.entries import Entry
from swifttailor.wording.lexicon.tokens import words_of
from swifttailor.wording.lexicon.vocabulary import WORDS, vocabulary
from swifttailor.wording.word_tables import read_table

TABLE = "usual_colors.txt"
_CLOTHS = "cloths"
"""The section of the names of cloths."""
_NAMED = frozenset(["garments", "fabrics", "occasions"])
"""Categories whose words have such colours."""


def usual_color(word: str, entry: Entry) -> str | None:
    """The colour that goes with a word of a text, sRGB as ``rrggbb``; None where none does.

    Args:
        word: As the text has it, in the plural, too.
        entry: That it belongs to.
    """
    if entry.category not in _NAMED:
        return entry.color
    own = words_of((entry.english or word).lower(), "en")
    keys = [" ".join(own), *[" ".join(words_of(s.word, "en")) for s in vocabulary("en").find(own)]]
    for key in keys:  # of names with two spellings, "qi pao", the one that was said
        found = _colors().get(key)
        if found is not None and not (found.of_cloth and entry.category == "garments"):
            return found.rgb
    return entry.color


@dataclass(frozen=True)
class _Usual:
    """What a row says of a word."""

    rgb: str
    of_cloth: bool
    """Whether the word names a cloth there: a teddy of silk is not of teddy's colour."""


@cache
def _colors() -> Mapping[str, _Usual]:
    """The colours of the table, by the words of the English tables."""
    found: dict[str, _Usual] = {}
    for row in read_table(WORDS / TABLE):
        rgb = row.options.get("rgb", ())
        if len(rgb) != 1 or len(row.options) > 1 or row.claims or row.words or row.numbers:
            row.wrong("one mark stands on the left, as in rgb:1f2a44.")
        for text in row.texts:
            key = " ".join(words_of(text, "en"))
            if key in found:
                row.wrong(f"'{text}' stands here twice.")
            if not any(s.entry.category in _NAMED for s in vocabulary("en").senses.get(key, ())):
                row.wrong(f"'{text}' names no garment, cloth or occasion in the English tables.")
            found[key] = _Usual(rgb[0], row.section == _CLOTHS)
    return found

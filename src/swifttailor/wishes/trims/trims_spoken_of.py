"""Trims that a text refuses, and texts that are about nothing else."""

from __future__ import annotations

from swifttailor.pattern.trims.names import TRIMS
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.trims.trims_of import TRIMS_OF
from swifttailor.wording.lexicon import WordReading

_DETAILS = "styles"
"""Category of words about details; those of garments are not refused with these."""


def refused_trims(heard: Heard) -> frozenset[str]:
    """Trims that a text does not want: "without pockets"."""
    if heard.words is None:
        return frozenset()
    found: set[str] = set()
    for mark in heard.words.marks:
        for entry in mark.entries if mark.denied else ():
            if entry.category == _DETAILS or mark.word.lower() in TRIMS:  # not those of jeans: "no jeans"
                found |= set(entry.trims) or {name for key in entry.cannot for name in TRIMS_OF.get(key, ())}
    return frozenset(found | {"drawstring"} if "lacing" in found else found)


def speaks_of_trims_alone(words: WordReading) -> bool:
    """Whether a text speaks of nothing else that garments have: "remove the kangaroo pocket".

    A network that has never heard of them guesses what else may be meant.
    """
    told = [
        entry
        for mark in words.marks
        for entry in mark.entries
        if entry.category not in ("function", "negations")
    ]
    of_trims = all(e.category == _DETAILS and any(what in TRIMS_OF for what in e.cannot) for e in told)
    return bool(told) and of_trims and all(mark.entries for mark in words.marks)

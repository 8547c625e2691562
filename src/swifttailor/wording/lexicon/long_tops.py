"""Tops that are as long as dresses: a tunic to the knee is measured and cut as one, a jacket as a coat."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from swifttailor.describing.claims import Claim

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.reading import Implication, WordMark, WordReading

_TOPS = frozenset({"top", "tunic"})
_LONG = frozenset({"above the knee", "knee", "below the knee", "midi", "ankle", "floor"})
_CROPPED = Claim("top_hem", "cropped")
_OTHERS = ("second", "theirs", "like", "part")
_HALF_WAY = re.compile(r"(?:mid|middle|half).*thigh", re.IGNORECASE)
_BESIDE = 4
"""Words before a length among which the other thing may stand that is so long."""


def with_long_tops(implied: Sequence[Implication], marks: Sequence[WordMark]) -> list[Implication]:
    """What follows from a text, with a dress of that hem in place of a top that ends at the knee or lower.

    Args:
        implied: What follows from its words.
        marks: Its words.
    """
    named = [i for i in implied if i.claim.name == "kind"]
    tops = [i for i in named if i.mark.role == "garment" and i.claim.value in _TOPS]
    if not tops or len(tops) < len(named) or _names_others(marks):
        return list(implied)
    tunic = any(i.claim.value == "tunic" for i in tops)
    hems = (_hem(marks, k) or (None if tunic else _thigh(marks, k)) for k in range(len(marks)))
    hem = next((found for found in hems if found is not None), None)
    if hem is None:
        return list(implied)
    mark, claim = hem
    if any(_CROPPED in e.claims("certain", "usual") for m in marks if not m.denied for e in m.entries):
        return [i for i in implied if i.mark is not mark]  # which is told as a contradiction
    kept = [i for i in implied if i.claim.name not in ("skirt_hem", "top_hem")]
    kept = [replace(i, claim=Claim("kind", "dress")) if i in tops else i for i in kept]
    return [*kept, replace(tops[0], claim=claim, certainty="certain", said=True, mark=mark)]


def _names_others(marks: Sequence[WordMark]) -> bool:
    """Whether it names what may be so long instead: a skirt, trousers."""
    return any(
        entry.category == "garments" and not entry.kinds <= _TOPS for mark in marks for entry in mark.entries
    )


def _hem(marks: Sequence[WordMark], k: int) -> tuple[WordMark, Claim] | None:
    mark = marks[k]
    if not _is_length(marks, k):
        return None
    claims = [claim for entry in mark.entries for claim in entry.claims("certain")]
    claim = next((c for c in claims if c.name == "skirt_hem" and c.value in _LONG), None)
    if claim is None or (claim.value == "floor" and "full" in mark.word.lower()):
        return None
    return mark, claim


def _thigh(marks: Sequence[WordMark], k: int) -> tuple[WordMark, Claim] | None:
    """The hem of a top that ends half-way down the thigh, where tunics may end that are no dresses."""
    half_way = _is_length(marks, k) and _HALF_WAY.search(marks[k].word) is not None
    return (marks[k], Claim("skirt_hem", "mini")) if half_way else None


def _is_length(marks: Sequence[WordMark], k: int) -> bool:
    """Whether a word tells how long the top is, and not something beside it."""
    mark = marks[k]
    if mark.denied or mark.role != "word" or not mark.entries or mark.entries[0].category != "lengths":
        return False
    before = marks[_clause_starts(marks, k) : k]
    return not any(m.role in _OTHERS or m.part in ("sleeves", "slit") for m in before)


def _clause_starts(marks: Sequence[WordMark], k: int) -> int:
    """The first of the words before one that stand in its clause: "long sleeves, to the knee" is two."""
    j = k
    while j > max(0, k - _BESIDE) and marks[j].start - marks[j - 1].end <= 1:
        j -= 1
    return j


def kinds_outgrown(words: WordReading) -> tuple[Claim, ...]:
    """Kinds that a garment is too long for, although its name is one of them.

    Args:
        words: Of a text.
    """
    kind = next((i for i in words.implications if i.claim == Claim("kind", "dress")), None)
    if kind is None or kind.mark.role != "garment":
        return ()
    names = frozenset().union(*[entry.kinds for entry in kind.mark.entries])
    if not names or not names <= _TOPS:
        return ()
    mini = any(i.claim == Claim("skirt_hem", "mini") for i in words.implications)  # as tunics may be
    return tuple([Claim("kind", name) for name in sorted(_TOPS - {"tunic"} if mini else _TOPS)])

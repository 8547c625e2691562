"""Amounts of changes: by how much, to how much, and one more or one fewer of what is counted."""

from __future__ import annotations

import re
from collections.abc import Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.wishes.mentions import Mention
from swifttailor.wishes.spoken_clauses import SpokenClause

_TO = re.compile(r"(?<!\w)(?:to|auf|à|a|at|becomes?)\s*(?:about|around|roughly|exactly)?\s*$")
_SMALLEST_CM = 10.0
"""A bare number from here on is a measure in cm."""
_COUNTED = {"tiers": "tier|tiers|row|rows|stufe|stufen|étage|étages", "godets": "godet|godets"}
_ONE_MORE = re.compile(
    r"(?<!\w)(?:another|one more|an extra|an additional|extra|add an?|add one)"
    r"(?: [\w'’]+)?? (?P<what>[\w'’]+)"
)
_SOME_MORE = re.compile(
    r"(?:(?:another|add) (?P<one>\w+)|(?P<other>\w+) (?:more|extra|additional)) (?P<what>[\w'’]+)"
)
SIGNED = re.compile(r"(?:[+\-\u2212]|(?<!\w)(?:plus|minus))\s*$")
"""Before a number without a unit, which is in cm then: "sleeve +4"."""
_MORE_BEFORE = re.compile(r"(?:(?<!\w)(?:plus|extra|add|adding|another|gain)(?: about)?\s*|\+\s*)$")
_MORE_BEHIND = re.compile(r"\s*(?:more|extra|plus)(?!\w)(?!\s+\w*(?:er|long|wide|deep)(?!\w))")
_CAREFUL_CM = 6.0
"""A step of no stated size where something beyond it is refused: "shorter, but not mini"."""
_NUMBERS = {"two": 2.0, "three": 3.0, "four": 4.0, "2": 2.0, "3": 3.0, "4": 4.0}


def is_more_by(text: str, numbers: Sequence[Mention]) -> bool:
    """Whether a length is to be added: "add 6 cm", "4 cm more"."""
    return any(
        (m.is_length or SIGNED.search(text[: m.start]))
        and (_MORE_BEFORE.search(text[: m.start]) or _MORE_BEHIND.match(text, m.end))
        for m in numbers
    )


def by_little(change: Change) -> Change:
    """A change of no said amount, kept small: "longer, but not too long"."""
    if isinstance(change, Step) and change.amount is None:
        return Step(change.quantity, change.direction, _CAREFUL_CM)
    return change


def is_target(text: str, mention: Mention) -> bool:
    """Whether a number is where a measure is to end: "to 52 cm"."""
    return _TO.search(text[: mention.start]) is not None


def to_target(changes: Sequence[Change], mention: Mention) -> tuple[Change, ...]:
    """Steps that lead to a measure that is stated, as that measure.

    Args:
        changes: Of a clause whose number says where they lead.
        mention: The number.
    """
    found: list[Change] = []
    for change in changes:
        stated = QUANTITIES[change.quantity].stated if isinstance(change, Step) else None
        if stated is None or (not mention.is_length and mention.value < _SMALLEST_CM):
            found.append(change)
        else:
            found.append(Gain(Claim(stated.claim, round(mention.value, 2))))
    return tuple(found)


def more_of_them(said: str) -> tuple[Change, ...]:
    """Pieces that are to be added: "another tier", "add two tiers".

    Args:
        said: A clause in lower case.
    """
    for quantity, words in _COUNTED.items():
        named = re.compile(words)
        several = _SOME_MORE.search(said)
        if several is not None and named.fullmatch(several["what"]):
            count = _NUMBERS.get(several["one"] or several["other"])
            if count is not None:
                return (Step(quantity, 1, count),)
        one = _ONE_MORE.search(said)
        if one is not None and named.fullmatch(one["what"]):
            return (Step(quantity, 1, 1.0),)
    return ()


def joined_amount(clause: SpokenClause, length: float) -> SpokenClause:
    """A clause whose steps are by a length that stands behind it: "a bit shorter, like 4 cm"."""
    steps = [
        Step(c.quantity, c.direction, length) if isinstance(c, Step) and c.amount is None else c
        for c in clause.changes
    ]
    return SpokenClause(clause.start, clause.end, tuple(steps), clause.left_over)

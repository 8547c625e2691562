"""What an edit has changed, told from the two patterns and not from what was intended."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.body.wearer import body_of
from swifttailor.describing.differences import Change, find_differences
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.pattern.digest import pattern_digest

_ONE_SLEEVE = frozenset({"left_sleeve", "right_sleeve"})
_DIGITS = 1
"""Of amounts: a millimetre is less than anyone sees."""


def changes_seen(before: Pattern, after: Pattern) -> tuple[Change, ...] | None:
    """What became true, and what grew or shrank by how much, as far as it is seen.

    Args:
        before: The pattern to edit.
        after: What was made of it.

    Returns:
        Nothing where the patterns are the same; None where one of them cannot be measured.
    """
    if pattern_digest(before) == pattern_digest(after):
        return ()
    try:
        body = body_of(before.drafted_for).measurements
        gains, steps = find_differences(measure_facts(before, body), measure_facts(after, body))
    except SwiftTailorError:
        return None
    if any(gain.claim.name == "sleeves" for gain in gains):  # then nobody asks for each alone
        gains = tuple(gain for gain in gains if gain.claim.name not in _ONE_SLEEVE)
    said: dict[str, Change] = {}
    for gain in gains:  # of values that run into each other, as "micro" into "mini", the first says enough
        said.setdefault(gain.claim.name, gain)
    return (
        *said.values(),
        *(replace(s, amount=None if s.amount is None else round(s.amount, _DIGITS)) for s in steps),
    )

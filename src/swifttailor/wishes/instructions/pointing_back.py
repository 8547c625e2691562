"""Words of an instruction that point back to its own: "it gapes at the waist, take it in there, 2 cm"."""

from __future__ import annotations

import re

from swifttailor.wishes.instructions.change_words import find_changes, find_parts
from swifttailor.wishes.instructions.spoken_targets import clauses_of
from swifttailor.wishes.text.mentions import find_mentions

_THERE = re.compile(
    r"(?<!\w)(?<!over )(?<!out )there"
    r"(?=\s*(?:$|[.,;!?)]|(?:please|and|by|about|maybe|a (?:bit|little|touch|tad)|too)(?!\w)))",
    re.IGNORECASE,
)
_SAME = re.compile(
    r"(?<!\w)(?:by )?(?:(?:about|roughly|exactly|just) )?"
    r"(?:the (?:very )?same (?:amount|measure|number|much|again)|(?<=by )the same|(?<=by )as much"
    r"|the same (?=(?:longer|shorter|wider|narrower|higher|lower|deeper)(?!\w)))",
    re.IGNORECASE,
)
_PLACES = frozenset(
    {"waist", "hips", "chest", "thigh", "sleeve_end", "leg_end", "neck", "shoulders", "hem", "armholes"}
)
"""What "there" can mean."""


def with_what_is_meant(text: str) -> str:
    """An instruction with the place and the number that it points back to, where it names them before.

    Args:
        text: In any case.
    """
    return _with_places(_with_numbers(text))


def _with_places(text: str) -> str:
    found = _THERE.search(text)
    if found is None:
        return text
    small = text.lower()
    start = next((a for a, b in clauses_of(small) if a <= found.start() < b), 0)
    own = [p for p in find_parts(small[start : found.start()]) if p.part != "all"]
    before = [p for p in find_parts(small[:start]) if p.part in _PLACES]
    if own or not before or not find_changes(small[start : found.end()]):
        return text
    return f"{text[: found.start()]}at the {before[-1].word}{text[found.end() :]}"


def _with_numbers(text: str) -> str:
    found = _SAME.search(text)
    if found is None:
        return text
    before = [m for m in find_mentions(text[: found.start()]) if m.is_length]
    if not before:
        return text
    said = text[before[-1].start : before[-1].end]
    kept = text[: found.start()].rstrip()
    by = "" if kept.lower().endswith(" by") else "by "
    return f"{kept} {by}{said}{text[found.end() :]}"

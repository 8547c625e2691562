"""Legs that were drafted, drafted anew for a large body that wears them."""

from __future__ import annotations

from swifttailor.body import Body
from swifttailor.pattern import Pattern
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.redrafted import redrafted

_WIDE_HIPS = 1.15
"""Times the hips of the default body."""
_LEGGED = frozenset(
    {"trousers", "pull-on-trousers", "jumpsuit", "wrap-jumpsuit", "strappy-jumpsuit", "strapless-jumpsuit"}
    | {"halter-jumpsuit"}
)
"""Drafts whose hems hardly grow where they are refitted: calves of large bodies catch narrow ones as they
fall, and wide ones are no longer wide."""


def legs_for_large(answer: Answer, body: Body) -> Pattern | None:
    """The draft of narrow or wide legs for large hips; None where it was cut, or is refitted."""
    begun = answer.drafted
    if begun is None or answer.cuts or begun.name not in _LEGGED or not begun.narrows_or_is_wide:
        return None
    if body.measurements.hips <= _WIDE_HIPS * Body.default().measurements.hips:
        return None
    return redrafted(answer.pattern, begun.as_long_on(body.measurements), body)

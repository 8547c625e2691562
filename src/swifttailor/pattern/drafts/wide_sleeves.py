"""Sleeves of drafts that are seen to be wide, though they are less than twice as wide as the arm."""

from __future__ import annotations

from collections.abc import Mapping

_WIDE_CM, _SHORT_CM = 42.0, 40.0
"""Width around at the end of sleeves that are wide, and how long those are at most that end above the wrist,
cm: of longer ones the width above the wrist tells."""
_OF_WIDE = (("sleeve_shape", "wide"),)


def wide_to_the_eye(options: Mapping[str, float | bool | str]) -> tuple[tuple[str, str], ...]:
    """Claims, by name and value, that short wide sleeves make true to the eye.

    Args:
        options: Of a draft, as words have them.
    """
    plain = options.get("sleeve_shape", "plain") == "plain"
    short = float(options.get("sleeve_length", _SHORT_CM + 1.0)) <= _SHORT_CM
    return _OF_WIDE if plain and short and float(options.get("sleeve_end", 0.0)) >= _WIDE_CM else ()

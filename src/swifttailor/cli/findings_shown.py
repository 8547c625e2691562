"""How many findings and changes are printed: those of a damaged pattern can be tens of thousands."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

MOST_SHOWN = 40
REPORT_HAS_ALL = "report.json"
"""Of a garment's folder."""
T = TypeVar("T")


def first_of(items: Sequence[T], what: str, all_of_them: str) -> tuple[Sequence[T], str]:
    """The first of many, gravest first as a check has them, and a line about the others.

    Args:
        items: Findings, changes, or lines about them.
        what: They are, such as "findings".
        all_of_them: How to see all, such as "--all".

    Returns:
        What to print, and the line to print behind it; empty where nothing is left out.
    """
    left = len(items) - MOST_SHOWN
    if left <= 1:  # a line about one line saves none
        return items, ""
    return items[:MOST_SHOWN], f"... and {left:,} more {what}. All of them: {all_of_them}"

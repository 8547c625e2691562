"""What people say of a garment that they wish for in other words than the lexicon has, put into plain ones.

Grammar that neighbouring words do not show: "one sleeve puffed, the other shoulder bare", "between the knee
and the ankle", "high in front and low behind", "10 inches up from the hem" of a slit.
The table is for anybody to extend.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from swifttailor.wishes.text.sayings_table import Saying, SayingsTable, read_sayings

_TABLE = Path(__file__).with_name("sayings_of_wishes.txt")


def plainly_wished(text: str) -> str:
    """A description with such sayings put plainly; the rest as it is.

    Args:
        text: In any case.
    """
    return _plain(text, _table().any_saying, _table().sayings)


def without_asides(text: str) -> str:
    """A text in which words of the cut that mean none are put plainly: "elbow room", "knee patches".

    No network sees them: each would take them for sleeves to the elbow.

    Args:
        text: In any case.
    """
    return _plain(text, _table().any_aside, _table().asides)


def _plain(text: str, any_of_them: re.Pattern[str], sayings: Sequence[Saying]) -> str:
    lowered = text.lower()
    if not any_of_them.search(lowered):
        return text
    for saying in sayings:
        if saying.pattern.search(lowered):
            text = re.sub(saying.pattern.pattern, saying.plain, text, flags=re.IGNORECASE)
            lowered = text.lower()
    return text


@cache
def _table() -> SayingsTable:
    return read_sayings(_TABLE)

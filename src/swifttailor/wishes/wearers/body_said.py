"""What a text has been found to say of the wearer's body while it is read."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

KG_PER_POUND = 0.4536
POUNDS_PER_STONE = 14


@dataclass
class SaidBody:
    """Collected piece by piece; what was read is taken out of the text."""

    text: str
    measures: dict[str, float] = field(default_factory=dict)
    """By the names of `body_measures.MEASURES`, cm."""
    kg: float | None = None
    size: str = ""
    """As `size_charts.find_size` reads it; without the figure where the text does not say it here."""
    region: str = ""
    """Of which the size is; empty where it is not said."""
    age: int | None = None
    """In years, of a child."""
    is_baby: bool = False
    build: str = ""
    """``petite``, ``tall`` or ``plus``."""
    notes: list[str] = field(default_factory=list)
    """What was understood otherwise than it is said, for a person."""

    def take(self, match: re.Match[str], instead: str = "") -> None:
        """Takes what was found out of the text."""
        self.text = f"{self.text[: match.start()]} {instead} {self.text[match.end() :]}"


def number(text: str) -> float:
    """A number with a point or a comma."""
    return float(text.replace(",", "."))

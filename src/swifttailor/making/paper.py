"""Papers, and how a sheet is cut into pages of them."""

from __future__ import annotations

import re
from dataclasses import dataclass

from swifttailor.errors import InputError
from swifttailor.inches import CM_PER_INCH

MARGIN_CM = 1.0
"""Left free on every side; home printers do not print closer to the edge."""
PAPERS: dict[str, tuple[float, float]] = {
    "a4": (21.0, 29.7),
    "a3": (29.7, 42.0),
    "a2": (42.0, 59.4),
    "a1": (59.4, 84.1),
    "a0": (84.1, 118.9),
    "letter": (8.5 * CM_PER_INCH, 11 * CM_PER_INCH),
    "legal": (8.5 * CM_PER_INCH, 14 * CM_PER_INCH),
    "tabloid": (11 * CM_PER_INCH, 17 * CM_PER_INCH),
    "arch-d": (24 * CM_PER_INCH, 36 * CM_PER_INCH),
}
"""Width and height in cm, upright."""
_SMALLEST_CM, _LARGEST_CM = 9.0, 500.0
_OWN_SIZE = re.compile(r"(\d+(?:\.\d+)?)\s*x\s*(\d+(?:\.\d+)?)\s*(cm|mm|in)?")


@dataclass(frozen=True)
class Paper:
    """A sheet of paper, cm."""

    name: str
    width: float
    height: float

    @classmethod
    def named(cls, name: str) -> Paper:
        """A paper by its name, or by its size: ``90x200cm``, ``24x36in``.

        Raises:
            InputError: There is no such paper, or none that could be printed on.
        """
        key = name.strip().lower()
        if key in PAPERS:
            return cls(key, *PAPERS[key])
        found = _OWN_SIZE.fullmatch(key)
        if found is None:
            raise InputError(
                f"There is no paper {name!r}. Accepted: {', '.join(PAPERS)}, or a size such as 90x200cm "
                "or 24x36in."
            )
        factor = {"mm": 0.1, "in": CM_PER_INCH}.get(found[3] or "cm", 1.0)
        width, height = float(found[1]) * factor, float(found[2]) * factor
        if not (_SMALLEST_CM <= min(width, height) and max(width, height) <= _LARGEST_CM):
            raise InputError(
                f"A paper of {width:g} x {height:g} cm cannot be printed on; from {_SMALLEST_CM:g} to "
                f"{_LARGEST_CM:g} cm is accepted on each side."
            )
        return cls(key, width, height)

    @property
    def tile(self) -> tuple[float, float]:
        """Width and height of what is printed on it, cm."""
        return self.width - 2 * MARGIN_CM, self.height - 2 * MARGIN_CM

    @property
    def for_reading(self) -> Paper:
        """Paper for the cover and the steps: this one where it is small, else A4 or Letter."""
        if (
            self.width <= PAPERS["a3"][0] + 1e-6
            and self.height <= PAPERS["a3"][1] + 1e-6
            and self.width >= 18
        ):
            return self
        inches = self.name in ("legal", "tabloid", "arch-d") or self.name.endswith("in")
        return Paper.named("letter" if inches else "a4")


@dataclass(frozen=True)
class Tile:
    """A page's part of the sheet."""

    column: int
    row: int
    """From the top, from 0."""

    @property
    def name(self) -> str:
        """``B3``: the column's letter and the row's number."""
        letters, number = "", self.column
        while number >= 0:
            letters, number = chr(ord("A") + number % 26) + letters, number // 26 - 1
        return f"{letters}{self.row + 1}"

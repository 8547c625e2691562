"""Tables as plain text: headings, rows, numbers to the right."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

NOTHING = "-"


@dataclass(frozen=True)
class Column:
    """One column of numbers."""

    heading: str
    """With the unit."""
    format: str = ".2f"


Row = tuple[str, Sequence[float | int | None]]
"""Name and numbers; None where there is none."""


def text_table(columns: Sequence[Column], rows: Sequence[Row]) -> str:
    """Lays out a table with one column for each number."""
    cells = [["", *(c.heading for c in columns)]]
    for name, values in rows:
        shown = [NOTHING if v is None else format(v, c.format) for v, c in zip(values, columns, strict=True)]
        cells.append([name, *shown])
    widths = [max(len(row[k]) for row in cells) for k in range(len(columns) + 1)]
    lines = []
    for row in cells:
        first = row[0].ljust(widths[0])
        rest = (text.rjust(width) for text, width in zip(row[1:], widths[1:], strict=True))
        lines.append("  ".join([first, *rest]).rstrip())
    lines.insert(1, "-" * max(map(len, lines)))
    return "\n".join(lines) + "\n"

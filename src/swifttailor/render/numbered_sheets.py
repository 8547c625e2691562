"""Sheets of pictures that take several files: name-01.png, name-02.png, ..."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from swifttailor.atomic_files import write_atomically

if TYPE_CHECKING:
    from PIL.Image import Image

Item = TypeVar("Item")


def write_numbered_sheets(
    folder: Path, name: str, items: Sequence[Item], per_sheet: int, draw: Callable[[Sequence[Item]], Image]
) -> list[Path]:
    """Draws some items on each sheet and writes it.

    Args:
        folder: Where to; none of these files is there yet.
        name: Of the files, before their numbers.
        items: All of them, in order.
        per_sheet: How many to a sheet.
        draw: A sheet of so many or, for the last, fewer.

    Raises:
        InputError: A file cannot be written.
    """
    written = []
    for number, first in enumerate(range(0, len(items), per_sheet), 1):
        sheet = draw(items[first : first + per_sheet])
        path = folder / f"{name}-{number:02d}.png"
        write_atomically(path, lambda target, sheet=sheet: sheet.save(target, "PNG"))
        written.append(path)
    return written


def sheets_named(name: str) -> tuple[str, str]:
    """Patterns of the names of all such files: name-2024.png is none."""
    return f"{name}-[0-9][0-9].png", f"{name}-[0-9][0-9][0-9].png"

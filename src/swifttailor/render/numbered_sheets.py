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
    """Draws some items on each sheet and writes it; sheets of an earlier time that are not replaced go.

    Args:
        folder: Where to.
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
    for digits in ("[0-9][0-9]", "[0-9][0-9][0-9]"):  # name-2024.png is somebody else's
        for old in set(folder.glob(f"{name}-{digits}.png")).difference(written):
            old.unlink()
    return written

"""Tasks of prints: the picture that a client repeats on the cloth."""

from __future__ import annotations

from typing import Any

from swifttailor.errors import InputError
from swifttailor.garment.print_tile import print_tile
from swifttailor.render.png import encode_png
from swifttailor.studio.bench.documents import Work
from swifttailor.studio.bench.part_looks import print_read
from swifttailor.studio.worker.link import Link


def tile(link: Link, *, print: dict[str, Any]) -> Work:
    """One repeat of a print: its ``png``, and the ``matrix`` of `PrintTile.matrix`, row by row.

    Raises:
        InputError: It cannot be drawn.
    """
    printed = print_read(print)
    if printed is None:
        raise InputError("This print cannot be drawn.")
    found = print_tile(printed)
    matrix = [float(number) for number in found.matrix().ravel()]
    return Work({"png": encode_png(found.picture), "matrix": matrix})

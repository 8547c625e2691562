"""The group codes of a DXF file of AutoCAD R12: points, lines, polylines, texts, blocks."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable

import numpy as np

from swifttailor.arrays import Floats

_TEXT_MM = 5.0


class DxfText:
    """Collects entities; lengths in millimetres, two decimals."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def add(self, code: int, value: str | float) -> None:
        """One group."""
        text = f"{value + 0.0:.2f}" if isinstance(value, float) else str(value)
        self.lines += [str(code), "0.00" if text == "-0.00" else text]

    def start(self, kind: str, layer: int | str | None = None) -> None:
        """The first groups of an entity, section or table."""
        self.add(0, kind)
        if layer is not None:
            self.add(8, _layer(layer))

    def point(self, layer: int, at: Floats, *, depth: float = 0.0, angle: float | None = None) -> None:
        """A point; notches have a depth and the direction of their cut in degrees."""
        self.start("POINT", layer)
        self._at(at, depth)
        if angle is not None:
            self.add(39, 0.0)
            self.add(50, float(angle))

    def line(self, layer: int, start: Floats, end: Floats) -> None:
        """A straight line."""
        self.start("LINE", layer)
        self._at(start)
        self.add(11, float(end[0]))
        self.add(21, float(end[1]))
        self.add(31, 0.0)

    def polyline(self, layer: int, points: Floats, *, closed: bool) -> None:
        """A polyline (n, 2); the first point of a closed one is not repeated."""
        self.start("POLYLINE", layer)
        self.add(66, "1")
        self._at(np.zeros(2))
        self.add(70, "1" if closed else "0")
        for point in points:
            self.start("VERTEX", layer)
            self._at(point)
        self.start("SEQEND", layer)

    def text(self, layer: int, text: str, at: Floats, *, size: float = _TEXT_MM) -> None:
        """A line of text that begins at a point."""
        self.start("TEXT", layer)
        self._at(at)
        self.add(40, size)
        self.add(1, plain(text))

    def content(self) -> str:
        """The whole file, with the line ends that DXF readers of all ages take."""
        return "\r\n".join([*self.lines, ""])

    def _at(self, point: Floats, z: float = 0.0) -> None:
        self.add(10, float(point[0]))
        self.add(20, float(point[1]))
        self.add(30, float(z))


def _layer(name: int | str) -> str:
    """Numbers as they are; names in the letters that R12 takes."""
    return str(name) if isinstance(name, int) else re.sub(r"[^A-Z0-9_$-]+", "_", plain(name).upper())[:31]


def plain(text: str) -> str:
    """ASCII without control characters: R12 knows no other letters."""
    ascii_text = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    return re.sub(r"[^\x20-\x7e]+", " ", ascii_text)[:250]


def block_names(names: Iterable[str]) -> list[str]:
    """Names as R12 accepts them for blocks: capitals, digits and ``_``, at most 31, no two alike."""
    taken: set[str] = set()
    made = []
    for name in names:
        base = re.sub(r"[^A-Z0-9]+", "_", plain(name).upper()).strip("_")[:27] or "PIECE"
        candidate, number = base, 2
        while candidate in taken:
            candidate, number = f"{base}_{number}", number + 1
        taken.add(candidate)
        made.append(candidate)
    return made

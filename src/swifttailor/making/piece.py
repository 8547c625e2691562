"""One shape to cut: its lines, notches, marks, and how often it is cut."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.making.cut_line import CutLine, Run
from swifttailor.making.trim_marks import TrimMark

FOLD_FROM_CM = 20.0
"""From this width on, pieces that are their own mirror image are cut on the fold; others are drawn whole."""


@dataclass(frozen=True, eq=False)
class PlacedNotch:
    """A notch where it is drawn."""

    point: Floats
    """(2,) on the sew line, cm."""
    outward: Floats
    """(2,) unit vector out of the piece."""
    depth: float
    """Of the allowance there, cm."""
    teeth: int


@dataclass(frozen=True, eq=False)
class DartMark:
    """A dart as it is drawn: two legs to a point."""

    legs: tuple[Floats, Floats]
    """Polylines, both from the mouth to the point, cm."""


@dataclass(frozen=True, eq=False)
class EdgeMark:
    """What is to be done with an edge."""

    points: Floats
    """The edge, cm."""
    text: str
    """``gather to 23.1 cm``."""


@dataclass(frozen=True, eq=False)
class SeamMark:
    """The numbers of an edge's seams: several where panels that are cut alike are sewn differently."""

    numbers: tuple[int, ...]
    point: Floats
    """(2,) middle of the edge, cm."""
    inward: Floats
    """(2,) unit vector into the piece."""
    length: float
    """Of the edge, cm."""


@dataclass(frozen=True, eq=False)
class Piece:
    """One shape to cut, once or several times. Seen from the right side, grain upright, y up, cm."""

    name: str
    panels: tuple[str, ...]
    """Panels of the pattern that are cut as drawn."""
    mirrored: tuple[str, ...]
    """Panels that are cut with the drawing turned over."""
    runs: tuple[Run, ...]
    """The sew line."""
    cut: CutLine
    notches: tuple[PlacedNotch, ...]
    darts: tuple[DartMark, ...]
    edge_marks: tuple[EdgeMark, ...]
    seam_marks: tuple[SeamMark, ...]
    symmetric: bool
    """Whether it is its own mirror image, at x = `middle`."""
    middle: float
    size: str = ""
    """Name of the size, where a file holds several."""
    marks: tuple[TrimMark, ...] = ()
    """What is put on it: outlines of pockets, buttons, zips, openings."""
    trim: str = ""
    """Name of the trim that it is cut for; empty for pieces of the garment itself."""
    cloth: str = ""
    """What it is cut of, where that is not the garment's cloth alone: ``of lining``."""

    @property
    def sew_line(self) -> Floats:
        """Closed polyline (n, 2), cm."""
        return np.concatenate([r.points[:-1] for r in self.runs])

    @property
    def count(self) -> int:
        """How many are cut in all."""
        return len(self.panels) + len(self.mirrored)

    @property
    def box(self) -> Floats:
        """[[min x, min y], [max x, max y]] of the cut line, cm."""
        return np.array([self.cut.outline.min(axis=0), self.cut.outline.max(axis=0)])

    @property
    def on_fold(self) -> bool:
        """Whether half of it is drawn, to be cut on the fold of the cloth."""
        return self.symmetric and float(np.ptp(self.box[:, 0])) >= FOLD_FROM_CM

    @property
    def instruction(self) -> str:
        """How often and how it is cut, in words."""
        return f"{self.often}, {self.cloth}" if self.cloth else self.often

    @property
    def often(self) -> str:
        """How often it is cut, in words."""
        if self.on_fold:
            return f"Cut {self.count} on the fold"
        if self.symmetric or not self.mirrored:
            return f"Cut {self.count}"
        if len(self.panels) == len(self.mirrored):
            return (
                f"Cut {self.count}, mirrored"
                if self.count == 2
                else f"Cut {self.count}, half of them mirrored"
            )
        return f"Cut {self.count}, {len(self.mirrored)} of them mirrored"

    @property
    def grain(self) -> Floats:
        """Ends (2, 2) of the grain line, cm."""
        low, high = self.box
        if self.on_fold:
            choices = [self.middle + share * (high[0] - self.middle) for share in (0.8, 0.7, 0.3)]
        else:
            choices = [low[0] + share * (high[0] - low[0]) for share in (0.3, 0.7, 0.25, 0.75)]
        spans = [(x, *_inside_span(self.cut.outline, x)) for x in choices]
        longest = max(top - bottom for _, bottom, top in spans)
        # The first that is about as long as any: beside the label, which stands in the middle.
        x, *span = next(s for s in spans if s[2] - s[1] > 0.75 * longest)
        inset = 0.2 * (span[1] - span[0])
        return np.array([[x, span[0] + inset], [x, span[1] - inset]])


def _inside_span(outline: Floats, x: float) -> tuple[float, float]:
    """The longest stretch (low, high) of the upright line at x inside a closed polyline (n, 2)."""
    start, end = outline, np.roll(outline, -1, axis=0)
    crossing = (start[:, 0] <= x) != (end[:, 0] <= x)
    a, b = start[crossing], end[crossing]
    heights = np.sort(a[:, 1] + (x - a[:, 0]) / (b[:, 0] - a[:, 0]) * (b[:, 1] - a[:, 1]))
    if len(heights) < 2:
        return float(outline[:, 1].min()), float(outline[:, 1].max())
    pairs = heights[: len(heights) // 2 * 2].reshape(-1, 2)
    low, high = pairs[int(np.argmax(pairs[:, 1] - pairs[:, 0]))]
    return float(low), float(high)

"""Fronts that are open from top to bottom, closed by buttons or a zip instead of a seam."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.making.allowances import EdgeKind
from swifttailor.making.cut_line import Run
from swifttailor.making.seams import Seam, SeamRole
from swifttailor.making.sewn_pattern import SewnPattern
from swifttailor.pattern import EdgeRef, Pattern
from swifttailor.pattern.trims import Button, Patch, Trim
from swifttailor.pattern.trims.names import CLOSES_FRONT

DOUBLE, SINGLE = "double-breasted buttons", ("buttons", "big buttons")


@dataclass(frozen=True)
class Closing:
    """How a front closes whose halves are sewn together in the pattern."""

    trim: str
    edges: frozenset[EdgeRef]
    """In the middle of the front; they stay open."""
    below: frozenset[EdgeRef]
    """Edges that go on from there to the hem and are free in the pattern too, as a coat's."""
    extension: float
    """How far each front reaches beyond the middle so that they lap, cm; nothing for zips and bands."""

    @property
    def panels(self) -> frozenset[str]:
        """The fronts."""
        return frozenset(ref.panel for ref in self.edges)

    def wider(self, ref: EdgeRef) -> float:
        """What an edge has beyond its allowance, cm."""
        return self.extension if ref in self.edges else 0.0

    def falling(self, runs: Sequence[Run], panel: str, seam: float, hem: float) -> list[shapely.Geometry]:
        """What makes a front that laps fall straight from its buttons to the hem, beside its free edges.

        Args:
            runs: The panel's sew line.
            panel: Name of the front.
            seam: Allowance beyond its edge, cm.
            hem: Allowance below its hem, cm.
        """
        line = self.straight(runs, panel, seam)
        if line is None:
            return []
        top, bottom, corner = line
        start = next(
            end
            for run in runs
            if EdgeRef(panel, run.edge) in self.edges
            for end in (run.points[0], run.points[-1])
            if np.hypot(*(end - top)) < self.extension + seam + 1e-6
        )
        down = hem * _unit(bottom - top)
        return [shapely.make_valid(shapely.Polygon([start, top, bottom + down, corner + down, corner]))]

    def straight(
        self, runs: Sequence[Run], panel: str, seam: float = 0.0
    ) -> tuple[Floats, Floats, Floats] | None:
        """Where the edge of a front that laps begins below its buttons, where it ends, and the hem's corner.

        Returns:
            (2,) each, cm; None where the middle is closed down to the hem.
        """
        middle = [run.points for run in runs if EdgeRef(panel, run.edge) in self.edges]
        low = [run.points for run in runs if EdgeRef(panel, run.edge) in self.below]
        if self.extension <= 0 or not middle or not low:
            return None
        points = np.concatenate(middle)
        start = points[points[:, 1].argmin()]
        down = _unit(start - points[points[:, 1].argmax()])
        going = middle[0][-1] - middle[0][0]
        out = _unit(np.array([going[1], -going[0]]))  # loops run anticlockwise
        below = np.concatenate(low)
        deep = (below - start) @ down
        top = start + (self.extension + seam) * out
        return top, top + float(deep.max()) * down, below[deep.argmax()]


def closing_trim(pattern: Pattern) -> str:
    """What closes the front all the way down; empty where nothing does."""
    return next((name for name in pattern.trims if name in CLOSES_FRONT), "")


def front_closing(sewn: SewnPattern, seams: Sequence[Seam], trims: Sequence[Trim]) -> Closing | None:
    """How the front closes; None where its halves are sewn together or are one.

    Args:
        sewn: The panels.
        seams: All seams.
        trims: Where trims lie on the panels.
    """
    name = closing_trim(sewn.pattern)
    stitches = [k for seam in seams if seam.role is SeamRole.CENTRE_FRONT for k in seam.stitches]
    edges = frozenset(ref for k in stitches for ref in sewn.pattern.stitches[k].sides)
    own = [t for t in trims if isinstance(t, Patch | Button) and t.trim == name]
    own = [t for t in own if t.panel in {ref.panel for ref in edges}]
    if not name or not own:
        return None
    extension = 0.0
    if name in SINGLE:  # as usual, a button's width
        extension = 2 * max(t.radius for t in own if isinstance(t, Button))
    elif name == DOUBLE:
        line = next(t for t in own if isinstance(t, Patch))
        middle = (line.first + line.second).mean(axis=0) / 2
        panel = sewn.pattern.panel(line.panel)
        extension = min(
            shapely.LineString(panel.flatten_edge(ref.edge, 0.01)).distance(shapely.Point(middle))
            for ref in edges
            if ref.panel == line.panel
        )
    below = frozenset(other for ref in edges for other in _below(sewn, ref))
    return Closing(name, edges, below, round(float(np.clip(extension, 0.0, 15.0)), 2))


def _unit(step: Floats) -> Floats:
    return step / max(float(np.hypot(*step)), 1e-9)


def _below(sewn: SewnPattern, ref: EdgeRef) -> Iterator[EdgeRef]:
    """Free edges that follow an edge of the middle downwards."""
    panel = sewn.panel(ref.panel)
    count = len(panel.edges)
    down = 1 if panel.edges[ref.edge][-1, 1] < panel.edges[ref.edge][0, 1] else -1
    for k in range(1, count):
        edge = (ref.edge + down * k) % count
        ends = panel.edges[edge][[0, -1]][::down, 1]
        if panel.kinds[edge] not in (EdgeKind.SLIT, EdgeKind.OPENING) or ends[1] > ends[0]:
            return
        yield EdgeRef(ref.panel, edge)

"""Panels of another colour down both sides, as of cycling jerseys: pieces along the side seams."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Patch, Trim
from swifttailor.pattern.trims.side_stripes import LEG, SIDE, outer_seams

_WIDTH, _WIDEST = 6.5, 0.55
"""How far a piece reaches from its seam, cm, and at most, as a part of the panel's width."""
_POINTS = 15
_SLACK, _LEAST = 0.04, 0.05
"""How exactly a piece lies on its panel, and how narrow it gets, cm."""
_SMALLEST = 1.0
"""What is smaller is no panel, cm2."""


def side_panels(chalk: Chalk, name: str) -> list[Trim]:
    """Along the side seams of front and back, of tops and dresses, and down the outside of legs."""
    pattern = chalk.pattern
    seams = [*outer_seams(pattern, SIDE), *outer_seams(pattern, LEG)]
    found: list[Trim] = []
    for ref in [ref for pair in seams for ref in pair]:
        panel = pattern.panel(ref.panel)
        seam = panel.sample_edge(ref.edge, _POINTS)
        inner = _inside(panel, seam, _WIDTH * chalk.size)
        found += [] if inner is None else [Patch(name, ref.panel, seam, inner)]
    return found


def _inside(panel: Panel, seam: Floats, width: float) -> Floats | None:
    """A line (n, 2) beside a seam (n, 2), so far inside of a panel as there is room, cm; else None."""
    import shapely

    outline = panel.outline(0.01)
    cloth = shapely.Polygon(outline).buffer(_SLACK)
    way = float(np.sign(outline[:, 0].mean() - seam[:, 0].mean()))
    reach = min(width, _WIDEST * float(np.ptp(outline[:, 0])))
    rows = []
    for x, y in seam:
        run = shapely.LineString([(x, y), (x + way * reach, y)]).intersection(cloth)
        runs = [each for each in getattr(run, "geoms", [run]) if each.distance(shapely.Point(x, y)) < _SLACK]
        rows.append(max([each.length for each in runs], default=0.0))
    away = np.maximum(np.array(rows) - 2 * _SLACK, _LEAST)
    inner = seam + np.stack([way * away, np.zeros(len(seam))], axis=1)
    piece = shapely.Polygon([*seam, *inner[::-1]])  # of a seam that runs across, nothing
    return inner if max(rows) > 1.0 and piece.is_valid and piece.area > _SMALLEST else None

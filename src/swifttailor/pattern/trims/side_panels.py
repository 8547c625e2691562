"""Panels of another colour down both sides, as of cycling jerseys: pieces along the side seams."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Patch, Trim
from swifttailor.pattern.trims.side_stripes import LEG, SIDE, outer_seams

_WIDTH, _WIDEST = 6.5, 0.55
"""How far a piece reaches from its seam, cm, and at most, as a part of the panel's width."""
_POINTS = 15
_NARROWER = (1.0, 0.6, 0.35)
_SLACK, _LEAST = 0.04, 0.05
"""How exactly a piece lies on its panel, and how narrow it gets, cm."""
_SMALLEST = 1.0
"""What is smaller is no panel, cm2."""


def side_panels(chalk: Chalk, name: str) -> list[Trim]:
    """Along the side seams of front and back, of tops and dresses, and down the outside of legs.

    Where seams bend so much that a piece would cross itself, all of them are narrower, or none is put on.
    """
    pattern = chalk.pattern
    refs = [ref for of in (SIDE, LEG) for pair in outer_seams(pattern, of) for ref in pair]
    for share in _NARROWER:
        found = [_piece(name, pattern.panel(ref.panel), ref, share * _WIDTH * chalk.size) for ref in refs]
        pieces = [piece for piece in found if piece is not None]
        if all(_is_plain(piece) for piece in pieces):
            return list(pieces)
    return []


def _piece(name: str, panel: Panel, ref: EdgeRef, width: float) -> Patch | None:
    seam = panel.sample_edge(ref.edge, _POINTS)
    inner = _inside(panel, seam, width)
    return None if inner is None else Patch(name, ref.panel, seam, inner)


def _is_plain(piece: Patch) -> bool:
    """Whether its border does not cross itself, and leaves room between."""
    import shapely

    shape = shapely.Polygon(piece.outline)
    return bool(shape.is_valid) and shape.area > _SMALLEST


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
    return seam + np.stack([way * away, np.zeros(len(seam))], axis=1) if max(rows) > 1.0 else None

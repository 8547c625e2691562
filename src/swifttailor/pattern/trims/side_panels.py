"""Panels of another colour down both sides, as of cycling jerseys: pieces along the side seams."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Patch, Trim
from swifttailor.pattern.trims.side_stripes import LEG, SIDE, outer_seams

_WIDTH, _WIDEST = 6.5, 0.55
"""How far a piece reaches from its seam, cm, and at most, as a part of half the front's width."""
_POINTS = 15


def side_panels(chalk: Chalk, name: str) -> list[Trim]:
    """Along the side seams of front and back, of tops and dresses, and down the outside of legs."""
    pattern = chalk.pattern
    seams = [*outer_seams(pattern, SIDE), *outer_seams(pattern, LEG)]
    found: list[Trim] = []
    for ref in [ref for pair in seams for ref in pair]:
        panel = pattern.panel(ref.panel)
        seam = panel.sample_edge(ref.edge, _POINTS)
        found.append(Patch(name, ref.panel, seam, _inside(panel, seam, _WIDTH * chalk.size)))
    return found


def _inside(panel: Panel, seam: Floats, width: float) -> Floats:
    """A line (n, 2) beside a seam (n, 2), so far inside of a panel as there is room, cm."""
    outline = panel.outline(0.5)
    middle = float(outline[:, 0].mean())
    way = np.sign(middle - float(seam[:, 0].mean()))
    room = _WIDEST * abs(float(np.ptp(outline[:, 0])))
    return seam + np.array([way * min(width, room), 0.0])

"""The frill of paper bag waists: cloth that stands up above the band that it is gathered by."""

from __future__ import annotations

from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Frill, Trim

_BANDS = ("wb_front", "wb_back")
_HEIGHT = 4.0
"""How far it stands up, cm."""


def waist_frill(chalk: Chalk, name: str) -> list[Trim]:
    """A gathered strip along the upper edge of a waistband that nothing hangs from above."""
    pattern = chalk.pattern
    if any("torso" in panel.name for panel in pattern.panels):
        return []
    sewn = {side for stitch in pattern.stitches for side in stitch.sides}
    edges: list[EdgeRef] = []
    for band in _BANDS:
        if band not in chalk.views:
            return []
        panel = pattern.panel(band)
        free = [EdgeRef(band, k) for k in range(len(panel.edges)) if EdgeRef(band, k) not in sewn]
        middle = (chalk.views[band].low + chalk.views[band].high) / 2
        free = [
            ref for ref in free if float(panel.to_world(panel.sample_edge(ref.edge, 9))[:, 1].mean()) > middle
        ]
        if not free:
            return []
        edges += free
    length = sum(pattern.edge_length(ref) for ref in edges)
    return [Frill(name, tuple(edges), _HEIGHT * chalk.size, length)]

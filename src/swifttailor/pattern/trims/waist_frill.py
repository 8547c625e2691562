"""What is made of the upper edge of a waistband: the frill of paper bag waists, a band folded over."""

from __future__ import annotations

from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Frill, Trim

_BANDS = ("wb_front", "wb_back")
_HEIGHT = 6.0
"""How far it stands up, cm."""
_FOLDED, _FOLDED_MOST = 8.5, 2.2
"""How far what is folded over hangs down, cm, and at most, as a part of the height of the band."""


def waist_frill(chalk: Chalk, name: str) -> list[Trim]:
    """A gathered strip along the upper edge of a waistband that nothing hangs from above."""
    edges = _upper_edges(chalk)
    length = sum(chalk.pattern.edge_length(ref) for ref in edges)
    return [Frill(name, edges, _HEIGHT * chalk.size, length)] if edges else []


def folded_band(chalk: Chalk, name: str) -> list[Trim]:
    """The upper part of a waistband, turned down over it on the outside, as of yoga trousers."""
    edges = _upper_edges(chalk)
    if not edges:
        return []
    band = chalk.views[_BANDS[0]]
    depth = min(_FOLDED * chalk.size, _FOLDED_MOST * (band.high - band.low))
    return [Frill(name, edges, depth, sum(chalk.pattern.edge_length(ref) for ref in edges), "flat")]


def _upper_edges(chalk: Chalk) -> tuple[EdgeRef, ...]:
    """The upper edges of a waistband that nothing hangs from; none of a garment without one."""
    pattern = chalk.pattern
    if any("torso" in panel.name for panel in pattern.panels):
        return ()
    sewn = {side for stitch in pattern.stitches for side in stitch.sides}
    edges: list[EdgeRef] = []
    for band in _BANDS:
        if band not in chalk.views:
            return ()
        panel = pattern.panel(band)
        free = [EdgeRef(band, k) for k in range(len(panel.edges)) if EdgeRef(band, k) not in sewn]
        middle = (chalk.views[band].low + chalk.views[band].high) / 2
        free = [
            ref for ref in free if float(panel.to_world(panel.sample_edge(ref.edge, 9))[:, 1].mean()) > middle
        ]
        if not free:
            return ()
        edges += free
    return tuple(edges)

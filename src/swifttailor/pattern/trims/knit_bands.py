"""The ribbed bands of cardigans: up both fronts, around neck and hem, at the sleeves."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.pattern import EdgeRef, Pattern
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.free_edges import hem_edges, neck_edges, sleeve_ends
from swifttailor.pattern.trims.shapes import Frill, Trim

KNIT_BANDS = "knit bands"
_FRONT_CM, _HEM_CM, _CUFF_CM = 2.6, 5.0, 5.5
"""How wide they are, cm."""
_MIDDLE_CM, _STEEP, _SHORTEST_CM = 12.0, 1.5, 4.0
"""Edges of a front lie so far from the middle at most, rise so many times as far as they go aside, and are at
least so long, cm."""


def knit_bands(chalk: Chalk, name: str) -> list[Trim]:
    """Bands along all edges, but for that of a collar; nothing where the front is in one piece."""
    pattern, size = chalk.pattern, chalk.size
    fronts = [_front_edges(pattern, f"{side}_ftorso") for side in ("left", "right")]
    neck = neck_edges(pattern)
    if not all(fronts):
        return []
    neck = () if any("collar" in ref.panel for ref in neck) else neck
    strips = [*((each, _FRONT_CM) for each in fronts), (neck, _FRONT_CM)]
    strips += [(hem_edges(pattern), _HEM_CM), (sleeve_ends(pattern), _CUFF_CM)]
    below = _over_the_hem_band(chalk, name, _FRONT_CM * size)
    return below + [
        Frill(name, edges, width * size, sum(pattern.edge_length(ref) for ref in edges), "flat")
        for edges, width in strips
        if edges
    ]


def _over_the_hem_band(chalk: Chalk, name: str, width: float) -> list[Trim]:
    """The bands of both fronts run on over a band that is sewn to the hem."""
    view = chalk.views.get("wb_front")
    column = None if view is None else view.column(0.3)
    if view is None or column is None:
        return []
    ends = np.linspace(column[0] + 0.2, column[1] - 0.2, 5).tolist()
    middle = [(0.0, y) for y in ends]
    beside = ([(x, y) for y in ends] for x in (-width, width))
    return [piece for edge in beside for piece in chalk.ruled(name, "wb_front", edge, middle)]


def _front_edges(pattern: Pattern, panel: str) -> tuple[EdgeRef, ...]:
    """Edges of a front in the middle, whether they are free or sewn to the other front."""
    if not any(each.name == panel for each in pattern.panels):
        return ()
    front = pattern.panel(panel)
    joined = {
        side
        for stitch in pattern.stitches
        if {ref.panel for ref in stitch.sides} == {"left_ftorso", "right_ftorso"}
        for side in stitch.sides
    }
    sewn = {side for stitch in pattern.stitches for side in stitch.sides} - joined
    others = {*sewn, *neck_edges(pattern), *hem_edges(pattern)}
    found = []
    for k in range(len(front.edges)):
        ref = EdgeRef(panel, k)
        points = front.to_world(front.sample_edge(k, 9))
        rises, aside = (abs(float(points[-1, axis] - points[0, axis])) for axis in (1, 0))
        near = float(np.abs(points[:, 0]).max()) <= _MIDDLE_CM
        if ref not in others and near and rises >= max(_STEEP * aside, _SHORTEST_CM):
            found.append(ref)
    return tuple(found)

"""Petal sleeves: two halves that lie over each other on top of the arm and part above the hem."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Patch, Trim
from swifttailor.pattern.trims.side_stripes import top_seams

_POINTS, _FEWEST, _LEAST, _ON_CLOTH = 25, 8, 0.05, 0.04
"""Points of each line, and of the upper half's edge at least; the least width of the gap, and how exactly it
lies on its panel, cm."""
_GAP, _DEEP, _ROUND = 0.5, 4.2, 1.4
"""How much of the seam on top is open from the hem up, how far the hem parts on either side of it, cm, and
how the edges curve: a power of the way down."""
_LONGEST, _SHORTEST = 20.0, 5.0
"""Of the gap, cm."""
_ASIDE, _FROM_CAP, _LINE = 11.0, 0.6, 0.16
"""How far beside the seam the upper half's edge begins at the armhole, how near to this it is drawn, and half
the width of what is drawn, cm."""


def sleeve_petals(chalk: Chalk, name: str) -> list[Trim]:
    """The gap between both halves, and the edge of the upper one on the front of each sleeve."""
    pieces: list[Trim] = []
    pairs = top_seams(chalk.pattern)
    if len(pairs) != 2 or any("cuff" in panel.name for panel in chalk.pattern.panels):
        return []
    for pair in pairs:
        for ref in pair:
            found = _drawn(chalk, name, ref, with_edge=not ref.panel.endswith("_b"))
            if not found:
                return []
            pieces += found
    return pieces


def _drawn(chalk: Chalk, name: str, ref: EdgeRef, *, with_edge: bool) -> list[Trim]:
    import shapely

    panel, s = chalk.pattern.panel(ref.panel), chalk.size
    seam = panel.sample_edge(ref.edge, 81)
    world = panel.to_world(seam)
    seam = seam if world[0, 1] > world[-1, 1] else seam[::-1]
    run = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(seam, axis=0), axis=1))])
    gap = min(_GAP * run[-1], _LONGEST * s)
    if gap < _SHORTEST * s:
        return []
    cloth = shapely.Polygon(panel.outline(0.01)).buffer(_ON_CLOTH)
    part = np.linspace(0.0, 1.0, _POINTS)
    first, across = _beside(seam, run, run[-1] - gap + part * gap)
    if not cloth.contains(shapely.Point(first[_POINTS // 2] + 0.5 * across[_POINTS // 2])):
        across = -across
    second = first + np.maximum(part**_ROUND * _DEEP * s, _LEAST)[:, None] * across
    if not cloth.covers(shapely.Polygon([*first, *second[::-1]])):
        return []
    pieces: list[Trim] = [Patch(name, ref.panel, first, second, "hole", is_cut=False)]
    if with_edge:
        line = _edge(seam, run, run[-1] - gap, across[0], _ASIDE * s)
        inside = shapely.contains_xy(cloth.buffer(-_FROM_CAP - _ON_CLOTH), line)
        begins = int(inside.argmax())
        after = ~inside[begins:]
        line = line[begins : begins + (int(after.argmax()) if after.any() else len(after))]
        if len(line) < _FEWEST:
            return []
        pieces.append(_strip(name, ref.panel, line))
    return pieces


def _beside(seam: Floats, run: Floats, at: Floats) -> tuple[Floats, Floats]:
    """Points (n, 2) so far along the seam, and unit vectors at right angles to it."""
    points = np.stack([np.interp(at, run, seam[:, k]) for k in (0, 1)], axis=1)
    along = np.gradient(points, axis=0)
    across = np.stack([-along[:, 1], along[:, 0]], axis=1)
    return points, across / np.linalg.norm(across, axis=1, keepdims=True)


def _edge(seam: Floats, run: Floats, apex: float, inward: Floats, aside: float) -> Floats:
    """The upper half's edge (n, 2) from the upper end of the gap to the armhole."""
    part = np.linspace(0.0, 1.0, 40)
    points, across = _beside(seam, run, apex * (1 - part))
    across = across if float(across[0] @ inward) > 0 else -across
    return points + (aside * np.sin(np.pi / 2 * part))[:, None] * across


def _strip(name: str, panel: str, line: Floats) -> Patch:
    along = np.gradient(line, axis=0)
    across = np.stack([-along[:, 1], along[:, 0]], axis=1)
    across *= _LINE / np.linalg.norm(across, axis=1, keepdims=True)
    return Patch(name, panel, line + across, line - across, "dark", is_cut=False)

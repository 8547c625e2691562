"""Hems of flared skirts drawn anew, everywhere as far from the waist.

The sides of a circle skirt that a network writes are shorter than its middle, or longer: its hem is no arc
around the waist, and hangs in points.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.describing.measuring.parts import Part
from swifttailor.pattern import Arc, Line, Panel, Pattern
from swifttailor.pattern.curve import to_relative
from swifttailor.recutting.amounts import cuts
from swifttailor.recutting.table.cutter import Cutter

FLATTEST = 1e-4
"""Height of an arc over its chord, below which it is a line."""
BENT = 1.02
"""Length of a side over its chord, up to which it may be drawn as a line."""
SYMMETRIC_CM = 1.0
"""The hem's ends may be so unequally far from the middle of the panel."""


def round_hem(cutter: Cutter) -> Pattern | None:
    """Draws the hem of a skirt of a front and a back anew, as far from the waist as it was on average.

    Returns:
        The pattern; None where the hem is not one edge in front and one behind between two straight sides.
    """
    pattern, hem = cutter.pattern, cuts.free_hem(cutter)
    names = {panel.name for panel in cutter.anatomy.panels(Part.SKIRT)}
    if len(hem) != 2 or {ref.panel for ref in hem} != names or len(names) != 2:
        return None
    lengths = [_lengths(pattern.panel(ref.panel), ref.edge) for ref in hem]
    if any(length is None for length in lengths):
        return None
    # The middle of a panel stands for half of its hem.
    length = float(np.mean([0.5 * middle + 0.5 * side for middle, side in filter(None, lengths)]))
    panels = {ref.panel: _redrawn(pattern.panel(ref.panel), ref.edge, length) for ref in hem}
    return replace(pattern, panels=tuple(panels.get(p.name, p) for p in pattern.panels))


def _lengths(panel: Panel, hem: int) -> tuple[float, float] | None:
    """From the waist to the hem in the middle and along the sides, cm; None where the panel is another."""
    count = len(panel.edges)
    before, after = (hem - 1) % count, (hem + 1) % count
    if count < 4 or not all(_is_straight(panel, k) for k in (before, after)):
        return None
    starts, _ = _sides(panel, hem)
    ends = panel.chord(hem)
    axis = ends[:, 0].mean()
    if abs(starts[:, 0].mean() - axis) > SYMMETRIC_CM or abs(ends[0, 1] - ends[1, 1]) > SYMMETRIC_CM:
        return None
    top, bottom = _middle(panel, hem)
    sides = np.linalg.norm(ends - starts, axis=1)
    return float(np.linalg.norm(bottom - top)), float(sides.mean())


def _is_straight(panel: Panel, number: int) -> bool:
    """Whether an edge is a line, or bends so little that it may be one: sides of what was refitted."""
    if isinstance(panel.edges[number].curve, Line):
        return True
    points = panel.sample_edge(number, 17)
    along = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    return along <= BENT * float(np.linalg.norm(points[-1] - points[0]))


def _sides(panel: Panel, hem: int) -> tuple[Floats, Floats]:
    """Where the sides begin at the waist (2, 2), before and after the hem, and their directions (2, 2)."""
    count = len(panel.edges)
    starts = panel.vertices[[(hem - 1) % count, (hem + 2) % count]]
    along = panel.chord(hem) - starts
    return starts, along / np.linalg.norm(along, axis=1, keepdims=True)


def _middle(panel: Panel, hem: int) -> tuple[Floats, Floats]:
    """The middle of the waist and of the hem, (2,) each."""
    count = len(panel.edges)
    others = [k for k in range(count) if k not in ((hem - 1) % count, hem, (hem + 1) % count)]
    waist = np.concatenate([panel.sample_edge(k, 33) for k in others])
    axis = panel.chord(hem)[:, 0].mean()
    top = waist[np.abs(waist[:, 0] - axis).argmin()]
    return top, panel.sample_edge(hem, 3)[1]


def _redrawn(panel: Panel, hem: int, length: float) -> Panel:
    starts, along = _sides(panel, hem)
    top, bottom = _middle(panel, hem)
    ends = starts + length * along
    middle = top + length * (bottom - top) / np.linalg.norm(bottom - top)
    count = len(panel.edges)
    vertices = panel.vertices.copy()
    vertices[[hem, (hem + 1) % count]] = ends
    _, height = to_relative(middle, ends)
    curve: Arc | Line = Line()
    if abs(height) > FLATTEST:
        radius = (0.25 + height**2) / (2 * abs(height)) * float(np.linalg.norm(ends[1] - ends[0]))
        curve = Arc(radius, large=abs(height) > 0.5, right=height < 0)
    edges = list(panel.edges)
    edges[hem] = replace(edges[hem], curve=curve)
    for k in ((hem - 1) % count, (hem + 1) % count):
        edges[k] = replace(edges[k], curve=Line())
    return replace(panel, vertices=vertices, edges=tuple(edges))

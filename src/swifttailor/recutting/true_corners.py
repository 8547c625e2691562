"""Hems that meet side seams at right angles, so that their corners do not hang in points."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import Cubic, EdgeRef, Pattern
from swifttailor.pattern import curve as curves
from swifttailor.recutting.amounts import cuts
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.ends import move_ends

_DEEPEST = 0.75
"""A symmetric cubic reaches so much of the way to its control points."""
_REACH = 0.6
"""Of half the hem, at most, that a corner's curve takes up."""
_LEAST_SLANT = 0.05
"""Radians; a side that is steeper than this has a true corner."""
_LEAST_ALONG = 0.1
"""Cosine between a hem and the way straight out from its side; no curve meets one that goes on as it."""


def true_corners(cutter: Cutter, dip: float) -> Pattern | None:
    """Shortens the side seams of a flared hem, or lengthens them, and draws it to them in curves.

    Args:
        cutter: The pattern.
        dip: How much lower the corners hang than the middles between them, cm; negative where they are
            higher, as in the hems of gores that are cut in bows.

    Returns:
        The pattern; None where a panel has more than one edge of the hem, or the sides do not allow it.
    """
    hem = cuts.free_hem(cutter)
    if not hem or dip == 0.0 or len({ref.panel for ref in hem}) != len(hem):
        return None
    shorter = move_ends(cutter.pattern, hem, -dip)
    if shorter is None:
        return None
    for ref in hem:
        if len(shorter.panel(ref.panel).edges) != len(cutter.pattern.panel(ref.panel).edges):
            return None
        curved = _curved(shorter, ref, dip)
        if curved is None:
            return None
        shorter = curved
    return shorter


def _curved(pattern: Pattern, ref: EdgeRef, dip: float) -> Pattern | None:
    panel = pattern.panel(ref.panel)
    count = len(panel.edges)
    chord = panel.chord(ref.edge)
    way = chord[1] - chord[0]
    controls = []
    for corner, side, at, toward in ((0, ref.edge - 1, 1.0, way), (1, ref.edge + 1, 0.0, -way)):
        tangent = curves.derivative(panel.edges[side % count].curve, panel.chord(side % count), [at])[0]
        reach = _reach(tangent, toward, dip)
        if reach is None:
            return None
        controls.append(curves.to_relative(chord[corner] + reach, chord))
    edges = list(panel.edges)
    edges[ref.edge] = replace(edges[ref.edge], curve=Cubic(controls[0], controls[1]))
    panels = [replace(p, edges=tuple(edges)) if p.name == panel.name else p for p in pattern.panels]
    return replace(pattern, panels=tuple(panels))


def _reach(side: Floats, toward: Floats, dip: float) -> Floats | None:
    """From a corner to its control point (2,), at a right angle to the side; None if that leads nowhere."""
    long = float(np.linalg.norm(toward))
    square = np.array([-side[1], side[0]]) / np.linalg.norm(side)
    square = square if square @ toward > 0 else -square
    along = float(square @ toward) / long
    slant = float(np.arccos(np.clip(along, -1.0, 1.0)))
    if slant < _LEAST_SLANT:
        return toward / 3
    if along < _LEAST_ALONG:
        return None
    if dip < 0.0:
        return square * min(1.0 / 3, _REACH / 2) * long / along  # a bow around the waist
    return square * min(dip / _DEEPEST / np.sin(slant), _REACH * long / 2 / np.cos(slant))

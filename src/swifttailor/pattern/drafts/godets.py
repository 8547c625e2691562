"""Godets: wedges let into slits in the hem of a drafted skirt, so that it is close above and swings below."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Annotated

import numpy as np

from swifttailor.arrays import Array
from swifttailor.pattern import curve as curves
from swifttailor.pattern.curve import Line
from swifttailor.pattern.drafts.cutting_table import CuttingTable, Piece
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.outline import Outline, Side

GodetCount = Annotated[
    int,
    Option("Wedges let into the hem, all around; of an odd number one more is in front.", "godets", 0, 12),
]
GodetWidth = Annotated[float, Option("Width of each wedge along its hem.", "cm", 12.0, 60.0)]
GodetHeight = Annotated[float, Option("Height of each wedge.", "cm", 12.0, 60.0)]
_SLIT_CM = 1.6
"""Width of a slit at the hem before its wedge is sewn in: so little is taken from the skirt."""
_BESIDE_CM = 1.5
"""Least of the hem between two slits."""
_LEFT_ABOVE_CM = 16.0
"""What stays whole above the point of a wedge."""
_CLEAR = 0.85
"""How far slits reach towards where neighbours would meet."""
_POINTS = 13
"""On a curved edge of the panel, to tell how near slits come to it."""
_APART_CM = 5.0
"""How far wedges stand off the skirt before sewing."""


@dataclass(frozen=True)
class Godets:
    """How many wedges there are, and how large."""

    count: int
    """All around; of an odd number one more is in front."""
    width: float
    """Of each along its hem, cm."""
    height: float
    """Of each from point to hem, cm."""


def let_in_godets(table: CuttingTable, godets: Godets) -> None:
    """Slits the hems of ``skirt_front`` and ``skirt_back`` and sews ``ins_skirt_front_0`` ... into the slits.

    Args:
        table: Where the skirt lies already, the lowest edge of each panel called ``hem``.
        godets: What is let in.
    """
    for part, count in (("front", godets.count - godets.count // 2), ("back", godets.count // 2)):
        if count:
            _let_in(table, f"skirt_{part}", count, godets)


def _let_in(table: CuttingTable, name: str, count: int, godets: Godets) -> None:
    piece = table.pieces[name]
    (hem,) = piece.find("hem")
    slit = min(_SLIT_CM, hem.length / count - _BESIDE_CM)
    ends = [y for side in piece.sides for _, y in (side.start, side.end)]
    long = min(godets.height, max(ends) - min(ends) - _LEFT_ABOVE_CM)  # of a wedge's sides, and of the slit's
    half = slit / 2 / hem.length
    stops = [(k + 0.5) / count + sign * half for k in range(count) for sign in (-1, 1)]
    parts = hem.split(stops)
    along = 1.0 if hem.end[0] > hem.start[0] else -1.0  # the loops of backs are turned
    mouths = [(np.array(part.start), np.array(part.end)) for part in parts[1::2]]
    upwards = [along * _across(end - start) for start, end in mouths]
    middles = [(start + end) / 2 for start, end in mouths]
    others = [side for side in piece.sides if side is not hem]
    corners = [corner for mouth in mouths for corner in mouth]
    along_them = [up for up in upwards for _ in range(2)]
    long = min(long, _CLEAR * _meeting(middles, upwards), _CLEAR * _to_sides(corners, along_them, others))
    new: list[Side] = [parts[0]]
    slits: list[tuple[Side, Side]] = []
    for k, (start, end) in enumerate(mouths):
        rise = math.sqrt(long**2 - (float(np.hypot(*(end - start))) / 2) ** 2)
        x, y = (middles[k] + rise * upwards[k]).tolist()
        point = (x, y)
        up = Side(f"slit_{k}_up", parts[2 * k + 1].start, point)
        down = Side(f"slit_{k}_down", point, parts[2 * k + 1].end)
        new += [up, down, parts[2 * k + 2]]
        slits.append((up, down))
    table.replace_sides(piece, piece.sides.index(hem), 1, new)
    for k, (up, _) in enumerate(slits):
        wedge = f"ins_{name}_{k}"
        middle = along * (k - (count - 1) / 2) * godets.width
        _lay_wedge(table, piece, wedge, long, godets.width, (middle, up.start[1]))
        table.seam(f"{name}.slit_{k}_up", f"{wedge}.{'left' if along > 0 else 'right'}")
        table.seam(f"{name}.slit_{k}_down", f"{wedge}.{'right' if along > 0 else 'left'}")


def _across(chord: Array) -> Array:
    """The direction (2,) to the left of a chord (2,), of length 1."""
    return np.array([-chord[1], chord[0]]) / float(np.hypot(*chord))


def _meeting(middles: Sequence[Array], upwards: Sequence[Array]) -> float:
    """How far above a bent hem neighbouring slits would meet, cm; infinite where they spread."""
    least = math.inf
    for (a, b), (u, v) in zip(pairwise(middles), pairwise(upwards), strict=True):
        apart, gap = float(u[0] * v[1] - u[1] * v[0]), b - a
        if abs(apart) > 1e-9:
            far = min(float(gap[0] * w[1] - gap[1] * w[0]) / apart for w in (u, v))
            least = min(least, far) if far > 0.0 else least
    return least


def _to_sides(corners: Sequence[Array], upwards: Sequence[Array], sides: Sequence[Side]) -> float:
    """How far above the hem a slit would reach another edge of its panel, cm."""
    least = math.inf
    chords = [ends for side in sides for ends in pairwise(_points_along(side))]
    for at, up in zip(corners, upwards, strict=True):
        for begins, ends in chords:
            start, chord = begins - at, ends - begins
            apart = float(up[0] * chord[1] - up[1] * chord[0])
            if abs(apart) < 1e-9:
                continue
            far = float(start[0] * chord[1] - start[1] * chord[0]) / apart
            share = float(start[0] * up[1] - start[1] * up[0]) / apart
            least = min(least, far) if far > 0.0 and 0.0 <= share <= 1.0 else least
    return least


def _points_along(side: Side) -> Array:
    """Points (n, 2) of an edge from which to which it is taken as straight: many of a curve."""
    count = 2 if isinstance(side.curve, Line) else _POINTS
    return curves.evaluate(side.curve, side.chord, np.linspace(0.0, 1.0, count))


def _lay_wedge(
    table: CuttingTable, piece: Piece, name: str, long: float, width: float, at: tuple[float, float]
) -> None:
    """A wedge, its hem an arc around its point, in front of its panel: wedges stand side by side."""
    half = min(width / (2 * long), 1.2)  # radians between the middle and either side
    x, y = long * math.sin(half), -long * math.cos(half)
    outline = Outline(-x, y).arc("hem", (x, y), long, right=True).line("right", 0.0, 0.0)
    outline.line("left", -x, y).closed()
    back = piece.name.endswith("back")
    z = piece.placement.translation[2] + (-_APART_CM if back else _APART_CM)
    table.lay(name, outline, label=piece.label, at=(at[0], at[1] - y, z), back=back)

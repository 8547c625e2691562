"""Fronts that seem to cross: the right one runs on over the middle, down to the left side.

Cloth lies in one layer, so nothing overlaps: where the edge of the upper front would lie there is a seam,
which carries the line of the right neckline on.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from swifttailor.pattern import curve as curves
from swifttailor.pattern.drafts.cutting_table import CuttingTable, Piece
from swifttailor.pattern.drafts.outline import Outline, Point, Side

LOWER = "left_ftorso"
"""The front that ends at the seam."""
UPPER = "right_ftorso"
"""The front that reaches to the other side."""
_FROM_SEAM = 1.5
"""Darts end so far from the seam, cm, or halfway to it where there is little room."""
_TANGENT = 0.4
"""How far across the front the seam carries the line of the neckline on, as a part of the way."""
_ABOVE_CORNER = 0.3
"""It never falls below this part of its height before it reaches the side."""


def shorten_darts(table: CuttingTable) -> None:
    """Makes the darts of the left front end before the seam where the fronts will cross; before `mirror`."""
    piece = table.pieces[LOWER]
    points, first = _seam_line(piece).sample, _first_side(piece)
    for k, (leg, other) in enumerate(zip(piece.sides[:-1], piece.sides[1:], strict=True)):
        if (leg.name, other.name) != ("dart", "dart"):
            continue
        mouth, tip = (np.array(leg.start) + other.end) / 2, np.array(leg.end)
        # From the mouth to the tip, as far as it stays below the seam (waist) or above it (side).
        reaches = np.linspace(0.0, 1.0, 101)
        way = mouth + reaches[:, None] * (tip - mouth)
        room = way[:, 1] - np.interp(way[:, 0], points[:, 0], points[:, 1])
        room = -room if k < first else room
        free = reaches[room > min(_FROM_SEAM, room[0] / 2)]
        x, y = mouth + (free[-1] if len(free) else 0.0) * (tip - mouth)
        piece.sides[k] = replace(leg, end=(float(x), float(y)))
        piece.sides[k + 1] = replace(other, start=(float(x), float(y)))


def cross_fronts(table: CuttingTable, above_hem: float = 0.0) -> None:
    """Gives what lies below the seam to the right front, and sews the fronts along it; after `mirror`.

    The seam ends on the left side seam, `above_hem` cm from its lower end.
    Edges of ``left_ftorso`` are then side, armhole, shoulder, neck, cross and the darts of the side; those
    of ``right_ftorso`` are the others and cross, its lower edge reaching from side to side. Both fronts must
    lie in one plane, in the same place.
    """
    lower, upper = table.pieces[LOWER], table.pieces[UPPER]
    if above_hem:
        table.cut_seam(f"{LOWER}.side", above_hem / lower.length("side"))
        cut = _first_side(lower)
        lower.sides[cut] = lower.sides[cut].renamed("lower_side")
    seam = _seam_line(lower).side
    first = _first_side(lower)
    given, kept = lower.sides[:first], lower.sides[first:]
    at = next(k for k, side in enumerate(upper.sides) if side.name == "centre")
    upper_sides = [*upper.sides[at + 1 :], *upper.sides[:at]]
    turned = seam.reversed()
    lower.sides = [*[side for side in kept if side.name != "centre"], seam]
    upper.sides = [*upper_sides, *given, replace(turned, serial=Side("", (0, 0), (1, 0)).serial)]
    table.seam(f"{LOWER}.cross", f"{UPPER}.cross")


class _SeamLine:
    """The seam, from the point of the neckline to the left side seam."""

    def __init__(self, side: Side) -> None:
        self.side = side
        self.sample = curves.evaluate(side.curve, side.chord, np.linspace(0.0, 1.0, 65))
        """(65, 2) points along it, cm."""


def _first_side(piece: Piece) -> int:
    return next(k for k, side in enumerate(piece.sides) if side.name == "side")


def _seam_line(piece: Piece) -> _SeamLine:
    neck = piece.find("neck")[-1]
    corner, point = piece.sides[_first_side(piece)].start, neck.end
    # The right neckline is the mirror image of the left one: beyond the middle it goes on with the same fall.
    dx, dy = curves.derivative(neck.curve, neck.chord, [1.0])[0]
    fall = abs(dy) / max(abs(dx), 1e-9)
    drop = point[1] - corner[1]
    across = min(_TANGENT * corner[0], (1 - _ABOVE_CORNER) * drop / max(fall, 1e-9))
    control = (across, point[1] - fall * across)
    outline = Outline(*point).quadratic("cross", _below_chord(control, point, corner), corner)
    return _SeamLine(outline.sides[0])


def _below_chord(control: Point, start: Point, end: Point) -> Point:
    """The control point, but not above the chord: a shallow neckline is carried on straight."""
    t = control[0] / (end[0] - start[0])
    return control[0], min(control[1], start[1] + t * (end[1] - start[1]) - 1e-6 * math.dist(start, end))

"""Necklines of the torso halves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.outline import Outline, Point

BARE_BACK = 18.0
"""A back neckline deeper than this bares the back: it runs down beside the shoulder blades, cm."""
_ABOVE_SEAM = 2.0
"""How much of the middle of such a back is left above its lower edge, cm."""

_DEEPEST_WIDE = 22.0
"""The deepest neckline that is as wide below as above, cm."""
_LOBES = 0.34
"""How far the lobes of a heart begin above its lowest point, as a part of its depth."""

NeckShape = Literal["round", "v", "square", "sweetheart"]


@dataclass(frozen=True)
class Neckline:
    """Where the neckline runs, relative to the point where neck meets shoulder."""

    shape: NeckShape = "round"
    """Shape of the front; the back is always round."""
    widening: float = 1.0
    """How far along the shoulder the neckline starts, outward from the neck, cm."""
    front_depth: float = 9.0
    """Fall of the centre front below the neck-shoulder point, cm."""
    back_depth: float = 2.0
    """Fall of the centre back below the neck-shoulder point, cm."""

    def start_x(self, figure: Figure) -> float:
        """Where on the shoulder the neckline starts; at least 3 cm of shoulder remain."""
        return min(figure.neck_x + self.widening, figure.shoulder_x - 3.0)

    @property
    def fall_in_front(self) -> float:
        """Fall of the centre front, cm: only a V may be deeper than what lies between armholes and darts."""
        return self.front_depth if self.shape == "v" else min(self.front_depth, _DEEPEST_WIDE)

    @property
    def bares_back(self) -> bool:
        """Whether it leaves the back bare, as that of a backless dress."""
        return self.back_depth > BARE_BACK


def draw_neckline(outline: Outline, start: Point, depth: float, slope: float, shape: NeckShape) -> None:
    """Draws from the shoulder point `start` to the middle line x = 0, `depth` cm lower.

    Round and square necklines, and the sides of hearts, leave the shoulder at right angles, so that front and
    back join smoothly.

    Args:
        outline: Continues at `start`.
        start: Shoulder end of the neckline, local cm.
        depth: Fall from `start` to the middle, cm.
        slope: Fall of the shoulder over its run.
        shape: Shape of the curve.
    """
    x, y = start
    low = y - depth
    if shape == "v":
        outline.quadratic("neck", (x * 0.55, low + depth * 0.38), (0.0, low))
    elif shape == "square":
        corner = x - min(slope, 0.3) * depth * 0.35
        outline.quadratic("neck", (corner - 0.1 * x, y - 0.55 * depth), (corner * 0.92, low))
        outline.line("neck", 0.0, low)
    elif shape == "sweetheart":
        side = (0.94 * (x - min(slope, 0.3) * depth * 0.25), low + _LOBES * depth)
        outline.quadratic("neck", (side[0] - 0.06 * x, y - 0.45 * depth), side)
        outline.cubic(
            "neck", (0.7 * x, low + 1.05 * _LOBES * depth), (0.22 * x, low + 0.9 * _LOBES * depth), (0.0, low)
        )
    else:
        run = min(0.55 * depth, 0.8 * x)
        outline.cubic("neck", (x - slope * run, y - run), (0.56 * x, low), (0.0, low))


def draw_bare_back(outline: Outline, start: Point, depth: float, widest: float) -> None:
    """Draws a wide scoop from the shoulder point `start` to the middle line x = 0, `depth` cm lower.

    Args:
        outline: Continues at `start`.
        start: Shoulder end of the neckline, local cm.
        depth: Fall from `start` to the middle, cm; less where the panel ends above.
        widest: How far from the middle it may lie, cm.
    """
    x, y = start
    foot = outline.sides[0].start[1]
    low = y - max(min(depth, y - foot - _ABOVE_SEAM), 0.5)
    aside = max(min(1.45 * x, widest), 0.8 * x)
    outline.cubic("neck", (min(x + 1.0, aside), y - 0.45 * (y - low)), (aside, low), (0.0, low))

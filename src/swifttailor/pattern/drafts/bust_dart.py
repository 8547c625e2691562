"""The bust dart of fitted bodices, from the side seam to the bust."""

from __future__ import annotations

import math

from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.outline import Outline, Point

_ABOVE_HEM_CM = 2.0
"""The dart ends so far above the lower end of the seam at least, as where a hem lies above the bust."""
_BESIDE_EDGE_CM, _EDGE_CM = 1.0, 24.0
"""It ends so far beside the edge of an open front, which comes to the middle within about so much height."""


def draw_side_with_bust_dart(outline: Outline, figure: Figure, underarm: Point) -> None:
    """Draws the front side seam with a dart that points to the bust.

    The seam is drawn as on the back and cut a little below the underarm; what lies above is turned about
    the tip of the dart. So the closed seam is exactly as long as the back's.
    """
    start = outline.sides[-1].end
    length = math.dist(start, underarm)
    t = 1 - min(6.0, 0.45 * length) / length
    mouth = (start[0] + t * (underarm[0] - start[0]), start[1] + t * (underarm[1] - start[1]))
    tip_y = max(min(figure.bust_y, underarm[1] - 1.0), start[1] + _ABOVE_HEM_CM)
    edge_x, low = outline.sides[0].start
    edge_x *= max(1.0 - (tip_y - low) / _EDGE_CM, 0.0)
    tip = (min(max(figure.bust_x + 2.5, edge_x + _BESIDE_EDGE_CM), mouth[0] - 4.0), tip_y)
    reach = math.dist(tip, mouth)
    opening = min(0.9 * figure.front_fullness, 0.35 * reach)
    if opening < 0.8:
        outline.line("side", *underarm)
        return
    angle = 2 * math.asin(opening / (2 * reach))
    outline.line("side", *mouth)
    outline.dart(tip, _turned(mouth, tip, angle))
    outline.line("side", *_turned(underarm, tip, angle))


def _turned(point: Point, center: Point, angle: float) -> Point:
    c, s = math.cos(angle), math.sin(angle)
    x, y = point[0] - center[0], point[1] - center[1]
    return center[0] + c * x - s * y, center[1] + s * x + c * y

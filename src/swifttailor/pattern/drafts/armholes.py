"""Edges of a torso around the arms: round to the shoulder, or cut in between the shoulder blades."""

from __future__ import annotations

import math

from swifttailor.pattern.drafts.outline import Outline, Point

RACER_NECK = 0.34
"""How deep the neck above a back that is cut in may be, as a part of the height from underarm to shoulder."""
_RACER_CM, _RACER_SHARE = 5.6, 0.42
"""Half of what is left between the shoulder blades, cm; how high that is, between underarm and shoulder."""
RACER_STRAP_CM = 4.0
"""Width of the straps of dresses whose back is cut in."""
_LEANS = math.radians(15.0)
"""By how much its end is turned to the middle."""
_STRAIGHT = 0.4
"""How far the strap behind leans to the middle at its end, as a part of its way there."""


def armhole(outline: Outline, tip: Point, slope: float, scoop: float) -> None:
    """Draws from the underarm point to the shoulder `tip`, at right angles to side and shoulder.

    Args:
        outline: Continues at the underarm point.
        tip: Shoulder end, local cm.
        slope: Fall of the shoulder over its run.
        scoop: How deep the lower bend is cut, 0.4 (back) to 0.75 (front).
    """
    start = outline.sides[-1].end
    across, rise = start[0] - tip[0], tip[1] - start[1]
    reach = 0.52 * rise
    inward = (start[0] - scoop * across - 0.06 * rise, start[1] + 0.04 * rise)
    outline.cubic("armhole", inward, (tip[0] - slope * reach, tip[1] - reach), tip)


def leaning_tip(neck: Point, tip: Point) -> Point:
    """The end of the shoulder of a back that is cut in, turned down: its strap runs aslant to the middle.

    Otherwise the outer edge of the strap is too long, and stands up behind the shoulder.

    Args:
        neck: Where the shoulder begins, local cm.
        tip: Where it would end, local cm.
    """
    x, y = tip[0] - neck[0], tip[1] - neck[1]
    c, s = math.cos(_LEANS), math.sin(_LEANS)
    return neck[0] + c * x + s * y, neck[1] - s * x + c * y


def racer_armhole(outline: Outline, tip: Point, slope: float) -> None:
    """Draws from the underarm point in between the shoulder blades, and out again to the shoulder `tip`.

    Args:
        outline: Continues at the underarm point.
        tip: Shoulder end, local cm.
        slope: Fall of the shoulder over its run.
    """
    x, y = outline.sides[-1].end
    rise = tip[1] - y
    inner = (min(_RACER_CM, 0.5 * tip[0]), y + _RACER_SHARE * rise)
    outline.cubic("armhole", (x - 0.6 * (x - inner[0]), y + 0.03 * rise), (inner[0], y + 0.2 * rise), inner)
    # A strap that left the shoulder at right angles would have to bend, and stand up where it does.
    inward = max(slope, _STRAIGHT * (tip[0] - inner[0]) / (0.3 * rise))
    above = (tip[0] - inward * 0.3 * rise, tip[1] - 0.3 * rise)
    outline.cubic("armhole", (inner[0], inner[1] + 0.25 * rise), above, tip)

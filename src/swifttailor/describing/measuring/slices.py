"""How wide placed panels are where a plane cuts them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike

from swifttailor.arrays import Floats
from swifttailor.pattern import Panel

_OUTLINE_CM = 0.05


def width_in_plane(panel: Panel, normal: ArrayLike, offset: float) -> float:
    """Length of the cut that a plane makes through a placed panel; notches and darts are left out, cm.

    Args:
        panel: Any panel.
        normal: (3,) unit normal of the plane in the world.
        offset: The plane holds the points whose product with `normal` is this, cm.
    """
    points = panel.outline(_OUTLINE_CM)
    across = panel.placement.matrix()[:, :2].T @ np.asarray(normal, np.float64)
    size = float(np.hypot(*across))
    if size < 1e-6:
        return 0.0
    height = panel.to_world(points) @ np.asarray(normal, np.float64) - offset
    height[height == 0.0] = 1e-12  # a corner on the plane belongs to one side
    following = np.roll(height, -1)
    crossing = (height > 0) != (following > 0)
    t = (height / (height - np.where(crossing, following, height - 1.0)))[crossing]
    ends = np.roll(points, -1, axis=0)[crossing]
    cuts = points[crossing] * (1 - t)[:, None] + ends * t[:, None]
    along = np.array([-across[1], across[0]]) / size
    places = np.sort(cuts @ along)
    return float((places[1::2] - places[::2]).sum())


def half_widths(panel: Panel, levels: Sequence[float], *, inmost: bool = False) -> Floats:
    """How far a placed panel reaches from its side of the middle to its outer edge at some heights, cm.

    Necklines and darts on the way are passed over, so that a bodice can be measured through them. For a
    panel across the middle it is the whole distance between its outer edges.

    Args:
        panel: Any panel.
        levels: The heights, cm.
        inmost: Look no further than to where the panel first ends: what lies beyond is a sleeve of its cloth.
    """
    points = panel.to_world(panel.outline(_OUTLINE_CM))
    low, high = float(points[:, 0].min()), float(points[:, 0].max())
    across = lies_across(panel)
    widths = np.zeros(len(levels))
    for k, level in enumerate(levels):
        cuts = _cuts(points, level)
        if inmost:
            cuts = _from_middle(points, cuts)
        if len(cuts):
            widths[k] = (
                np.ptp(cuts) if across or inmost else cuts.max() - low if high > -low else high - cuts.min()
            )
    return widths


def lies_across(panel: Panel) -> bool:
    """Whether a placed panel reaches far over the middle of the body."""
    x = panel.to_world(panel.outline(_OUTLINE_CM))[:, 0]
    low, high = float(x.min()), float(x.max())
    return min(-low, high) > 0.2 * (high - low)


def whole_widths(panels: Sequence[Panel], levels: Sequence[float], *, inmost: bool = False) -> Floats:
    """From outer edge to outer edge of placed panels of one face at some heights, cm.

    Args:
        panels: Of the face.
        levels: The heights, cm.
        inmost: As `half_widths` has it, for the halves of a face that reach over each other.
    """
    outlines = [panel.to_world(panel.outline(_OUTLINE_CM)) for panel in panels]
    widths = np.zeros(len(levels))
    for k, level in enumerate(levels):
        cuts = [_cuts(points, level) for points in outlines]
        if inmost:
            cuts = [_from_middle(points, each) for points, each in zip(outlines, cuts, strict=True)]
        joined = np.concatenate(cuts)
        widths[k] = np.ptp(joined) if len(joined) else 0.0
    return widths


def _from_middle(points: Floats, cuts: Floats) -> Floats:
    """Where the outline of a half passes a height in the middle and at the side."""
    ordered = np.sort(cuts)
    return ordered[:2] if points[:, 0].mean() > 0 else ordered[-2:]


def _cuts(points: Floats, level: float) -> Floats:
    """Where an outline (n, 3) passes a height: x (m,), cm."""
    x, height = points[:, 0], points[:, 1] - level
    following = np.roll(height, -1)
    crossing = (height > 0) != (following > 0)
    t = height[crossing] / (height[crossing] - following[crossing])
    return x[crossing] * (1 - t) + np.roll(x, -1)[crossing] * t


def girth_at(panels: Iterable[Panel], level: float) -> float:
    """Widths of some placed panels at a height together, cm."""
    return sum(width_in_plane(p, (0.0, 1.0, 0.0), level) for p in panels)

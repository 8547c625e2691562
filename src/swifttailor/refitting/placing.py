"""Where the panels of a refitted pattern stand around the other body."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import Panel, Pattern
from swifttailor.pattern.check import panel_regions
from swifttailor.refitting.body_profile import BodyProfile
from swifttailor.refitting.stretch import ease_scale, height_map

_EDGE_ON_CM = 4.0
_OVER_CM = 8.0
"""Panels that reach less far over the middle belong to one side: crotches do so."""


def placed_on(before: Pattern, after: Pattern, start: BodyProfile, end: BodyProfile) -> Pattern:
    """Moves each panel to where its middle stood beside the first body.

    Args:
        before: Placed around the first body.
        after: The same panels in other sizes.
        start: The first body.
        end: The second body.
    """
    regions = panel_regions(before)
    panels = []
    for old, new in zip(before.panels, after.panels, strict=True):
        middle = _middle(old)
        point = old.to_world(middle[None])[0]
        if regions[old.name] == "arm":
            wanted = _arm_place(point, start, end)
        else:
            wanted = _trunk_place(point, _wider(old, new), start, end)
            if regions[old.name] == "leg" and _beside(old):
                wanted[0] = _leg_place(point, _wider(old, new) or 1.0, start, end)
        shift = wanted - old.placement.matrix()[:, :2] @ _middle(new)
        x, y, z = shift.tolist()
        panels.append(replace(new, placement=replace(old.placement, translation=(x, y, z))))
    return replace(after, panels=tuple(panels))


def _beside(panel: Panel) -> bool:
    """Whether a panel hangs on one side of the body, as those of trousers do."""
    x = panel.to_world(panel.outline(0.5))[:, 0]
    return min(float(x.max()), -float(x.min())) < _OVER_CM


def _leg_place(point: Floats, wider: float, start: BodyProfile, end: BodyProfile) -> float:
    """X beside the other leg as beside the first."""
    x, y, _ = point
    low, high = start.leg_heights[[0, -1]]
    at = float(np.clip(y, low, high))
    leg, leg_2 = (float(np.interp(at, start.leg_heights, body.leg_middle)) for body in (start, end))
    return float(np.sign(x) * (leg_2 + wider * (abs(x) - leg)))


def _wider(old: Panel, new: Panel) -> float | None:
    """How many times as wide as it was a panel is, seen from the front; None where it is seen edge-on."""
    across = old.placement.matrix()[0, :2]
    was, now = (float(np.ptp(panel.outline(0.5) @ across)) for panel in (old, new))
    return now / was if was > _EDGE_ON_CM else None


def _middle(panel: Panel) -> Floats:
    box = np.array([panel.vertices.min(axis=0), panel.vertices.max(axis=0)])
    return box.mean(axis=0)


def _trunk_place(point: Floats, wider: float | None, start: BodyProfile, end: BodyProfile) -> Floats:
    """Before or behind the other trunk, as far away for its size, at the same place of its height.

    Args:
        point: (3,) middle of a panel beside the first body, cm.
        wider: How many times as wide as it was the panel is: panels that met in the middle still do.
        start: The first body.
        end: The second body.
    """
    x, y, z = point
    height = float(np.clip(y, start.heights[0], start.heights[-1]))
    half, side, ahead, behind = (np.interp(height, start.heights, values) for values in _widths(start))
    half_2, side_2, ahead_2, behind_2 = (np.interp(height, start.heights, values) for values in _widths(end))
    scale = ease_scale(start, end)
    x_2 = x * (half_2 / half if wider is None else wider)
    deep = side_2 + ahead_2 + scale * (z - side - ahead)
    if z < side:
        deep = side_2 - behind_2 + scale * (z - side + behind)
    return np.array([x_2, float(height_map(start, end)(np.clip(y, -20.0, 260.0))), deep])


def _widths(body: BodyProfile) -> tuple[Floats, ...]:
    return body.half_width, body.side, body.ahead, body.behind


def _arm_place(point: Floats, start: BodyProfile, end: BodyProfile) -> Floats:
    """Beside the arm: as far along it as before, as a share, and further out by as much as it is thicker."""
    sign = -1.0 if point[0] < 0 else 1.0
    offset = point * [sign, 1.0, 1.0] - start.shoulder
    down = float(offset @ start.arm_axis)
    beside = offset - down * start.arm_axis
    away = float(np.linalg.norm(beside))
    radius, radius_2 = (float(body.arm[0]) / (2 * np.pi) for body in (start, end))
    out = radius_2 + ease_scale(start, end) * (away - radius)
    beside = beside * max(out / max(away, 1e-6), 0.3)
    longer = end.measurements.arm_length / start.measurements.arm_length
    placed = end.shoulder + down * longer * end.arm_axis + beside
    return placed * [sign, 1.0, 1.0]

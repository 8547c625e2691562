"""Where the panels of a refitted pattern stand around the other body."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import Panel, Pattern
from swifttailor.pattern.check import panel_regions
from swifttailor.refitting.body_profile import BodyProfile
from swifttailor.refitting.stretch import height_map


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
        move = _arm_place if regions[old.name] == "arm" else _trunk_place
        wanted = move(old.to_world(middle[None])[0], start, end)
        local = _middle(new)
        shift = wanted - old.placement.matrix()[:, :2] @ local
        x, y, z = shift.tolist()
        panels.append(replace(new, placement=replace(old.placement, translation=(x, y, z))))
    return replace(after, panels=tuple(panels))


def _middle(panel: Panel) -> Floats:
    box = np.array([panel.vertices.min(axis=0), panel.vertices.max(axis=0)])
    return box.mean(axis=0)


def _trunk_place(point: Floats, start: BodyProfile, end: BodyProfile) -> Floats:
    x, y, z = point
    height = float(np.clip(y, start.heights[0], start.heights[-1]))
    at = [np.interp(height, start.heights, values) for values in _widths(start)]
    to = [np.interp(height, start.heights, values) for values in _widths(end)]
    half, side, ahead, behind = np.subtract(to, at)
    side_0 = at[1]
    out = float(np.clip(x / max(at[0], 1e-6), -1.0, 1.0))
    deep = side + (ahead if z >= side_0 else -behind)
    return np.array([x + out * half, float(height_map(start, end)(np.clip(y, -20.0, 260.0))), z + deep])


def _widths(body: BodyProfile) -> tuple[Floats, ...]:
    return body.half_width, body.side, body.ahead, body.behind


def _arm_place(point: Floats, start: BodyProfile, end: BodyProfile) -> Floats:
    """Beside the arm: as far along it as before, as a share, and further out by as much as it is thicker."""
    sign = -1.0 if point[0] < 0 else 1.0
    offset = point * [sign, 1.0, 1.0] - start.shoulder
    down = float(offset @ start.arm_axis)
    beside = offset - down * start.arm_axis
    away = float(np.linalg.norm(beside))
    thicker = float(end.arm[0] - start.arm[0]) / (2 * np.pi)
    beside = beside * max(1.0 + thicker / max(away, 1e-6), 0.5)
    longer = end.measurements.arm_length / start.measurements.arm_length
    placed = end.shoulder + down * longer * end.arm_axis + beside
    return placed * [sign, 1.0, 1.0]

"""Thin lines beside edges of panels: where stitches of another colour lie."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Patch, Trim

_HALF = 0.17
"""Half the width of a line as it is drawn, cm."""
_SHORTEST = 2.0
"""Shorter lines are left out, cm."""
_POINTS, _SLACK, _LEAST = 31, 0.02, 0.5
"""Points along an edge; how exactly a line lies on its panel, and what part of it has to."""


def beside_edge(chalk: Chalk, name: str, ref: EdgeRef, inside: float) -> list[Trim]:
    """A line along an edge of a panel, so far inside of it, cm; its ends are cut off where they leave it."""
    import shapely

    panel = chalk.pattern.panel(ref.panel)
    edge = panel.sample_edge(ref.edge, _POINTS)
    cloth = shapely.Polygon(panel.outline(0.01)).buffer(_SLACK)
    across = _across(edge)
    middle = _POINTS // 2
    if not cloth.contains(shapely.Point(edge[middle] + 0.3 * across[middle])):
        across = -across
    near, far = (edge + (inside + way * _HALF) * across for way in (-1.0, 1.0))
    held = shapely.contains_xy(cloth, near) & shapely.contains_xy(cloth, far)
    found = np.flatnonzero(held)
    if len(found) < _LEAST * _POINTS or np.ptp(found) != len(found) - 1:
        return []
    near, far = near[found], far[found]
    length = float(np.linalg.norm(np.diff(near, axis=0), axis=1).sum())
    is_plain = length >= _SHORTEST and shapely.Polygon([*near, *far[::-1]]).is_valid
    return _patch(name, panel, near, far) if is_plain else []


def inside_patch(chalk: Chalk, name: str, patch: Patch, inside: float) -> list[Trim]:
    """A line around a piece that is sewn on, but for its upper edge, so far inside of it, cm."""
    import shapely

    panel = chalk.pattern.panel(patch.panel)
    ring = shapely.Polygon(patch.outline).buffer(-inside, join_style="mitre").exterior
    corners = np.array(ring.coords)[:-1] if not ring.is_empty else np.zeros((0, 2))
    if len(corners) < 3:
        return []
    heights = panel.to_world(corners)[:, 1]
    top = np.argsort(heights)[-2:]
    first = int(top[0]) if (top[0] + 1) % len(corners) != top[1] else int(top[1])
    line = np.roll(corners, -first, axis=0)
    across = _across(line)
    first, second = line - _HALF * across, line + _HALF * across
    return _patch(name, panel, first, second) if shapely.Polygon([*first, *second[::-1]]).is_valid else []


def _across(line: Floats) -> Floats:
    """(n, 2) unit vectors at right angles to a line (n, 2)."""
    along = np.gradient(line, axis=0)
    across = np.stack([-along[:, 1], along[:, 0]], axis=1)
    return across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-9)


def _patch(name: str, panel: Panel, first: Floats, second: Floats) -> list[Trim]:
    return [Patch(name, panel.name, first, second, "dark", is_cut=False)]

"""One piece of a trim in space, and the balls that knots are made of."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array, Floats, Ints

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment

AROUND = 16
"""Corners of what is round."""


@dataclass(frozen=True, eq=False)
class TrimMesh:
    """One piece of a trim in space."""

    trim: str
    """A name of `pattern.trims.TRIMS`."""
    look: str
    """``cloth``, ``dark``, ``metal``, ``button``, ``leather``, or of a rip ``hole`` or ``thread``."""
    vertices: Floats
    """(n, 3) cm."""
    faces: Ints
    """(f, 3)."""
    lines: Ints
    """(k, 2) edges that show: of what is sewn on, its border."""
    cloth_at: Floats | None = None
    """(f, 3, 2) where on the cloth the corners of the faces lie, cm, so that prints run on over pockets; None
    of what is not of the garment's cloth, or goes around it."""
    flat: Floats | None = None
    """(n, 2) the vertices on their panel, panel-local cm; None of what goes around the body."""
    panel: str = ""
    """Name of the panel that it lies on; empty of what goes around the body."""
    opacity: float = 1.0
    """Share of what lies beneath that it hides."""


def ball(middle: Array, radii: tuple[float, float, float]) -> tuple[Floats, Ints]:
    """A coarse ellipsoid: vertices (n, 3), cm, and faces (f, 3).

    Args:
        middle: (3,) cm.
        radii: Along x, y and z, cm.
    """
    up, around = np.linspace(-np.pi / 2, np.pi / 2, 7), np.arange(AROUND) * (2 * np.pi / AROUND)
    a, b = np.meshgrid(up, around, indexing="ij")
    points = np.stack([np.cos(a) * np.sin(b), np.sin(a), np.cos(a) * np.cos(b)], axis=-1)
    vertices = middle + points.reshape(-1, 3) * radii
    grid = np.arange(len(vertices)).reshape(a.shape)
    after = np.roll(grid, -1, axis=1)
    quads = np.stack([grid[:-1], after[:-1], after[1:], grid[1:]], axis=-1).reshape(-1, 4)
    # At the poles a ring is one point, and half of each quad has no area.
    return vertices, np.concatenate([quads[AROUND:, [0, 1, 2]], quads[:-AROUND, [0, 2, 3]]]).astype(np.int32)


def front_of(garment: Garment, x: float, y: float, outward: float = 1.0) -> float:
    """The z of the foremost vertex near a place, NaN where there is none; of the hindmost, outward -1."""
    away = np.abs(garment.vertices[:, :2] - (x, y)).max(axis=1)
    near = away < 2.0
    if not near.any():
        return float("nan")
    return outward * float((outward * garment.vertices[near, 2]).max())

"""Shapes that figures to print are put together from, on a square from -1 to 1, y up."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from swifttailor.arrays import Array

Shape = Callable[[Array, Array], Array]
"""Which points (n, n) of a square it covers."""


def oval(cx: float, cy: float, rx: float, ry: float, turn: float = 0.0) -> Shape:
    """An ellipse, turned to the left by so many degrees."""
    cos, sin = np.cos(np.radians(turn)), np.sin(np.radians(turn))

    def covers(x: Array, y: Array) -> Array:
        along, across = (x - cx) * cos + (y - cy) * sin, (y - cy) * cos - (x - cx) * sin
        return (along / rx) ** 2 + (across / ry) ** 2 < 1.0

    return covers


def polygon(*corners: tuple[float, float]) -> Shape:
    """What lies inside of a closed line."""

    def covers(x: Array, y: Array) -> Array:
        inside = np.zeros(x.shape, bool)
        for (ax, ay), (bx, by) in zip(corners, (*corners[1:], corners[0]), strict=True):
            if ay != by:
                inside ^= ((ay > y) != (by > y)) & (x < ax + (y - ay) * (bx - ax) / (by - ay))
        return inside

    return covers


def line(ax: float, ay: float, bx: float, by: float, half: float) -> Shape:
    """A stroke with round ends."""

    def covers(x: Array, y: Array) -> Array:
        dx, dy = bx - ax, by - ay
        share = np.clip(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0)
        return np.hypot(x - ax - share * dx, y - ay - share * dy) < half

    return covers


def star(cx: float, cy: float, size: float, points: int = 5) -> Shape:
    """A star, one point up."""
    turns = np.pi / 2 + np.pi * np.arange(2 * points) / points
    radii = [size if k % 2 == 0 else 0.42 * size for k in range(2 * points)]
    return polygon(*[(cx + r * np.cos(t), cy + r * np.sin(t)) for r, t in zip(radii, turns, strict=True)])


def in_pairs(*shapes: tuple[int, Shape]) -> list[tuple[int, Shape]]:
    """Each shape and its image on the other side."""
    return [(ink, lambda x, y, own=shape: own(x, y) | own(-x, y)) for ink, shape in shapes]

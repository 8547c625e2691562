"""What prints show at the samples of a picture: one pass over them, only where something has a print."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.cloth_table import (
    BLUR,
    CHECKS,
    COORDINATES,
    FOLDS,
    KIND,
    PLAID,
    SIZES,
    STRIPES,
    TableOfPrint,
    layers,
    new_table,
)
from swifttailor.render.prints import bank_of
from swifttailor.render.scene import Projection
from swifttailor.render.surface import Surface

_FINE, _AVERAGED = 2.0, 1.5
"""Bands narrower than so many pixels are averaged over so many of them: they fade, but keep straight."""


@dataclass(frozen=True, eq=False)
class Paint:
    """Colours of the samples that show a print."""

    painted: Array
    """(surfaces,) int8: 0 without a print, 1 with a print, 2 with one that has folds."""
    paint: Array
    """(H, W, 3) float32 linear colours, set only where a print is seen; (0, 0, 3) without any."""
    bumps: Array
    """(H, W, 3) float32 by which folds tilt unit normals, in the world; (0, 0, 3) without any."""


def paint_prints(projection: Projection, samples: int, *, few: bool) -> Paint:
    """Evaluates the prints of a scene at the samples of its picture.

    Args:
        projection: The scene in the picture.
        samples: Along each side of a pixel.
        few: Whether pixels within a print make do with two samples.
    """
    surfaces = projection.scene.surfaces
    painted = np.zeros(len(surfaces), np.int8)
    pixel = projection.camera.height * samples / len(projection.nearest.keys)
    tables = {k: _table(s, pixel) for k, s in enumerate(surfaces) if s.print is not None}
    paint = bumps = np.zeros((0, 0, 3), np.float32)
    if tables:
        paint = np.zeros((*projection.nearest.keys.shape, 3), np.float32)
    if any(_has_folds(table) for table in tables.values()):
        bumps = np.zeros(paint.shape, np.float32)
    for k, table in tables.items():
        painted[k] = 2 if _has_folds(table) else 1
        _paint(projection, k, table, paint, bumps, samples, few)
    return Paint(painted, paint, bumps)


def _table(surface: Surface, pixel: float) -> Array:
    """The row of a surface's print; bands that pixels of so many cm would beat against are averaged."""
    if not isinstance(surface.print, TableOfPrint):
        return new_table(COORDINATES)
    table = surface.print.table()
    if _finest(table) < _FINE * pixel:
        table[BLUR] = _AVERAGED * pixel
    return table


def _finest(table: Array) -> float:
    """Width of the narrowest band or gap of a print, cm."""
    first, second, third = (float(size) for size in table[SIZES : SIZES + 3])
    if table[KIND] == STRIPES:
        return min(first, second)
    if table[KIND] == CHECKS:
        return first
    if table[KIND] == PLAID:
        return first * min(second, 1.0 - second, third)
    return np.inf


def _has_folds(table: Array) -> bool:
    return bool(table[FOLDS] > 0.0)


def _paint(
    projection: Projection,
    index: int,
    table: Array,
    paint: Array,
    bumps: Array,
    samples: int,
    few: bool,
) -> None:
    from swifttailor.render.print_kernels import paint_samples

    scene = projection.scene
    surface = scene.surfaces[index]
    first = int(scene.first_vertex[index])
    vertices = scene.vertices[first : scene.first_vertex[index + 1]]
    rest = vertices if surface.rest is None else np.ascontiguousarray(surface.rest, np.float64)
    keys = projection.nearest.keys
    paint_samples(
        keys,
        projection.nearest.front,
        projection.points,
        scene.faces,
        projection.camera.perspective,
        scene.vertices,
        rest,
        np.array([first, scene.first_face[index], scene.first_face[index + 1]]),
        np.ascontiguousarray(surface.print_at, np.float32),
        table,
        layers(table),
        bank_of(table),
        paint,
        bumps,
        samples,
        few,
    )
    if table[0] == COORDINATES and surface.print is not None:
        face = projection.nearest.face
        mine = (face >= scene.first_face[index]) & (face < scene.first_face[index + 1])
        # Where the wrong side is seen, the kernel leaves a third coordinate below 0.
        mine[mine] = paint[mine][:, 2] >= 0
        paint[mine] = surface.print.colors(paint[mine][:, :2])

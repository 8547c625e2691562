"""Seams and hems: edges of a surface drawn as thin lines where the surface shows them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array
from swifttailor.compiled_loop import CompiledLoop
from swifttailor.render.surface import LineSet

if TYPE_CHECKING:
    from swifttailor.render.scene import Projection

_dim_along = CompiledLoop("swifttailor.render.shading_kernels", "dim_along")
_LIFT = 0.5
"""A line is seen when it lies less than this behind what the pixel shows, cm."""


def draw_lines(kept: Array, projection: Projection, index: int, line: LineSet, samples: int) -> None:
    """Takes light away along a set of edges, in place.

    Args:
        kept: (height, width) float32 share of light kept at each sample.
        projection: The scene in the picture.
        index: Of the surface that has the line.
        line: The edges.
        samples: Samples along a side of a finished pixel.
    """
    scene, nearest = projection.scene, projection.nearest
    edges = np.ascontiguousarray(np.asarray(line.edges).reshape(-1, 2), np.int32)
    lift = scene.surfaces[index].lift
    faces = scene.first_face[index], scene.first_face[index + 1]
    depths = np.array([nearest.low, nearest.steps, projection.camera.perspective, lift, *faces])
    points = projection.points[scene.first_vertex[index] :]
    _dim_along(kept, edges, points, nearest.keys, depths, line.strength, line.width * samples / 2, _LIFT)

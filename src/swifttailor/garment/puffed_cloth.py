"""Quilted cloth as it puffs between its lines, for pictures: files hold it as it was draped."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from swifttailor.pattern.trims.quilting import QUILTING, heights_of_lines, lines_apart

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment

_PUFF = 0.16
"""How far cloth stands off between two lines, as a part of how far they are apart."""


def with_puffs(garment: Garment) -> Garment:
    """The garment with the cloth of quilted panels moved outward between the lines; others as they are."""
    if QUILTING not in garment.pattern.trims:
        return garment
    mesh, apart = garment.mesh, lines_apart(garment.pattern)
    off = np.zeros(len(mesh.flat_vertices))
    for index, panel in enumerate(garment.pattern.panels):
        own = np.unique(mesh.flat_faces[mesh.face_panel == index])
        heights = heights_of_lines(panel, mesh.flat_vertices[own])
        if heights is not None:
            off[own] = _PUFF * apart * np.sqrt(np.abs(np.sin(np.pi * heights / apart)))
    count = np.bincount(mesh.weld, minlength=mesh.vertex_count)
    mean = np.bincount(mesh.weld, off, minlength=mesh.vertex_count) / np.maximum(count, 1)
    return replace(garment, vertices=garment.vertices + mean[:, None] * garment.vertex_normals)

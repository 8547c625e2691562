"""Whether a garment is too tight, before it is made: by the coarse drape that the network starts from."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.garment_sewer.sewer import Prepared
from swifttailor.ggi.outline_decode import outline_sampler

TOO_TIGHT = 0.105
"""`stretch` above which a drape of the pattern is hardly ever accepted: of 977 drapes of
GarmentCode's `train`, 38 of the 41 that were too tight lie above it, and 4 % of the others
(`benchmarks/tight_patterns.py`)."""
_UNMEASURED = 0.1
"""Sides of triangles shorter than this on the flat panel are not measured, cm."""


def is_too_tight(prepared: Prepared) -> bool:
    """Whether cloth would be stretched by more than drapes may be, or than it is cut to be."""
    return stretch(prepared) > TOO_TIGHT + prepared.mesh.pattern.cloth_stretch


def stretch(prepared: Prepared) -> float:
    """How much longer cloth is around the body than it was cut: exceeded by 5 % of all sides of triangles.

    The mesh is laid where the coarse drape has the pixels, so this takes some milliseconds. Where a seam is
    gathered, the shorter side counts, as the other is loose.

    Args:
        prepared: With a prior that hangs; panels that are not hung are stretched by their way to the seams.

    Returns:
        Share of the length; 0.05 is usual for close garments.
    """
    mesh = prepared.mesh
    worn = worn_coarsely(prepared)
    cut = _sides(mesh.flat_vertices[mesh.flat_faces])
    long = _sides(worn[mesh.faces])
    measured = cut > _UNMEASURED
    return float(np.percentile(long[measured] / cut[measured], 95)) - 1.0


def worn_coarsely(prepared: Prepared) -> Floats:
    """(v, 3) where the coarse drape has the vertices of the mesh, cm."""
    mesh = prepared.mesh
    flat = outline_sampler(prepared.layout, mesh).weights @ prepared.table.prior.astype(np.float64)
    return mesh.welded_mean(flat)


def _sides(corners: Floats) -> Floats:
    """(f, 3) lengths of the sides of triangles (f, 3, d)."""
    return np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)

"""A body with a quarter of its faces, for pictures whose pixels show more than these do."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from swifttailor.arrays import Floats, Ints

COARSE_FILE = Path(__file__).with_name("coarse_body.npz")
"""Which vertices of the default body are left, and their faces: ``scripts/make_coarse_body.py``."""


def coarse_body(vertices: Floats, faces: Ints, usual: Ints) -> tuple[Floats, Ints]:
    """Leaves out three of four vertices of a body.

    Args:
        vertices: (N, 3) cm.
        faces: (M, 3).
        usual: (K, 3) faces of the default body. What is left out is known of its mesh alone, in any shape and
            pose; a body with another mesh stays as it is.

    Returns:
        Vertices (n, 3) and faces (m, 3) int32.
    """
    if not np.array_equal(faces, usual):
        return vertices, faces
    left, coarse = _left_of_default()
    return np.ascontiguousarray(vertices[left]), coarse


@cache
def _left_of_default() -> tuple[Ints, Ints]:
    with np.load(COARSE_FILE, allow_pickle=False) as stored:
        return stored["vertices"].astype(np.int64), stored["faces"].astype(np.int32)

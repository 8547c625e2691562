"""Where on the wearer a picture looks: places on the default body as it stands, whatever the pose."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array, Floats, Ints
from swifttailor.picture_reader.labels import MASK_STRIDE

UNIT_CM = 100.0


def worn_places(face: Array, things: Iterable[tuple[Floats, Ints]]) -> NDArray[np.float16]:
    """Where the faces that are seen lie at rest.

    Args:
        face: (h, w) of `render.view.Seen`.
        things: Vertices (n, 3) at rest, cm, and faces of every surface, in the order they are drawn.

    Returns:
        (h / 4, w / 4, 3) middle of the face at the middle of each cell, in units of `UNIT_CM`; NaN where
        nobody is.
    """
    half = MASK_STRIDE // 2
    seen = face[half::MASK_STRIDE, half::MASK_STRIDE]
    found = np.full((*seen.shape, 3), np.float16(np.nan))
    first = 0
    for vertices, faces in things:
        here = (seen >= first) & (seen < first + len(faces))
        found[here] = vertices[faces[seen[here] - first]].mean(axis=1) / UNIT_CM
        first += len(faces)
    return found

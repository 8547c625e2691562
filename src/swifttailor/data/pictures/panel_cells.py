"""Which panel a picture shows where, and where two of a garment meet in it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array
from swifttailor.data.pictures.bank import WornGarment
from swifttailor.data.pictures.closer import face_kinds
from swifttailor.picture_reader.labels import MASK_STRIDE

SEAM = 64
"""Added to the cells in which two panels of one garment meet."""


def panel_cells(face: Array, first: int, garments: Sequence[WornGarment]) -> NDArray[np.uint8]:
    """Kinds of panels in the cells of a picture.

    Args:
        face: (h, w) of `render.view.Seen`.
        first: Number of the first face of the first garment.
        garments: In the order they are drawn; the panels of each in the order of `PANEL_NAMES`.

    Returns:
        (h / 4, w / 4) number of `PANEL_KINDS` at the middle of each cell and 1, 0 where no garment is; `SEAM`
        more where panels meet.
    """
    half = MASK_STRIDE // 2
    height, width = face.shape[0] // MASK_STRIDE, face.shape[1] // MASK_STRIDE
    found = np.zeros((height, width), np.uint8)
    for garment in garments:
        kinds = face_kinds(garment)
        first, begin = first + len(garment.faces), first
        if kinds is None:
            continue
        kind_of_face = 1 + kinds
        here = (face >= begin) & (face < first)
        number = np.where(here, face - begin, 0)
        middle = here[half::MASK_STRIDE, half::MASK_STRIDE]
        found[middle] = kind_of_face[number[half::MASK_STRIDE, half::MASK_STRIDE][middle]]
        panel = garment.face_panel[number].astype(np.int16)
        blocks = (height, MASK_STRIDE, width, MASK_STRIDE)
        most = np.where(here, panel, -1).reshape(blocks).max(axis=(1, 3))
        least = np.where(here, panel, 1000).reshape(blocks).min(axis=(1, 3))
        found[(most > least) & (found > 0)] |= SEAM
    return found

"""How far a garment lies from where pictures show one."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial import KDTree

from swifttailor.arrays import Floats
from swifttailor.picture_reader.reading import PartReading
from swifttailor.tailor.looking import SeenPicture

LEAST_CELLS = 6
"""Of fewer cells nothing can be told."""
_INSIDE = 0.5
_EDGE_CM = 3.0


def can_be_compared(pictures: Sequence[SeenPicture], part: str) -> bool:
    """Whether any picture says where on the wearer the garment of a part lies."""
    return any(_seen_places(picture, part) is not None for picture in pictures)


def distance_cm(pictures: Sequence[SeenPicture], part: str, vertices: Floats) -> float:
    """Mean distance between the outlines of a garment and of what pictures show, seen as they are seen.

    Places are compared as on the default body that stands, so the pose of the person does not count: the
    reader says of each cell of a picture which place of the wearer it shows. Both ways: what is shown is to
    lie on the garment, and the garment where something is shown.

    Args:
        pictures: As they were read.
        part: Of the body.
        vertices: (v, 3) of the garment on the default body, cm.

    Returns:
        Centimetres, the mean of the pictures; 0 where none tells.
    """
    found = []
    for picture in pictures:
        places = _seen_places(picture, part)
        if places is None:
            continue
        turned = np.deg2rad(picture.reading.camera.azimuth)
        right = np.array([np.cos(turned), 0.0, -np.sin(turned)])
        shown, made = (np.stack([p @ right, p[:, 1]], axis=1) for p in (places, vertices))
        made = _inside_picture(made, shown, picture, part)
        there, back = KDTree(made).query(shown)[0], KDTree(shown).query(made)[0]
        found.append(float(there.mean() + back.mean()) / 2)
    return float(np.mean(found)) if found else 0.0


def _seen_places(picture: SeenPicture, part: str) -> Floats | None:
    """(n, 3) places of the wearer at which the garment is seen, cm."""
    read = _read_part(picture, part)
    if read is None or read.cells is None:
        return None
    there = read.cells.mask > _INSIDE
    return read.cells.places[there].astype(np.float64) if there.sum() >= LEAST_CELLS else None


def _read_part(picture: SeenPicture, part: str) -> PartReading | None:
    return next((p for p in picture.reading.parts if p.part == part), None)


def _inside_picture(made: Floats, shown: Floats, picture: SeenPicture, part: str) -> Floats:
    """Without what lies above or below where the picture ends, if the garment goes on there."""
    read = _read_part(picture, part)
    assert read is not None
    mask = read.mask
    kept = np.ones(len(made), bool)
    if (mask[-1] > _INSIDE).any():
        kept &= made[:, 1] > shown[:, 1].min() - _EDGE_CM
    if (mask[0] > _INSIDE).any():
        kept &= made[:, 1] < shown[:, 1].max() + _EDGE_CM
    return made[kept] if kept.any() else made

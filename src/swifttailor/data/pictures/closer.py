"""Cameras and pictures from near, as a reader of pictures cuts them out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array, Floats, Pixels
from swifttailor.data.pictures.bank import WornGarment
from swifttailor.picture_reader.close_ups import ALL_PARTS, CLOSE_UPS, LEAST_CM, WHOLE
from swifttailor.picture_reader.panel_kinds import kinds_of_panels
from swifttailor.render import Camera

_MARGIN, _SHIFT = (0.03, 0.35), 0.06
"""Around the part, as a share of its larger extent; and by how much it is off the middle, in sides."""
_SHARP, _COARSEST = 0.4, 2.6
"""Share of close-ups with a value for each pixel; how many pixels have one at most in the others."""


def face_kinds(garment: WornGarment) -> NDArray[np.uint8] | None:
    """(f,) number of `PANEL_KINDS` of each face; None where GarmentCode does not know all panels."""
    kinds = kinds_of_panels()[np.flatnonzero(garment.truth.panels)]
    return kinds[garment.face_panel] if len(kinds) == garment.face_panel.max() + 1 else None


def close_up_by_lot(
    garment: WornGarment,
    carried: Floats,
    camera: Camera,
    chance: np.random.Generator,
    parts: Sequence[str] = ALL_PARTS,
) -> tuple[Camera, int]:
    """A camera that looks from where another does, but at one of `CLOSE_UPS` alone.

    Args:
        garment: As the body stands.
        carried: (v, 3) its vertices where the picture has them, cm.
        camera: Looks at the whole garment.
        chance: Decides at what.
        parts: Of these, see `CloseUp.part`.

    Returns:
        The camera, and the number in `CLOSE_UPS`; the same camera and `WHOLE` where there is nothing.
    """
    found = _first_of(garment, chance, parts)
    if found is None:
        return camera, WHOLE
    shown, number = found
    return _aimed(camera, carried[garment.faces[shown].ravel()], chance), number


def has_any(garment: WornGarment, parts: Sequence[str]) -> bool:
    """Whether there is any of these parts, see `CloseUp.part`, to look at from near."""
    return _first_of(garment, np.random.default_rng(0), parts) is not None


def _first_of(
    garment: WornGarment, chance: np.random.Generator, parts: Sequence[str]
) -> tuple[NDArray[np.bool_], int] | None:
    """Which faces one of the close-ups shows, by lot, and its number."""
    kinds = face_kinds(garment)
    if kinds is None:
        return None
    places = garment.vertices[garment.faces].mean(axis=1)
    for number in chance.permutation(len(CLOSE_UPS)):
        if CLOSE_UPS[number].part in parts:
            shown = CLOSE_UPS[number].points(places, kinds)
            if shown.any():
                return shown, int(number)
    return None


def _aimed(camera: Camera, points: Array, chance: np.random.Generator) -> Camera:
    """The same view of some points (n, 3) alone."""
    right, up, back = camera.axes
    low, high = (np.array([f(points @ right), f(points @ up)]) for f in (np.min, np.max))
    seen = float((high - low).max()) * (1 + 2 * float(chance.uniform(*_MARGIN)))
    seen = min(max(seen, LEAST_CM), camera.height)
    across, level = (low + high) / 2 + seen * chance.normal(0, _SHIFT, 2)
    x, y, z = (float(v) for v in across * right + level * up + float((points @ back).mean()) * back)
    opened = camera.field_of_view * seen / camera.height
    return replace(camera, target=(x, y, z), height=seen, field_of_view=opened)


def coarsened(pixels: Pixels, chance: np.random.Generator) -> Pixels:
    """As if cut out of a picture with fewer pixels."""
    from PIL import Image

    if chance.random() < _SHARP:
        return pixels
    size = round(len(pixels) / chance.uniform(1.0, _COARSEST))
    fewer = Image.fromarray(pixels).resize((size, size), Image.Resampling.BOX)
    return np.asarray(fewer.resize((len(pixels), len(pixels)), Image.Resampling.BICUBIC))

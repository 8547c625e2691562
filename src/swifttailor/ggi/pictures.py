"""The three images as PNG pictures for people: row 0 at the top, as pictures have it."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.atomic_files import write_bytes
from swifttailor.errors import InputError
from swifttailor.ggi.images import GarmentGeometryImage
from swifttailor.ggi.panel_colors import color_types
from swifttailor.ggi.stitching import StitchingImage

SEMANTIC, STITCHING, GEOMETRY = "semantic.png", "stitching.png", "geometry.png"


_GOLDEN_RATIO = 0.6180339887498949
_CLOTH = 40
"""Grey of what is not sewn, in the picture of the stitches."""
_DARKEST = 0.45
"""Brightness of a seam's colour where it begins; where it ends it is 1."""


def write_pictures(images: GarmentGeometryImage, folder: Path | str) -> list[Path]:
    """Writes semantic.png, stitching.png and, where there is a drape, geometry.png; returns their paths."""
    folder = Path(folder)
    pictures = {
        SEMANTIC: color_types(images.semantic),
        STITCHING: stitching_picture(images.stitching, images.occupancy),
    }
    if images.geometry is not None:
        pictures[GEOMETRY] = geometry_picture(images.geometry, images.occupancy)
    return [_write_png(picture, folder / name) for name, picture in pictures.items()]


def stitching_picture(stitching: StitchingImage, occupancy: NDArray[np.bool_]) -> Pixels:
    """(N, N, 3) sRGB: a hue for each stitch, darker where its seam begins; row 0 as in the image.

    The two sides of a stitch thus have equal colours where they meet. Cloth that is not sewn is grey.
    """
    picture = np.where(occupancy, _CLOTH, 0).astype(np.uint8).reshape(-1, 1).repeat(3, axis=1)
    number = np.repeat(np.arange(len(stitching.start) - 1) // 2, np.diff(stitching.start))
    brightness = _DARKEST + (1 - _DARKEST) * stitching.fraction
    colors = _hues((number * _GOLDEN_RATIO) % 1.0) * brightness[:, None]
    shown = stitching.ids.ravel()[stitching.pixels] == number + 1
    picture[stitching.pixels[shown]] = np.round(255 * colors[shown]).astype(np.uint8)
    return picture.reshape(*occupancy.shape, 3)


def geometry_picture(geometry: NDArray[np.float32], occupancy: NDArray[np.bool_]) -> Pixels:
    """(N, N, 3) sRGB: x, y and z as red, green and blue, each from its least (40) to its greatest (255)."""
    picture = np.zeros((*occupancy.shape, 3), np.uint8)
    values = geometry[occupancy].astype(np.float64)
    if not np.isfinite(values).all():
        raise InputError("The geometry image holds positions that are not finite; it cannot be drawn.")
    if len(values):
        low, high = values.min(axis=0), values.max(axis=0)
        share = (values - low) / np.maximum(high - low, 1e-9)
        picture[occupancy] = np.round(40 + 215 * share).astype(np.uint8)
    return picture


def _hues(hue: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bright sRGB colours (n, 3) from 0 to 1 of hues (n,) from 0 to 1, one part white to four of the hue."""
    ramp = np.abs((hue[:, None] * 6 + np.array([0.0, 4.0, 2.0])) % 6 - 3) - 1
    return 0.2 + 0.8 * np.clip(ramp, 0.0, 1.0)


def _write_png(picture: Pixels, path: Path) -> Path:
    from PIL import Image

    encoded = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(picture[::-1])).save(encoded, "PNG", compress_level=6)
    return write_bytes(path, encoded.getvalue())

"""Colours as people tell them apart: CIE Lab (D65), in which equal distances look about equal."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.color import decode_srgb, to_linear

_TO_XYZ = np.array(
    [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]]
)
_WHITE = _TO_XYZ.sum(axis=1)
_KNEE, _SLOPE = (6 / 29) ** 3, 841 / 108


def linear_of_srgb(srgb: Array) -> Array:
    """Linear light (..., 3), 0 to 1, of sRGB values from 0 to 255."""
    return decode_srgb(np.asarray(srgb, np.float64) / 255.0)


def lab_of_linear(linear: Array) -> Array:
    """Lightness 0 to 100, green to red and blue to yellow (..., 3) of linear light."""
    xyz = np.asarray(linear, np.float64) @ _TO_XYZ.T / _WHITE
    f = np.where(xyz > _KNEE, np.cbrt(xyz), _SLOPE * xyz + 4 / 29)
    x, y, z = f[..., 0], f[..., 1], f[..., 2]
    return np.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=-1)


def linear_of_lab(lab: Array) -> Array:
    """Linear light (..., 3) of colours in Lab; what no screen can show lies outside of 0 to 1."""
    lab = np.asarray(lab, np.float64)
    y = (lab[..., 0] + 16) / 116
    f = np.stack([y + lab[..., 1] / 500, y, y - lab[..., 2] / 200], axis=-1)
    xyz = np.where(f > 6 / 29, f**3, (f - 4 / 29) / _SLOPE) * _WHITE
    return xyz @ np.linalg.inv(_TO_XYZ).T


def lab_of_hex(rgb: str) -> Array:
    """Lab (3,) of ``rrggbb``, with or without ``#``."""
    return lab_of_linear(to_linear(rgb))

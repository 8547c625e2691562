"""One repeat of a print as a picture, for whoever draws a garment by a texture that repeats."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import cos, radians, sin, sqrt

import numpy as np

from swifttailor.arrays import Array, Pixels
from swifttailor.garment.cloth_print import SETT, ClothPrint

PIXELS_PER_CM = 24
"""Of tiles that are small enough for it: between two colours lies a millimetre."""
MOST_PIXELS = 1024
"""Along each side."""
_FEWEST_PIXELS = 4


@dataclass(frozen=True, eq=False)
class PrintTile:
    """A piece of cloth that is laid beside itself in both directions without a seam."""

    picture: Pixels
    """(h, w, 3) sRGB, row 0 at the top."""
    width: float
    """Along the rows, cm."""
    height: float
    """Cm."""
    angle: float
    """By which the tiles are turned on the cloth, degrees, to the left and around its origin, where the lower
    left corner of one of them lies."""

    def matrix(self) -> Array:
        """(2, 2) from places on the cloth, cm, to those in the picture: (0, 0) is its lower left corner."""
        turn = radians(self.angle)
        along, up = np.array([cos(turn), sin(turn)]), np.array([-sin(turn), cos(turn)])
        return np.stack([along / self.width, up / self.height])


def print_tile(printed: ClothPrint) -> PrintTile:
    """The smallest tile of a print, without the unevenness of yarn, which repeats nowhere.

    It is drawn by what draws previews.

    Args:
        printed: Any.
    """
    width, height = _repeats(printed)
    columns, rows = _pixels(width), _pixels(height)
    across = (np.arange(columns) + 0.5) / columns * width
    up = (np.arange(rows)[::-1] + 0.5) / rows * height
    places = np.stack(np.meshgrid(across, up), axis=2).reshape(-1, 2)
    straight = replace(printed, sizes={**printed.sizes, "angle": 0.0}).drawn(grain=0.0)
    from swifttailor.render.color import encode_srgb

    picture = encode_srgb(straight.colors(places).reshape(rows, columns, 3))
    return PrintTile(picture, width, height, printed.size("angle"))


def _repeats(printed: ClothPrint) -> tuple[float, float]:
    """After which it repeats across and up, cm, before it is turned."""
    if printed.kind == "stripes":
        both = printed.size("width") + printed.size("gap")
        return both, both  # across, stripes are alike everywhere
    if printed.kind == "checks":
        return 2 * printed.size("width"), 2 * printed.size("width")
    if printed.kind == "dots":  # every second row is shifted by half
        return printed.size("spacing"), sqrt(3) * printed.size("spacing")
    one = printed.size("spacing" if printed.kind == "plaid" else "repeat")
    one *= SETT if printed.is_tartan else 1.0
    return one, one


def _pixels(length: float) -> int:
    return int(np.clip(round(PIXELS_PER_CM * length), _FEWEST_PIXELS, MOST_PIXELS))

"""Lace: figures of flowers on a net, or on a lining of nearly the same colour."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from swifttailor.garment.cloth_print import TEXTURE_SIDE, ClothPrint, texture_places
from swifttailor.render.color import encode_srgb, to_linear
from swifttailor.render.png import encode_png
from swifttailor.render.prints import Motif

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment

_REPEAT_CM = 7.0
_FLOWERS = 0
_FIGURES = (0.93, 0.62, 0.80)
"""Share of what lies beneath that three sorts of figures hide."""
_LIGHT_FROM = 0.18
_LINING_OF_LIGHT, _LINING_OF_DARK = 0.83, 0.2
"""How lace is told from its lining of the same colour: that is darker, or has so much of white."""


def lined_lace(color: str) -> ClothPrint:
    """Lace on an opaque lining, as a print.

    Args:
        color: ``#rrggbb``.
    """
    ground = _lining(color)
    return ClothPrint(
        "motif", (ground, color, _between(ground, color), color), {"repeat": _REPEAT_CM}, "flowers"
    )


def lace_opacity(net: float) -> Motif:
    """How much of what lies beneath lace hides at each place: a print of greys, 0 to 1.

    Args:
        net: The share that the net between figures hides.
    """
    shares = (net, *[max(net, figure) for figure in _FIGURES])
    return Motif(tuple((share, share, share) for share in shares), _FLOWERS, _REPEAT_CM, 0.0, 0.0)


def mean_opacity(net: float) -> float:
    """About how much lace hides, for what cannot show its figures."""
    return 0.45 * net + 0.55 * sum(_FIGURES) / len(_FIGURES)


def lace_picture(garment: Garment, color: str, opacity: float) -> bytes:
    """The lace of a garment's parts as a texture over the unit square of texture coordinates.

    Args:
        garment: Gives the places of its panels.
        color: ``#rrggbb``.
        opacity: Share that its net hides; 1.0: lace on a lining.

    Returns:
        A PNG file, with opacity where it is below 1.
    """
    side = TEXTURE_SIDE
    places = texture_places(garment, side)
    if opacity >= 1.0:
        return encode_png(encode_srgb(lined_lace(color).drawn().colors(places).reshape(side, side, 3)))
    picture = np.zeros((side, side, 4), np.uint8)
    picture[:, :, :3] = encode_srgb(to_linear(color))
    shares = lace_opacity(opacity).colors(places)[:, 0].reshape(side, side)
    picture[:, :, 3] = np.round(255.0 * np.clip(shares, 0.0, 1.0))
    return encode_png(picture)


def _lining(color: str) -> str:
    parts = [int(color[k : k + 2], 16) for k in (1, 3, 5)]
    if (0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]) / 255 > _LIGHT_FROM:
        return _hex([_LINING_OF_LIGHT * part for part in parts])
    return _hex([part + _LINING_OF_DARK * (255 - part) for part in parts])


def _between(one: str, other: str) -> str:
    return _hex([(int(one[k : k + 2], 16) + int(other[k : k + 2], 16)) / 2 for k in (1, 3, 5)])


def _hex(parts: list[float]) -> str:
    return "#" + "".join(f"{round(part):02x}" for part in parts)

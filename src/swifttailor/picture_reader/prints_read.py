"""The prints of the garments in a photograph: which they are, their colours, after how much they repeat."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.picture_reader.cloth_repeats import repeat_of
from swifttailor.picture_reader.flat_cloth import FlatCloth
from swifttailor.picture_reader.print_colors import blurred_colors, print_colors
from swifttailor.picture_reader.print_head import PLAIN, PrintHead
from swifttailor.picture_reader.reading import PictureReading
from swifttailor.picture_reader.seen_print import DOWN, PrintKind, SeenPrint

LEAST_CERTAINTY = 0.8
"""What is less surely printed so is read as plain: a print that is not there is worse than one missed."""
_STRIPES_SEEN, _COLORS_SEEN = 3, 4
"""Colours of stripes and checks, and of figures, beyond which no more are told."""
_LEAST_SHARE, _LEAST_OF_DOTS = 0.06, 0.015
"""Of the cloth: what covers less is no colour of the print; dots may be few."""
_SURELY_AGAIN, _SURELY_PRINTED = 0.3, 0.9
"""How surely a print has to repeat, or to be one, whose colours are hardly two."""


def with_prints(reading: PictureReading, pixels: Pixels, head: PrintHead) -> PictureReading:
    """A reading of a photograph with the prints of the garments in it.

    Args:
        reading: Of it.
        pixels: (h, w, 3) sRGB.
        head: Tells prints apart.
    """
    pixel = reading.camera.height / max(reading.box[2] - reading.box[0], 1)
    parts = tuple([replace(part, print=_seen(pixels, part.mask, head, pixel)) for part in reading.parts])
    return replace(reading, parts=parts)


def _seen(pixels: Pixels, mask: NDArray[np.float32], head: PrintHead, pixel: float) -> SeenPrint | None:
    """The print of a garment; None of plain ones, and where nothing is sure.

    Args:
        pixels: (h, w, 3) sRGB.
        mask: (h, w) 0 to 1: where it is.
        head: Tells prints apart.
        pixel: Side of one, cm on the garment.
    """
    told = head.told(pixels, mask)
    likeliest = max(told, key=told.__getitem__, default=PLAIN)
    if likeliest == PLAIN or told[likeliest] < LEAST_CERTAINTY:
        return None
    cloth = FlatCloth.of(pixels, mask)
    return None if cloth is None else measured(cloth, likeliest, told[likeliest], pixel)


def measured(cloth: FlatCloth, told: str, certainty: float, pixel: float) -> SeenPrint | None:
    """What can be measured of a print; None where its colours are one, or nearly and it does not repeat.

    Args:
        cloth: That has it.
        told: One of `print_head.PRINTS`, not plain.
        certainty: Of that.
        pixel: Side of a pixel of the photograph, cm on the garment.
    """
    kind, angle, directions = _KINDS[told]
    colors = print_colors(
        cloth,
        _COLORS_SEEN if kind == "figures" else _STRIPES_SEEN,
        _LEAST_OF_DOTS if kind == "dots" else _LEAST_SHARE,
    )
    repeat = repeat_of(cloth, directions) if directions else None
    again = repeat is not None and repeat.certainty >= _SURELY_AGAIN
    if not colors and (again or certainty >= _SURELY_PRINTED):
        colors = blurred_colors(cloth)
    if not colors:
        return None
    return SeenPrint(
        kind,
        certainty,
        tuple([name for name, _ in colors]),
        tuple([share for _, share in colors]),
        angle,
        None if repeat is None else repeat.lag * cloth.pixel * pixel,
    )


_KINDS: Mapping[str, tuple[PrintKind, float, tuple[float, ...]]] = {
    "across": ("stripes", 0.0, (90.0,)),
    "down": ("stripes", DOWN, (0.0,)),
    "checks": ("checks", 0.0, (0.0, 90.0)),
    "dots": ("dots", 0.0, (0.0, 45.0, 90.0, 135.0)),
    "figures": ("figures", 0.0, ()),
}
"""What is told, as kinds, with their angle and the directions in which they repeat."""

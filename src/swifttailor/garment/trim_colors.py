"""Colours of what is put on a garment: of its own cloth, or of horn, metal and leather."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array
from swifttailor.garment.cloth_color import cloth_color
from swifttailor.render.color import Color, to_linear

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment

GREY = (0.2126, 0.7152, 0.0722)
"""How light red, green and blue look."""
DARK = 0.04
"""Cloth that throws back less light than this has lighter seams in previews."""
DARKEST = 0.010
"""Least light, linear, that cloth of any colour throws back: folds of black cloth are seen."""
_COLORS = {"metal": "#8d8f94", "leather": "#4a3226"}
_LIGHT_BUTTON, _DARK_BUTTON = "#bdb6a8", "#6b5a49"


def trim_color(garment: Garment, look: str, color: Color | None = None) -> Array:
    """(3,) linear light that a part of a trim throws back.

    Args:
        garment: What it is on.
        look: See `TrimMesh.look`.
        color: Of the garment's cloth; None: its own.
    """
    ground = garment.color or cloth_color(garment.pattern) if color is None else color
    if color is None and garment.print is not None:
        ground = garment.print.colors[0]
    cloth = np.maximum(to_linear(ground), DARKEST)
    if look == "cloth":
        return 0.94 * cloth
    if look == "dark":
        return (0.30 if float(cloth @ GREY) >= DARK else 2.2) * cloth
    if look == "button":
        return to_linear(_LIGHT_BUTTON if float(cloth @ GREY) < 0.25 else _DARK_BUTTON)
    return to_linear(_COLORS[look])

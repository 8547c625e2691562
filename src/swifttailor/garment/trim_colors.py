"""Colours of what is put on a garment: of its own cloth, or of horn, metal and leather."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array
from swifttailor.garment.cloth_color import cloth_color
from swifttailor.garment.part_looks import TRIMS_OF_PARTS, color_of_panel
from swifttailor.pattern.trims.layers import LAYERS
from swifttailor.render.color import GREY, Color, to_linear

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment

DARK = 0.04
"""Cloth that throws back less light than this has lighter seams in previews."""
_STRONG = 0.075
"""Cloth of which red, green or blue is more has darker ones: lighter ones would be pink on burgundy."""
DARKEST = 0.010
"""Least light, linear, that cloth of any colour throws back: folds of black cloth are seen."""
_LOOKS_COLORED: Mapping[str, tuple[str, ...]] = {
    "buttons": ("button",),
    "zip": ("metal", "dark"),
    "pockets": ("cloth",),
    "belt": ("cloth", "leather"),
    "drawstring": ("cloth", "dark"),
    "frills": ("cloth",),
    "fringe": ("cloth",),
    "edging": ("cloth",),
    "side_stripes": ("cloth",),
    "side_panels": ("cloth",),
    "bow": ("cloth",),
    "lacing": ("dark",),
    "apron": ("cloth",),
    "motif": ("cloth",),
}
"""Of what is put on, the parts that have that colour: a buckle is metal whatever its belt is."""
_COLORS = {"metal": "#8d8f94", "leather": "#4a3226", "hole": "#a9a097"}
_IN_ANOTHER: Mapping[str, tuple[str, str]] = {
    "apron": ("#f3efe6", "#e2dccf"),
    **dict.fromkeys(("edging", "piping", "bands", "narrow bands"), ("#f3efe6", "#33415c")),
    "lace trim": ("#f3efe6", "#dad3c5"),
    "neck lace": ("#f3efe6", "#dad3c5"),
    "fur trim": ("#f4f1ea", "#6d5039"),
    **dict.fromkeys(("neck fur", "sleeve fur"), ("#ddccb0", "#8a6a4b")),
    "side panels": ("#f3efe6", "#26324a"),
    **dict.fromkeys(("side stripes", "sleeve stripes"), ("#f3efe6", "#26324a")),
    **dict.fromkeys(("three side stripes", "three sleeve stripes"), ("#f3efe6", "#26324a")),
    "satin stripes": ("#4a4c53", "#26324a"),
    "reflecting bands": ("#d5d9dc", "#b4bac0"),
    "elbow patches": ("#8a6748", "#7a5536"),
    "toggles": ("#ecdcbc", "#5b3d26"),
    "chest heart": ("#d8404f", "#c22f40"),
    "chest star": ("#f0c94a", "#e2a92c"),
    "denim seams": ("#c98d47", "#b57a34"),
    "hem border": ("#d3a94c", "#b98a2e"),
    "blouse front": ("#f7f5ef", "#f7f5ef"),
    "illusion yoke": ("#cdc5bb", "#d6cdc2"),
}
"""What is of another colour than the cloth, where none is told: on darker cloth, and on light cloth."""
_SOFT = (
    "creases",
    "pleated front",
    "fine pleats",
    "neck pleats",
    "shoulder pleats",
    "back pleat",
    "box pleats",
    "neck gathers",
    "shoulder gathers",
    "bust gathers",
)
"""Folds of the cloth itself, which are shades and no stitches."""
_STITCHES, _BLUE = "topstitching", 1.15
"""Stitches are of copper on denim whose blue is so many times its red; on other colours of its own shade."""
_COPPER, _COPPER_ON_LIGHT = "#c98d47", "#b57a34"
_STITCHED_DARKER, _STITCHED_LIGHTER = 0.6, 0.05
"""How light they are beside cloth of another colour, and by how much lighter than dark cloth, in light."""
_UNDYED, _PALE = "#f1efe9", 0.62
"""Threads inside of cloth, and how much of their colour shows where it is worn."""
_RIBS = ("neck rib", "armhole ribs", "hem rib", "knit bands", "folded band")
_OF_THE_WHOLE = ("shoulder drape",)
"""What is of the garment's own cloth, whatever the panel below it is."""
_SEEN_ON_DARK, _LINES_ON_DARK = 0.012, 0.04
"""So much lighter are what is sewn on dark cloth and lines on it, linear light."""
_LIGHT = 0.55
"""Linear light of cloth from which on it is light."""
_ZIPS = ("zip", "half zip", "back zip", "side zip", "asymmetric zip")
_BRIGHT_METAL, _METAL_LIKE = "#e3e5e8", (0.16, 0.45)
"""Of zips on cloth that is as light as their metal, linear light, on which nobody would see them else."""
_BLACK_LEATHER, _GREYISH = "#33312f", 0.02
"""A belt of leather on black cloth, and how far apart the channels of that are at most, linear light."""
_LIGHT_BUTTON, _DARK_BUTTON = "#bdb6a8", "#6b5a49"


def is_dark(color: Array) -> bool:
    """Whether lines on cloth of a colour (3,), linear light, are lighter than it."""
    return float(color @ GREY) < DARK and float(color.max()) < _STRONG


def trim_color(
    garment: Garment, look: str, color: Color | None = None, *, trim: str = "", panel: str = ""
) -> Array:
    """(3,) linear light that a part of a trim throws back.

    Args:
        garment: What it is on.
        look: See `TrimMesh.look`.
        color: Of the garment's cloth; None: its own.
        trim: Its name, where it may have a colour of its own.
        panel: Which it lies on: cloth is of that panel's colour.
    """
    ground = garment.color or cloth_color(garment.pattern) if color is None else color
    on_parts = any(one.printed for one in garment.looks)
    if color is None and garment.print is not None and not on_parts:
        ground = garment.print.ground
    if color is None and garment.looks:
        own = _own_color(garment, look, trim)
        if own is not None:
            return np.maximum(to_linear(own), DARKEST)
        below = "" if trim in _OF_THE_WHOLE else panel
        ground = (color_of_panel(garment, below) if below else None) or ground
    cloth = np.maximum(to_linear(ground), DARKEST)
    if trim == _STITCHES:
        return _stitches_on(cloth)
    if trim in _IN_ANOTHER:  # or nobody would see it
        pale, deep = _IN_ANOTHER[trim]
        return to_linear(pale if float(cloth @ GREY) < _LIGHT else deep)
    if look == "thread" or trim == "frayed hem":
        return (1.0 - _PALE) * cloth + _PALE * to_linear(_UNDYED)
    if look == "cloth" and trim not in LAYERS and float(cloth @ GREY) < DARK:
        return cloth + _SEEN_ON_DARK  # or nobody would see a pocket on black
    if look == "cloth":
        return (0.84 if trim in _RIBS else 1.0 if trim in LAYERS else 0.94) * cloth
    if look == "dark" and trim in _SOFT:
        return (0.52 if float(cloth @ GREY) >= DARK else 1.8) * cloth
    if look == "dark":
        return (
            0.30 * cloth if float(cloth @ GREY) >= DARK else np.maximum(2.2 * cloth, cloth + _LINES_ON_DARK)
        )
    if look == "button":
        return to_linear(_LIGHT_BUTTON if float(cloth @ GREY) < 0.25 else _DARK_BUTTON)
    if look == "metal" and trim in _ZIPS and _METAL_LIKE[0] < float(cloth @ GREY) < _METAL_LIKE[1]:
        return to_linear(_BRIGHT_METAL)
    if look == "leather" and is_dark(cloth) and float(np.ptp(cloth)) < _GREYISH:
        return to_linear(_BLACK_LEATHER)
    return to_linear(_COLORS[look])


def _stitches_on(cloth: Array) -> Array:
    """(3,) linear light of the stitches on denim of a colour (3,): copper on blue alone, as in shops."""
    grey = float(cloth @ GREY)
    if float(cloth[2]) > _BLUE * float(cloth[0]):
        return to_linear(_COPPER if grey < _LIGHT else _COPPER_ON_LIGHT)
    return cloth + _STITCHED_LIGHTER if grey < DARK else _STITCHED_DARKER * cloth


def _own_color(garment: Garment, look: str, trim: str) -> str | None:
    for one in garment.looks:
        if trim in TRIMS_OF_PARTS.get(one.part, ()) and look in _LOOKS_COLORED[one.part]:
            return one.color
    return None

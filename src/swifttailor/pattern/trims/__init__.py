"""Pockets, buttons, belts, frills: what is put on a garment and holds no panels together."""

from swifttailor.pattern.trims.names import LIKE_EACH_OTHER, TRIMS, trims_read
from swifttailor.pattern.trims.placing import place_trims, trims_that_fit
from swifttailor.pattern.trims.shapes import Belt, Bow, Button, Frill, Layer, Patch, Stirrup, Trim

__all__ = [
    "LIKE_EACH_OTHER",
    "TRIMS",
    "Belt",
    "Bow",
    "Button",
    "Frill",
    "Layer",
    "Patch",
    "Stirrup",
    "Trim",
    "place_trims",
    "trims_read",
    "trims_that_fit",
]

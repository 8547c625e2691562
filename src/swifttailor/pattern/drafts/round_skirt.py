"""The skirts of dresses that are no closer at the hips than at the waist: cut from a circle, or gathered."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.flared_skirt import lay_bubble_skirt, lay_flared_skirt
from swifttailor.pattern.drafts.joins import SKIRT_WHOLE, sew_skirt_to_bodice
from swifttailor.pattern.drafts.shaped_hem import LEVEL, HemShape

LEAST_GATHERS = 1.1
"""Less fullness is none: the skirt is cut from a circle."""
_BELOW_WAIST_CM = 3.0
"""Between bodice and skirt before draping."""


@dataclass(frozen=True)
class RoundSkirt:
    """How the skirt is cut."""

    length: float
    """Seam to hem, cm."""
    fraction: float
    """Part of a full circle that it is cut from, where it is not gathered."""
    gathers: float
    """Width over that of the seam it is gathered into; 1 for a skirt without gathers."""
    hem: HemShape = LEVEL
    """Of a skirt that is not gathered."""
    hem_band: float = 0.0
    """Height of a band that draws the hem of a gathered skirt together, cm."""


def lay_round_skirt(table: CuttingTable, figure: Figure, skirt: RoundSkirt, waist: Halves) -> None:
    """Lays both panels and sews them to both halves of the bodice, which must already lie on the table."""
    top_y = figure.waist_y - _BELOW_WAIST_CM
    gathered = skirt.gathers >= LEAST_GATHERS
    if gathered:
        lay_bubble_skirt(table, figure, waist, skirt.length, top_y, skirt.gathers, skirt.hem_band)
    else:
        lay_flared_skirt(table, waist, skirt.length, top_y, skirt.fraction, skirt.hem)
    sew_skirt_to_bodice(table, SKIRT_WHOLE, gathered=gathered)

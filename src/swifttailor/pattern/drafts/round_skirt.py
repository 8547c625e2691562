"""The skirts of dresses that are not closer at the hips than the waist: of a circle, gathered, pleated."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.flared_skirt import lay_bubble_skirt, lay_flared_skirt
from swifttailor.pattern.drafts.joins import SKIRT_WHOLE, sew_skirt_to_bodice
from swifttailor.pattern.drafts.pleated_skirt import (
    LEAST_PLEATS,
    KnifePleats,
    lay_pleated_skirt,
    sew_pleats_to_bodice,
)
from swifttailor.pattern.drafts.shaped_hem import LEVEL, HemShape

LEAST_GATHERS = 1.1
"""Less fullness is none: the skirt is cut from a circle."""
_BELOW_WAIST_CM = 3.0
"""Between bodice and skirt before draping."""
_PLEAT_CM, _HIP_EASE_CM = 4.0, 3.0
"""Cloth that is folded under each strip of a pleated skirt, and its room at the hips."""
_GATHERED_FLARE = 0.55
"""Width of the hem of a gathered skirt over its gathered edge, times the length: one as wide all the way down
hangs like a barrel."""
_LEAST_TO_HIPS_CM = 6.0
"""From a seam below the waist to the hips, at least, for how it widens, cm."""
_FLARE, _MOST_FLARE_CM = 1.1, 72.0
"""Width of the hem of a pleated skirt over its waist: times the length, and at most, cm around."""


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
    pleats: int = 0
    """Strips seen between knife pleats in front, and as many behind; fewer than 2 are none."""


def lay_round_skirt(table: CuttingTable, figure: Figure, skirt: RoundSkirt, waist: Halves) -> None:
    """Lays both panels and sews them to both halves of the bodice, which must already lie on the table."""
    top_y = figure.waist_y - _BELOW_WAIST_CM
    if skirt.pleats >= LEAST_PLEATS:
        lay_dress_pleats(table, figure, waist, skirt.pleats, skirt.length, top_y)
        sew_pleats_to_bodice(table, skirt.pleats)
        return
    gathered = skirt.gathers >= LEAST_GATHERS
    if gathered:
        lay_bubble_skirt(
            table,
            figure,
            waist,
            skirt.length,
            top_y,
            skirt.gathers,
            skirt.hem_band,
            _GATHERED_FLARE * skirt.length,
        )
    else:
        lay_flared_skirt(table, waist, skirt.length, top_y, skirt.fraction, skirt.hem)
    sew_skirt_to_bodice(table, SKIRT_WHOLE, gathered=gathered)


def lay_pleats_from_hips(
    table: CuttingTable, figure: Figure, seam: Halves, strips: int, length: float, top_y: float
) -> None:
    """Lays the pleated skirt of a dress with a low seam; arguments as of `lay_dress_pleats`."""
    flare = min(_FLARE * length, _MOST_FLARE_CM)
    hips = figure.hips.eased(_HIP_EASE_CM)
    to_hips = max(top_y + _BELOW_WAIST_CM - figure.hip_y, _LEAST_TO_HIPS_CM)
    lay_pleated_skirt(
        table, seam, KnifePleats(length, strips, _PLEAT_CM, flare), top_y, hips=hips, to_hips=to_hips
    )


def lay_dress_pleats(
    table: CuttingTable, figure: Figure, waist: Halves, strips: int, length: float, top_y: float
) -> None:
    """Lays the pleated skirt of a dress or pinafore.

    Args:
        table: Where it goes.
        figure: The body.
        waist: Half widths of what it is sewn to, cm.
        strips: Seen in front, and as many behind.
        length: Of the skirt itself, from its upper edge, cm.
        top_y: World height of the upper edge, cm.
    """
    lay_pleated_skirt(
        table,
        waist,
        KnifePleats(length, strips, _PLEAT_CM, min(_FLARE * length, _MOST_FLARE_CM)),
        top_y,
        hips=figure.hips.eased(_HIP_EASE_CM),
        to_hips=top_y + _BELOW_WAIST_CM - figure.hip_y,
    )

"""Skirts of rows of cloth, each gathered into the one above."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import band_below_waist, lay_body_waist_band
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.fitted_skirt import SKIRT_BACK_Z, SKIRT_FRONT_Z, FittedSkirt, lay_fitted_skirt
from swifttailor.pattern.drafts.joins import SKIRT_HALVES, SKIRT_WHOLE, sew_skirt_to_band
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.outline import annular_sector
from swifttailor.pattern.drafts.tiers import lay_tiers_below
from swifttailor.pattern.pattern import Pattern

_BELOW_HIPS_CM, _LOWEST_TIERS_CM = 6.0, 16.0
"""A close part ends so far below the hips at least, and leaves so much to its tiers, cm."""
_LEAST_TIER_CM, _LEAST_FALL_CM = 6.0, 18.0
_HIP_EASE_CM, _FLARE = 4.0, 1.0
"""Of the close part: cm, degrees."""


@dataclass(frozen=True)
class TieredSkirtOptions:
    """Options of the tiered skirt."""

    length: declared.SkirtLength = 84.0
    tiers: Annotated[int, Option("Number of tiers, all of one height.", "tiers", 2, 6)] = 3
    fullness: Annotated[
        float, Option("Width of each tier over that of the edge it is gathered into.", "times", 1.15, 1.8)
    ] = 1.4
    close: Annotated[
        float,
        Option("Close part from the body's waist to the uppermost tier; 0: there is none.", "cm", 0.0, 76.0),
    ] = 0.0
    first: Annotated[
        float,
        Option("Height of the uppermost tier; 0: as high as the others.", "cm", 0.0, 76.0),
    ] = 0.0
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0
    below_waist: declared.BelowWaist = 0.0


def draft_tiered_skirt(options: TieredSkirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the tiered skirt for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("tiered-skirt")
    # A close part begins at the waist, as the darts above the hips need the room.
    low = 0.0 if options.close > 0 else band_below_waist(figure, options.below_waist, options.band_height)
    waist = lay_body_waist_band(table, figure, options.band_height, options.waist_ease, low)
    if options.close > 0:
        _lay_below_hips(table, figure, options, waist)
        return table.finish()
    heights = _heights(options, low)
    top_y = figure.waist_y - low - options.band_height - 3.0
    widths = {"front": 2 * waist.front, "back": 2 * waist.back}
    for tier in range(options.tiers):
        number, above = _number(tier), _number(tier - 1)
        for part in widths:
            widths[part] *= options.fullness
            at = top_y - sum(heights[:tier])
            outline = annular_sector("waist", widths[part], widths[part], heights[tier], at)
            z = SKIRT_FRONT_Z if part == "front" else SKIRT_BACK_Z
            name = f"skirt_{part}{number}"
            table.lay(name, outline, label="leg", at=(0.0, 0.0, z), back=part == "back")
            if tier:
                table.seam(f"skirt_{part}{above}.bottom", f"{name}.waist", gathered=True)
        for side in ("left_side", "right_side"):
            table.seam(f"skirt_front{number}.{side}", f"skirt_back{number}.{side}")
    sew_skirt_to_band(table, SKIRT_WHOLE, gathered=True)
    return table.finish()


def _lay_below_hips(table: CuttingTable, figure: Figure, options: TieredSkirtOptions, waist: Halves) -> None:
    """A fitted skirt, and the tiers from its hem on; it ends below the hips, and the tiers have room."""
    below_hips = figure.waist_y - figure.hip_y + _BELOW_HIPS_CM
    close = min(max(options.close, below_hips), options.length - _LOWEST_TIERS_CM)
    close = max(close, below_hips)
    length = max(options.length, close + _LOWEST_TIERS_CM)
    shape = FittedSkirt(close, _HIP_EASE_CM, _FLARE)
    lay_fitted_skirt(table, figure, shape, waist, figure.waist_y - options.band_height)
    sew_skirt_to_band(table, SKIRT_HALVES)
    height = (length - close) / options.tiers
    lay_tiers_below(table, options.tiers, height, figure.waist_y - close - 3.0, options.fullness)


def _heights(options: TieredSkirtOptions, low: float) -> list[float]:
    """Of all tiers from the band down, whose upper edge is so `low` below the waist, cm."""
    whole, count = max(options.length - low - options.band_height, _LEAST_FALL_CM), options.tiers
    if not options.first:
        return [whole / count] * count
    least = min(_LEAST_TIER_CM, whole / count)
    first = min(max(options.first, least), whole - (count - 1) * least)
    return [first, *[(whole - first) / (count - 1)] * (count - 1)]


def _number(tier: int) -> str:
    """What tells the panels of a tier from those of others: nothing at the waist."""
    return f"_{tier - 1}" if tier > 0 else ""

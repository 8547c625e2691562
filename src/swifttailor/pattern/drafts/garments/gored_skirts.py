"""Skirts of several tapered panels on a waistband."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_body_waist_band
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.gored_skirt import Gores, lay_gored_skirt, sew_gores_to_band
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.pattern import Pattern

_LEAST_FLARED = 14.0
"""How much is left below what is close, cm."""


@dataclass(frozen=True)
class GoredSkirtOptions:
    """Options of the gored skirt."""

    length: declared.SkirtLength = 66.0
    gores: Annotated[int, Option("All around; of an odd number one more is in front.", "gores", 4, 12)] = 6
    flare: Annotated[
        float, Option("Width of the hem over that of the hips, all around.", "cm", 0.0, 160.0)
    ] = 70.0
    close: Annotated[
        float, Option("Waist to where it begins to flare; 0: from the hips on.", "cm", 0.0, 70.0)
    ] = 0.0
    hip_ease: declared.HipEase = 4.0
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0


def draft_gored_skirt(options: GoredSkirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the gored skirt for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("gored-skirt")
    height = options.band_height
    lower = lay_body_waist_band(table, figure, height, options.waist_ease)
    close = max(min(options.close, options.length - _LEAST_FLARED) - height, 0.0)
    lay_gored_skirt(
        table,
        lower,
        Gores(options.length - height, options.gores, options.flare, close),
        figure.waist_y - height - 3.0,
        hips=figure.hips.eased(options.hip_ease),
        to_hips=figure.waist_y - figure.hip_y - height,
    )
    sew_gores_to_band(table, options.gores)
    return table.finish()

"""Fitted skirt: pencil or A-line with back darts on a shaped waistband."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_body_waist_band
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fitted_skirt import FittedSkirt, lay_fitted_skirt
from swifttailor.pattern.drafts.joins import SKIRT_HALVES, sew_skirt_to_band
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class FittedSkirtOptions:
    """Options of the fitted skirt."""

    length: declared.SkirtLength = 58.0
    flare: declared.SkirtFlare = 0.0
    hip_ease: declared.HipEase = 4.0
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0


def draft_fitted_skirt(options: FittedSkirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the fitted skirt for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("fitted-skirt")
    lower = lay_body_waist_band(table, figure, options.band_height, options.waist_ease)
    skirt = FittedSkirt(options.length, options.hip_ease, options.flare)
    lay_fitted_skirt(table, figure, skirt, lower, figure.waist_y - options.band_height)
    sew_skirt_to_band(table, SKIRT_HALVES)
    return table.finish()

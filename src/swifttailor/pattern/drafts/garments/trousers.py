"""Trousers: long or short legs, back darts, shaped waistband."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_body_waist_band
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.joins import sew_trousers_to_band
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.trousers import Trousers, lay_trousers, sew_legs
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class TrousersOptions:
    """Options of the trousers."""

    length: declared.TrouserLength = 102.0
    hip_ease: declared.HipEase = 4.0
    leg_ease: declared.LegEase = 9.0
    flare: declared.LegFlare = 0.0
    crotch_drop: Annotated[float, Option("Crotch of the trousers below the body's.", "cm", 0.5, 5.0)] = 1.0
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0


def draft_trousers(options: TrousersOptions, measurements: Measurements) -> Pattern:
    """Drafts the trousers for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("trousers")
    lower = lay_body_waist_band(table, figure, options.band_height, options.waist_ease)
    legs = Trousers(options.length, options.hip_ease, options.leg_ease, options.flare, options.crotch_drop)
    lay_trousers(table, figure, legs, lower, figure.waist_y - options.band_height)
    table.mirror()
    sew_legs(table)
    sew_trousers_to_band(table)
    return table.finish()

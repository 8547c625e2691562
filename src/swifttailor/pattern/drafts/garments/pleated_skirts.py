"""Skirts laid in pleats on a waistband."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_body_waist_band
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.joins import SKIRT_WHOLE, sew_skirt_to_band
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.pleated_skirt import lay_pleated_skirt
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class PleatedSkirtOptions:
    """Options of the pleated skirt."""

    length: Annotated[float, Option("Body's waist to the hem, down the middle.", "cm", 30.0, 100.0)] = 44.0
    pleats: Annotated[int, Option("Pleats in front, and as many behind.", "pleats", 2, 12)] = 8
    depth: Annotated[
        float, Option("Cloth of each pleat that is folded away at the waist.", "cm", 1.0, 8.0)
    ] = 1.5
    fraction: Annotated[
        float, Option("Part of a circle that it is cut from; 0 is straight.", "circles", 0.0, 1.0)
    ] = 0.6
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0


def draft_pleated_skirt(options: PleatedSkirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the pleated skirt for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("pleated-skirt")
    lower = lay_body_waist_band(table, figure, options.band_height, options.waist_ease)
    top_y = figure.waist_y - options.band_height - 3.0
    lay_pleated_skirt(
        table,
        lower,
        options.length - options.band_height,
        top_y,
        pleats=options.pleats,
        depth=options.depth,
        fraction=options.fraction,
    )
    sew_skirt_to_band(table, SKIRT_WHOLE)
    return table.finish()

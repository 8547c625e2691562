"""Circle skirt: part of a circle on a shaped waistband."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_body_waist_band
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.flared_skirt import lay_flared_skirt
from swifttailor.pattern.drafts.joins import SKIRT_WHOLE, sew_skirt_to_band
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class CircleSkirtOptions:
    """Options of the circle skirt."""

    length: declared.SkirtLength = 60.0
    fraction: Annotated[
        float, Option("Part of a full circle that the skirt is cut from.", "circles", 0.3, 1.5)
    ] = 0.75
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0


def draft_circle_skirt(options: CircleSkirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the circle skirt for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("circle-skirt")
    lower = lay_body_waist_band(table, figure, options.band_height, options.waist_ease)
    top_y = figure.waist_y - options.band_height - 3.0
    lay_flared_skirt(table, lower, options.length - options.band_height, top_y, options.fraction)
    sew_skirt_to_band(table, SKIRT_WHOLE)
    return table.finish()

"""Skirts laid in pleats on a waistband."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_yoke_or_band
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.pleated_skirt import KnifePleats, lay_pleated_skirt, sew_pleats_to_band
from swifttailor.pattern.pattern import Pattern

_HIP_EASE_CM = 3.0
_LEAST_TO_HIPS_CM = 1.0
"""From the lower edge of a yoke down, which may end below the hips."""


@dataclass(frozen=True)
class PleatedSkirtOptions:
    """Options of the pleated skirt."""

    length: Annotated[float, Option("Body's waist to the hem, down the middle.", "cm", 32.0, 100.0)] = 46.0
    strips: Annotated[
        int, Option("Strips seen between pleats in front, and as many behind.", "strips", 2, 8)
    ] = 6
    depth: Annotated[float, Option("Cloth that is folded under each strip.", "cm", 2.0, 6.0)] = 4.0
    flare: Annotated[
        float, Option("Width of the hem over the waist as it hangs, all around.", "cm", 20.0, 120.0)
    ] = 52.0
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0
    apron: Annotated[bool, Option("Leave the front flat, as of a kilt: pleats are behind alone.")] = False
    yoke: declared.SkirtYoke = 0.0


def draft_pleated_skirt(options: PleatedSkirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the pleated skirt for a body: knife pleats all around, or behind a flat front."""
    figure = Figure.of(measurements)
    table = CuttingTable("pleated-skirt")
    lower, height = lay_yoke_or_band(table, figure, options.yoke, options.band_height, options.waist_ease)
    skirt = KnifePleats(options.length - height, options.strips, options.depth, options.flare, options.apron)
    lay_pleated_skirt(
        table,
        lower,
        skirt,
        figure.waist_y - height - 3.0,
        hips=figure.hips.eased(_HIP_EASE_CM),
        to_hips=max(figure.waist_y - figure.hip_y - height, _LEAST_TO_HIPS_CM),
    )
    sew_pleats_to_band(table, options.strips, apron=options.apron)
    return table.finish()

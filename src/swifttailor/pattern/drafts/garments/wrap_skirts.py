"""Skirts that are wound around the hips, as far as one layer shows them: wrap skirt, sarong."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_body_waist_band
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fitted_skirt import FittedSkirt, Opening, lay_fitted_skirt
from swifttailor.pattern.drafts.joins import SKIRT_HALVES, sew_skirt_to_band
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.pattern import Pattern

OpeningHeight = Annotated[
    float, Option("How far the front is open from the hem up; at most to the hips.", "cm", 10.0, 70.0)
]
OpeningWidth = Annotated[float, Option("Width of the opening along the hem.", "cm", 2.0, 30.0)]
OpeningAside = Annotated[
    float, Option("Upper end of the opening from the middle, to the wearer's left.", "cm", 0.0, 14.0)
]


@dataclass(frozen=True)
class WrapSkirtOptions:
    """Options of the wrap skirt."""

    length: declared.SkirtLength = 62.0
    flare: declared.SkirtFlare = 7.0
    hip_ease: declared.HipEase = 4.0
    opening_height: OpeningHeight = 36.0
    opening_width: OpeningWidth = 13.0
    opening_aside: OpeningAside = 9.0
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0


def draft_wrap_skirt(options: WrapSkirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the wrap skirt for a body."""
    return _wound("wrap-skirt", options, measurements)


@dataclass(frozen=True)
class SarongOptions:
    """Options of the sarong."""

    length: declared.SkirtLength = 92.0
    flare: declared.SkirtFlare = 0.0
    hip_ease: declared.HipEase = 6.0
    opening_height: OpeningHeight = 56.0
    opening_width: OpeningWidth = 18.0
    opening_aside: OpeningAside = 10.0
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0


def draft_sarong(options: SarongOptions, measurements: Measurements) -> Pattern:
    """Drafts the sarong for a body."""
    return _wound("sarong", options, measurements)


def _wound(name: str, options: WrapSkirtOptions | SarongOptions, measurements: Measurements) -> Pattern:
    figure = Figure.of(measurements)
    table = CuttingTable(name)
    lower = lay_body_waist_band(table, figure, options.band_height, options.waist_ease)
    opening = Opening(options.opening_height, options.opening_width, options.opening_aside)
    skirt = FittedSkirt(options.length, options.hip_ease, options.flare, opening)
    lay_fitted_skirt(table, figure, skirt, lower, figure.waist_y - options.band_height)
    sew_skirt_to_band(table, SKIRT_HALVES)
    return table.finish()

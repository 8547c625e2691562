"""Skirts that are wound around the hips: their fronts overlap below the waistband."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_body_waist_band
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fitted_skirt import (
    FittedSkirt,
    Overlap,
    lay_fitted_skirt,
    sew_overlap_to_band,
)
from swifttailor.pattern.drafts.flared_skirt import lay_round_wrap_skirt
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.pattern import Pattern

OverlapAside = Annotated[
    float,
    Option("Where the fronts meet at the waist, from the middle to the wearer's left.", "cm", 4.0, 16.0),
]
OverlapEdge = Annotated[
    float, Option("Where the edge of the upper front meets the hem, likewise.", "cm", -20.0, 20.0)
]
OverlapUnder = Annotated[float, Option("How far the lower front reaches under it there.", "cm", 6.0, 40.0)]
Round = Annotated[
    float,
    Option(
        "Part of a full circle that it is cut from; less than 0.3: shaped by side seams and darts.",
        "circles",
        0.0,
        0.75,
    ),
]
Petals = Annotated[
    float,
    Option(
        "How high above the hem the fronts part in the middle, their edges curved like petals; less than 3, "
        "or cut from a part of a circle: straight.",
        "cm",
        0.0,
        12.0,
    ),
]
_ROUND_FROM, _LEAST_FALL_CM = 0.3, 15.0
"""What is less of a circle is cut with darts; how long what hangs from the waistband is at least, cm."""


@dataclass(frozen=True)
class WrapSkirtOptions:
    """Options of the wrap skirt."""

    length: declared.SkirtLength = 62.0
    flare: declared.SkirtFlare = 7.0
    hip_ease: declared.HipEase = 4.0
    overlap_aside: OverlapAside = 9.0
    overlap_edge: OverlapEdge = 12.0
    overlap_under: OverlapUnder = 24.0
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0
    fraction: Round = 0.0
    petals: Petals = 0.0


def draft_wrap_skirt(options: WrapSkirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the wrap skirt for a body."""
    return _wound("wrap-skirt", options, measurements)


@dataclass(frozen=True)
class SarongOptions:
    """Options of the sarong."""

    length: declared.SkirtLength = 92.0
    flare: declared.SkirtFlare = 3.0
    hip_ease: declared.HipEase = 3.0
    overlap_aside: OverlapAside = 10.0
    overlap_edge: OverlapEdge = 8.0
    overlap_under: OverlapUnder = 28.0
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0


def draft_sarong(options: SarongOptions, measurements: Measurements) -> Pattern:
    """Drafts the sarong for a body."""
    return _wound("sarong", options, measurements)


def _wound(name: str, options: WrapSkirtOptions | SarongOptions, measurements: Measurements) -> Pattern:
    figure = Figure.of(measurements)
    table = CuttingTable(name)
    lower = lay_body_waist_band(table, figure, options.band_height, options.waist_ease)
    fraction, petals = 0.0, 0.0
    if isinstance(options, WrapSkirtOptions):
        fraction, petals = options.fraction, options.petals
    petals = 0.0 if fraction >= _ROUND_FROM else petals  # those of round skirts are too wide to curve away
    overlap = Overlap(options.overlap_aside, options.overlap_edge, options.overlap_under, petals)
    if fraction >= _ROUND_FROM:
        fall = max(options.length - options.band_height, _LEAST_FALL_CM)
        top_y = figure.waist_y - options.band_height - 3.0
        lay_round_wrap_skirt(table, lower, fall, top_y, fraction, overlap)
        sew_overlap_to_band(table)
        return table.finish()
    skirt = FittedSkirt(options.length, options.hip_ease, options.flare, overlap)
    lay_fitted_skirt(table, figure, skirt, lower, figure.waist_y - options.band_height)
    sew_overlap_to_band(table)
    return table.finish()

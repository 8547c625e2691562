"""Skirts on a waistband shaped to the body: fitted, with a flounce below, cut from a circle, gathered."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import (
    LOWEST_YOKE_CM,
    band_below_waist,
    lay_body_waist_band,
    lay_yoke_or_band,
)
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fitted_skirt import FittedSkirt, lay_fitted_skirt
from swifttailor.pattern.drafts.flared_skirt import (
    SHORTEST_FLOUNCE,
    lay_bubble_skirt,
    lay_flared_skirt,
    lay_flounce,
)
from swifttailor.pattern.drafts.godets import GodetCount, GodetHeight, Godets, GodetWidth, let_in_godets
from swifttailor.pattern.drafts.joins import SKIRT_HALVES, SKIRT_WHOLE, sew_skirt_to_band
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.shaped_hem import HemShape
from swifttailor.pattern.pattern import Pattern

_LEAST_FALL = 15.0
"""Of a skirt below its band, cm."""


@dataclass(frozen=True)
class FittedSkirtOptions:
    """Options of the fitted skirt."""

    length: declared.SkirtLength = 58.0
    flare: declared.SkirtFlare = 0.0
    hip_ease: declared.HipEase = 4.0
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0
    stretch: declared.ClothStretch = 0.0
    godets: GodetCount = 0
    godet_width: GodetWidth = 32.0
    godet_height: GodetHeight = 30.0


def draft_fitted_skirt(options: FittedSkirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the fitted skirt for a body."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("fitted-skirt", options.stretch / 100)
    lower = lay_body_waist_band(table, figure, options.band_height, options.waist_ease)
    skirt = FittedSkirt(options.length, options.hip_ease, options.flare)
    lay_fitted_skirt(table, figure, skirt, lower, figure.waist_y - options.band_height)
    sew_skirt_to_band(table, SKIRT_HALVES)
    let_in_godets(table, Godets(options.godets, options.godet_width, options.godet_height))
    return table.finish()


@dataclass(frozen=True)
class MermaidSkirtOptions:
    """Options of the mermaid skirt."""

    length: declared.SkirtLength = 96.0
    close: declared.FlounceSeam = 58.0
    taper: Annotated[float, Option("Slant of the side seams inwards, above it.", "degrees", 0.0, 4.0)] = 1.5
    fraction: declared.FlounceFraction = 0.5
    hip_ease: declared.HipEase = 3.0
    band_height: declared.BandHeight = 4.0


def draft_mermaid_skirt(options: MermaidSkirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the mermaid skirt for a body: close down to the knee, a flounce cut from a circle below."""
    figure = Figure.of(measurements)
    table = CuttingTable("mermaid-skirt")
    lower = lay_body_waist_band(table, figure, options.band_height, 0.0)
    close = min(options.close, options.length - SHORTEST_FLOUNCE)
    skirt = FittedSkirt(close, options.hip_ease, -options.taper)
    lay_fitted_skirt(table, figure, skirt, lower, figure.waist_y - options.band_height)
    sew_skirt_to_band(table, SKIRT_HALVES)
    lay_flounce(table, options.length - close, figure.waist_y - close - 3.0, options.fraction)
    return table.finish()


@dataclass(frozen=True)
class CircleSkirtOptions:
    """Options of the circle skirt."""

    length: declared.ShortSkirtLength = 60.0
    fraction: declared.CircleFraction = 0.75
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0
    hem_dip: declared.HemDip = 0.0
    scallop_width: declared.ScallopWidth = 0.0
    hem_points: declared.HemPoints = 0.0
    below_waist: declared.BelowWaist = 0.0
    yoke: declared.SkirtYoke = 0.0


def draft_circle_skirt(options: CircleSkirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the circle skirt for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("circle-skirt")
    if options.yoke >= LOWEST_YOKE_CM:  # it begins at the waist
        below = 0.0
        lower, height = lay_yoke_or_band(table, figure, options.yoke, 0.0, options.waist_ease)
    else:
        height = options.band_height
        below = band_below_waist(figure, options.below_waist, height)
        lower = lay_body_waist_band(table, figure, height, options.waist_ease, below)
    top_y = figure.waist_y - below - height - 3.0
    fall = max(options.length - below - height, _LEAST_FALL)
    hem = HemShape(options.hem_dip, options.scallop_width, points=options.hem_points)
    lay_flared_skirt(table, lower, fall, top_y, options.fraction, hem)
    sew_skirt_to_band(table, SKIRT_WHOLE)
    return table.finish()


@dataclass(frozen=True)
class GatheredSkirtOptions:
    """Options of the gathered skirt."""

    length: declared.SkirtLength = 58.0
    fullness: Annotated[float, Option("Width of the skirt over the waistband.", "times", 1.25, 3.0)] = 1.8
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0
    hem_band: declared.HemBand = 0.0
    flare: Annotated[float, Option("Width of the hem over that of the gathered edge.", "cm", 0.0, 60.0)] = (
        30.0
    )
    yoke: declared.SkirtYoke = 0.0


def draft_gathered_skirt(options: GatheredSkirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the gathered skirt for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("gathered-skirt")
    lower, height = lay_yoke_or_band(table, figure, options.yoke, options.band_height, options.waist_ease)
    top_y = figure.waist_y - height - 3.0
    fall = options.length - height
    lay_bubble_skirt(table, figure, lower, fall, top_y, options.fullness, options.hem_band, options.flare)
    sew_skirt_to_band(table, SKIRT_WHOLE, gathered=True)
    return table.finish()

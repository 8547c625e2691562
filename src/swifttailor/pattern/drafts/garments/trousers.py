"""Trousers with back darts and a shaped waistband: any legs, slim jeans, leggings, flares."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import band_below_waist, lay_body_waist_band
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.joins import sew_trousers_to_band
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.trousers import (
    CLOSE_REACH,
    FLARED_SIDE_SHARE,
    NARROW_CM,
    NARROWEST,
    NARROWING_CM,
    SIDE_SHARE,
    Trousers,
    lay_trousers,
    sew_legs,
)
from swifttailor.pattern.pattern import Pattern

SlimLegEase = Annotated[float, Option("Room on top of the leg's girth at the knee.", "cm", 0.0, 8.0)]
Taper = Annotated[float, Option("How much narrower the hem is than the knee.", "cm", 0.0, 12.0)]
Bow = Annotated[
    float, Option("How far each side seam bows outward at the thigh, as of jodhpurs.", "cm", 0.0, 8.0)
]
Barrel = Annotated[
    float, Option("How far each side seam stands out at the knee, as of barrel legs.", "cm", 0.0, 9.0)
]
StretchBandHeight = Annotated[
    float, Option("Height of the waistband; higher ones reach over the belly.", "cm", 2.0, 13.0)
]
CrotchDrop = Annotated[float, Option("Crotch of the trousers below the body's.", "cm", 0.0, 5.0)]


@dataclass(frozen=True)
class TrousersOptions:
    """Options of the trousers."""

    length: declared.LongTrouserLength = 102.0
    hip_ease: declared.HipEase = 4.0
    leg_ease: declared.LegEase = 9.0
    flare: declared.LegFlare = 0.0
    crotch_drop: Annotated[float, Option("Crotch of the trousers below the body's.", "cm", 0.5, 5.0)] = 1.0
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0
    below_waist: declared.BelowWaist = 0.0
    side_slits: declared.LegSlits = 0.0
    back_rise: declared.BackRise = 0.0


def draft_trousers(options: TrousersOptions, measurements: Measurements) -> Pattern:
    """Drafts the trousers for a body."""
    legs = Trousers(options.length, options.hip_ease, options.leg_ease, options.flare, options.crotch_drop)
    if options.flare <= NARROWING_CM or options.leg_ease + options.flare < NARROW_CM:
        legs = replace(legs, side_share=SIDE_SHARE)
    return _on_band("trousers", legs, options, options.waist_ease, measurements)


@dataclass(frozen=True)
class JeansOptions:
    """Options of the jeans."""

    length: declared.TrouserLength = 98.0
    hip_ease: declared.HipEase = 2.0
    leg_ease: SlimLegEase = 5.0
    taper: Taper = 4.0
    crotch_drop: CrotchDrop = 0.5
    band_height: declared.BandHeight = 4.0
    below_waist: declared.BelowWaist = 0.0
    bow: Bow = 0.0
    barrel: Barrel = 0.0
    side_slits: declared.LegSlits = 0.0
    back_rise: declared.BackRise = 0.0
    stretch: declared.ClothStretch = 0.0


def draft_jeans(options: JeansOptions, measurements: Measurements) -> Pattern:
    """Drafts slim jeans for a body."""
    return _on_band("jeans", _slim_legs(options), options, 0.0, measurements)


@dataclass(frozen=True)
class LeggingsOptions:
    """Options of the leggings."""

    length: declared.TrouserLength = 98.0
    hip_ease: Annotated[float, Option("Room on top of the hip girth, all around.", "cm", 0.0, 20.0)] = 1.5
    leg_ease: SlimLegEase = 1.5
    taper: Taper = 10.0
    crotch_drop: CrotchDrop = 0.0
    band_height: StretchBandHeight = 6.0
    below_waist: declared.BelowWaist = 0.0
    side_slits: declared.LegSlits = 0.0
    back_rise: declared.BackRise = 0.0
    stretch: declared.ClothStretch = 8.0


def draft_leggings(options: LeggingsOptions, measurements: Measurements) -> Pattern:
    """Drafts leggings for a body: without darts, close all the way down."""
    return _on_band("leggings", replace(_slim_legs(options), darts=False), options, 0.0, measurements)


@dataclass(frozen=True)
class FlaresOptions:
    """Options of the flares."""

    length: declared.TrouserLength = 105.0
    hip_ease: declared.HipEase = 2.0
    leg_ease: declared.LegEase = 9.0
    flare: Annotated[float, Option("Extra width of the hem over the knee.", "cm", 8.0, 40.0)] = 32.0
    crotch_drop: CrotchDrop = 0.5
    band_height: declared.BandHeight = 4.0
    below_waist: declared.BelowWaist = 0.0
    side_slits: declared.LegSlits = 0.0
    back_rise: declared.BackRise = 0.0
    stretch: declared.ClothStretch = 0.0


def draft_flares(options: FlaresOptions, measurements: Measurements) -> Pattern:
    """Drafts flares for a body: close to the knee, and wider from there to the hem.

    Those of cloth that stretches lie on the legs as leggings do, without darts.
    """
    legs = Trousers(options.length, options.hip_ease, options.leg_ease, options.flare, options.crotch_drop)
    legs = replace(legs, side_share=FLARED_SIDE_SHARE)
    if options.stretch:
        legs = replace(legs, darts=False, reach=CLOSE_REACH)
    return _on_band("flares", legs, options, 0.0, measurements)


_OnBand = TrousersOptions | JeansOptions | LeggingsOptions | FlaresOptions


def _slim_legs(options: JeansOptions | LeggingsOptions) -> Trousers:
    return Trousers(
        options.length,
        options.hip_ease,
        options.leg_ease,
        -options.taper,
        options.crotch_drop,
        narrowest=NARROWEST,
        reach=CLOSE_REACH,
        side_share=SIDE_SHARE,
        bow=options.bow if isinstance(options, JeansOptions) else 0.0,
        barrel=options.barrel if isinstance(options, JeansOptions) else 0.0,
    )


def _on_band(name: str, legs: Trousers, options: _OnBand, ease: float, measurements: Measurements) -> Pattern:
    """Lays and sews legs on a waistband."""
    stretch = options.stretch / 100 if not isinstance(options, TrousersOptions) else 0.0
    figure = Figure.of(measurements).for_cloth(stretch)
    table = CuttingTable(name, stretch)
    height = options.band_height
    low = band_below_waist(figure, options.below_waist, height)
    lower = lay_body_waist_band(table, figure, height, ease, low, options.back_rise)
    legs = replace(legs, side_slit=options.side_slits)
    lay_trousers(table, figure, legs, lower, figure.waist_y - low - height)
    table.mirror()
    sew_legs(table)
    sew_trousers_to_band(table)
    return table.finish()

"""Close garments without legs: bodysuit, swimsuit, briefs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import band_below_waist, lay_body_waist_band
from swifttailor.pattern.drafts.bodice import sew_centres
from swifttailor.pattern.drafts.briefs import Briefs, lay_briefs
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.fitted_strap_bodice import FittedStrapBodice, lay_fitted_strap_bodice
from swifttailor.pattern.drafts.garments.fitted_garments import (
    RacerBack,
    SleevedBodiceOptions,
    lay_sleeved_bodice,
)
from swifttailor.pattern.drafts.garments.strappy import FrontDip, StrapWidth
from swifttailor.pattern.drafts.halter_bodice import HalterBodice, lay_halter_bodice, sew_strap
from swifttailor.pattern.drafts.in_one_piece import cut_in_one
from swifttailor.pattern.drafts.joins import sew_trousers_to_band, sew_trousers_to_bodice
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.trousers import sew_legs
from swifttailor.pattern.pattern import Pattern

LegHeight = Annotated[
    float,
    Option(
        "Where the legs are cut out to at the sides: above the widest part of the hips.", "cm", -2.0, 10.0
    ),
]
CloseHipEase = Annotated[float, Option("Room on top of the hip girth, all around.", "cm", 0.0, 8.0)]
SeatCover = Annotated[
    float, Option("How much of the seat the back covers; 0 leaves a strip in the middle.", "times", 0.0, 1.0)
]
_CROTCH_DROP_CM = 0.0
_ROUND_CM = 11.0
"""Halters whose necklines fall less are round."""
_KNIT_PERCENT = 3.0
"""Cloth that stretches so much needs neither darts nor a seam at the waist."""
_BRIEFS_BAND_CM, _BRIEFS_DROP_CM = 3.0, 3.0
"""Height of the band of briefs, and by how much they reach lower than what hangs from the shoulders."""


@dataclass(frozen=True)
class BriefsOptions:
    """Options of the briefs."""

    hip_ease: CloseHipEase = 3.0
    leg_height: LegHeight = 1.0
    below_waist: declared.BelowWaist = 6.0
    seat: SeatCover = 1.0
    stretch: declared.ClothStretch = 8.0


def draft_briefs(options: BriefsOptions, measurements: Measurements) -> Pattern:
    """Drafts briefs for a body: a waistband, and cloth cut out over the legs."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("briefs", options.stretch / 100)
    low = band_below_waist(figure, options.below_waist, _BRIEFS_BAND_CM)
    waist = lay_body_waist_band(table, figure, _BRIEFS_BAND_CM, 0.0, low)
    cut = Briefs(options.hip_ease, options.leg_height, _BRIEFS_DROP_CM, options.seat)
    lay_briefs(table, figure, cut, waist, figure.waist_y - low - _BRIEFS_BAND_CM)
    table.mirror()
    sew_legs(table)
    sew_trousers_to_band(table)
    return table.finish()


@dataclass(frozen=True)
class BodysuitOptions(SleevedBodiceOptions):
    """Options of the bodysuit."""

    bust_ease: declared.BustEase = 4.0
    waist_ease: declared.WaistEase = 3.0
    neck_widening: declared.NeckWidening = 2.0
    hip_ease: CloseHipEase = 3.0
    leg_height: LegHeight = 4.0
    stretch: declared.ClothStretch = 8.0
    strap_width: Annotated[
        float, Option("Width of the shoulder where there are no sleeves; 0: all of it.", "cm", 0.0, 10.0)
    ] = 0.0
    racer: RacerBack = False


def draft_bodysuit(options: BodysuitOptions, measurements: Measurements) -> Pattern:
    """Drafts the bodysuit for a body: a darted bodice, sleeves or none, cut out over the legs."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("bodysuit", options.stretch / 100)
    knit = options.stretch >= _KNIT_PERCENT
    waist = lay_sleeved_bodice(
        table, figure, options, strap=options.strap_width, racer=options.racer, knit=knit
    )
    cut = Briefs(options.hip_ease, options.leg_height, _CROTCH_DROP_CM)
    return _without_legs(table, figure, cut, waist, knit=knit)


@dataclass(frozen=True)
class SwimsuitOptions:
    """Options of the swimsuit."""

    bust_ease: declared.BustEase = 3.0
    waist_ease: declared.WaistEase = 3.0
    strap_width: StrapWidth = 2.5
    dip: FrontDip = 4.0
    hip_ease: CloseHipEase = 4.0
    leg_height: LegHeight = 7.0
    stretch: declared.ClothStretch = 14.0
    halter: Annotated[bool, Option("Its front rises to the neck and is held by a strap behind it.")] = False
    neck_depth: Annotated[
        float,
        Option("Fall of the neckline of such a front: a V, or round where it is high.", "cm", 7.0, 20.0),
    ] = 16.0


def draft_swimsuit(options: SwimsuitOptions, measurements: Measurements) -> Pattern:
    """Drafts the swimsuit for a body: a darted bodice on straps, cut out over the legs."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("swimsuit", options.stretch / 100)
    if options.halter:
        shape = "round" if options.neck_depth < _ROUND_CM else "v"
        neck = Neckline(shape, 0.5, options.neck_depth)
        front = HalterBodice(
            options.bust_ease, 0.0, max(options.strap_width, 1.5), neck, 0.0, options.waist_ease
        )
        waist = lay_halter_bodice(table, figure, front)
        assert waist is not None
    else:
        knit = options.stretch >= _KNIT_PERCENT
        bodice = FittedStrapBodice(
            options.strap_width, options.bust_ease, options.waist_ease, options.dip, knit=knit
        )
        waist = lay_fitted_strap_bodice(table, figure, bodice)
    cut = Briefs(options.hip_ease, options.leg_height, _CROTCH_DROP_CM)
    knit = options.stretch >= _KNIT_PERCENT and not options.halter
    return _without_legs(table, figure, cut, waist, halter=options.halter, knit=knit)


def _without_legs(
    table: CuttingTable,
    figure: Figure,
    briefs: Briefs,
    waist: Halves,
    *,
    halter: bool = False,
    knit: bool = False,
) -> Pattern:
    """Lays what is below the waist, and sews it to the bodice; a `knit` has no seam there."""
    lay_briefs(table, figure, briefs, waist, figure.waist_y)
    if knit:
        cut_in_one(table)
    table.mirror()
    sew_centres(table)
    if halter:
        sew_strap(table)
    sew_legs(table)
    sew_trousers_to_bodice(table)
    return table.finish()

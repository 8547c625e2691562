"""Trousers gathered into the waistband, with cuffs or without: pyjamas, joggers, harem trousers."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import band_below_waist, lay_body_waist_band, lay_leg_cuff
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.joins import sew_trousers_to_band
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.trousers import (
    NARROWING_CM,
    ROOMY_CM,
    SIDE_SHARE,
    Trousers,
    lay_trousers,
    sew_legs,
)
from swifttailor.pattern.pattern import Pattern

_SHAPED_CM = 1.5
"""What the upper edge is narrower than the hips, around: so little that no dart is sewn."""

_USUAL_CM, _LOWEST_CM = 2.0, -6.0
"""What the legs of usual joggers use up so anyway; how far above the floor cuffs stay before draping, cm."""
_BELOW_KNEE_CM = 10.0
"""Legs that end so far below the knee lie around the calves."""
_DROP_SHARE, _LEAST_DROP_CM = 0.22, 1.0
"""Crotches drop by no more than this part of the inseam: short legs have nothing to hang from."""


@dataclass(frozen=True)
class PullOnTrousersOptions:
    """Options of the pull-on trousers."""

    length: declared.LongTrouserLength = 100.0
    hip_ease: Annotated[float, Option("Room on top of the hip girth, all around.", "cm", 2.0, 40.0)] = 8.0
    leg_ease: declared.LegEase = 22.0
    flare: Annotated[float, Option("How much wider the leg ends than at the knee.", "cm", -26.0, 30.0)] = 0.0
    crotch_drop: Annotated[float, Option("Crotch of the trousers below the body's.", "cm", 0.5, 14.0)] = 2.0
    band_height: declared.BandHeight = 4.0
    waist_ease: declared.BandEase = 0.0
    below_waist: declared.BelowWaist = 0.0
    back_rise: declared.BackRise = 0.0


@dataclass(frozen=True)
class OpenPullOnTrousersOptions(PullOnTrousersOptions):
    """Options of those without cuffs."""

    side_slits: declared.LegSlits = 0.0


def draft_pull_on_trousers(options: OpenPullOnTrousersOptions, measurements: Measurements) -> Pattern:
    """Drafts pull-on trousers for a body: no darts, an elastic waist's gathers instead."""
    figure = Figure.of(measurements)
    table = CuttingTable("pull-on-trousers")
    _lay_legs(table, figure, options, options.length)
    return _sewn(table)


@dataclass(frozen=True)
class JoggersOptions(PullOnTrousersOptions):
    """Options of the joggers."""

    length: Annotated[
        float, Option("Body's waist to the end of the cuffs, down the side.", "cm", 44.0, 101.0)
    ] = 98.0
    leg_ease: declared.LegEase = 14.0
    flare: Annotated[
        float, Option("How much wider the leg is above the cuff than at the knee.", "cm", -12.0, 20.0)
    ] = -8.0
    cuff_height: declared.CuffHeight = 6.0
    cuff_ease: Annotated[float, Option("Room of the cuff on top of the leg's girth.", "cm", 1.0, 12.0)] = 2.0


def draft_joggers(options: JoggersOptions, measurements: Measurements) -> Pattern:
    """Drafts the joggers for a body: pull-on trousers gathered into cuffs."""
    figure = Figure.of(measurements)
    table = CuttingTable("joggers")
    _lay_legs(table, figure, options, options.length - options.cuff_height + _bloused(figure, options))
    lay_leg_cuff(table, figure, options.cuff_ease, options.cuff_height)
    return _sewn(table)


def _bloused(figure: Figure, options: JoggersOptions) -> float:
    """By how much legs far wider than their cuffs are longer, cm: going in to them, they use it up."""
    hem_y = figure.waist_y - options.length + options.cuff_height
    hem = figure.leg_girth(hem_y) + options.leg_ease + options.flare
    cuff = figure.close_leg_girth(hem_y - options.cuff_height) + options.cuff_ease
    above_floor = hem_y - options.cuff_height - _LOWEST_CM
    return min(max((hem - cuff) / (2 * math.pi) - _USUAL_CM, 0.0), max(above_floor, 0.0))


def _lay_legs(table: CuttingTable, figure: Figure, options: PullOnTrousersOptions, length: float) -> None:
    """Lays the waistband and the left leg; `length` from the body's waist to the leg's end, cm."""
    low = band_below_waist(figure, options.below_waist, options.band_height)
    lay_body_waist_band(table, figure, options.band_height, options.waist_ease, low, options.back_rise)
    wide = figure.hips.eased(options.hip_ease - _SHAPED_CM)
    inseam = figure.crotch_y - (figure.waist_y - length)
    drop = min(options.crotch_drop, max(_LEAST_DROP_CM, _DROP_SHARE * inseam))
    # Close legs that narrow at the inseams alone hang beside the calves, not around them.
    around_calves = options.leg_ease < ROOMY_CM and figure.waist_y - length < figure.knee_y - _BELOW_KNEE_CM
    around_calves = around_calves or options.flare <= NARROWING_CM
    share = SIDE_SHARE if around_calves else Trousers.side_share
    legs = Trousers(length, options.hip_ease, options.leg_ease, options.flare, drop, side_share=share)
    if isinstance(options, OpenPullOnTrousersOptions):
        legs = replace(legs, side_slit=options.side_slits)
    lay_trousers(table, figure, legs, wide, figure.waist_y - low - options.band_height)


def _sewn(table: CuttingTable) -> Pattern:
    table.mirror()
    sew_legs(table)
    sew_trousers_to_band(table, gathered=True)
    return table.finish()

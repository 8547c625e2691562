"""Garments on thin straps or on none: camisole, slip dress, dresses and jumpsuits with a waist seam."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_gathering_leg_cuff
from swifttailor.pattern.drafts.bodice import sew_centres
from swifttailor.pattern.drafts.crossed_straps import sew_crossed_straps
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.fitted_skirt import FittedSkirt, lay_fitted_skirt
from swifttailor.pattern.drafts.fitted_strap_bodice import FittedStrapBodice, lay_fitted_strap_bodice
from swifttailor.pattern.drafts.flared_skirt import SHORTEST_FLOUNCE, lay_flounce
from swifttailor.pattern.drafts.joins import (
    SKIRT_HALVES,
    sew_skirt_to_bodice,
    sew_trousers_to_bodice,
)
from swifttailor.pattern.drafts.knit_tube import KnitTube, lay_knit_tube
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.round_skirt import RoundSkirt, lay_round_skirt
from swifttailor.pattern.drafts.strap_bodice import StrapBodice, lay_strap_bodice
from swifttailor.pattern.drafts.strapless_bodice import StraplessBodice, lay_strapless_bodice
from swifttailor.pattern.drafts.trousers import lay_trousers, legs_of_bodice, sew_legs
from swifttailor.pattern.pattern import Pattern

StrapWidth = Annotated[float, Option("Width of the straps.", "cm", 1.0, 4.0)]
_WIDEST_CROSSED_CM = 4.0
"""Of straps that cross behind, cm."""
StraplessEase = Annotated[float, Option("Room on top of the bust girth, all around.", "cm", 0.0, 6.0)]
HeldWaistEase = Annotated[float, Option("Room on top of the waist girth, all around.", "cm", -1.0, 4.0)]
HeartDip = Annotated[float, Option("Fall of the heart in the middle; 0 is straight.", "cm", 0.0, 8.0)]
_BUSTIER_STRAP_CM, _HELD_EASE_CM = 1.8, 2.0
"""Straps of a bustier, and its room beside one that has to hold itself, cm."""
FrontDip = Annotated[float, Option("Fall of the front between the straps.", "cm", 0.0, 8.0)]
CrossedStraps = Annotated[bool, Option("Cross the straps behind.")]


@dataclass(frozen=True)
class CamisoleOptions:
    """Options of the camisole."""

    length: declared.TopLength = 20.0
    chest_ease: declared.BustEase = 4.0
    flare: declared.HemFlare = 2.0
    strap_width: StrapWidth = 1.5
    dip: FrontDip = 3.0
    waist_shaping: declared.WaistShaping = 0.0
    stretch: declared.ClothStretch = 0.0
    crossed: CrossedStraps = False


def draft_camisole(options: CamisoleOptions, measurements: Measurements) -> Pattern:
    """Drafts the camisole for a body."""
    bodice = StrapBodice(
        options.strap_width,
        options.chest_ease,
        options.length,
        options.dip,
        options.flare,
        options.waist_shaping,
        options.stretch > 0.0,
        options.crossed,
    )
    return _on_straps("camisole", bodice, measurements, options.stretch / 100)


@dataclass(frozen=True)
class SlipDressOptions:
    """Options of the slip dress."""

    length: declared.LongLength = 56.0
    chest_ease: declared.BustEase = 4.0
    flare: declared.HemFlare = 24.0
    strap_width: StrapWidth = 1.5
    dip: FrontDip = 4.0
    waist_shaping: declared.WaistShaping = 0.0
    crossed: CrossedStraps = False


def draft_slip_dress(options: SlipDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the slip dress for a body."""
    bodice = StrapBodice(
        options.strap_width,
        options.chest_ease,
        options.length,
        options.dip,
        options.flare,
        options.waist_shaping,
        crossed=options.crossed,
    )
    return _on_straps("slip-dress", bodice, measurements)


@dataclass(frozen=True)
class BustierOptions:
    """Options of the bustier."""

    bust_ease: StraplessEase = 1.0
    waist_ease: HeldWaistEase = 0.0
    dip: HeartDip = 4.5
    straps: Annotated[bool, Option("Hold it on thin straps, its upper edge round between them.")] = False


def draft_bustier(options: BustierOptions, measurements: Measurements) -> Pattern:
    """Drafts the bustier for a body: its close waist holds it up."""
    if options.straps:
        bust, waist = options.bust_ease + _HELD_EASE_CM, options.waist_ease + _HELD_EASE_CM
        held = FittedStrapBodice(_BUSTIER_STRAP_CM, bust, waist, options.dip)
        table = CuttingTable("bustier")
        lay_fitted_strap_bodice(table, Figure.of(measurements), held)
        table.mirror()
        sew_centres(table)
        return table.finish()
    bodice = StraplessBodice(options.bust_ease, options.waist_ease, options.dip)
    return _strapless("bustier", bodice, measurements)


@dataclass(frozen=True)
class BandeauOptions:
    """Options of the bandeau."""

    bust_ease: StraplessEase = 1.0
    waist_ease: HeldWaistEase = 0.0
    stretch: declared.ClothStretch = 0.0
    knit: Annotated[bool, Option("Make it a tube of knitted cloth without darts.")] = False
    length: Annotated[
        float, Option("Hem of the tube below the waist; negative ends above it.", "cm", -12.0, 6.0)
    ] = -9.0


def draft_bandeau(options: BandeauOptions, measurements: Measurements) -> Pattern:
    """Drafts the bandeau for a body: a bustier with a straight upper edge, or a tube of knitted cloth."""
    if not options.knit:
        bodice = StraplessBodice(options.bust_ease, options.waist_ease, dip=0.0)
        return _strapless("bandeau", bodice, measurements, options.stretch / 100)
    table = CuttingTable("bandeau", options.stretch / 100)
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    lay_knit_tube(table, figure, KnitTube(options.bust_ease, options.length))
    table.mirror()
    sew_centres(table)
    return table.finish()


def _strapless(
    name: str, bodice: StraplessBodice, measurements: Measurements, stretch: float = 0.0
) -> Pattern:
    table = CuttingTable(name, stretch)
    lay_strapless_bodice(table, Figure.of(measurements).for_cloth(stretch), bodice)
    table.mirror()
    sew_centres(table)
    return table.finish()


@dataclass(frozen=True)
class HeldDressOptions:
    """Options of the skirts of dresses on straps or none."""

    waist_ease: HeldWaistEase = 0.0
    skirt_length: Annotated[float, Option("Body's waist to the hem.", "cm", 36.0, 104.0)] = 62.0
    skirt_fraction: declared.CircleFraction = 0.5
    gathers: declared.SkirtGathers = 1.0
    pleats: declared.SkirtPleats = 0
    hem_band: declared.HemBand = 0.0
    fitted: Annotated[bool, Option("Cut the skirt close, with darts, instead of from a circle.")] = False
    hip_ease: declared.HipEase = 4.0
    skirt_flare: declared.SkirtFlare = 1.0
    flounce: Annotated[bool, Option("End the close skirt at a flounce cut from a circle.")] = False
    close: declared.FlounceSeam = 58.0
    stretch: declared.ClothStretch = 0.0


@dataclass(frozen=True)
class StraplessDressOptions(HeldDressOptions):
    """Options of the strapless dress."""

    bust_ease: StraplessEase = 1.0
    dip: HeartDip = 4.5
    skirt_length: Annotated[float, Option("Body's waist to the hem.", "cm", 36.0, 104.0)] = 98.0


def draft_strapless_dress(options: StraplessDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the strapless dress for a body: the waist seam holds it up."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("strapless-dress", options.stretch / 100)
    bodice = StraplessBodice(options.bust_ease, options.waist_ease, options.dip)
    waist = lay_strapless_bodice(table, figure, bodice)
    return _with_skirt(table, figure, options, waist)


@dataclass(frozen=True)
class StrappyDressOptions(HeldDressOptions):
    """Options of the strappy dress."""

    bust_ease: declared.BustEase = 3.0
    waist_ease: declared.WaistEase = 2.0
    strap_width: Annotated[float, Option("Width of the straps.", "cm", 1.0, 7.0)] = 1.5
    dip: FrontDip = 3.0
    crossed: CrossedStraps = False


def draft_strappy_dress(options: StrappyDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the strappy dress for a body: a darted bodice on thin straps, a skirt sewn to its waist."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("strappy-dress", options.stretch / 100)
    strap = min(options.strap_width, _WIDEST_CROSSED_CM) if options.crossed else options.strap_width
    bodice = FittedStrapBodice(strap, options.bust_ease, options.waist_ease, options.dip, options.crossed)
    waist = lay_fitted_strap_bodice(table, figure, bodice)
    return _with_skirt(table, figure, options, waist, crossed=options.crossed)


def _with_skirt(
    table: CuttingTable, figure: Figure, options: HeldDressOptions, waist: Halves, *, crossed: bool = False
) -> Pattern:
    table.mirror()
    sew_centres(table)
    if crossed:
        sew_crossed_straps(table)
    if options.fitted or options.flounce:
        close = min(options.close, options.skirt_length - SHORTEST_FLOUNCE)
        length = close if options.flounce else options.skirt_length
        flare = min(options.skirt_flare, -1.5) if options.flounce else options.skirt_flare
        lay_fitted_skirt(table, figure, FittedSkirt(length, options.hip_ease, flare), waist, figure.waist_y)
        sew_skirt_to_bodice(table, SKIRT_HALVES)
        if options.flounce:
            y = figure.waist_y - close - 3.0
            lay_flounce(table, options.skirt_length - close, y, options.skirt_fraction)
    else:
        skirt = RoundSkirt(
            options.skirt_length,
            options.skirt_fraction,
            options.gathers,
            hem_band=options.hem_band,
            pleats=options.pleats,
        )
        lay_round_skirt(table, figure, skirt, waist)
    return table.finish()


@dataclass(frozen=True)
class HeldJumpsuitOptions:
    """Options of the legs of jumpsuits on straps or none."""

    waist_ease: HeldWaistEase = 0.0
    hip_ease: declared.HipEase = 6.0
    length: declared.TrouserLength = 102.0
    leg_ease: declared.LegEase = 22.0
    flare: declared.LegFlare = -8.0
    crotch_drop: Annotated[float, Option("Crotch below the body's.", "cm", 1.5, 8.0)] = 3.0
    leg_cuff: declared.GatheringLegCuff = 0.0
    stretch: declared.ClothStretch = 0.0


@dataclass(frozen=True)
class StraplessJumpsuitOptions(HeldJumpsuitOptions):
    """Options of the strapless jumpsuit."""

    bust_ease: StraplessEase = 1.0
    dip: HeartDip = 0.0


def draft_strapless_jumpsuit(options: StraplessJumpsuitOptions, measurements: Measurements) -> Pattern:
    """Drafts the strapless jumpsuit for a body: the waist seam holds it up."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("strapless-jumpsuit", options.stretch / 100)
    bodice = StraplessBodice(options.bust_ease, options.waist_ease, options.dip)
    return _with_legs(table, figure, options, lay_strapless_bodice(table, figure, bodice))


@dataclass(frozen=True)
class StrappyJumpsuitOptions(HeldJumpsuitOptions):
    """Options of the strappy jumpsuit."""

    bust_ease: declared.BustEase = 3.0
    waist_ease: declared.WaistEase = 3.0
    strap_width: StrapWidth = 1.5
    dip: FrontDip = 3.0
    crossed: CrossedStraps = False


def draft_strappy_jumpsuit(options: StrappyJumpsuitOptions, measurements: Measurements) -> Pattern:
    """Drafts the strappy jumpsuit for a body: a darted bodice on thin straps, trousers sewn to its waist."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("strappy-jumpsuit", options.stretch / 100)
    bodice = FittedStrapBodice(
        options.strap_width, options.bust_ease, options.waist_ease, options.dip, options.crossed
    )
    waist = lay_fitted_strap_bodice(table, figure, bodice)
    return _with_legs(table, figure, options, waist, crossed=options.crossed)


def _with_legs(
    table: CuttingTable, figure: Figure, options: HeldJumpsuitOptions, waist: Halves, *, crossed: bool = False
) -> Pattern:
    legs = legs_of_bodice(
        options.length, options.hip_ease, options.leg_ease, options.flare, options.crotch_drop
    )
    lay_trousers(table, figure, legs, waist, figure.waist_y)
    lay_gathering_leg_cuff(table, figure, options.leg_cuff)
    table.mirror()
    sew_centres(table)
    if crossed:
        sew_crossed_straps(table)
    sew_legs(table)
    sew_trousers_to_bodice(table)
    return table.finish()


def _on_straps(name: str, bodice: StrapBodice, measurements: Measurements, stretch: float = 0.0) -> Pattern:
    table = CuttingTable(name, stretch)
    lay_strap_bodice(table, Figure.of(measurements).for_cloth(stretch), bodice)
    table.mirror()
    sew_centres(table)
    if bodice.crossed:
        sew_crossed_straps(table)
    return table.finish()

"""Garments that leave the shoulders bare and are held elsewhere: halters, and necklines around the arms."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated, Literal

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.bodice import sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fitted_skirt import FittedSkirt, lay_fitted_skirt
from swifttailor.pattern.drafts.flared_skirt import SHORTEST_FLOUNCE, lay_flared_skirt, lay_flounce
from swifttailor.pattern.drafts.halter_bodice import HalterBodice, lay_halter_bodice, sew_strap
from swifttailor.pattern.drafts.joins import (
    SKIRT_HALVES,
    SKIRT_WHOLE,
    sew_skirt_to_bodice,
    sew_trousers_to_bodice,
)
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.off_shoulder_bodice import OffShoulderBodice, lay_off_shoulder_bodice
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.trousers import lay_trousers, legs_of_bodice, sew_legs
from swifttailor.pattern.pattern import Pattern

HalterStrap = Annotated[float, Option("Width of the front at the neck, and of the strap.", "cm", 1.5, 6.0)]
AboveUnderarm = Annotated[float, Option("Height of the upper edge over the underarm.", "cm", 3.0, 9.0)]
BareSleeve = Annotated[float, Option("Bare shoulder tip to the sleeve's end.", "cm", 18.0, 64.0)]
CloseArmEase = Annotated[float, Option("Room on top of the upper arm girth, all around.", "cm", 2.0, 14.0)]

_SHORTEST_CLOSE_CM, _FLOUNCED_TAPER = 30.0, -1.5
"""Of the close part above a flounce, cm, and the slant of its sides, degrees."""
_CROTCH_DROP = 3.0
"""Of a jumpsuit's crotch below the body's: the room to sit down in, cm."""


@dataclass(frozen=True)
class _HalterOptions:
    """What halter tops and dresses have in common."""

    length: declared.TopLength = 14.0
    chest_ease: declared.BustEase = 3.0
    flare: declared.HemFlare = 0.0
    neckline: declared.NeckShapeOption = "v"
    neck_depth: declared.NeckDepth = 16.0
    strap_width: HalterStrap = 3.5
    back_fall: Annotated[
        float, Option("Fall of the back from the underarm to its middle.", "cm", 3.0, 20.0)
    ] = 5.0


@dataclass(frozen=True)
class HalterTopOptions(_HalterOptions):
    """Options of the halter top."""

    stretch: declared.ClothStretch = 0.0


def draft_halter_top(options: HalterTopOptions, measurements: Measurements) -> Pattern:
    """Drafts the halter top for a body; one of cloth that stretches lies on the ribs, as of bikinis."""
    stretch = options.stretch / 100
    table = CuttingTable("halter-top", stretch)
    bodice = replace(_halter(options), stretches=stretch > 0.0)
    lay_halter_bodice(table, Figure.of(measurements).for_cloth(stretch), bodice)
    return _sewn_halter(table)


@dataclass(frozen=True)
class HalterDressOptions(_HalterOptions):
    """Options of the halter dress."""

    length: declared.LongLength = 58.0
    flare: declared.DressFlare = 40.0
    waist_seam: Annotated[
        bool,
        Option("Sew a skirt cut from a circle to a waist with darts; else it is cut in one, with a flare."),
    ] = True
    waist_ease: declared.WaistEase = 2.0
    skirt_fraction: declared.CircleFraction = 0.5


def draft_halter_dress(options: HalterDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the halter dress for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("halter-dress")
    waist_ease = options.waist_ease if options.waist_seam else None
    waist = lay_halter_bodice(table, figure, _halter(options, waist_ease))
    if waist is None:
        return _sewn_halter(table)
    lay_flared_skirt(table, waist, options.length, figure.waist_y - 3.0, options.skirt_fraction)
    return _sewn_halter(table, "skirt")


@dataclass(frozen=True)
class HalterJumpsuitOptions:
    """Options of the halter jumpsuit."""

    chest_ease: declared.BustEase = 3.0
    waist_ease: declared.WaistEase = 3.0
    hip_ease: declared.HipEase = 6.0
    neckline: declared.NeckShapeOption = "v"
    neck_depth: declared.NeckDepth = 16.0
    strap_width: HalterStrap = 3.5
    length: declared.TrouserLength = 102.0
    leg_ease: declared.LegEase = 22.0
    flare: declared.LegFlare = -8.0
    stretch: declared.ClothStretch = 0.0


def draft_halter_jumpsuit(options: HalterJumpsuitOptions, measurements: Measurements) -> Pattern:
    """Drafts the halter jumpsuit for a body."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("halter-jumpsuit", options.stretch / 100)
    neckline = Neckline(options.neckline, 0.5, options.neck_depth)
    halter = HalterBodice(options.chest_ease, 0.0, options.strap_width, neckline, 0.0, options.waist_ease)
    waist = lay_halter_bodice(table, figure, halter)
    assert waist is not None
    # Legs are heavy, and the strap holds the front alone: without a hold the back slides down.
    table.label("left_btorso.top", "strapless_top")
    legs = legs_of_bodice(options.length, options.hip_ease, options.leg_ease, options.flare, _CROTCH_DROP)
    lay_trousers(table, figure, legs, waist, figure.waist_y)
    return _sewn_halter(table, "trousers")


@dataclass(frozen=True)
class OffShoulderTopOptions:
    """Options of the off-the-shoulder top."""

    length: declared.TopLength = 14.0
    chest_ease: declared.BustEase = 3.0
    flare: declared.HemFlare = 0.0
    above_underarm: AboveUnderarm = 5.0
    sleeve_length: BareSleeve = 30.0
    arm_ease: CloseArmEase = 5.0
    sleeve_end: declared.SleeveEnd = 30.0


def draft_off_shoulder_top(options: OffShoulderTopOptions, measurements: Measurements) -> Pattern:
    """Drafts the off-the-shoulder top for a body."""
    return _off_shoulder("off-shoulder-top", options, measurements)


@dataclass(frozen=True)
class OffShoulderDressOptions(OffShoulderTopOptions):
    """Options of the off-the-shoulder dress."""

    length: declared.LongLength = 50.0
    flare: declared.DressFlare = 30.0
    waist_seam: Annotated[
        bool,
        Option("Sew a skirt cut from a circle to a waist with darts; else it is cut in one, with a flare."),
    ] = False
    waist_ease: declared.WaistEase = 3.0
    skirt_fraction: declared.CircleFraction = 0.5
    flounce: Annotated[
        bool, Option("With a waist seam, cut the skirt close and end it at a flounce cut from a circle.")
    ] = False
    close: declared.FlounceSeam = 54.0
    hip_ease: declared.HipEase = 4.0


def draft_off_shoulder_dress(options: OffShoulderDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the off-the-shoulder dress for a body."""
    if not options.waist_seam:
        return _off_shoulder("off-shoulder-dress", options, measurements)
    table, figure = CuttingTable("off-shoulder-dress"), Figure.of(measurements)
    waist = lay_off_shoulder_bodice(table, figure, _bare(options, options.waist_ease))
    assert waist is not None
    if not options.flounce:
        lay_flared_skirt(table, waist, options.length, figure.waist_y - 3.0, options.skirt_fraction)
    table.mirror()
    sew_centres(table)
    if options.flounce:
        close = max(min(options.close, options.length - SHORTEST_FLOUNCE), _SHORTEST_CLOSE_CM)
        skirt = FittedSkirt(close, options.hip_ease, _FLOUNCED_TAPER)
        lay_fitted_skirt(table, figure, skirt, waist, figure.waist_y)
    sew_skirt_to_bodice(table, SKIRT_HALVES if options.flounce else SKIRT_WHOLE)
    if options.flounce:
        fall = max(options.length - close, SHORTEST_FLOUNCE)
        lay_flounce(table, fall, figure.waist_y - close - 3.0, options.skirt_fraction)
    return table.finish()


def _halter(options: _HalterOptions, waist_ease: float | None = None) -> HalterBodice:
    neckline = Neckline(options.neckline, 0.5, options.neck_depth)
    return HalterBodice(
        options.chest_ease,
        options.length,
        options.strap_width,
        neckline,
        options.flare,
        waist_ease,
        options.back_fall,
    )


def _sewn_halter(table: CuttingTable, lower: Literal["skirt", "trousers"] | None = None) -> Pattern:
    table.mirror()
    sew_centres(table)
    sew_strap(table)
    if lower == "skirt":
        sew_skirt_to_bodice(table, SKIRT_WHOLE)
    elif lower == "trousers":
        sew_legs(table)
        sew_trousers_to_bodice(table)
    return table.finish()


def _bare(options: OffShoulderTopOptions, waist_ease: float | None = None) -> OffShoulderBodice:
    return OffShoulderBodice(
        options.chest_ease,
        options.length,
        options.above_underarm,
        options.flare,
        options.sleeve_length,
        options.arm_ease,
        options.sleeve_end,
        waist_ease,
    )


def _off_shoulder(name: str, options: OffShoulderTopOptions, measurements: Measurements) -> Pattern:
    table = CuttingTable(name)
    lay_off_shoulder_bodice(table, Figure.of(measurements), _bare(options))
    table.mirror()
    sew_centres(table)
    return table.finish()

"""Garments with a darted bodice: fitted top, fitted, mermaid, skater and shirt dress, jumpsuit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.armholes import RACER_STRAP_CM
from swifttailor.pattern.drafts.band import lay_gathering_leg_cuff, lay_sleeve_cuff
from swifttailor.pattern.drafts.bodice import sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.fitted_bodice import FittedBodice, lay_fitted_bodice
from swifttailor.pattern.drafts.fitted_skirt import FittedSkirt, lay_fitted_skirt
from swifttailor.pattern.drafts.flared_skirt import SHORTEST_FLOUNCE, lay_flounce
from swifttailor.pattern.drafts.godets import GodetCount, GodetHeight, Godets, GodetWidth, let_in_godets
from swifttailor.pattern.drafts.joins import (
    SKIRT_HALVES,
    sew_skirt_to_bodice,
    sew_trousers_to_bodice,
)
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neck_collar import CollarHeight, CollarOption, NeckCollar
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.round_skirt import RoundSkirt, lay_round_skirt
from swifttailor.pattern.drafts.shaped_hem import HemShape
from swifttailor.pattern.drafts.shaped_sleeve import SleeveShapeOption, lay_shaped_sleeve
from swifttailor.pattern.drafts.sleeve import Sleeve
from swifttailor.pattern.drafts.tiers import lay_tiers_below
from swifttailor.pattern.drafts.trousers import lay_trousers, legs_of_bodice, sew_legs
from swifttailor.pattern.pattern import Pattern

_INSET_CM = 1.5
"""How far the armholes of a sleeveless shirt dress lie inside the shoulder tips."""
RacerBack = Annotated[
    bool, Option("Cut the back in between the shoulder blades, where there are no sleeves.")
]


@dataclass(frozen=True)
class SetInSleeveOptions:
    """Options of sleeves that may be set into a darted bodice."""

    sleeves: declared.Sleeves = False
    sleeve_length: declared.SleeveLength = 24.0
    arm_ease: declared.ArmEase = 6.0
    sleeve_end: declared.SleeveEnd = 33.0
    cap_ease: declared.CapEase = 3.0
    sleeve_shape: SleeveShapeOption = "plain"


@dataclass(frozen=True)
class CloseDressOptions(SetInSleeveOptions):
    """Options of dresses that are close from the bust to the hips and below."""

    bust_ease: declared.BustEase = 5.0
    waist_ease: declared.WaistEase = 3.5
    hip_ease: declared.HipEase = 4.0
    skirt_length: declared.SkirtLength = 60.0
    skirt_flare: declared.SkirtFlare = 2.0
    neckline: declared.NeckShapeOption = "round"
    neck_widening: declared.NeckWidening = 1.5
    neck_depth: declared.PlungingNeckDepth = 12.0
    back_neck_depth: declared.BareBackDepth = 4.0
    shoulder_inset: Annotated[
        float, Option("How far the armhole lies inside the shoulder tip.", "cm", 0.0, 5.0)
    ] = 1.5
    armhole_drop: declared.ArmholeDrop = 2.0
    collar: CollarOption = "none"
    collar_width: declared.CollarWidth = 5.5
    collar_height: CollarHeight = 4.0
    stretch: declared.ClothStretch = 0.0


@dataclass(frozen=True)
class FittedDressOptions(CloseDressOptions):
    """Options of the fitted dress."""

    godets: GodetCount = 0
    godet_width: GodetWidth = 32.0
    godet_height: GodetHeight = 30.0


def draft_fitted_dress(options: FittedDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the fitted dress for a body."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("fitted-dress", options.stretch / 100)
    _lay_fitted_dress(table, figure, options, options.skirt_length, options.skirt_flare)
    let_in_godets(table, Godets(options.godets, options.godet_width, options.godet_height))
    return table.finish()


@dataclass(frozen=True)
class MermaidDressOptions(CloseDressOptions):
    """Options of the mermaid dress."""

    skirt_length: declared.SkirtLength = 100.0
    skirt_flare: declared.SkirtFlare = -1.5
    close: declared.FlounceSeam = 58.0
    fraction: declared.FlounceFraction = 0.5
    tiers: Annotated[
        int, Option("Gathered tiers below the close part; 0: a flounce cut from a circle.", "tiers", 0, 6)
    ] = 0
    fullness: Annotated[
        float, Option("Width of each tier over that of the edge it is gathered into.", "times", 1.15, 1.8)
    ] = 1.4


def draft_mermaid_dress(options: MermaidDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the mermaid dress for a body: close down to the knee, a flounce cut from a circle below."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("mermaid-dress", options.stretch / 100)
    close = min(options.close, options.skirt_length - SHORTEST_FLOUNCE)
    _lay_fitted_dress(table, figure, options, close, options.skirt_flare)
    if options.tiers:
        height = (options.skirt_length - close) / options.tiers
        lay_tiers_below(table, options.tiers, height, figure.waist_y - close - 3.0, options.fullness)
        return table.finish()
    lay_flounce(table, options.skirt_length - close, figure.waist_y - close - 3.0, options.fraction)
    return table.finish()


def _lay_fitted_dress(
    table: CuttingTable, figure: Figure, options: CloseDressOptions, length: float, flare: float
) -> None:
    """Lays and sews bodice and skirt; `length` is the skirt's, from the body's waist to its hem, cm."""
    collar = NeckCollar(options.collar, options.collar_width, options.collar_height)
    bodice = FittedBodice(
        collar.neckline(_neckline(options)),
        options.bust_ease,
        options.waist_ease,
        options.armhole_drop,
        0.0 if options.sleeves else -options.shoulder_inset,
    )
    waist = lay_fitted_bodice(table, figure, bodice)
    _set_in_sleeves(table, figure, options)
    collar.lay(table, figure)
    table.mirror()
    sew_centres(table)
    collar.sew(table)
    lay_fitted_skirt(table, figure, FittedSkirt(length, options.hip_ease, flare), waist, figure.waist_y)
    sew_skirt_to_bodice(table, SKIRT_HALVES)


@dataclass(frozen=True)
class ShirtDressOptions:
    """Options of the shirt dress."""

    bust_ease: declared.BustEase = 9.0
    waist_ease: declared.WaistEase = 7.0
    skirt_length: declared.SkirtLength = 62.0
    skirt_fraction: declared.CircleFraction = 0.5
    gathers: declared.SkirtGathers = 1.0
    pleats: declared.SkirtPleats = 0
    neckline: declared.NeckShapeOption = "v"
    neck_widening: declared.NeckWidening = 1.0
    neck_depth: declared.NeckDepth = 15.0
    back_neck_depth: declared.BackNeckDepth = 2.0
    armhole_drop: declared.ArmholeDrop = 3.5
    sleeves: declared.Sleeves = True
    sleeve_length: declared.SleeveLength = 56.0
    arm_ease: declared.ArmEase = 7.0
    sleeve_end: declared.SleeveEnd = 27.0
    cap_ease: declared.CapEase = 3.0
    cuffs: Annotated[bool, Option("Sew cuffs to the sleeves.")] = True
    cuff_height: declared.SleeveCuffHeight = 6.0
    cuff_ease: declared.CuffWidth = 5.0
    sleeve_shape: SleeveShapeOption = "plain"
    collar: CollarOption = "none"
    collar_width: declared.CollarWidth = 5.5
    collar_height: CollarHeight = 4.0


def draft_shirt_dress(options: ShirtDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the shirt dress for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("shirt-dress")
    collar = NeckCollar(options.collar, options.collar_width, options.collar_height)
    neckline = collar.neckline(_neckline(options))
    inset = 0.0 if options.sleeves else _INSET_CM
    bodice = FittedBodice(neckline, options.bust_ease, options.waist_ease, options.armhole_drop, -inset)
    waist = lay_fitted_bodice(table, figure, bodice)
    if options.sleeves:
        cuffs = options.cuffs and options.sleeve_shape == "plain"
        cuff = min(options.cuff_height, options.sleeve_length - 9.0) if cuffs else 0.0
        length = options.sleeve_length - cuff
        plain = Sleeve(length, options.arm_ease, options.sleeve_end, options.cap_ease / 100)
        lay_shaped_sleeve(table, figure, options.sleeve_shape, plain)
        if cuffs:
            lay_sleeve_cuff(table, figure, length, options.cuff_ease, cuff)
    collar.lay(table, figure)
    table.mirror()
    sew_centres(table)
    collar.sew(table)
    skirt = RoundSkirt(options.skirt_length, options.skirt_fraction, options.gathers, pleats=options.pleats)
    lay_round_skirt(table, figure, skirt, waist)
    return table.finish()


@dataclass(frozen=True)
class SleevedBodiceOptions(SetInSleeveOptions):
    """Options of garments with a darted bodice that sleeves may be set into."""

    bust_ease: declared.BustEase = 5.0
    waist_ease: declared.WaistEase = 3.5
    neckline: declared.NeckShapeOption = "round"
    neck_widening: declared.NeckWidening = 1.5
    neck_depth: declared.PlungingNeckDepth = 12.0
    back_neck_depth: declared.BareBackDepth = 4.0
    armhole_drop: declared.ArmholeDrop = 2.0
    stretch: declared.ClothStretch = 0.0


@dataclass(frozen=True)
class SkaterDressOptions(SleevedBodiceOptions):
    """Options of the skater dress."""

    skirt_length: declared.SkirtLength = 50.0
    skirt_fraction: declared.CircleFraction = 0.75
    gathers: declared.SkirtGathers = 1.0
    pleats: declared.SkirtPleats = 0
    hem_band: declared.HemBand = 0.0
    hem_dip: declared.HemDip = 0.0
    scallop_width: declared.ScallopWidth = 0.0
    hem_points: declared.HemPoints = 0.0
    racer: RacerBack = False


def draft_skater_dress(options: SkaterDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the skater dress for a body: fit and flare, of any length."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("skater-dress", options.stretch / 100)
    waist = lay_sleeved_bodice(table, figure, options, racer=options.racer)
    table.mirror()
    sew_centres(table)
    hem = HemShape(options.hem_dip, options.scallop_width, points=options.hem_points)
    skirt = RoundSkirt(
        options.skirt_length,
        options.skirt_fraction,
        options.gathers,
        hem,
        options.hem_band,
        options.pleats,
    )
    lay_round_skirt(table, figure, skirt, waist)
    return table.finish()


@dataclass(frozen=True)
class FittedTopOptions(SleevedBodiceOptions):
    """Options of the fitted top."""

    bust_ease: declared.BustEase = 4.0
    waist_ease: declared.WaistEase = 3.0


def draft_fitted_top(options: FittedTopOptions, measurements: Measurements) -> Pattern:
    """Drafts the fitted top for a body: the darted bodice alone, which ends at the waist."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("fitted-top", options.stretch / 100)
    lay_sleeved_bodice(table, figure, options)
    table.mirror()
    sew_centres(table)
    return table.finish()


@dataclass(frozen=True)
class PeplumTopOptions(SleevedBodiceOptions):
    """Options of the peplum top."""

    length: Annotated[float, Option("Waist seam to the hem of the peplum.", "cm", 10.0, 30.0)] = 18.0
    fraction: declared.CircleFraction = 0.8
    collar: CollarOption = "none"
    collar_width: declared.CollarWidth = 5.5
    collar_height: CollarHeight = 4.0


def draft_peplum_top(options: PeplumTopOptions, measurements: Measurements) -> Pattern:
    """Drafts the peplum top for a body: the skater dress with a skirt that ends at the hips."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("peplum-top", options.stretch / 100)
    collar = NeckCollar(options.collar, options.collar_width, options.collar_height)
    waist = lay_sleeved_bodice(table, figure, options, collar.neckline(_neckline(options)))
    collar.lay(table, figure)
    table.mirror()
    sew_centres(table)
    collar.sew(table)
    lay_round_skirt(table, figure, RoundSkirt(options.length, options.fraction, 1.0), waist)
    return table.finish()


@dataclass(frozen=True)
class JumpsuitOptions(SleevedBodiceOptions):
    """Options of the jumpsuit."""

    bust_ease: declared.BustEase = 7.0
    waist_ease: declared.WaistEase = 6.0
    neckline: declared.NeckShapeOption = "v"
    neck_widening: declared.NeckWidening = 1.5
    neck_depth: declared.PlungingNeckDepth = 15.0
    armhole_drop: declared.ArmholeDrop = 2.5
    hip_ease: declared.HipEase = 6.0
    length: declared.TrouserLength = 102.0
    leg_ease: declared.LegEase = 22.0
    flare: declared.LegFlare = -8.0
    crotch_drop: Annotated[
        float, Option("Crotch below the body's; the room to sit down in.", "cm", 1.5, 8.0)
    ] = 3.0
    leg_cuff: declared.GatheringLegCuff = 0.0
    collar: CollarOption = "none"
    collar_width: declared.CollarWidth = 5.5
    collar_height: CollarHeight = 4.0


def draft_jumpsuit(options: JumpsuitOptions, measurements: Measurements) -> Pattern:
    """Drafts the jumpsuit for a body."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("jumpsuit", options.stretch / 100)
    collar = NeckCollar(options.collar, options.collar_width, options.collar_height)
    waist = lay_sleeved_bodice(table, figure, options, collar.neckline(_neckline(options)))
    collar.lay(table, figure)
    legs = legs_of_bodice(
        options.length, options.hip_ease, options.leg_ease, options.flare, options.crotch_drop
    )
    lay_trousers(table, figure, legs, waist, figure.waist_y)
    lay_gathering_leg_cuff(table, figure, options.leg_cuff)
    table.mirror()
    sew_centres(table)
    collar.sew(table)
    sew_legs(table)
    sew_trousers_to_bodice(table)
    return table.finish()


def lay_sleeved_bodice(
    table: CuttingTable,
    figure: Figure,
    options: SleevedBodiceOptions,
    neckline: Neckline | None = None,
    *,
    strap: float = 0.0,
    yoke: bool = False,
    racer: bool = False,
    knit: bool = False,
) -> Halves:
    """Lays a bodice with sleeves, or with armholes further in.

    Args:
        table: Where it goes.
        figure: The body.
        options: Of its garment.
        neckline: Instead of that of the options.
        strap: Width of the shoulder where there are no sleeves, cm; 0: nearly all of it, or `RACER_STRAP_CM`.
        yoke: Whether it ends below the arms and has no darts.
        racer: Whether the back is cut in between the shoulder blades, where there are none.
        knit: Whether it is of cloth that stretches, and has no darts.

    Returns:
        The sewn half widths of its waist, cm.
    """
    strap = RACER_STRAP_CM if racer and not strap else strap
    asked = neckline or _neckline(options)
    extension = 0.0 if options.sleeves else -_INSET_CM
    if strap and not options.sleeves:
        extension = min(extension, asked.start_x(figure) + strap - figure.shoulder_x)
    bodice = FittedBodice(
        asked,
        options.bust_ease,
        options.bust_ease if yoke else options.waist_ease,
        options.armhole_drop,
        extension,
        yoke=yoke,
        racer=racer and not options.sleeves,
        knit=knit,
    )
    waist = lay_fitted_bodice(table, figure, bodice)
    _set_in_sleeves(table, figure, options)
    return waist


def _set_in_sleeves(table: CuttingTable, figure: Figure, options: SetInSleeveOptions) -> None:
    """Lays the left sleeve and sews it in, where there are to be any."""
    if options.sleeves:
        plain = Sleeve(options.sleeve_length, options.arm_ease, options.sleeve_end, options.cap_ease / 100)
        lay_shaped_sleeve(table, figure, options.sleeve_shape, plain)


def _neckline(
    options: CloseDressOptions | ShirtDressOptions | SleevedBodiceOptions,
) -> Neckline:
    return Neckline(options.neckline, options.neck_widening, options.neck_depth, options.back_neck_depth)

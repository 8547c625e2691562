"""Tops with bands at wrists and hem: hoodie, sweatshirt, bomber jacket, denim jacket."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Literal

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_sleeve_cuff, lay_waist_band
from swifttailor.pattern.drafts.bodice import LooseBodice, lay_loose_bodice, sew_centres
from swifttailor.pattern.drafts.cut_in_one import lay_cuff_of_one
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.hood import Hood, lay_hood, sew_hood
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neck_collar import CollarHeight, NeckCollar, SewnCollarOption
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.shaped_sleeve import (
    ArmholeCut,
    ArmholeCutOption,
    BalloonOption,
    KnittedSleeveOption,
    RaglanOption,
    WingOption,
    ballooning,
    lay_shaped_sleeve,
)
from swifttailor.pattern.drafts.sleeve import Sleeve
from swifttailor.pattern.drafts.stand_collar import lay_stand_collar, sew_collar
from swifttailor.pattern.pattern import Pattern

_INSET_CM = 2.0
"""How far armholes without sleeves lie inside the shoulder tips."""

_NAPE_CM = 4.0
"""Fall of the back neckline of jumpers, cm: cut closer, it stands up behind the neck."""

_WITHOUT_CUFFS = ("bell", "wide")
"""Sleeves that end wide."""

HemBandEase = Annotated[
    float, Option("Room of the hem band on top of the body there, all around.", "cm", 0.0, 20.0)
]
"""All of it lies behind: with much, bands of short jackets stand off there like a shelf."""


@dataclass(frozen=True)
class BandedOptions:
    """What all of these have."""

    length: declared.BandedLength = 22.0
    chest_ease: declared.ChestEase = 16.0
    neck_widening: declared.HighNeckWidening = 2.0
    neck_depth: declared.HighNeckDepth = 9.5
    armhole_drop: declared.ArmholeDrop = 4.5
    shoulder_extension: declared.ShoulderExtension = 2.0
    sleeve_length: declared.SleeveLength = 58.0
    arm_ease: declared.ArmEase = 12.0
    sleeve_end: declared.SleeveEnd = 28.0
    sleeve_shape: KnittedSleeveOption = "plain"
    cuffs: Annotated[bool, Option("Sew ribbed cuffs to the sleeves.")] = True
    cuff_height: declared.SleeveCuffHeight = 6.0
    cuff_ease: declared.CuffWidth = 5.0
    hem_band: Annotated[bool, Option("Sew a ribbed band to the hem.")] = True
    hem_band_height: Annotated[float, Option("Height of the hem band.", "cm", 3.0, 10.0)] = 6.0
    hem_band_ease: HemBandEase = 4.0


@dataclass(frozen=True)
class SweatshirtOptions(BandedOptions):
    """Options of the sweatshirt."""

    neckline: Annotated[Literal["round", "v"], Option("Shape of the front neckline.")] = "round"
    neck_widening: declared.HighNeckWidening = -1.2
    neck_depth: Annotated[
        float, Option("Fall of the front neckline below the neck-shoulder point.", "cm", 7.0, 24.0)
    ] = 9.8
    collar: Annotated[
        Literal["none", "standing", "rolled", "loose"],
        Option("Collar: one that stands on a close neck, is turned down over itself, or falls wide over it."),
    ] = "none"
    collar_height: CollarHeight = 4.5
    sleeves: declared.Sleeves = True
    armhole: ArmholeCutOption = "set-in"
    wing: WingOption = 8.0


def draft_sweatshirt(options: SweatshirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the sweatshirt for a body."""
    figure, table = Figure.of(measurements), CuttingTable("sweatshirt")
    collar = NeckCollar(options.collar, 0.0, options.collar_height)
    neckline = Neckline(options.neckline, options.neck_widening, options.neck_depth, _NAPE_CM)
    _lay_bodice(table, figure, options, collar.neckline(neckline), sleeves=options.sleeves)
    collar.lay(table, figure)
    if options.sleeves:
        _lay_sleeve(table, figure, options, options.armhole, options.wing)
    return _finished(table, figure, options, collar.sew)


@dataclass(frozen=True)
class BomberJacketOptions(BandedOptions):
    """Options of the bomber jacket."""

    sleeve_shape: BalloonOption = "plain"
    length: declared.BandedLength = 14.0
    chest_ease: declared.ChestEase = 18.0
    neck_widening: declared.CloseNeckWidening = 0.0
    neck_depth: declared.HighNeckDepth = 8.0
    collar_height: Annotated[float, Option("Height of the collar.", "cm", 2.0, 6.0)] = 4.0
    armhole: RaglanOption = "set-in"
    hem_band_ease: HemBandEase = 1.0


def draft_bomber_jacket(options: BomberJacketOptions, measurements: Measurements) -> Pattern:
    """Drafts the bomber jacket for a body: zipped up, so closed in front; its collar stands."""
    figure, table = Figure.of(measurements), CuttingTable("bomber-jacket")
    neckline = Neckline("round", options.neck_widening, options.neck_depth, 1.5)
    _lay_bodice(table, figure, options, neckline)
    lay_stand_collar(table, figure, options.collar_height)
    _lay_sleeve(table, figure, options, options.armhole)
    return _finished(table, figure, options, sew_collar)


@dataclass(frozen=True)
class DenimJacketOptions(BandedOptions):
    """Options of the denim jacket."""

    sleeve_shape: BalloonOption = "plain"
    length: declared.BandedLength = 12.0
    chest_ease: declared.ChestEase = 14.0
    neck_widening: declared.CloseNeckWidening = 0.5
    neck_depth: declared.CollarNeckDepth = 10.0
    collar: SewnCollarOption = "shirt"
    collar_height: CollarHeight = 4.0
    arm_ease: declared.ArmEase = 9.0
    hem_band_ease: HemBandEase = 3.0
    collar_width: declared.CollarWidth = 6.0


def draft_denim_jacket(options: DenimJacketOptions, measurements: Measurements) -> Pattern:
    """Drafts the denim jacket for a body: buttoned up, so closed in front."""
    figure, table = Figure.of(measurements), CuttingTable("denim-jacket")
    collar = NeckCollar(options.collar, options.collar_width, options.collar_height)
    neckline = Neckline("v", options.neck_widening, options.neck_depth, 1.5)
    _lay_bodice(table, figure, options, collar.neckline(neckline))
    collar.lay(table, figure)
    _lay_sleeve(table, figure, options)
    return _finished(table, figure, options, collar.sew)


@dataclass(frozen=True)
class HoodieOptions(BandedOptions):
    """Options of the hoodie."""

    sleeve_shape: BalloonOption = "plain"
    length: declared.BandedLength = 24.0
    chest_ease: declared.ChestEase = 18.0
    neck_widening: declared.HighNeckWidening = 2.5
    neck_depth: declared.HighNeckDepth = 10.0
    hood_height: declared.HoodHeight = 4.0
    hood_depth: declared.HoodDepth = 4.0
    sleeves: declared.Sleeves = True
    armhole: RaglanOption = "set-in"


def draft_hoodie(options: HoodieOptions, measurements: Measurements) -> Pattern:
    """Drafts the hoodie for a body."""
    figure, table = Figure.of(measurements), CuttingTable("hoodie")
    neckline = Neckline("round", options.neck_widening, options.neck_depth, 2.0)
    _lay_bodice(table, figure, options, neckline, sleeves=options.sleeves)
    lay_hood(table, figure, Hood(options.hood_height, options.hood_depth))
    if options.sleeves:
        _lay_sleeve(table, figure, options, options.armhole)
    return _finished(table, figure, options, sew_hood)


_SHORT_BAND_CM = 4.0
"""Height of the bands of what ends above the waist, at most."""


def _band_height(options: BandedOptions) -> float:
    """A band shorter than the torso leaves at least 2 cm of cloth above it."""
    if not options.hem_band:
        return 0.0
    return min(options.hem_band_height, max(options.length - 2.0, _SHORT_BAND_CM))


def _lay_bodice(
    table: CuttingTable, figure: Figure, options: BandedOptions, neckline: Neckline, *, sleeves: bool = True
) -> None:
    """Lays the left half of the torso."""
    extension = options.shoulder_extension if sleeves else -_INSET_CM
    bodice = LooseBodice(
        neckline,
        options.chest_ease,
        options.length - _band_height(options),
        options.armhole_drop,
        hip_ease=options.hem_band_ease + 2.0 if options.hem_band else 6.0,
        shoulder_extension=extension,
    )
    lay_loose_bodice(table, figure, bodice)


def _lay_sleeve(
    table: CuttingTable,
    figure: Figure,
    options: BandedOptions,
    armhole: ArmholeCut = "set-in",
    wing: float = 8.0,
) -> None:
    """Lays the left sleeve and its cuff."""
    open_shape = options.sleeve_shape if options.sleeve_shape in _WITHOUT_CUFFS else None
    cuffs = options.cuffs and open_shape is None
    cuff = min(options.cuff_height, options.sleeve_length - 10.0) if cuffs else 0.0
    sleeve = Sleeve(
        options.sleeve_length - max(cuff, 0.0),
        options.arm_ease,
        options.sleeve_end,
        0.01,
        options.shoulder_extension,
    )
    if options.sleeve_shape == "balloon":
        sleeve = ballooning(sleeve)
    lay_shaped_sleeve(table, figure, open_shape or "plain", sleeve, armhole, wing)
    if cuffs:
        lay_cuff = lay_cuff_of_one if armhole == "cut-in-one" else lay_sleeve_cuff
        lay_cuff(table, figure, options.sleeve_length - cuff, options.cuff_ease, cuff)


def _finished(
    table: CuttingTable,
    figure: Figure,
    options: BandedOptions,
    sew_neck: Callable[[CuttingTable], None] | None = None,
) -> Pattern:
    """Adds the right half, sews what lies at the neck together, and the band to the hem."""
    table.mirror()
    sew_centres(table)
    if sew_neck is not None:
        sew_neck(table)
    if options.hem_band:
        sew_hem_band(table, figure, options.length, options.hem_band_ease, _band_height(options))
    return table.finish()


def sew_hem_band(table: CuttingTable, figure: Figure, length: float, ease: float, height: float) -> None:
    """Sews a band to the hem of a whole torso, which is closed in front.

    Args:
        table: Has both halves.
        figure: The body.
        length: Where the band ends, below the waist, cm.
        ease: Its room on top of the body there, cm around.
        height: cm.
    """
    hem = [2 * table.length(f"left_{side}torso.hem") for side in "fb"]
    body = figure.girth_below_waist(length)
    if length < 0:  # towards the bust
        up = min(-length / (figure.bust_y - figure.waist_y), 1.0)
        body = body.times(1 + up * (figure.bust.girth / figure.waist.girth - 1))
    body = body.eased(ease)
    share = min(body.girth / sum(hem), 1.0)
    band = Halves(hem[0] / 2 * share, hem[1] / 2 * share)
    top_y = figure.waist_y - length + height - 4.0
    lay_waist_band(table, band, band, height, top_y, at_waist=False)
    table.seam("wb_front.top", ["left_ftorso.hem", "right_ftorso.hem"], gathered=True)
    table.seam("wb_back.top", ["right_btorso.hem", "left_btorso.hem"], gathered=True)

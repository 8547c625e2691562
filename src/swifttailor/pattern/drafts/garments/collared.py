"""Garments whose collar is turned or folded down: polo shirt, shirt, blazer, coat."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_sleeve_cuff
from swifttailor.pattern.drafts.bodice import LooseBodice, lay_loose_bodice, sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.hem_room import SHIRT_HIP_EASE, SHIRTING
from swifttailor.pattern.drafts.lapel_collar import LapelCollar
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neck_collar import CollarHeight, NeckCollar, SewnCollarOption
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.overlapped_fronts import overlap_fronts
from swifttailor.pattern.drafts.shaped_sleeve import (
    ArmholeCut,
    ArmholeCutOption,
    RaglanOption,
    SleeveShapeOption,
    WingOption,
    lay_shaped_sleeve,
)
from swifttailor.pattern.drafts.sleeve import Sleeve
from swifttailor.pattern.pattern import Pattern

_HEM_OPENING_CM = 1.5
"""How far the front edges of a shirt have moved back from the middle at the hem, below the last button."""
_LEVEL_DIP_CM = 2.5
"""So much longer is the back at the middle of the hem: blades and collar take it up, and it would end
above the front else."""
_INSET_CM = 1.5
"""How far the armholes of a sleeveless shirt lie inside the shoulder tips."""


CoatCollar = Literal["lapels", "none", "shirt", "folded", "flat", "standing", "mandarin"]
JacketCollar = Annotated[
    CoatCollar, Option("Collar: lapels, none on a round neck, or one of those that shirts have.")
]
_ROUND_NECK = Neckline("round", 0.5, 11.0, 2.0)
"""Of a jacket or coat without a collar."""


@dataclass(frozen=True)
class PoloShirtOptions:
    """Options of the polo shirt."""

    length: declared.TopLength = 22.0
    chest_ease: declared.ChestEase = 10.0
    flare: declared.HemFlare = 0.0
    neck_widening: declared.CloseNeckWidening = 0.0
    neck_depth: declared.CollarNeckDepth = 14.0
    collar: SewnCollarOption = "shirt"
    collar_width: declared.CollarWidth = 5.0
    collar_height: CollarHeight = 4.0
    armhole_drop: declared.ArmholeDrop = 2.5
    sleeve_length: declared.SleeveLength = 22.0
    arm_ease: declared.ArmEase = 7.0
    sleeve_end: declared.SleeveEnd = 33.0
    side_slits: declared.SideSlits = 0.0
    waist_shaping: declared.WaistShaping = 0.0


def draft_polo_shirt(options: PoloShirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the polo shirt for a body: buttoned up, so closed in front."""
    figure, table = Figure.of(measurements), CuttingTable("polo-shirt")
    collar = NeckCollar(options.collar, options.collar_width, options.collar_height)
    _lay_left(table, figure, options, options.sleeve_length, collar)
    return _finished(table, collar)


@dataclass(frozen=True)
class ShirtOptions(PoloShirtOptions):
    """Options of the shirt."""

    length: declared.TopLength = 24.0
    chest_ease: declared.ChestEase = 12.0
    neck_depth: declared.CollarNeckDepth = 13.0
    collar_width: declared.CollarWidth = 5.5
    armhole_drop: declared.ArmholeDrop = 3.0
    sleeve_length: declared.SleeveLength = 60.0
    arm_ease: declared.ArmEase = 8.0
    sleeve_end: declared.SleeveEnd = 27.0
    sleeves: declared.Sleeves = True
    cuffs: Annotated[bool, Option("Sew cuffs to the sleeves.")] = True
    cuff_height: declared.SleeveCuffHeight = 6.0
    cuff_ease: declared.CuffWidth = 5.0
    sleeve_shape: SleeveShapeOption = "plain"
    shoulder_extension: declared.ShoulderExtension = 0.0
    armhole: RaglanOption = "set-in"
    hem_opening: declared.HemOpening = 0.0
    hem_rise: declared.HemRise = 0.0
    hem_dip: declared.TopHemDip = 0.0


def draft_shirt(options: ShirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the shirt for a body: buttoned, so sewn from the V to the last button, and open below it."""
    figure, table = Figure.of(measurements), CuttingTable("shirt")
    cuffs = options.cuffs and options.sleeves and options.sleeve_shape == "plain"
    cuff = min(options.cuff_height, options.sleeve_length - 9.0) if cuffs else 0.0
    collar = NeckCollar(options.collar, options.collar_width, options.collar_height)
    _lay_left(table, figure, options, options.sleeve_length - cuff if options.sleeves else None, collar)
    if cuffs:
        lay_sleeve_cuff(table, figure, options.sleeve_length - cuff, options.cuff_ease, cuff)
    return _finished(table, collar)


def _lay_left(
    table: CuttingTable, figure: Figure, options: PoloShirtOptions, sleeve: float | None, collar: NeckCollar
) -> None:
    """Lays the left half of torso, sleeve and collar; `sleeve` is its length alone, cm, None without one."""
    opening, extension = (
        (options.hem_opening, options.shoulder_extension) if isinstance(options, ShirtOptions) else (0.0, 0.0)
    )
    bodice = LooseBodice(
        collar.neckline(Neckline("v", options.neck_widening, options.neck_depth, 1.5)),
        options.chest_ease,
        options.length,
        options.armhole_drop,
        flare=options.flare,
        shoulder_extension=extension if sleeve is not None else -_INSET_CM,
        front_slit=opening,
        front_opening=_HEM_OPENING_CM if opening else 0.0,
        side_slits=options.side_slits,
        waist_shaping=options.waist_shaping,
        side_rise=options.hem_rise if isinstance(options, ShirtOptions) else 0.0,
        back_dip=_LEVEL_DIP_CM + (options.hem_dip if isinstance(options, ShirtOptions) else 0.0),
        hip_ease=SHIRT_HIP_EASE,
        hem_room=SHIRTING,
        darted=True,
    )
    lay_loose_bodice(table, figure, bodice)
    collar.lay(table, figure)
    if sleeve is not None:
        plain = Sleeve(sleeve, options.arm_ease, options.sleeve_end, 0.01, extension)
        if isinstance(options, ShirtOptions):
            lay_shaped_sleeve(table, figure, options.sleeve_shape, plain, options.armhole)
        else:
            lay_shaped_sleeve(table, figure, "plain", plain)


def _finished(
    table: CuttingTable, collar: NeckCollar | LapelCollar, opening: float = 0.0, crossing: float = 0.0
) -> Pattern:
    table.mirror()
    overlap_fronts(table, opening, crossing)
    sew_centres(table)
    collar.sew(table)
    return table.finish()


@dataclass(frozen=True)
class BlazerOptions:
    """Options of the blazer."""

    length: declared.TopLength = 24.0
    chest_ease: declared.ChestEase = 9.0
    waist_shaping: declared.WaistShaping = 2.5
    flare: declared.HemFlare = 0.0
    neck_widening: declared.CloseNeckWidening = 0.0
    neck_depth: declared.LapelDepth = 28.0
    lapels: Annotated[Literal["notched", "shawl"], Option("Shape of the collar in front.")] = "notched"
    collar_width: declared.LapelCollarWidth = 5.0
    lapel_width: declared.LapelWidth = 7.5
    opening: declared.OverlapOrOpening = 1.0
    closed_to: declared.ClosedTo = 0.0
    armhole_drop: declared.ArmholeDrop = 3.0
    sleeve_length: declared.SleeveLength = 59.0
    arm_ease: declared.ArmEase = 8.0
    sleeve_end: declared.SleeveEnd = 27.0
    sleeve_shape: SleeveShapeOption = "plain"
    shoulder_extension: declared.ShoulderExtension = 0.0
    collar: JacketCollar = "lapels"
    collar_height: CollarHeight = 5.0


def draft_blazer(options: BlazerOptions, measurements: Measurements) -> Pattern:
    """Drafts the blazer for a body: closed for a little below the lapels, as by a button, and open below."""
    return _with_lapels("blazer", options, measurements, _collar_instead(options.collar, options))


@dataclass(frozen=True)
class CoatOptions(BlazerOptions):
    """Options of the coat."""

    length: declared.LongLength = 56.0
    chest_ease: declared.ChestEase = 14.0
    waist_shaping: declared.WaistShaping = 0.0
    flare: declared.DressFlare = 10.0
    neck_depth: declared.LapelDepth = 24.0
    opening: declared.OverlapOrOpening = 0.0
    closed_to: declared.ClosedTo = 30.0
    crossing: declared.Crossing = 0.0
    collar_width: declared.LapelCollarWidth = 6.0
    lapel_width: declared.LapelWidth = 8.5
    armhole_drop: declared.ArmholeDrop = 3.5
    sleeve_length: declared.SleeveLength = 61.0
    arm_ease: declared.ArmEase = 10.0
    sleeve_end: declared.SleeveEnd = 31.0
    standing: Annotated[bool, Option("Sew a collar that stands to a close neck instead of lapels.")] = False
    armhole: ArmholeCutOption = "set-in"
    wing: WingOption = 8.0


def draft_coat(options: CoatOptions, measurements: Measurements) -> Pattern:
    """Drafts the coat for a body: a longer, wider blazer."""
    collar = _collar_instead("standing" if options.standing else options.collar, options)
    return _with_lapels("coat", options, measurements, collar, options.armhole, options.wing)


def _collar_instead(shape: CoatCollar, options: BlazerOptions) -> NeckCollar | None:
    """The collar that a jacket or coat has instead of lapels; None for lapels."""
    return None if shape == "lapels" else NeckCollar(shape, options.collar_width, options.collar_height)


def _with_lapels(
    name: str,
    options: BlazerOptions,
    measurements: Measurements,
    collar: NeckCollar | None = None,
    armhole: ArmholeCut = "set-in",
    wing: float = 8.0,
) -> Pattern:
    """Lays and sews a blazer or coat with lapels, or with another collar."""
    figure = Figure.of(measurements)
    table = CuttingTable(name)
    neckline = Neckline("v", options.neck_widening, options.neck_depth, 1.5)
    extension = options.shoulder_extension
    bare = collar is not None and collar.shape == "none"
    bodice = LooseBodice(
        neckline if collar is None else _ROUND_NECK if bare else collar.neckline(neckline),
        options.chest_ease,
        options.length,
        options.armhole_drop,
        hip_ease=7.0,
        flare=options.flare,
        shoulder_extension=extension,
        waist_shaping=options.waist_shaping,
        front_opening=options.opening,
        front_closed_to=options.closed_to,
        darted=True,
    )
    lay_loose_bodice(table, figure, bodice)
    sewn = collar or LapelCollar(options.collar_width, options.lapels, options.lapel_width)
    sewn.lay(table, figure)
    sleeve = Sleeve(options.sleeve_length, options.arm_ease, options.sleeve_end, 0.02, extension)
    lay_shaped_sleeve(table, figure, options.sleeve_shape, sleeve, armhole, wing)
    crossing = options.crossing if isinstance(options, CoatOptions) else 0.0
    return _finished(table, sewn, options.opening, crossing)

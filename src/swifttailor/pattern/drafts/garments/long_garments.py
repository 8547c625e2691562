"""Garments that hang from the shoulders: robe, hooded coat, kaftan, poncho, swing and shift dress."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.armholes import RACER_STRAP_CM
from swifttailor.pattern.drafts.band import lay_sleeve_cuff
from swifttailor.pattern.drafts.bodice import (
    LooseBodice,
    follows_body,
    lay_loose_bodice,
    sew_centres,
)
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.hood import Hood, lay_hood, sew_hood
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neck_collar import NO_COLLAR, CollarHeight, CollarOption, NeckCollar
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.overlapped_fronts import overlap_fronts
from swifttailor.pattern.drafts.shaped_sleeve import (
    ArmholeCutOption,
    RaglanOption,
    SleeveShape,
    SleeveShapeOption,
    TrailingOption,
    WingOption,
    lay_shaped_sleeve,
)
from swifttailor.pattern.drafts.sleeve import Sleeve
from swifttailor.pattern.pattern import Pattern

LongNeckDepth = Annotated[
    float, Option("Fall of the front neckline below the neck-shoulder point.", "cm", 8.0, 38.0)
]
DeepArmhole = Annotated[float, Option("How far the underarm lies below the armpit.", "cm", 2.0, 18.0)]
WideArmEase = Annotated[float, Option("Room on top of the upper arm girth, all around.", "cm", 6.0, 50.0)]
WideSleeveEnd = Annotated[
    float, Option("Width around at the sleeve's end; at most that at the underarm.", "cm", 24.0, 80.0)
]

_INSET_CM = 1.5
"""How far the armholes of a sleeveless hooded coat lie inside the shoulder tips."""
_UNDER_PONCHO = 18.0
"""How far the underarm of a poncho lies below the armpit, cm."""


@dataclass(frozen=True)
class RobeOptions:
    """Options of the robe."""

    length: declared.LongLength = 72.0
    chest_ease: declared.ChestEase = 22.0
    flare: declared.HemFlare = 12.0
    neck_widening: declared.NeckWidening = 1.5
    neck_depth: LongNeckDepth = 34.0
    armhole_drop: DeepArmhole = 10.0
    shoulder_extension: declared.ShoulderExtension = 3.0
    front_slit: Annotated[
        float, Option("Length of the front that is open from the hem up.", "cm", 0.0, 70.0)
    ] = 52.0
    opening: declared.OverlapOrOpening = -18.0
    crossing: declared.Crossing = 0.0
    sleeve_length: declared.SleeveLength = 54.0
    arm_ease: WideArmEase = 30.0
    sleeve_end: WideSleeveEnd = 54.0
    sleeve_shape: TrailingOption = "plain"


def draft_robe(options: RobeOptions, measurements: Measurements) -> Pattern:
    """Drafts the robe for a body: closed from the waist to the slit, where a belt would hold it."""
    figure = Figure.of(measurements)
    table = CuttingTable("robe")
    bodice = LooseBodice(
        Neckline("v", options.neck_widening, options.neck_depth, 2.0),
        options.chest_ease,
        options.length,
        options.armhole_drop,
        hip_ease=16.0,
        flare=options.flare,
        shoulder_extension=options.shoulder_extension,
        front_slit=options.front_slit,
        front_opening=options.opening if options.front_slit else 0.0,
    )
    sleeve = Sleeve(options.sleeve_length, options.arm_ease, options.sleeve_end, 0.01)
    return _with_sleeves(table, figure, bodice, sleeve, options.sleeve_shape, crossing=options.crossing)


@dataclass(frozen=True)
class HoodedCoatOptions:
    """Options of the hooded coat."""

    length: declared.LongLength = 48.0
    chest_ease: declared.ChestEase = 20.0
    flare: declared.HemFlare = 8.0
    neck_widening: declared.HighNeckWidening = 2.5
    neck_depth: declared.HighNeckDepth = 10.0
    hood_height: declared.HoodHeight = 6.0
    hood_depth: declared.HoodDepth = 5.0
    opening: declared.OverlapOrOpening = 1.0
    closed_to: declared.ClosedTo = 26.0
    armhole_drop: declared.ArmholeDrop = 4.5
    shoulder_extension: declared.ShoulderExtension = 2.0
    sleeves: declared.Sleeves = True
    sleeve_length: declared.SleeveLength = 60.0
    arm_ease: declared.ArmEase = 13.0
    sleeve_end: declared.SleeveEnd = 32.0
    armhole: RaglanOption = "set-in"
    side_slits: declared.SideSlits = 0.0
    sleeve_shape: TrailingOption = "plain"


def draft_hooded_coat(options: HoodedCoatOptions, measurements: Measurements) -> Pattern:
    """Drafts the hooded coat for a body: closed below the neck, as by a toggle, and open below."""
    figure, table = Figure.of(measurements), CuttingTable("hooded-coat")
    bodice = LooseBodice(
        Neckline("round", options.neck_widening, options.neck_depth, 2.0),
        options.chest_ease,
        options.length,
        options.armhole_drop,
        hip_ease=10.0,
        flare=options.flare,
        shoulder_extension=options.shoulder_extension if options.sleeves else -_INSET_CM,
        front_opening=options.opening,
        front_closed_to=options.closed_to,
        side_slits=options.side_slits,
    )
    lay_loose_bodice(table, figure, bodice)
    lay_hood(table, figure, Hood(options.hood_height, options.hood_depth))
    if options.sleeves:
        shape = (options.arm_ease, options.sleeve_end, 0.01, options.shoulder_extension)
        sleeve = Sleeve(options.sleeve_length, *shape)
        lay_shaped_sleeve(table, figure, options.sleeve_shape, sleeve, options.armhole)
    table.mirror()
    overlap_fronts(table, options.opening)
    sew_centres(table)
    sew_hood(table)
    return table.finish()


@dataclass(frozen=True)
class KaftanOptions:
    """Options of the kaftan."""

    length: declared.LongLength = 92.0
    chest_ease: Annotated[float, Option("Room on top of the bust girth, all around.", "cm", 16.0, 60.0)] = (
        36.0
    )
    flare: declared.HemFlare = 40.0
    neckline: declared.NeckShapeOption = "v"
    neck_widening: declared.NeckWidening = 1.0
    neck_depth: LongNeckDepth = 22.0
    armhole_drop: DeepArmhole = 15.0
    shoulder_extension: Annotated[
        float, Option("How far the shoulder seam reaches over the shoulder tip.", "cm", 0.0, 8.0)
    ] = 6.0
    sleeve_length: declared.SleeveLength = 48.0
    arm_ease: WideArmEase = 46.0
    sleeve_end: WideSleeveEnd = 70.0
    side_slits: declared.SideSlits = 0.0


def draft_kaftan(options: KaftanOptions, measurements: Measurements) -> Pattern:
    """Drafts the kaftan for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("kaftan")
    bodice = LooseBodice(
        Neckline(options.neckline, options.neck_widening, options.neck_depth, 2.0),
        options.chest_ease,
        options.length,
        options.armhole_drop,
        hip_ease=20.0,
        flare=options.flare,
        shoulder_extension=options.shoulder_extension,
        side_slits=options.side_slits,
    )
    sleeve = Sleeve(options.sleeve_length, options.arm_ease, options.sleeve_end, 0.01)
    return _with_sleeves(table, figure, bodice, sleeve)


@dataclass(frozen=True)
class PonchoOptions:
    """Options of the poncho."""

    length: declared.TopLength = 20.0
    chest_ease: Annotated[float, Option("Room on top of the bust girth, all around.", "cm", 16.0, 60.0)] = (
        40.0
    )
    flare: declared.HemFlare = 30.0
    neckline: declared.NeckShapeOption = "round"
    neck_widening: declared.NeckWidening = 2.0
    neck_depth: LongNeckDepth = 10.0
    sleeve_length: declared.SleeveLength = 42.0
    hood: Annotated[bool, Option("Sew a hood to a close neck.")] = False


def draft_poncho(options: PonchoOptions, measurements: Measurements) -> Pattern:
    """Drafts the poncho for a body: body and arms under one width of cloth, which hangs from them."""
    collar = NeckCollar("hood" if options.hood else "none", 0.0, 0.0)
    bodice = LooseBodice(
        collar.neckline(Neckline(options.neckline, options.neck_widening, options.neck_depth, 2.0)),
        options.chest_ease,
        options.length,
        _UNDER_PONCHO,
        hip_ease=16.0,
        flare=options.flare,
        shoulder_extension=6.0,
    )
    figure, table = Figure.of(measurements), CuttingTable("poncho")
    sleeve = Sleeve(options.sleeve_length, 50.0, 78.0, 0.01)
    return _with_sleeves(table, figure, bodice, sleeve, collar=collar)


@dataclass(frozen=True)
class SwingDressOptions:
    """Options of the swing dress."""

    length: declared.LongLength = 46.0
    chest_ease: declared.BustEase = 7.0
    flare: Annotated[float, Option("Extra width of the hem, all around.", "cm", 20.0, 130.0)] = 90.0
    neckline: declared.NeckShapeOption = "round"
    neck_widening: declared.NeckWidening = 1.5
    neck_depth: declared.NeckDepth = 11.5
    back_neck_depth: declared.BackNeckDepth = 4.0
    armhole_drop: declared.ArmholeDrop = 2.0
    sleeves: declared.Sleeves = False
    sleeve_length: declared.SleeveLength = 24.0
    arm_ease: declared.ArmEase = 6.0
    sleeve_end: declared.SleeveEnd = 33.0
    sleeve_shape: SleeveShapeOption = "plain"
    collar: CollarOption = "none"
    collar_width: declared.CollarWidth = 5.5
    collar_height: CollarHeight = 4.0


def draft_swing_dress(options: SwingDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the swing dress for a body: close at the bust, and ever wider from there to the hem."""
    return _from_the_shoulders("swing-dress", options, measurements)


@dataclass(frozen=True)
class ShiftDressOptions:
    """Options of the shift dress."""

    length: declared.LongLength = 44.0
    chest_ease: declared.ChestEase = 8.0
    flare: declared.HemFlare = 4.0
    neckline: declared.NeckShapeOption = "round"
    neck_widening: declared.NeckWidening = 1.0
    neck_depth: declared.NeckDepth = 11.0
    back_neck_depth: declared.BareBackDepth = 3.0
    armhole_drop: declared.ArmholeDrop = 2.0
    shoulder_extension: declared.ShoulderExtension = 0.0
    sleeves: declared.Sleeves = False
    sleeve_length: declared.SleeveLength = 24.0
    arm_ease: declared.ArmEase = 7.0
    sleeve_end: declared.SleeveEnd = 33.0
    sleeve_shape: SleeveShapeOption = "plain"
    armhole: ArmholeCutOption = "set-in"
    wing: WingOption = 8.0
    side_slits: declared.SideSlits = 0.0
    back_slit: declared.BackSlit = 0.0
    hem_rise: declared.HemRise = 0.0
    cuffs: Annotated[bool, Option("Sew cuffs to plain sleeves.")] = False
    cuff_height: declared.SleeveCuffHeight = 6.0
    cuff_ease: declared.CuffWidth = 5.0
    collar: CollarOption = "none"
    collar_width: declared.CollarWidth = 5.5
    collar_height: CollarHeight = 4.0
    waist_shaping: declared.WaistShaping = 0.0
    stretch: declared.ClothStretch = 0.0
    racer: Annotated[
        bool, Option("Cut the back in between the shoulder blades, where there are no sleeves and no collar.")
    ] = False


def draft_shift_dress(options: ShiftDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the shift dress for a body: straight, without a waist."""
    return _from_the_shoulders("shift-dress", options, measurements)


def _from_the_shoulders(
    name: str, options: SwingDressOptions | ShiftDressOptions, measurements: Measurements
) -> Pattern:
    shift = options if isinstance(options, ShiftDressOptions) else None
    stretch, shaping = (shift.stretch, shift.waist_shaping) if shift else (0.0, 0.0)
    cut, wing = (shift.armhole, shift.wing) if shift else ("set-in", 0.0)
    figure = Figure.of(measurements).for_cloth(stretch / 100)
    table = CuttingTable(name, stretch / 100)
    asked = Neckline(options.neckline, options.neck_widening, options.neck_depth, options.back_neck_depth)
    collar = NeckCollar(options.collar, options.collar_width, options.collar_height)
    extension = shift.shoulder_extension if shift else 0.0
    racer = shift is not None and shift.racer and not options.sleeves and options.collar == "none"
    bared = asked.start_x(figure) + RACER_STRAP_CM - figure.shoulder_x if racer else -1.5
    bodice = LooseBodice(
        collar.neckline(asked),
        options.chest_ease,
        options.length,
        options.armhole_drop,
        flare=options.flare,
        shoulder_extension=extension if options.sleeves else min(bared, 0.0),
        racer=racer,
        side_slits=shift.side_slits if shift else 0.0,
        back_slit=shift.back_slit if shift else 0.0,
        side_rise=shift.hem_rise if shift else 0.0,
        waist_shaping=shaping,
        follows=follows_body(stretch, shaping, cut),
    )
    lay_loose_bodice(table, figure, bodice)
    collar.lay(table, figure)
    if options.sleeves:
        cuffed = shift is not None and shift.cuffs and options.sleeve_shape == "plain" and cut != "cut-in-one"
        cuff = min(shift.cuff_height, options.sleeve_length - 9.0) if shift and cuffed else 0.0
        long = options.sleeve_length - cuff
        sleeve = Sleeve(long, options.arm_ease, options.sleeve_end, 0.01, extension)
        lay_shaped_sleeve(table, figure, options.sleeve_shape, sleeve, cut, wing)
        if shift and cuffed:
            lay_sleeve_cuff(table, figure, long, shift.cuff_ease, cuff)
    table.mirror()
    sew_centres(table)
    collar.sew(table)
    return table.finish()


def _with_sleeves(
    table: CuttingTable,
    figure: Figure,
    bodice: LooseBodice,
    sleeve: Sleeve,
    shape: SleeveShape = "plain",
    collar: NeckCollar = NO_COLLAR,
    crossing: float = 0.0,
) -> Pattern:
    """Lays a loose bodice with sleeves and perhaps a collar, and sews everything."""
    lay_loose_bodice(table, figure, bodice)
    collar.lay(table, figure)
    sleeve = replace(sleeve, shoulder_extension=max(bodice.shoulder_extension, 0.0))
    lay_shaped_sleeve(table, figure, shape, sleeve)
    table.mirror()
    overlap_fronts(table, bodice.front_opening, crossing)
    sew_centres(table)
    collar.sew(table)
    return table.finish()

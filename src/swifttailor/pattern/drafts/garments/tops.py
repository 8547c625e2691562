"""Tops with a loose torso: t-shirt, tank top, turtleneck, waistcoat, hoodie."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_sleeve_cuff
from swifttailor.pattern.drafts.bodice import (
    LooseBodice,
    follows_body,
    lay_loose_bodice,
    sew_centres,
)
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.garments.banded import sew_hem_band
from swifttailor.pattern.drafts.hem_room import JERSEY, JERSEY_HIP_EASE
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neck_collar import NeckCollar
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.overlapped_fronts import overlap_fronts
from swifttailor.pattern.drafts.shaped_sleeve import (
    ArmholeCutOption,
    SleeveShapeOption,
    WingOption,
    lay_shaped_sleeve,
)
from swifttailor.pattern.drafts.sleeve import Sleeve
from swifttailor.pattern.pattern import Pattern

_WAISTCOAT_OPENING_CM = 1.8
"""How far the front edges of a waistcoat have moved back from the middle at the hem."""
_WAISTCOAT_HIP_CM = 1.0
"""Its least room at the hem: with more, its points stand off in front."""
_WAISTCOAT_NAPE_CM = 4.5
"""Fall of its back neckline: cut closer, it stands up behind the neck, with no collar to hold it."""
_RIB_CM, _SHORT_RIB_CM, _RIB_EASE_CM = 6.0, 4.0, 4.0
"""Height of the ribbed hem of a cardigan, at most where it ends at the waist, and its room there, cm."""
_CUFF_CM, _CUFF_EASE_CM = 6.0, 5.0
"""Height of its cuffs, and their room, cm."""
_KNITTED_NAPE_CM, _ROUND_CM = 2.5, 14.0
"""Fall of its back neckline, and most of a round one in front."""
_INSET_CM = 1.5
"""How far the armholes of a sleeveless turtleneck or waistcoat lie inside the shoulder tips."""


@dataclass(frozen=True)
class TShirtOptions:
    """Options of the t-shirt."""

    length: declared.TopLength = 22.0
    chest_ease: declared.ChestEase = 10.0
    flare: declared.HemFlare = 0.0
    neckline: declared.NeckShapeOption = "round"
    neck_widening: declared.NeckWidening = -0.8
    neck_depth: declared.NeckDepth = 9.8
    back_neck_depth: declared.BareBackDepth = 2.5
    armhole_drop: declared.ArmholeDrop = 2.5
    shoulder_extension: declared.ShoulderExtension = 0.0
    sleeve_length: declared.SleeveLength = 22.0
    arm_ease: declared.ArmEase = 7.0
    sleeve_end: declared.SleeveEnd = 34.0
    cap_ease: declared.CapEase = 1.0
    sleeve_shape: SleeveShapeOption = "plain"
    armhole: ArmholeCutOption = "set-in"
    wing: WingOption = 8.0
    side_slits: declared.SideSlits = 0.0
    hem_rise: declared.HemRise = 0.0
    hem_dip: declared.TopHemDip = 0.0
    waist_shaping: declared.WaistShaping = 0.0
    stretch: declared.ClothStretch = 0.0


def draft_t_shirt(options: TShirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the t-shirt for a body."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("t-shirt", options.stretch / 100)
    neckline = Neckline(options.neckline, options.neck_widening, options.neck_depth, options.back_neck_depth)
    bodice = LooseBodice(
        neckline,
        options.chest_ease,
        options.length,
        options.armhole_drop,
        flare=options.flare,
        shoulder_extension=options.shoulder_extension,
        side_slits=options.side_slits,
        side_rise=options.hem_rise,
        back_dip=options.hem_dip,
        hip_ease=JERSEY_HIP_EASE,
        hem_room=JERSEY,
        waist_shaping=options.waist_shaping,
        follows=follows_body(options.stretch, options.waist_shaping, options.armhole),
    )
    lay_loose_bodice(table, figure, bodice)
    sleeve = Sleeve(
        options.sleeve_length,
        options.arm_ease,
        options.sleeve_end,
        options.cap_ease / 100,
        options.shoulder_extension,
    )
    lay_shaped_sleeve(table, figure, options.sleeve_shape, sleeve, options.armhole, options.wing)
    table.mirror()
    sew_centres(table)
    return table.finish()


@dataclass(frozen=True)
class TankTopOptions:
    """Options of the tank top."""

    length: declared.TopLength = 20.0
    chest_ease: declared.ChestEase = 5.0
    flare: declared.HemFlare = 0.0
    neckline: declared.NeckShapeOption = "round"
    neck_widening: declared.NeckWidening = 2.5
    neck_depth: declared.NeckDepth = 15.0
    back_neck_depth: declared.BackNeckDepth = 7.0
    strap_width: Annotated[float, Option("Width of the straps on the shoulder.", "cm", 3.0, 12.0)] = 4.0
    armhole_drop: declared.ArmholeDrop = 2.0
    racer: Annotated[bool, Option("Cut the back in between the shoulder blades.")] = False
    hem_rise: declared.HemRise = 0.0
    hem_dip: declared.TopHemDip = 0.0
    waist_shaping: declared.WaistShaping = 0.0
    stretch: declared.ClothStretch = 0.0
    side_slits: declared.SideSlits = 0.0


def draft_tank_top(options: TankTopOptions, measurements: Measurements) -> Pattern:
    """Drafts the tank top for a body."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("tank-top", options.stretch / 100)
    neckline = Neckline(options.neckline, options.neck_widening, options.neck_depth, options.back_neck_depth)
    strap_end = neckline.start_x(figure) + options.strap_width
    bodice = LooseBodice(
        neckline,
        options.chest_ease,
        options.length,
        options.armhole_drop,
        flare=options.flare,
        hip_ease=JERSEY_HIP_EASE,
        shoulder_extension=min(strap_end - figure.shoulder_x, 0.0),
        racer=options.racer,
        side_rise=options.hem_rise,
        back_dip=options.hem_dip,
        side_slits=options.side_slits,
        hem_room=JERSEY,
        waist_shaping=options.waist_shaping,
        follows=follows_body(options.stretch, options.waist_shaping),
    )
    lay_loose_bodice(table, figure, bodice)
    table.mirror()
    sew_centres(table)
    return table.finish()


@dataclass(frozen=True)
class TurtleneckOptions:
    """Options of the turtleneck."""

    length: declared.TopLength = 22.0
    chest_ease: declared.ChestEase = 8.0
    flare: declared.HemFlare = 0.0
    neck_widening: Annotated[
        float, Option("Distance of the collar from the neck, along the shoulder.", "cm", 0.0, 3.0)
    ] = 0.2
    neck_depth: Annotated[
        float, Option("Fall of the front neckline below the neck-shoulder point.", "cm", 5.0, 10.0)
    ] = 6.5
    collar_height: Annotated[float, Option("Height of the collar.", "cm", 2.0, 14.0)] = 8.0
    rolled: Annotated[bool, Option("Turn the collar down over itself.")] = True
    split: Annotated[
        bool, Option("Leave a collar that is not turned down open in front, with round corners.")
    ] = False
    armhole_drop: declared.ArmholeDrop = 2.5
    sleeves: declared.Sleeves = True
    sleeve_length: declared.SleeveLength = 58.5
    arm_ease: declared.ArmEase = 6.0
    sleeve_end: declared.SleeveEnd = 22.0
    sleeve_shape: SleeveShapeOption = "plain"
    armhole: ArmholeCutOption = "set-in"
    wing: WingOption = 8.0
    side_slits: declared.SideSlits = 0.0
    hem_dip: declared.TopHemDip = 0.0
    waist_shaping: declared.WaistShaping = 0.0
    opening: declared.OverlapOrOpening = 0.0
    closed_to: declared.ClosedTo = 0.0
    stretch: declared.ClothStretch = 0.0


def draft_turtleneck(options: TurtleneckOptions, measurements: Measurements) -> Pattern:
    """Drafts the turtleneck for a body."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("turtleneck", options.stretch / 100)
    bodice = LooseBodice(
        Neckline("round", options.neck_widening, options.neck_depth, 1.5),
        options.chest_ease,
        options.length,
        options.armhole_drop,
        flare=options.flare,
        shoulder_extension=0.0 if options.sleeves else -_INSET_CM,
        side_slits=options.side_slits,
        back_dip=options.hem_dip,
        hip_ease=JERSEY_HIP_EASE,
        hem_room=JERSEY,
        waist_shaping=options.waist_shaping,
        follows=follows_body(options.stretch, options.waist_shaping, options.armhole),
        front_opening=options.opening,
        front_closed_to=options.closed_to,
        darted=options.stretch == 0.0 and options.armhole != "cut-in-one",
    )
    lay_loose_bodice(table, figure, bodice)
    rolled = options.rolled and not options.opening
    standing = "mandarin" if options.split and not options.rolled else "standing"
    collar = NeckCollar("rolled" if rolled else standing, 0.0, options.collar_height)
    collar.lay(table, figure)
    if options.sleeves:
        sleeve = Sleeve(options.sleeve_length, options.arm_ease, options.sleeve_end, 0.01)
        lay_shaped_sleeve(table, figure, options.sleeve_shape, sleeve, options.armhole, options.wing)
    table.mirror()
    overlap_fronts(table, options.opening)
    sew_centres(table)
    collar.sew(table)
    return table.finish()


@dataclass(frozen=True)
class CardiganOptions:
    """Options of the cardigan."""

    length: Annotated[float, Option("Hem below the waist; negative ends above it.", "cm", -6.0, 80.0)] = 24.0
    chest_ease: declared.ChestEase = 12.0
    flare: declared.HemFlare = 0.0
    neck_widening: declared.CloseNeckWidening = 0.3
    neckline: Annotated[Literal["round", "v"], Option("Shape of the front neckline.")] = "v"
    neck_depth: Annotated[
        float, Option("Fall of the front neckline below the neck-shoulder point.", "cm", 9.0, 34.0)
    ] = 26.0
    opening: declared.OverlapOrOpening = 1.0
    closed_to: declared.ClosedTo = 8.0
    armhole_drop: declared.ArmholeDrop = 2.5
    shoulder_extension: declared.ShoulderExtension = 0.0
    sleeve_length: declared.SleeveLength = 58.5
    arm_ease: declared.ArmEase = 8.0
    sleeve_end: declared.SleeveEnd = 25.0
    sleeve_shape: SleeveShapeOption = "plain"
    armhole: ArmholeCutOption = "set-in"
    wing: WingOption = 8.0
    waist_shaping: declared.WaistShaping = 0.0
    ribbed: Annotated[
        bool, Option("Sew ribbed bands to hem and plain sleeves, where the fronts do not open.")
    ] = False


def draft_cardigan(options: CardiganOptions, measurements: Measurements) -> Pattern:
    """Drafts the cardigan for a body: sewn from its V to the last button; its fronts overlap below."""
    figure = Figure.of(measurements)
    table = CuttingTable("cardigan")
    ribbed = options.ribbed and options.opening == 0.0
    band = min(_RIB_CM, max(options.length - 2.0, _SHORT_RIB_CM)) if ribbed else 0.0
    bodice = LooseBodice(
        Neckline(
            options.neckline,
            options.neck_widening,
            min(options.neck_depth, _ROUND_CM) if options.neckline == "round" else options.neck_depth,
            _KNITTED_NAPE_CM if ribbed else 1.5,
        ),
        options.chest_ease,
        options.length - band,
        options.armhole_drop,
        hip_ease=_RIB_EASE_CM + 2.0 if ribbed else 4.0,
        flare=options.flare,
        shoulder_extension=options.shoulder_extension,
        front_opening=options.opening,
        front_closed_to=options.closed_to,
        waist_shaping=options.waist_shaping,
        darted=options.armhole != "cut-in-one" and not ribbed,
    )
    lay_loose_bodice(table, figure, bodice)
    cuff = min(_CUFF_CM, options.sleeve_length - 10.0)
    cuff = cuff if ribbed and options.sleeve_shape == "plain" and options.armhole != "cut-in-one" else 0.0
    length = options.sleeve_length - cuff
    sleeve = Sleeve(length, options.arm_ease, options.sleeve_end, 0.01, options.shoulder_extension)
    lay_shaped_sleeve(table, figure, options.sleeve_shape, sleeve, options.armhole, options.wing)
    if cuff:
        lay_sleeve_cuff(table, figure, length, _CUFF_EASE_CM, cuff)
    table.mirror()
    overlap_fronts(table, options.opening)
    sew_centres(table)
    if ribbed:
        sew_hem_band(table, figure, options.length, _RIB_EASE_CM, band)
    return table.finish()


@dataclass(frozen=True)
class WaistcoatOptions:
    """Options of the waistcoat."""

    length: declared.TopLength = 10.0
    chest_ease: declared.BustEase = 2.0
    waist_shaping: declared.WaistShaping = 3.5
    point: Annotated[float, Option("Fall of the front hem to its points.", "cm", 0.0, 12.0)] = 6.0
    neck_widening: declared.NeckWidening = 1.5
    neck_depth: Annotated[
        float, Option("Fall of the front neckline below the neck-shoulder point.", "cm", 10.0, 30.0)
    ] = 26.0
    armhole_drop: declared.ArmholeDrop = 3.0
    hem_opening: declared.HemOpening = 4.0


def draft_waistcoat(options: WaistcoatOptions, measurements: Measurements) -> Pattern:
    """Drafts the waistcoat for a body: buttoned, so sewn from the V to the last button, and open below it."""
    figure = Figure.of(measurements)
    table = CuttingTable("waistcoat")
    bodice = LooseBodice(
        Neckline("v", options.neck_widening, options.neck_depth, _WAISTCOAT_NAPE_CM),
        options.chest_ease,
        options.length,
        options.armhole_drop,
        shoulder_extension=-_INSET_CM,
        hip_ease=_WAISTCOAT_HIP_CM,
        waist_shaping=options.waist_shaping,
        front_point=options.point,
        front_slit=options.hem_opening,
        front_opening=_WAISTCOAT_OPENING_CM if options.hem_opening else 0.0,
        darted=True,
    )
    lay_loose_bodice(table, figure, bodice)
    table.mirror()
    sew_centres(table)
    return table.finish()

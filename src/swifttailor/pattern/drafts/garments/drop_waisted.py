"""Dresses that fall straight to the hips, where a skirt is sewn on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.bodice import LooseBodice, lay_loose_bodice, sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.flared_skirt import lay_bubble_skirt, lay_gathered_skirt
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neck_collar import CollarHeight, CollarOption, NeckCollar
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.pleated_skirt import LEAST_PLEATS, sew_pleats_to_bodice
from swifttailor.pattern.drafts.round_skirt import lay_pleats_from_hips
from swifttailor.pattern.drafts.shaped_sleeve import SleeveShapeOption, lay_shaped_sleeve
from swifttailor.pattern.drafts.sleeve import Sleeve
from swifttailor.pattern.pattern import Pattern

_SHORTEST_CM = 10.0
"""Of the skirt, seam to hem."""
_INSET_CM = 1.5
"""How far armholes without sleeves lie inside the shoulder tips."""
_BELOW_SEAM_CM = 3.0


@dataclass(frozen=True)
class DropWaistDressOptions:
    """Options of the drop-waist dress."""

    seam: Annotated[float, Option("Seam of the skirt below the waist.", "cm", 10.0, 24.0)] = 17.0
    skirt_length: Annotated[float, Option("Body's waist to the hem.", "cm", 30.0, 100.0)] = 54.0
    chest_ease: declared.ChestEase = 9.0
    hip_ease: Annotated[float, Option("Room at the seam over the body there.", "cm", 3.0, 16.0)] = 6.0
    fullness: Annotated[
        float, Option("Width of the skirt over that of the seam it is gathered into.", "times", 1.0, 1.6)
    ] = 1.35
    skirt_flare: Annotated[float, Option("Extra width of the hem, all around.", "cm", 0.0, 80.0)] = 20.0
    hem_band: declared.HemBand = 0.0
    pleats: declared.SkirtPleats = 0
    neckline: declared.NeckShapeOption = "round"
    neck_widening: declared.NeckWidening = 1.5
    neck_depth: declared.NeckDepth = 11.5
    back_neck_depth: declared.BackNeckDepth = 3.0
    armhole_drop: declared.ArmholeDrop = 2.0
    sleeves: declared.Sleeves = False
    sleeve_length: declared.SleeveLength = 24.0
    arm_ease: declared.ArmEase = 7.0
    sleeve_end: declared.SleeveEnd = 33.0
    sleeve_shape: SleeveShapeOption = "plain"
    collar: CollarOption = "none"
    collar_width: declared.CollarWidth = 5.5
    collar_height: CollarHeight = 4.0


def draft_drop_waist_dress(options: DropWaistDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the drop-waist dress for a body: straight to the hips, a skirt gathered into the seam there."""
    figure = Figure.of(measurements)
    table = CuttingTable("drop-waist-dress")
    collar = NeckCollar(options.collar, options.collar_width, options.collar_height)
    asked = Neckline(options.neckline, options.neck_widening, options.neck_depth, options.back_neck_depth)
    seam = min(options.seam, options.skirt_length - _SHORTEST_CM)
    bodice = LooseBodice(
        collar.neckline(asked),
        options.chest_ease,
        seam,
        options.armhole_drop,
        hip_ease=options.hip_ease,
        shoulder_extension=0.0 if options.sleeves else -_INSET_CM,
    )
    lay_loose_bodice(table, figure, bodice)
    if options.sleeves:
        sleeve = Sleeve(options.sleeve_length, options.arm_ease, options.sleeve_end, 0.01)
        lay_shaped_sleeve(table, figure, options.sleeve_shape, sleeve)
    collar.lay(table, figure)
    table.mirror()
    sew_centres(table)
    collar.sew(table)
    hem = Halves(*[table.length(f"left_{part}torso.hem") for part in "fb"])
    top_y = figure.waist_y - seam - _BELOW_SEAM_CM
    length = options.skirt_length - seam
    if options.pleats >= LEAST_PLEATS:
        lay_pleats_from_hips(table, figure, hem, options.pleats, length, top_y)
        sew_pleats_to_bodice(table, options.pleats, "hem")
        return table.finish()
    if options.hem_band:
        lay_bubble_skirt(table, figure, hem, length, top_y, options.fullness, options.hem_band)
    else:
        lay_gathered_skirt(table, hem, length, top_y, options.fullness, options.skirt_flare)
    gathered = options.fullness > 1.0
    for part, halves in (("front", ("left", "right")), ("back", ("right", "left"))):
        table.label(f"skirt_{part}.waist", "lower_interface")
        table.seam(
            [f"skirt_{part}.waist"], [f"{half}_{part[0]}torso.hem" for half in halves], gathered=gathered
        )
    return table.finish()

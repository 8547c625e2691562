"""A jumpsuit whose fronts seem to cross above the waist: the bodice of a wrap dress on trousers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.crossed_fronts import UPPER, cross_fronts, shorten_darts
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fitted_bodice import FittedBodice, lay_fitted_bodice
from swifttailor.pattern.drafts.garments.wrap import CrossDepth
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.shaped_sleeve import SleeveShapeOption, lay_shaped_sleeve
from swifttailor.pattern.drafts.sleeve import Sleeve
from swifttailor.pattern.drafts.trousers import lay_trousers, legs_of_bodice, sew_legs
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class WrapJumpsuitOptions:
    """Options of the wrap jumpsuit."""

    bust_ease: declared.BustEase = 5.0
    waist_ease: declared.WaistEase = 4.0
    neck_widening: declared.NeckWidening = 0.6
    neck_depth: CrossDepth = 23.0
    back_neck_depth: declared.BackNeckDepth = 2.5
    armhole_drop: declared.ArmholeDrop = 2.5
    sleeves: declared.Sleeves = False
    sleeve_length: declared.SleeveLength = 24.0
    arm_ease: declared.ArmEase = 6.0
    sleeve_end: declared.SleeveEnd = 33.0
    sleeve_shape: SleeveShapeOption = "plain"
    hip_ease: declared.HipEase = 6.0
    length: declared.TrouserLength = 102.0
    leg_ease: declared.LegEase = 22.0
    flare: declared.LegFlare = -8.0
    crotch_drop: Annotated[
        float, Option("Crotch below the body's; the room to sit down in.", "cm", 1.5, 8.0)
    ] = 4.0


def draft_wrap_jumpsuit(options: WrapJumpsuitOptions, measurements: Measurements) -> Pattern:
    """Drafts the wrap jumpsuit for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("wrap-jumpsuit")
    bodice = FittedBodice(
        Neckline("v", options.neck_widening, options.neck_depth, options.back_neck_depth),
        options.bust_ease,
        options.waist_ease,
        options.armhole_drop,
        shoulder_extension=0.0 if options.sleeves else -1.5,
    )
    waist = lay_fitted_bodice(table, figure, bodice)
    shorten_darts(table)
    if options.sleeves:
        sleeve = Sleeve(options.sleeve_length, options.arm_ease, options.sleeve_end, 0.015)
        lay_shaped_sleeve(table, figure, options.sleeve_shape, sleeve)
    legs = legs_of_bodice(
        options.length, options.hip_ease, options.leg_ease, options.flare, options.crotch_drop
    )
    lay_trousers(table, figure, legs, waist, figure.waist_y)
    table.mirror()
    table.seam("left_btorso.centre", "right_btorso.centre")
    cross_fronts(table)
    sew_legs(table)
    for part, half in (("f", "r"), ("f", "l"), ("b", "l"), ("b", "r")):
        table.label(f"pant_{part}_{half}.waist", "lower_interface")
    # The whole waist of the front belongs to the one that lies above.
    table.seam(f"{UPPER}.waist", ["pant_f_r.waist", "pant_f_l.waist"])
    for half, side in (("l", "left"), ("r", "right")):
        table.seam(f"{side}_btorso.waist", f"pant_b_{half}.waist")
    return table.finish()

"""Jumpsuit: darted bodice and trousers joined at the waist, with or without sleeves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.bodice import sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fitted_bodice import FittedBodice, lay_fitted_bodice
from swifttailor.pattern.drafts.joins import sew_trousers_to_bodice
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.sleeve import Sleeve, lay_sleeve
from swifttailor.pattern.drafts.trousers import Trousers, lay_trousers, sew_legs
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class JumpsuitOptions:
    """Options of the jumpsuit."""

    bust_ease: declared.BustEase = 7.0
    waist_ease: declared.WaistEase = 6.0
    hip_ease: declared.HipEase = 6.0
    neckline: declared.NeckShapeOption = "v"
    neck_widening: declared.NeckWidening = 2.5
    neck_depth: declared.NeckDepth = 14.0
    back_neck_depth: declared.BackNeckDepth = 4.0
    armhole_drop: declared.ArmholeDrop = 2.5
    sleeves: Annotated[bool, Option("Set in sleeves.")] = False
    sleeve_length: declared.SleeveLength = 24.0
    arm_ease: declared.ArmEase = 6.0
    sleeve_end: declared.SleeveEnd = 33.0
    cap_ease: declared.CapEase = 3.0
    length: declared.TrouserLength = 100.0
    leg_ease: declared.LegEase = 12.0
    flare: declared.LegFlare = 4.0
    crotch_drop: Annotated[
        float, Option("Crotch below the body's; the room to sit down in.", "cm", 1.5, 8.0)
    ] = 3.0


def draft_jumpsuit(options: JumpsuitOptions, measurements: Measurements) -> Pattern:
    """Drafts the jumpsuit for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("jumpsuit")
    neckline = Neckline(options.neckline, options.neck_widening, options.neck_depth, options.back_neck_depth)
    inset = 0.0 if options.sleeves else 1.5
    bodice = FittedBodice(neckline, options.bust_ease, options.waist_ease, options.armhole_drop, -inset)
    waist = lay_fitted_bodice(table, figure, bodice)
    if options.sleeves:
        sleeve = Sleeve(options.sleeve_length, options.arm_ease, options.sleeve_end, options.cap_ease / 100)
        lay_sleeve(table, figure, sleeve)
    legs = Trousers(options.length, options.hip_ease, options.leg_ease, options.flare, options.crotch_drop)
    lay_trousers(table, figure, legs, waist, figure.waist_y)
    table.mirror()
    sew_centres(table)
    sew_legs(table)
    sew_trousers_to_bodice(table)
    return table.finish()

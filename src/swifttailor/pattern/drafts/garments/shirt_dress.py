"""Shirt dress: easy darted bodice, sleeves with cuffs, waist seam, flared skirt."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_sleeve_cuff
from swifttailor.pattern.drafts.bodice import sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fitted_bodice import FittedBodice, lay_fitted_bodice
from swifttailor.pattern.drafts.flared_skirt import lay_flared_skirt
from swifttailor.pattern.drafts.joins import SKIRT_WHOLE, sew_skirt_to_bodice
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.sleeve import Sleeve, lay_sleeve
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class ShirtDressOptions:
    """Options of the shirt dress."""

    bust_ease: declared.BustEase = 9.0
    waist_ease: declared.WaistEase = 7.0
    skirt_length: declared.SkirtLength = 62.0
    skirt_fraction: declared.CircleFraction = 0.5
    neckline: declared.NeckShapeOption = "v"
    neck_widening: declared.NeckWidening = 1.0
    neck_depth: declared.NeckDepth = 15.0
    back_neck_depth: declared.BackNeckDepth = 2.0
    armhole_drop: declared.ArmholeDrop = 3.5
    sleeve_length: declared.SleeveLength = 56.0
    arm_ease: declared.ArmEase = 7.0
    sleeve_end: declared.SleeveEnd = 27.0
    cap_ease: declared.CapEase = 3.0
    cuffs: Annotated[bool, Option("Sew cuffs to the sleeves.")] = True
    cuff_height: Annotated[float, Option("Height of the cuffs.", "cm", 3.0, 10.0)] = 6.0
    cuff_ease: declared.CuffWidth = 5.0


def draft_shirt_dress(options: ShirtDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the shirt dress for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("shirt-dress")
    neckline = Neckline(options.neckline, options.neck_widening, options.neck_depth, options.back_neck_depth)
    bodice = FittedBodice(neckline, options.bust_ease, options.waist_ease, options.armhole_drop)
    waist = lay_fitted_bodice(table, figure, bodice)
    cuff = min(options.cuff_height, options.sleeve_length - 9.0) if options.cuffs else 0.0
    sleeve = Sleeve(
        options.sleeve_length - cuff, options.arm_ease, options.sleeve_end, options.cap_ease / 100
    )
    lay_sleeve(table, figure, sleeve)
    if options.cuffs:
        lay_sleeve_cuff(table, figure, _cuff_width(table, figure, options, cuff), cuff)
    table.mirror()
    sew_centres(table)
    lay_flared_skirt(table, waist, options.skirt_length, figure.waist_y - 3.0, options.skirt_fraction)
    sew_skirt_to_bodice(table, SKIRT_WHOLE)
    return table.finish()


def _cuff_width(table: CuttingTable, figure: Figure, options: ShirtDressOptions, cuff: float) -> float:
    """The arm's girth where the cuff sits plus its ease; no wider than the sleeve's end, cm."""
    end = table.length("left_sleeve_f.hem", "left_sleeve_b.hem")
    return min(figure.arm_girth(options.sleeve_length - cuff) + options.cuff_ease, end)

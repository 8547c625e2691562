"""Fitted dress: darted sleeveless bodice on a pencil or A-line skirt."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.bodice import sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fitted_bodice import FittedBodice, lay_fitted_bodice
from swifttailor.pattern.drafts.fitted_skirt import FittedSkirt, lay_fitted_skirt
from swifttailor.pattern.drafts.joins import SKIRT_HALVES, sew_skirt_to_bodice
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class FittedDressOptions:
    """Options of the fitted dress."""

    bust_ease: declared.BustEase = 5.0
    waist_ease: declared.WaistEase = 3.5
    hip_ease: declared.HipEase = 4.0
    skirt_length: declared.SkirtLength = 60.0
    skirt_flare: declared.SkirtFlare = 2.0
    neckline: declared.NeckShapeOption = "round"
    neck_widening: declared.NeckWidening = 3.0
    neck_depth: declared.NeckDepth = 11.0
    back_neck_depth: declared.BackNeckDepth = 4.0
    shoulder_inset: Annotated[
        float, Option("How far the armhole lies inside the shoulder tip.", "cm", 0.0, 5.0)
    ] = 1.5
    armhole_drop: declared.ArmholeDrop = 2.0


def draft_fitted_dress(options: FittedDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the fitted dress for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("fitted-dress")
    neckline = Neckline(options.neckline, options.neck_widening, options.neck_depth, options.back_neck_depth)
    bodice = FittedBodice(
        neckline, options.bust_ease, options.waist_ease, options.armhole_drop, -options.shoulder_inset
    )
    waist = lay_fitted_bodice(table, figure, bodice)
    table.mirror()
    sew_centres(table)
    skirt = FittedSkirt(options.skirt_length, options.hip_ease, options.skirt_flare)
    lay_fitted_skirt(table, figure, skirt, waist, figure.waist_y)
    sew_skirt_to_bodice(table, SKIRT_HALVES)
    return table.finish()

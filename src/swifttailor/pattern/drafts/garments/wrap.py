"""Garments whose fronts seem to cross above the waist, and overlap below it: wrap dress and wrap top."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.bodice import SHORT_CM, LooseBodice, lay_loose_bodice
from swifttailor.pattern.drafts.crossed_fronts import cross_fronts, shorten_darts
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.fitted_bodice import FittedBodice, lay_fitted_bodice
from swifttailor.pattern.drafts.fitted_skirt import (
    FittedSkirt,
    Overlap,
    lay_fitted_skirt,
    sew_overlap_to_bodice,
)
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.shaped_sleeve import (
    ArmholeCut,
    SleeveShapeOption,
    WingOption,
    lay_shaped_sleeve,
)
from swifttailor.pattern.drafts.sleeve import Sleeve
from swifttailor.pattern.pattern import Pattern

CrossDepth = Annotated[
    float, Option("Fall of the point where the fronts cross below the neck-shoulder point.", "cm", 14.0, 28.0)
]

_OVERLAP = Overlap(aside=11.0, edge=16.0, under=28.0)
_DRAWN_IN = 2.0
"""How much more each side of a top narrows that ends at the waist, where it is tied, cm."""
_ABOVE_HEM = 3.0
"""Least distance of the end of the crossing from the hem of a top, cm."""


@dataclass(frozen=True)
class WrapDressOptions:
    """Options of the wrap dress."""

    bust_ease: declared.BustEase = 5.0
    waist_ease: declared.WaistEase = 3.5
    skirt_length: declared.SkirtLength = 62.0
    skirt_flare: declared.SkirtFlare = 9.0
    hip_ease: declared.HipEase = 6.0
    neck_widening: declared.NeckWidening = 0.6
    neck_depth: CrossDepth = 24.0
    back_neck_depth: declared.BackNeckDepth = 2.5
    armhole_drop: declared.ArmholeDrop = 2.5
    sleeves: declared.Sleeves = True
    sleeve_length: declared.SleeveLength = 58.0
    arm_ease: declared.ArmEase = 6.0
    sleeve_end: declared.SleeveEnd = 23.0
    sleeve_shape: SleeveShapeOption = "plain"


def draft_wrap_dress(options: WrapDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the wrap dress for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("wrap-dress")
    bodice = FittedBodice(
        Neckline("v", options.neck_widening, options.neck_depth, options.back_neck_depth),
        options.bust_ease,
        options.waist_ease,
        options.armhole_drop,
        shoulder_extension=0.0 if options.sleeves else -1.5,
    )
    waist = lay_fitted_bodice(table, figure, bodice)
    shorten_darts(table)
    _finish_bodice(table, figure, options)
    skirt = FittedSkirt(options.skirt_length, options.hip_ease, options.skirt_flare, _OVERLAP)
    lay_fitted_skirt(table, figure, skirt, waist, figure.waist_y)
    sew_overlap_to_bodice(table, "right")
    return table.finish()


@dataclass(frozen=True)
class WrapTopOptions:
    """Options of the wrap top."""

    length: declared.TopLength = 18.0
    chest_ease: declared.BustEase = 3.0
    waist_shaping: declared.WaistShaping = 1.5
    neck_widening: declared.NeckWidening = 0.6
    neck_depth: CrossDepth = 22.0
    back_neck_depth: declared.BackNeckDepth = 2.5
    armhole_drop: declared.ArmholeDrop = 2.0
    sleeves: declared.Sleeves = True
    sleeve_length: declared.SleeveLength = 58.0
    arm_ease: declared.ArmEase = 5.0
    sleeve_end: declared.SleeveEnd = 22.0
    sleeve_shape: SleeveShapeOption = "plain"
    armhole: Annotated[
        Literal["set-in", "cut-in-one"],
        Option("Set-in: sewn to an armhole. Cut-in-one: of the same cloth as front and back, as of kimonos."),
    ] = "set-in"
    wing: WingOption = 8.0


def draft_wrap_top(options: WrapTopOptions, measurements: Measurements) -> Pattern:
    """Drafts the wrap top for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("wrap-top")
    bodice = LooseBodice(
        Neckline("v", options.neck_widening, options.neck_depth, options.back_neck_depth),
        options.chest_ease,
        options.length,
        options.armhole_drop,
        shoulder_extension=0.0 if options.sleeves else -1.5,
        waist_shaping=options.waist_shaping + (_DRAWN_IN if options.length < SHORT_CM else 0.0),
    )
    lay_loose_bodice(table, figure, bodice)
    _finish_bodice(table, figure, options, max(options.length, _ABOVE_HEM), options.armhole, options.wing)
    return table.finish()


def _finish_bodice(
    table: CuttingTable,
    figure: Figure,
    options: WrapDressOptions | WrapTopOptions,
    above_hem: float = 0.0,
    armhole: ArmholeCut = "set-in",
    wing: float = 8.0,
) -> None:
    """Sets the sleeves in, lays the right half, and lets the fronts cross."""
    if options.sleeves:
        sleeve = Sleeve(options.sleeve_length, options.arm_ease, options.sleeve_end, 0.015)
        lay_shaped_sleeve(table, figure, options.sleeve_shape, sleeve, armhole, wing)
    # They cross down to the waist, or to just above the hem of a shorter top.
    above_hem = min(above_hem, 0.5 * table.length("left_ftorso.side"))
    table.mirror()
    table.seam("left_btorso.centre", "right_btorso.centre")
    cross_fronts(table, above_hem)

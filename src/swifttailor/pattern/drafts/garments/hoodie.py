"""Hoodie: wide torso, long sleeves, two-panel hood, cuffs and hem band."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.band import lay_sleeve_cuff, lay_waist_band
from swifttailor.pattern.drafts.bodice import LooseBodice, lay_loose_bodice, sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.hood import Hood, lay_hood, sew_hood
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.sleeve import Sleeve, lay_sleeve
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class HoodieOptions:
    """Options of the hoodie."""

    length: Annotated[float, Option("Hem below the waist, band included.", "cm", 6.0, 50.0)] = 24.0
    chest_ease: declared.ChestEase = 18.0
    neck_widening: Annotated[
        float, Option("Distance of the neckline from the neck, along the shoulder.", "cm", 1.0, 5.0)
    ] = 2.5
    neck_depth: Annotated[
        float, Option("Fall of the front neckline below the neck-shoulder point.", "cm", 7.0, 14.0)
    ] = 10.0
    armhole_drop: declared.ArmholeDrop = 4.5
    shoulder_extension: Annotated[
        float, Option("How far the shoulder seam reaches over the shoulder tip.", "cm", 0.0, 5.0)
    ] = 2.0
    sleeve_length: declared.SleeveLength = 57.0
    arm_ease: declared.ArmEase = 12.0
    sleeve_end: declared.SleeveEnd = 28.0
    hood_height: Annotated[float, Option("Height of the hood over the head length.", "cm", 4.0, 18.0)] = 6.0
    hood_depth: Annotated[float, Option("Depth of the hood on top of the head's own.", "cm", 2.0, 14.0)] = 5.0
    cuffs: Annotated[bool, Option("Sew ribbed cuffs to the sleeves.")] = True
    cuff_height: Annotated[float, Option("Height of the cuffs.", "cm", 3.0, 10.0)] = 6.0
    cuff_ease: declared.CuffWidth = 5.0
    hem_band: Annotated[bool, Option("Sew a ribbed band to the hem.")] = True
    hem_band_height: Annotated[float, Option("Height of the hem band.", "cm", 3.0, 10.0)] = 6.0
    hem_band_ease: Annotated[
        float, Option("Room of the hem band on top of the body there, all around.", "cm", 0.0, 20.0)
    ] = 4.0


def draft_hoodie(options: HoodieOptions, measurements: Measurements) -> Pattern:
    """Drafts the hoodie for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("hoodie")
    neckline = Neckline("round", options.neck_widening, options.neck_depth, 2.0)
    # A band shorter than the torso leaves at least 2 cm of cloth above it.
    band = min(options.hem_band_height, options.length - 2.0) if options.hem_band else 0.0
    bodice = LooseBodice(
        neckline,
        options.chest_ease,
        options.length - band,
        options.armhole_drop,
        hip_ease=options.hem_band_ease + 2.0 if options.hem_band else 6.0,
        shoulder_extension=options.shoulder_extension,
    )
    lay_loose_bodice(table, figure, bodice)
    cuff = min(options.cuff_height, options.sleeve_length - 10.0) if options.cuffs else 0.0
    sleeve = Sleeve(
        options.sleeve_length - max(cuff, 0.0),
        options.arm_ease,
        options.sleeve_end,
        0.01,
        options.shoulder_extension,
    )
    lay_sleeve(table, figure, sleeve)
    if options.cuffs:
        end = table.length("left_sleeve_f.hem", "left_sleeve_b.hem")
        at_cuff = figure.arm_girth(options.sleeve_length - cuff)
        lay_sleeve_cuff(table, figure, min(at_cuff + options.cuff_ease, end), cuff)
    lay_hood(table, figure, Hood(options.hood_height, options.hood_depth))
    table.mirror()
    sew_centres(table)
    sew_hood(table)
    if options.hem_band:
        _sew_hem_band(table, figure, options, band)
    return table.finish()


def _sew_hem_band(table: CuttingTable, figure: Figure, options: HoodieOptions, height: float) -> None:
    hem = [2 * table.length(f"left_{side}torso.hem") for side in "fb"]
    body = figure.girth_below_waist(options.length).eased(options.hem_band_ease)
    share = min(body.girth / sum(hem), 1.0)
    band = Halves(hem[0] / 2 * share, hem[1] / 2 * share)
    top_y = figure.waist_y - options.length + height - 4.0
    lay_waist_band(table, band, band, height, top_y, at_waist=False)
    table.seam("wb_front.top", ["left_ftorso.hem", "right_ftorso.hem"], gathered=True)
    table.seam("wb_back.top", ["right_btorso.hem", "left_btorso.hem"], gathered=True)

"""T-shirt: loose torso, short or long set-in sleeves."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.bodice import LooseBodice, lay_loose_bodice, sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.sleeve import Sleeve, lay_sleeve
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class TShirtOptions:
    """Options of the t-shirt."""

    length: declared.TopLength = 20.0
    chest_ease: declared.ChestEase = 10.0
    flare: declared.HemFlare = 0.0
    neckline: declared.NeckShapeOption = "round"
    neck_widening: declared.NeckWidening = 1.5
    neck_depth: declared.NeckDepth = 9.5
    back_neck_depth: declared.BackNeckDepth = 2.5
    armhole_drop: declared.ArmholeDrop = 2.5
    sleeve_length: declared.SleeveLength = 22.0
    arm_ease: declared.ArmEase = 7.0
    sleeve_end: declared.SleeveEnd = 34.0
    cap_ease: declared.CapEase = 1.0


def draft_t_shirt(options: TShirtOptions, measurements: Measurements) -> Pattern:
    """Drafts the t-shirt for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("t-shirt")
    neckline = Neckline(options.neckline, options.neck_widening, options.neck_depth, options.back_neck_depth)
    bodice = LooseBodice(
        neckline, options.chest_ease, options.length, options.armhole_drop, flare=options.flare
    )
    lay_loose_bodice(table, figure, bodice)
    sleeve = Sleeve(options.sleeve_length, options.arm_ease, options.sleeve_end, options.cap_ease / 100)
    lay_sleeve(table, figure, sleeve)
    table.mirror()
    sew_centres(table)
    return table.finish()

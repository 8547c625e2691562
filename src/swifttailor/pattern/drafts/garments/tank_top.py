"""Tank top: loose torso with straps, no sleeves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.bodice import LooseBodice, lay_loose_bodice, sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class TankTopOptions:
    """Options of the tank top."""

    length: declared.TopLength = 18.0
    chest_ease: declared.ChestEase = 5.0
    flare: declared.HemFlare = 0.0
    neckline: declared.NeckShapeOption = "round"
    neck_widening: declared.NeckWidening = 2.5
    neck_depth: declared.NeckDepth = 15.0
    back_neck_depth: declared.BackNeckDepth = 7.0
    strap_width: Annotated[float, Option("Width of the straps on the shoulder.", "cm", 3.0, 9.0)] = 4.0
    armhole_drop: declared.ArmholeDrop = 2.0


def draft_tank_top(options: TankTopOptions, measurements: Measurements) -> Pattern:
    """Drafts the tank top for a body."""
    figure = Figure.of(measurements)
    table = CuttingTable("tank-top")
    neckline = Neckline(options.neckline, options.neck_widening, options.neck_depth, options.back_neck_depth)
    strap_end = neckline.start_x(figure) + options.strap_width
    bodice = LooseBodice(
        neckline,
        options.chest_ease,
        options.length,
        options.armhole_drop,
        flare=options.flare,
        hip_ease=6.0,
        shoulder_extension=min(strap_end - figure.shoulder_x, 0.0),
    )
    lay_loose_bodice(table, figure, bodice)
    table.mirror()
    sew_centres(table)
    return table.finish()

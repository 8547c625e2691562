"""Dresses with a seam under the bust."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.bodice import sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.flared_skirt import lay_gathered_skirt
from swifttailor.pattern.drafts.garments.fitted_garments import SleevedBodiceOptions, lay_sleeved_bodice
from swifttailor.pattern.drafts.joins import SKIRT_WHOLE, sew_skirt_to_bodice
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.pattern import Pattern

_BELOW_BUST = 0.5
"""Where the seam runs, as a part of the way from the bust to the waist."""
_ARM_CM = 6.0
"""Radius of the upper arm and what cloth keeps away from it."""
_BELOW_ARM_CM = 4.0
"""A yoke ends so far below the underarm, cm."""
_NARROWED = 0.75
"""So much of what the bust is wider than the waist is gone there."""


@dataclass(frozen=True)
class EmpireDressOptions(SleevedBodiceOptions):
    """Options of the empire dress."""

    bust_ease: declared.BustEase = 6.0
    waist_ease: Annotated[float, Option("Room on top of the girth under the bust.", "cm", 0.0, 16.0)] = 4.0
    neck_depth: declared.NeckDepth = 12.0
    armhole_drop: declared.ArmholeDrop = 1.5
    sleeve_length: declared.SleeveLength = 20.0
    skirt_length: declared.SkirtLength = 60.0
    fullness: Annotated[
        float, Option("Width of the skirt over that of the seam it is gathered into.", "times", 1.2, 1.6)
    ] = 1.4
    skirt_flare: Annotated[float, Option("Extra width of the hem, all around.", "cm", 0.0, 80.0)] = 24.0
    yoke: Annotated[bool, Option("End the bodice at the bust, without darts: a smock's yoke.")] = False


def draft_empire_dress(options: EmpireDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the empire dress for a body: a short darted bodice, a skirt gathered into it under the bust."""
    figure = Figure.of(measurements).for_cloth(options.stretch / 100)
    table = CuttingTable("empire-dress", options.stretch / 100)
    under_y = figure.bust_y - _BELOW_BUST * (figure.bust_y - figure.waist_y)
    waist = _under_bust(figure)
    if options.yoke:
        under_y, waist = figure.armpit_y - options.armhole_drop - _BELOW_ARM_CM, figure.bust
    short = replace(figure, waist_y=under_y, waist=waist)
    seam = lay_sleeved_bodice(table, short, options, yoke=options.yoke)
    table.mirror()
    sew_centres(table)
    length = options.skirt_length + under_y - figure.waist_y
    fullness = min(options.fullness, _between_the_arms(figure, under_y) / max(seam.front, seam.back))
    lay_gathered_skirt(table, seam, length, under_y - 3.0, fullness, options.skirt_flare)
    sew_skirt_to_bodice(table, SKIRT_WHOLE, gathered=True)
    return table.finish()


def _between_the_arms(figure: Figure, y: float) -> float:
    """Half of the widest flat panel that can hang from height `y` and be sewn without catching an arm, cm."""
    fall = figure.shoulder_line(figure.shoulder_x) - y
    return figure.shoulder_x + fall / math.tan(math.radians(figure.arm_angle)) - _ARM_CM


def _under_bust(figure: Figure) -> Halves:
    bust, waist = figure.bust, figure.waist
    return Halves(
        bust.front + _NARROWED * (waist.front - bust.front), bust.back + _NARROWED * (waist.back - bust.back)
    )

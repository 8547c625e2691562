"""Garments on thin straps: camisole, slip dress."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from swifttailor.pattern.drafts import declared
from swifttailor.pattern.drafts.bodice import sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.measurements import Measurements
from swifttailor.pattern.drafts.options import Option
from swifttailor.pattern.drafts.strap_bodice import StrapBodice, lay_strap_bodice
from swifttailor.pattern.pattern import Pattern

StrapWidth = Annotated[float, Option("Width of the straps.", "cm", 1.0, 4.0)]
FrontDip = Annotated[float, Option("Fall of the front between the straps.", "cm", 0.0, 8.0)]


@dataclass(frozen=True)
class CamisoleOptions:
    """Options of the camisole."""

    length: declared.TopLength = 16.0
    chest_ease: declared.BustEase = 4.0
    flare: declared.HemFlare = 2.0
    strap_width: StrapWidth = 1.5
    dip: FrontDip = 3.0


def draft_camisole(options: CamisoleOptions, measurements: Measurements) -> Pattern:
    """Drafts the camisole for a body."""
    bodice = StrapBodice(options.strap_width, options.chest_ease, options.length, options.dip, options.flare)
    return _on_straps("camisole", bodice, measurements)


@dataclass(frozen=True)
class SlipDressOptions:
    """Options of the slip dress."""

    length: Annotated[float, Option("Hem below the waist.", "cm", 25.0, 100.0)] = 56.0
    chest_ease: declared.BustEase = 4.0
    flare: declared.HemFlare = 24.0
    strap_width: StrapWidth = 1.5
    dip: FrontDip = 4.0


def draft_slip_dress(options: SlipDressOptions, measurements: Measurements) -> Pattern:
    """Drafts the slip dress for a body."""
    bodice = StrapBodice(options.strap_width, options.chest_ease, options.length, options.dip, options.flare)
    return _on_straps("slip-dress", bodice, measurements)


def _on_straps(name: str, bodice: StrapBodice, measurements: Measurements) -> Pattern:
    table = CuttingTable(name)
    lay_strap_bodice(table, Figure.of(measurements), bodice)
    table.mirror()
    sew_centres(table)
    return table.finish()

"""A peplum: a short flared piece sewn to a top that ends, or is cut off, at the waist."""

from __future__ import annotations

from swifttailor.describing.measuring.parts import LOWER_PARTS, Face, Part
from swifttailor.describing.measuring.skirts import upper_edges
from swifttailor.pattern import Pattern
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Halves
from swifttailor.pattern.drafts.flared_skirt import lay_flared_skirt
from swifttailor.recutting.amounts.cuts import lengthen_hem
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.grafting import lay_pattern, sew_across
from swifttailor.recutting.ways.removal import WAIST_LABEL

PEPLUM_CM, PEPLUM_FRACTION = 17.0, 0.5
"""How long it is, and of how much of a circle it is cut."""
SHORT_CM = 3.0
"""A top that ends less far from the waist is not cut off."""
_BELOW_CM = 2.0
"""From the top's edge down to it, as placed."""
_FACES: tuple[Face, Face] = ("front", "back")


def sew_peplum(cutter: Cutter) -> Pattern | None:
    """Sews a peplum to the waist of a top; what of the top lies below is cut off.

    None where the garment has a lower part or a band, ends far above the waist, or is cut otherwise.
    """
    hem, body = cutter.facts.hem, cutter.facts.body
    if cutter.names(*LOWER_PARTS, Part.WAISTBAND) or hem is None or hem.level > body.waist + SHORT_CM:
        return None
    below = body.waist - hem.level
    short = lengthen_hem(cutter, -below) if below > SHORT_CM else cutter.pattern
    if short is None:
        return None
    top = cutter.with_pattern(short)
    edges = top.hem_of(Part.TORSO)
    bench = Workbench(short)
    held = {f: [bench.at[r] for r in edges if top.anatomy.parts[r.panel].face == f] for f in _FACES}
    if not all(held.values()):
        return None
    widths = {f: sum(bench.piece_of(side).length(side) for side in sides) for f, sides in held.items()}
    table = CuttingTable("peplum")
    waist = Halves(widths["front"] / 2, widths["back"] / 2)
    lay_flared_skirt(table, waist, PEPLUM_CM, body.waist - _BELOW_CM, PEPLUM_FRACTION)
    drafted = table.finish()
    laid = lay_pattern(bench, drafted)
    if laid is None:
        return None
    own = cutter.with_pattern(drafted).anatomy
    upper = upper_edges(own, Part.SKIRT)[0]
    for face in _FACES:
        sides = [laid[r] for r in upper if own.parts[r.panel].face == face]
        for side in sides:
            bench.relabel(side, WAIST_LABEL)
        if not sew_across(bench, held[face], sides):
            return None
    return bench.pattern()

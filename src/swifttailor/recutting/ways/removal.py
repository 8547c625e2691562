"""Taking parts off a garment."""

from __future__ import annotations

from collections.abc import Collection

from swifttailor.pattern import Pattern
from swifttailor.recutting.table.workbench import Workbench

WAIST_LABEL = "lower_interface"


def remove_panels(pattern: Pattern, names: Collection[str]) -> Pattern | None:
    """Takes panels off; what they were sewn to becomes a free border.

    Where the garment hung from the removed panels by the waist label, the edges they were sewn to get it.

    Returns:
        What is left; None where nothing is, or it falls apart.
    """
    gone = set(names)
    if not gone or len(gone) == len(pattern.panels):
        return None
    bench = Workbench(pattern)
    held = any(e.label == WAIST_LABEL for n in gone for e in pattern.panel(n).edges)
    freed = [
        bench.at[own]
        for s in pattern.stitches
        for own, other in (s.sides, s.sides[::-1])
        if other.panel in gone and own.panel not in gone
    ]
    if held:
        for side in freed:
            bench.relabel(side, WAIST_LABEL)
    bench.remove(gone)
    rest = bench.pattern()
    return rest if len(rest.components()) == 1 else None

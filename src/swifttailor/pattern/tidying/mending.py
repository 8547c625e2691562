"""What is mended in a pattern that a network has written, and a person would not have drawn."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.pattern import Pattern, Severity, check_pattern, repair_pattern
from swifttailor.pattern.check.repair import Change, Repair
from swifttailor.pattern.tidying.closed_slits import open_slits
from swifttailor.pattern.tidying.corner_slivers import without_corner_slivers
from swifttailor.pattern.tidying.even_seams import even_seams
from swifttailor.pattern.tidying.even_sides import even_sides

INEXACT_CM = 4.0
"""Corners and curves of a written pattern may be this far off: so far they are moved to free an outline of
itself."""
INEXACT_SHARE = 0.05
"""Or so much of a panel's size: flounces are metres wide."""
WHOLE_SHARE = 0.6
"""Panels that hold together are the garment if they have so much of all the cloth."""

_EVENING = (even_sides, without_corner_slivers, even_sides, open_slits, even_seams)
"""Sides come first, so that slivers go on both; and again, for what had one on one side only."""


def mend(pattern: Pattern, *, alike: bool = False) -> Repair:
    """Mends what can be, as `repair_pattern` does, with the exactness of a network in mind.

    A seam of a few millimetres with half a metre is not gathered but a slip: it is left open. A hood that is
    sewn to itself alone would lie on the floor: it is left out.

    Args:
        pattern: As it was written.
        alike: Whether what is nearly even is made exactly so: left and right, slits, side seams; not in an
            edit, where what was uneven before is to stay.
    """
    evened: tuple[Change, ...] = ()
    for step in _EVENING if alike else ():
        pattern, done = step(pattern)
        evened += done
    wrong = {
        f.stitch
        for f in check_pattern(pattern)
        if f.code == "uneven-seam" and f.severity is Severity.ERROR and f.stitch is not None
    }
    changes = tuple(
        Change("uneven-seam", "left this seam open: its edges cannot belong together", stitch=k)
        for k in sorted(wrong)
    )
    kept = tuple(s for k, s in enumerate(pattern.stitches) if k not in wrong)
    pattern = replace(pattern, stitches=kept) if wrong else pattern
    pattern, left_out = _held_together(pattern)
    repair = repair_pattern(pattern, largest_move=INEXACT_CM, largest_share=INEXACT_SHARE)
    return replace(repair, changes=(*evened, *changes, *left_out, *repair.changes))


def _held_together(pattern: Pattern) -> tuple[Pattern, tuple[Change, ...]]:
    """The pattern without what is sewn to nothing of the garment, and what that was."""
    groups = pattern.components()
    if len(groups) < 2:
        return pattern, ()
    cloth = {p.name: abs(p.signed_area()) for p in pattern.panels}
    garment = max(groups, key=lambda group: sum(cloth[name] for name in group))
    if sum(cloth[name] for name in garment) < WHOLE_SHARE * sum(cloth.values()):
        return pattern, ()
    kept = replace(
        pattern,
        panels=tuple(p for p in pattern.panels if p.name in garment),
        stitches=tuple(s for s in pattern.stitches if all(side.panel in garment for side in s.sides)),
    )
    why = "left this panel out: it is not sewn to the rest of the garment"
    return kept, tuple(Change("disconnected", why, p.name) for p in pattern.panels if p.name not in garment)

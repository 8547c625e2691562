"""What is mended in a pattern that a network has written, and a person would not have drawn."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.pattern import Pattern, Severity, check_pattern, repair_pattern
from swifttailor.pattern.check.repair import Change, Repair

INEXACT_CM = 4.0
"""Corners and curves of a written pattern may be this far off: so far they are moved to free an outline of
itself."""
INEXACT_SHARE = 0.05
"""Or so much of a panel's size: flounces are metres wide."""


def mend(pattern: Pattern) -> Repair:
    """Mends what can be, as `repair_pattern` does, with the exactness of a network in mind.

    A seam of a few millimetres with half a metre is not gathered but a slip: it is left open.
    """
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
    repair = repair_pattern(pattern, largest_move=INEXACT_CM, largest_share=INEXACT_SHARE)
    return replace(repair, changes=(*changes, *repair.changes))

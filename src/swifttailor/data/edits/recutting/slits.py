"""Opening a side seam from the hem up, or sewing it shut."""

from __future__ import annotations

from collections.abc import Collection

from swifttailor.data.edits.recutting.ends import find_ends
from swifttailor.data.edits.recutting.workbench import Workbench
from swifttailor.pattern import EdgeRef, Pattern

LEFT_SEWN_CM = 5.0
"""What stays sewn above a slit at least."""


def open_side(pattern: Pattern, hem: Collection[EdgeRef], height: float, side: str) -> Pattern | None:
    """Opens the side seam of one side of a skirt from its hem up.

    Args:
        pattern: Any pattern.
        hem: Edges of the hem.
        height: Of the slit, cm.
        side: ``left`` or ``right``, the wearer's.

    Returns:
        The pattern with the slit; None where there is no such seam, or it is too short.
    """
    bench = Workbench(pattern)
    for end in find_ends(bench, pattern, hem):
        piece = bench.pieces[end.panel]
        for seam, at_end in ((end.before, True), (end.after, False)):
            partner = bench.partner(seam)
            x = float(piece.panel.to_world(piece.chord(seam)[[1 if at_end else 0]])[0, 0])
            if partner is None or (x > 0) != (side == "left") or abs(x) < 5.0:
                continue
            other = bench.piece_of(partner).panel
            if (other.normal()[2] < 0) == (piece.panel.normal()[2] < 0):
                continue
            if piece.length(seam) < height + LEFT_SEWN_CM:
                return None
            _open(bench, seam, height, at_end)
            return bench.pattern()
    return None


def _open(bench: Workbench, seam: int, height: float, at_end: bool) -> None:
    """Cuts both sides of a seam and unpicks the parts next to the hem."""
    partner = bench.partner(seam)
    assert partner is not None
    for id, last in ((seam, at_end), (partner, not at_end)):
        length = bench.piece_of(id).length(id)
        second = bench.split(id, 1 - height / length if last else height / length)
        if not last:
            bench.resew(id, second)

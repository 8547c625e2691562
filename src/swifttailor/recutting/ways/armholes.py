"""Moving the ends of free armholes: deeper or higher along the side seam, in or out along the shoulder."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from swifttailor.pattern import EdgeRef, Line, Pattern
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.sleeves import Hole

SHORTEST_CM = 3.0
"""What is left at least of a side seam or shoulder seam."""
LEAST_HOLE_CM = 8.0


def lower_underarms(pattern: Pattern, holes: Sequence[Hole], distance: float) -> Pattern | None:
    """Moves the lower ends of armholes down their side seams, cm, in front and behind alike.

    Returns:
        The recut pattern; None where an armhole does not end at a side seam that is long enough.
    """
    return _move(pattern, holes, distance, under=True)


def lengthen_shoulders(pattern: Pattern, holes: Sequence[Hole], distance: float) -> Pattern | None:
    """Moves the upper ends of armholes outward along their shoulder seams, cm, in front and behind alike.

    Returns:
        The recut pattern; None where an armhole does not end at a straight shoulder seam that is long enough.
    """
    return _move(pattern, holes, -distance, under=False)


def _move(pattern: Pattern, holes: Sequence[Hole], into: float, *, under: bool) -> Pattern | None:
    """Moves an end of armholes into the seam that it meets there, out of it for negative distances."""
    bench = Workbench(pattern)
    for hole in holes:
        seams = [_seam_beside(bench, run, under=under) for run in (hole.front, hole.back)]
        if bench.partner(seams[0][0]) != seams[1][0]:
            return None
        for run, (seam, follows) in zip((hole.front, hole.back), seams, strict=True):
            ids = [bench.at[r] for r in run]
            ids = ids if follows == under else ids[::-1]
            if not _move_end(bench, ids, seam, into, follows=follows):
                return None
    return bench.pattern()


def _seam_beside(bench: Workbench, run: Sequence[EdgeRef], *, under: bool) -> tuple[int, bool]:
    """The side next to the lower or upper end of a run that goes down, and whether it follows it."""
    last = bench.at[run[-1 if under else 0]]
    others = {bench.at[r] for r in run}
    if len(run) > 1:
        follows = bench.neighbour(last, 1) not in others
    else:
        piece = bench.piece_of(last)
        y = piece.panel.to_world(piece.chord(last))[:, 1]
        follows = (y[1] < y[0]) == under
    return bench.neighbour(last, 1 if follows else -1), follows


def _move_end(bench: Workbench, run: Sequence[int], seam: int, into: float, *, follows: bool) -> bool:
    """Moves the end of a run, given in the order of the loop, that meets a seam there."""
    length = bench.piece_of(seam).length(seam)
    straight = isinstance(bench.side(seam).edge.curve, Line)
    if length - into < SHORTEST_CM or (not straight and into < 0):
        return False
    old = bench.run_chord(run)
    new = old.copy()
    end = 1 if follows else 0
    if straight:
        chord = bench.piece_of(seam).chord(seam)
        near, far = chord if follows else chord[::-1]
        new[end] = near + into * (far - near) / length
    else:
        rest = bench.split(seam, into / length if follows else 1.0 - into / length)
        new[end] = bench.side(rest).start
        if follows:
            bench.resew(seam, rest)
        bench.drop(seam if follows else rest)
    if np.hypot(*(new[1] - new[0])) < LEAST_HOLE_CM:
        return False
    bench.map_run(run, old, new)
    return True

"""Making a neckline wider or narrower: its shoulder ends move along the shoulder seams."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import Arc, EdgeRef, Line, Pattern
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.ends import End
from swifttailor.recutting.ways.necklines import neckline_halves

SHORTEST_SHOULDER_CM = 2.5


def widen_neckline(
    pattern: Pattern, front: Sequence[EdgeRef], back: Sequence[EdgeRef], distance: float
) -> Pattern | None:
    """Moves both shoulder ends of the neckline outward, in front and behind alike.

    Args:
        pattern: Any pattern.
        front: The free edges of the front neckline.
        back: Those of the back.
        distance: Along each shoulder seam, cm; negative towards the neck.

    Returns:
        The recut pattern, the middles of the neckline where they were; None where its halves do not meet at
        straight centre and shoulder seams.
    """
    bench = Workbench(pattern)
    halves = [h for edges in (front, back) for h in neckline_halves(bench, pattern, edges)]
    if len(halves) != 4:
        return None
    shoulders = [end.after if seam == end.before else end.before for end, seam in halves]
    if any(bench.partner(s) not in shoulders for s in shoulders):
        return None
    for (end, seam), shoulder in zip(halves, shoulders, strict=True):
        if not _widen_half(bench, end, seam == end.before, shoulder, distance):
            return None
    return bench.pattern()


def _widen_half(bench: Workbench, end: End, at_start: bool, shoulder: int, distance: float) -> bool:
    if not isinstance(bench.side(shoulder).edge.curve, Line):
        return False
    seam = bench.piece_of(shoulder).chord(shoulder)
    near, far = (seam[0], seam[1]) if at_start else (seam[1], seam[0])
    length = float(np.hypot(*(far - near)))
    if length - distance < SHORTEST_SHOULDER_CM:
        return False
    old = bench.run_chord(end.run)
    middle = old[0] if at_start else old[1]
    new_near = near + distance * (far - near) / length
    if len(end.run) == 1 and isinstance(bench.side(end.run[0]).edge.curve, Arc):
        bench.map_run(end.run, old, np.array([middle, new_near] if at_start else [new_near, middle]))
        return True
    was, now = near - middle, new_near - middle
    if min(abs(was[0]), abs(now[0])) < 2.0 or min(abs(was[1]), abs(now[1])) < 0.5:
        return False

    def move(points: Floats) -> Floats:
        return middle + (points - middle) * (now / was)

    following = bench.neighbour(end.run[-1], 1)
    return bench.map_points(end.panel, move, {*end.run, following})

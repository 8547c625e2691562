"""A hem that was moved below the waist, made wide enough: darts close again, side seams flare."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import EdgeRef, Pattern
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.ends import SHORTEST_CM, End, find_ends

STEEPEST = 0.5
"""How far a seam turns, cm at its end for 1 cm of its length."""
_DART_END_CM = 0.4
"""What a dart leaves open at the hem."""


def widen_below(pattern: Pattern, refs: Collection[EdgeRef], girth: float, last: float) -> Pattern | None:
    """Widens the end of a part below a height; what lies above stays.

    Darts that run out at the end are closed towards it, as those of a bodice are below the waist; what that
    does not bring, the seams between front and back do.

    Args:
        pattern: Any pattern.
        refs: The edges at the end, of all panels that meet there.
        girth: How much wider it is to be, cm; not negative.
        last: Only so much of each seam turns, cm from its end.

    Returns:
        The recut pattern; its seams keep their lengths exactly. None where the seams do not allow it.
    """
    bench = Workbench(pattern)
    ends = find_ends(bench, pattern, refs)
    if not ends:
        return None
    darts = {s: w for e in ends for s, w in _dart_legs(bench, ends, e)}
    sides = {s for e in ends for s in (e.before, e.after) if s not in darts and _is_side_seam(bench, s)}
    closing = sum(max(width - _DART_END_CM, 0.0) for width in darts.values()) / 2
    share = min(girth / closing, 1.0) if closing > 0 else 0.0
    left = girth - share * closing
    if left > 0.1 and len(sides) < 2:
        return None
    by = {s: share * max(width - _DART_END_CM, 0.0) / 2 for s, width in darts.items()}
    by |= {s: left / len(sides) for s in sides}
    lower = _parted(bench, ends, set(by), last)
    for end, (before, after) in zip(ends, lower, strict=True):
        old = bench.run_chord(end.run)
        new = old.copy()
        outward = (old[0] - old[1]) / max(float(np.hypot(*(old[0] - old[1]))), 1e-9)
        for k, (side, part, direction) in enumerate(
            ((end.before, before, outward), (end.after, after, -outward))
        ):
            if side not in by:
                continue
            turned = _turned(bench.piece_of(part).chord(part)[k], old[k], direction, by[side])
            if turned is None:
                return None
            new[k] = turned
        if (new[1] - new[0]) @ (old[1] - old[0]) <= SHORTEST_CM**2:
            return None
        bench.map_run(end.run, old, new)
    return bench.pattern()


def _dart_legs(bench: Workbench, ends: Sequence[End], end: End) -> list[tuple[int, float]]:
    """The leg of a dart behind a run and the other before the next run, with the dart's width at the end."""
    for other in ends:
        if other.panel == end.panel and bench.partner(end.after) == other.before:
            width = float(np.hypot(*(bench.run_chord(other.run)[0] - bench.run_chord(end.run)[1])))
            return [(end.after, width), (other.before, width)]
    return []


def _is_side_seam(bench: Workbench, side: int) -> bool:
    """Whether it joins front and back."""
    partner = bench.partner(side)
    if partner is None:
        return False
    faces = [bench.piece_of(s).panel.normal()[2] < 0 for s in (side, partner)]
    return faces[0] != faces[1]


def _turned(pivot: Floats, at: Floats, direction: Floats, by: float) -> Floats | None:
    """(2,) the end of a side turned about its upper one, or None where that is too steep."""
    arm = at - pivot
    length = float(np.hypot(*arm))
    if by > STEEPEST * length:
        return None
    angle = np.sign(np.array([-arm[1], arm[0]]) @ direction) * by / max(length, 1e-9)
    c, s = np.cos(angle), np.sin(angle)
    return pivot + np.array([[c, -s], [s, c]]) @ arm


def _parted(
    bench: Workbench, ends: Sequence[End], turning: Collection[int], last: float
) -> list[tuple[int, int]]:
    """Parts seams `last` cm above their ends; for each end what leads to it and away from it then."""
    seams = [seam for seam in bench.seams if seam[0] in turning and seam[1] in turning]
    long = {
        side
        for a, b, _ in seams
        if min(bench.piece_of(s).length(s) for s in (a, b)) > last + SHORTEST_CM
        for side in (a, b)
    }
    parts: dict[int, tuple[int, int]] = {}
    lower = []
    for end in ends:
        before, after = end.before, end.after
        if before in long:
            parts[before] = before, bench.split(before, 1 - last / bench.piece_of(before).length(before))
        if after in long:
            parts[after] = bench.split(after, last / bench.piece_of(after).length(after)), after
        lower.append((parts.get(before, (0, before))[1], after))
    for a, b, turned in seams:
        if a in parts and b in parts:
            bench.unpick(a)
            for one, other in zip(parts[a], parts[b], strict=True):
                bench.sew(one, other, right_wrong=turned)
    return lower

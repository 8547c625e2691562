"""Moving the end of a part: hems, sleeve ends, leg ends, edges of bands, in or out along their side seams."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.describing.measuring.chain import edge_runs
from swifttailor.pattern import EdgeRef, Line, Pattern
from swifttailor.pattern import curve as curves
from swifttailor.recutting.table.workbench import Workbench

SHORTEST_CM = 1.5
"""What is left at least of a side seam, or of the end of a panel."""
SHORTEST_PIECE_CM = 0.5
"""What is left at least of a side that another side of the same seam goes on from."""
TURNING_CM = 8.0
"""So far a curved side is drawn on as it ends."""


@dataclass
class End:
    """A run of sides at the end of a panel, with the side seams that lead to it."""

    panel: str
    run: list[int]
    before: int
    """Side that ends where the run starts."""
    after: int
    """Side that starts where the run ends."""


def find_ends(bench: Workbench, pattern: Pattern, refs: Collection[EdgeRef]) -> list[End]:
    """The ends that some edges form; none where an end goes nearly all around a panel."""
    ends = []
    for name in dict.fromkeys(r.panel for r in refs):
        count = len(pattern.panel(name).edges)
        for run in edge_runs(pattern.panel(name), [r.edge for r in refs if r.panel == name]):
            if len(run) > count - 3:
                return []
            ids = [bench.at[EdgeRef(name, k)] for k in run]
            before, after = (EdgeRef(name, k % count) for k in (run[0] - 1, run[-1] + 1))
            ends.append(End(name, ids, bench.at[before], bench.at[after]))
    return ends


def move_ends(
    pattern: Pattern,
    refs: Collection[EdgeRef],
    distance: float,
    carried: Collection[str] = (),
    *,
    least: float = SHORTEST_CM,
    upright: bool = False,
) -> Pattern | None:
    """Moves the end of a part along its side seams.

    Args:
        pattern: Any pattern.
        refs: The edges at the end, of all panels that meet there.
        distance: Outward, cm; negative cuts off.
        carried: Panels that hang from the end and move with it.
        least: What must be left of the end of a panel, cm.
        upright: Whether sides are drawn on straight down, so that the end stays as wide as it is.

    Returns:
        The recut pattern, every side seam still joining equal lengths; None where the sides do not allow it.
        What carries panels keeps its length: its sides are redrawn to where it has moved.
    """
    bench = Workbench(pattern)
    ends = find_ends(bench, pattern, refs)
    if not ends or not _sides_agree(bench, ends):
        return None
    if carried:
        return _move_whole(bench, ends, distance, carried)
    old = [bench.run_chord(e.run) for e in ends]
    if distance > 0 and upright:
        new = [was + distance * _down(bench, e) for e, was in zip(ends, old, strict=True)]
        _insert_extensions(bench, ends, bent=True)
    elif distance > 0:
        new = [_lengthened(bench, e, distance) for e in ends]
        _insert_extensions(bench, ends)
    else:
        if not _cut_off(bench, ends, -distance):
            return None
        new = [bench.run_chord(e.run) for e in ends]
    for end, was, now in zip(ends, old, new, strict=True):
        if min(np.hypot(*(was[1] - was[0])), np.hypot(*(now[1] - now[0]))) < least:
            return None
        bench.map_run(end.run, was, now)
    return bench.pattern()


def swing_sides(
    pattern: Pattern,
    refs: Collection[EdgeRef],
    width: float,
    *,
    all_seams: bool = False,
    steepest: float = 0.25,
) -> Pattern | None:
    """Widens (or narrows) the end of a part by turning its side seams about their upper ends.

    Args:
        pattern: Any pattern.
        refs: The edges at the end, of all panels that meet there.
        width: How far each end of each side seam moves outward, cm; negative narrows.
        all_seams: Whether seams between two front or two back panels are turned as well.
        steepest: How far a side seam may be turned, cm at its end for 1 cm of its length.

    Returns:
        The recut pattern; its seams keep their lengths exactly. None where the sides do not allow it.
    """
    bench = Workbench(pattern)
    ends = find_ends(bench, pattern, refs)
    if not ends or not _sides_agree(bench, ends):
        return None
    turned = 0
    for end in ends:
        old = bench.run_chord(end.run)
        new = old.copy()
        outward = (old[0] - old[1]) / max(float(np.hypot(*(old[0] - old[1]))), 1e-9)
        for k, (side, direction) in enumerate(((end.before, outward), (end.after, -outward))):
            if not all_seams and not _joins_front_to_back(bench, side):
                continue
            upper = _drawn_on_from(bench, side, -1 if k == 0 else 1)
            pivot = bench.piece_of(side).chord(side if upper is None else upper)[k]
            arm = old[k] - pivot
            length = float(np.hypot(*arm))
            if steepest * length < abs(width):
                return None
            sign = np.sign(np.array([-arm[1], arm[0]]) @ direction)
            c, s = np.cos(sign * width / length), np.sin(sign * width / length)
            turn = np.array([[c, -s], [s, c]])
            new[k] = pivot + turn @ arm
            if upper is not None:
                between = bench.side(side if k == 0 else upper)
                between.start = pivot + turn @ (between.start - pivot)
            turned += 1
        if (new[1] - new[0]) @ (old[1] - old[0]) <= SHORTEST_CM**2:
            return None
        bench.map_run(end.run, old, new)
    return bench.pattern() if turned else None


def _move_whole(
    bench: Workbench, ends: Sequence[End], distance: float, carried: Collection[str]
) -> Pattern | None:
    """Moves ends as they are, out by `distance`, with the panels that hang from them."""
    moves = []
    for end in ends:
        if distance < 0 and min(_length(bench, s) for s in (end.before, end.after)) < SHORTEST_CM - distance:
            return None
        old = bench.run_chord(end.run)
        outward = (_lengthened(bench, end, 1.0) - old).mean(axis=0)
        step = distance * outward / max(float(np.hypot(*outward)), 1e-9)
        bench.map_run(end.run, old, old + step)
        panel = bench.pieces[end.panel].panel
        moves.append(panel.to_world(step[None])[0] - panel.to_world(np.zeros((1, 2)))[0])
    bench.shift(carried, np.mean(moves, axis=0))
    return bench.pattern()


def _sides_agree(bench: Workbench, ends: Sequence[End]) -> bool:
    """Whether every side seam that leads to the end is sewn to another that does, or to nothing."""
    sides = {s for e in ends for s in (e.before, e.after)}
    return all((p := bench.partner(s)) is None or p in sides for s in sides)


def _joins_front_to_back(bench: Workbench, side: int) -> bool:
    partner = bench.partner(side)
    if partner is None:
        return False
    faces = [bench.piece_of(s).panel.normal()[2] < 0 for s in (side, partner)]
    return faces[0] != faces[1]


def _drawn_on_from(bench: Workbench, side: int, step: int) -> int | None:
    """The curved side that a straight one draws on, next to it away from the end; None where there is none.

    Both turn together: a seam that was lengthened would else bend where it was.
    """
    upper, partner = bench.neighbour(side, step), bench.partner(side)
    if partner is None or bench.partner(upper) != bench.neighbour(partner, -step):
        return None
    straight, above = (isinstance(bench.side(s).edge.curve, Line) for s in (side, upper))
    # A short curve above a long straight line is a hip or an underarm, which stays.
    return upper if straight and not above and _length(bench, upper) > 0.5 * _length(bench, side) else None


def _lengthened(bench: Workbench, end: End, distance: float) -> Floats:
    """Start and end (2, 2) of a run after its sides have been drawn on straight, local cm."""
    chords = [bench.piece_of(s).chord(s) for s in (end.before, end.after)]
    arriving = curves.derivative(bench.side(end.before).edge.curve, chords[0], [1.0])[0]
    leaving = curves.derivative(bench.side(end.after).edge.curve, chords[1], [0.0])[0]
    return np.array(
        [
            chords[0][1] + distance * _drawn_on(arriving, chords[0], distance),
            chords[1][0] - distance * _drawn_on(leaving, chords[1], distance),
        ]
    )


def _drawn_on(tangent: Floats, chord: Floats, distance: float) -> Floats:
    """Direction (2,) in which a side is drawn on, of length 1.

    A side that turns outward at its end, as a trumpet skirt's, would run to the side for as far as it is
    drawn on; further than `TURNING_CM` it takes the direction of the whole side more and more.
    """
    share = min(1.0, TURNING_CM / distance)
    parts = [v / max(float(np.hypot(*v)), 1e-9) for v in (tangent, chord[1] - chord[0])]
    along = share * parts[0] + (1 - share) * parts[1]
    return along / max(float(np.hypot(*along)), 1e-9)


def _down(bench: Workbench, end: End) -> Floats:
    """Straight down (2,) on a panel, as it is placed."""
    down = -bench.pieces[end.panel].panel.placement.matrix()[1, :2]
    return down / max(float(np.hypot(*down)), 1e-9)


def _insert_extensions(bench: Workbench, ends: Sequence[End], *, bent: bool = False) -> None:
    """Adds a straight side where a curved one cannot simply be drawn on, and sews it to its partner's.

    Where sides are bent, all of them are added.
    """
    added: dict[int, int] = {}
    for end in ends:
        for side, at in ((end.before, end.run[0]), (end.after, end.after)):
            partner = bench.partner(side)
            sides = [s for s in (side, partner) if s is not None]
            if not bent and all(isinstance(bench.side(s).edge.curve, Line) for s in sides):
                continue
            added[side] = bench.insert_line(at, bench.side(at).start)
    for side, extension in added.items():
        partner = bench.partner(side)
        if partner is not None and side < partner:
            bench.sew(extension, added[partner])


def _cut_off(bench: Workbench, ends: Sequence[End], distance: float) -> bool:
    """Takes `distance` cm off every side seam, whole sides where they are shorter.

    Returns:
        Whether that is possible: not where a side leads to two ends.
    """
    if _shared(ends):
        return False
    left = {s: distance for e in ends for s in (e.before, e.after)}
    while True:
        used_up = [
            s for s, rest in left.items() if rest > 0 and _length(bench, s) < rest + _stays(bench, ends, s)
        ]
        if not used_up:
            break
        # Both sides of a seam go together.
        used_up = list(dict.fromkeys(s for u in used_up for s in (u, bench.partner(u)) if s is not None))
        for end in ends:
            for which, step in (("before", -1), ("after", 1)):
                side = getattr(end, which)
                if side not in used_up:
                    continue
                rest = max(left.pop(side) - _length(bench, side), 0.0)
                following = bench.neighbour(side, step)
                if following in left or following in (*end.run, end.before, end.after):
                    return False
                if which == "before":
                    bench.side(end.run[0]).start = bench.side(side).start
                bench.drop(side)
                setattr(end, which, following)
                left[following] = rest
        if _shared(ends) or not _sides_agree(bench, ends):
            return False
    for end in ends:
        rest, length = left[end.before], _length(bench, end.before)
        if rest > 0.0:
            cut = bench.split(end.before, 1 - rest / length)
            bench.side(end.run[0]).start = bench.side(cut).start
            bench.drop(cut)
        rest, length = left[end.after], _length(bench, end.after)
        if rest <= 0.0:
            continue
        kept = bench.split(end.after, rest / length)
        bench.resew(end.after, kept)
        bench.drop(end.after)
        end.after = kept
    return True


def _stays(bench: Workbench, ends: Sequence[End], side: int) -> float:
    """What has to be left of a side, cm: less where the seam that it is of goes on above it."""
    step = -1 if any(end.before == side for end in ends) else 1
    above, partner = bench.neighbour(side, step), bench.partner(side)
    beyond = None if partner is None else bench.neighbour(partner, -step)
    goes_on = bench.partner(above) == beyond and _length(bench, above) >= SHORTEST_CM
    return SHORTEST_PIECE_CM if goes_on else SHORTEST_CM


def _shared(ends: Sequence[End]) -> bool:
    """Whether a side lies between two of the ends."""
    sides = [s for e in ends for s in (e.before, e.after)]
    return len(set(sides)) < len(sides)


def _length(bench: Workbench, side: int) -> float:
    return bench.piece_of(side).length(side)

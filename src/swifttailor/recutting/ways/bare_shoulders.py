"""Baring shoulders: what lies above the line from the underarm to the middle of the neckline is cut off."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import numpy as np

from swifttailor.describing.measuring.anatomy import Anatomy
from swifttailor.describing.measuring.parts import Face, Part
from swifttailor.pattern import EdgeRef, Line, Pattern, Quadratic
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.sleeves import ArmSide, find_hole

_ABOVE_UNDERARM_CM: dict[Face, float] = {"front": 4.5, "back": 1.0}
"""Highest middle of a strapless edge: in front it covers the bust."""
_LEAST_SEAM_CM = 5.0
"""What is left at least of a seam in the middle."""
_LEVEL_SHARE = 0.6
"""How much of the way to the underarm such an edge runs level, roughly."""
_FACES: tuple[Face, Face] = ("front", "back")


def bare_shoulders(
    pattern: Pattern, anatomy: Anatomy, sides: Collection[ArmSide], *, other_bare: bool = False
) -> Pattern | None:
    """Cuts off the shoulders of some sides, with armholes and necklines.

    Args:
        pattern: The pattern that `anatomy` is of.
        anatomy: Knows its borders.
        sides: The wearer's.
        other_bare: Whether the other side is bare already. Where both are, the middle is lowered as well.

    Returns:
        The pattern with bare shoulders; None where an armhole is not free, or a panel is not cut from the
        underarm over shoulder and neckline to a seam in the middle.
    """
    bench = Workbench(pattern)
    for face in _FACES:
        lowest: list[tuple[int, int, float]] = []
        for side in sides:
            hole = find_hole(anatomy, side)
            if hole is None:
                return None
            run = hole.front if face == "front" else hole.back
            cut = _cut(bench, anatomy, run)
            if cut is None:
                return None
            lowest.append((*cut, _ABOVE_UNDERARM_CM[face]))
            if other_bare:
                beyond = bench.partner(cut[1])
                if beyond is None:
                    return None
                after = bench.neighbour(cut[0], 1) == cut[1]
                lowest.append((bench.neighbour(beyond, 1 if after else -1), beyond, _ABOVE_UNDERARM_CM[face]))
        if len(lowest) == 2 and not _lower_middle(bench, lowest):
            return None
        if len(lowest) == 2:
            for edge, seam, _ in lowest:
                _level(bench, edge, seam)
    return bench.pattern()


def _level(bench: Workbench, edge: int, seam: int) -> None:
    """Bends a new edge so that it leaves the middle level: straight, both would meet there in a peak."""
    piece = bench.piece_of(edge)
    chord = piece.chord(edge)
    last = bench.neighbour(edge, 1) == seam
    middle, under = (chord[1], chord[0]) if last else (chord[0], chord[1])
    if piece.panel.to_world(chord)[:, 1].argmax() != int(last):
        return
    way = chord[1] - chord[0]
    control = middle + np.array([_LEVEL_SHARE * (under - middle)[0], 0.0]) - chord[0]
    across = np.array([-way[1], way[0]])
    relative = control @ way / (way @ way), control @ across / (way @ way)
    bench.side(edge).edge = replace(
        bench.side(edge).edge, curve=Quadratic((float(relative[0]), float(relative[1])))
    )


def _cut(bench: Workbench, anatomy: Anatomy, arm: tuple[EdgeRef, ...]) -> tuple[int, int] | None:
    """Takes off what is above one panel's new edge; that edge and the seam in the middle beside it."""
    border = {r for r in (anatomy.top.edges if anatomy.top else ()) if anatomy.part_of(r) is Part.TORSO}
    neck = {bench.at[r] for r in border if r.panel == arm[0].panel}
    holes = {bench.at[r] for r in arm}
    loop = [s.id for s in bench.piece_of(bench.at[arm[0]]).sides]
    gone = neck | holes
    shoulders = [i for i in loop if i not in gone and {bench.neighbour(i, -1), bench.neighbour(i, 1)} <= gone]
    if len(shoulders) != 1 or not neck:
        return None
    gone |= {shoulders[0]}
    starts = [i for i in loop if i in gone and bench.neighbour(i, -1) not in gone]
    if len(starts) != 1 or len(loop) - len(gone) < 3:
        return None
    first = starts[0]
    inward = first in holes
    for id in gone - {first}:
        bench.drop(id)
    side = bench.side(first)
    side.edge = replace(side.edge, curve=Line())
    return first, bench.neighbour(first, 1 if inward else -1)


def _lower_middle(bench: Workbench, cuts: list[tuple[int, int, float]]) -> bool:
    """Lowers the middle of a new edge towards the height of the underarms, on both sides of its seam."""
    edges = {edge for edge, _, _ in cuts}
    (_, one, _), (_, other, _) = cuts
    if bench.partner(one) != other or not all(
        isinstance(bench.side(s).edge.curve, Line) for s in (one, other)
    ):
        return False
    lowered = []
    for edge, seam, above in cuts:
        panel = bench.piece_of(edge).panel
        chord = bench.piece_of(edge).chord(edge)
        at_end = bench.neighbour(edge, 1) == seam
        under, middle = panel.to_world(chord if at_end else chord[::-1])[:, 1]
        lowered.append(middle - under - above)
    distance = min(lowered)
    if distance <= 0.0:
        return True
    for edge, seam, _ in cuts:
        piece = bench.piece_of(seam)
        length = piece.length(seam)
        if length - distance < _LEAST_SEAM_CM:
            return False
        chord = piece.chord(seam)
        if bench.neighbour(edge, 1) == seam:
            bench.side(seam).start = chord[0] + distance * (chord[1] - chord[0]) / length
        else:
            bench.side(edge).start = chord[1] + distance * (chord[0] - chord[1]) / length
    return len(edges) == 2

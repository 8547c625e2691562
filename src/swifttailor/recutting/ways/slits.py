"""Slits: opening seams from the hem up, cutting into a hem, and closing what is open."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import numpy as np

from swifttailor.describing.measuring.parts import Face
from swifttailor.pattern import EdgeRef, Line, Pattern
from swifttailor.pattern import curve as curves
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.ends import find_ends

LEFT_SEWN_CM = 5.0
"""What stays sewn above a slit at least."""
_STRAIGHT_ON = 0.9
"""Cosine of the angle of a joint in a seam."""
MIDDLE_CM = 4.0
"""How far from the middle of the body a slit in front or behind may be."""


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
            return bench.pattern() if _open(bench, seam, height, at_end) else None
    return None


def open_middle(
    pattern: Pattern, hem: Collection[EdgeRef], height: float, face: Face, width: float = 2.0
) -> Pattern | None:
    """Opens a slit in the middle of the front or back: the centre seam, or a cut into the one panel there.

    Args:
        pattern: Any pattern.
        hem: Edges of the hem.
        height: Of the slit, cm.
        face: Front or back.
        width: At the hem where the panel is cut, cm.

    Returns:
        The pattern with the slit; None where there is no place for it.
    """
    bench = Workbench(pattern)
    ends = [e for e in find_ends(bench, pattern, hem) if _on_face(bench, e.panel, face)]
    for end in ends:
        piece = bench.pieces[end.panel]
        for seam, at_end in ((end.before, True), (end.after, False)):
            partner = bench.partner(seam)
            x = float(piece.panel.to_world(piece.chord(seam)[[1 if at_end else 0]])[0, 0])
            if (
                partner is None
                or abs(x) > MIDDLE_CM
                or not _on_face(bench, bench.piece_of(partner).panel.name, face)
            ):
                continue
            return bench.pattern() if _open(bench, seam, height, at_end) else None
    for end in ends:
        for side in end.run:
            if cut_wedge(bench, side, height, width):
                return bench.pattern()
    return None


def close_slits(pattern: Pattern, pairs: Collection[tuple[EdgeRef, EdgeRef]]) -> Pattern:
    """Closes slits: sews the sides of open seams together, fills what is cut into a panel.

    Args:
        pattern: Any pattern.
        pairs: The two sides of each slit; they meet at their upper ends.
    """
    bench = Workbench(pattern)
    for first, second in pairs:
        a, b = bench.at[first], bench.at[second]
        if first.panel != second.panel:
            bench.sew(a, b)
            continue
        if bench.neighbour(b, 1) == a:
            a, b = b, a
        bench.drop(a)
        bench.drop(b)
    return bench.pattern()


def reach_slit(pattern: Pattern, sides: tuple[EdgeRef, EdgeRef], height: float) -> Pattern | None:
    """Makes a slit cut into one panel higher or lower; None for another, or where it is not straight."""
    bench = Workbench(pattern)
    a, b = (bench.at[s] for s in sides)
    if bench.neighbour(b, 1) == a:
        a, b = b, a
    if bench.neighbour(a, 1) != b or not all(isinstance(bench.side(s).edge.curve, Line) for s in (a, b)):
        return None
    piece = bench.piece_of(a)
    middle = (piece.chord(a)[0] + piece.chord(b)[1]) / 2
    up = piece.chord(a)[1] - middle
    bench.side(b).start = middle + height * up / np.hypot(*up)
    return bench.pattern()


def _on_face(bench: Workbench, name: str, face: Face) -> bool:
    return (bench.pieces[name].panel.normal()[2] < 0) == (face == "back")


def cut_wedge(bench: Workbench, side: int, height: float, width: float, *, x: float = 0.0) -> bool:
    """Cuts a narrow wedge into a side of a panel, up from its hem; False where it does not reach there.

    Args:
        bench: Where the panel lies.
        side: Of its hem.
        height: Of the wedge, cm.
        width: At the hem, cm.
        x: Where it is, to the left of the middle of the body, cm.
    """
    piece = bench.piece_of(side)
    name = piece.panel.name
    chord = piece.chord(side)
    length = piece.length(side)
    if length < width + 4.0:
        return False
    shares = np.linspace(0.0, 1.0, 401)
    curve = bench.side(side).edge.curve
    points = curves.evaluate(curve, chord, curves.parameters_by_length(curve, chord, shares))
    away = np.abs(piece.panel.to_world(points)[:, 0] - x)
    at = float(shares[away.argmin()]) * length
    if away.min() > MIDDLE_CM or not width / 2 + 1.0 < at < length - width / 2 - 1.0:
        return False
    right = bench.split(side, (at + width / 2) / length)
    wedge = bench.split(side, (at - width / 2) / (at + width / 2))
    start, end = piece.chord(wedge)
    along = (end - start) / np.hypot(*(end - start))
    turn = 1.0 if bench.pieces[name].panel.signed_area() >= 0 else -1.0
    apex = (start + end) / 2 + height * turn * np.array([-along[1], along[0]])
    bench.side(wedge).edge = replace(bench.side(wedge).edge, curve=Line())
    bench.insert_line(right, apex)
    return True


def _open(bench: Workbench, seam: int, height: float, at_end: bool) -> bool:
    """Unpicks a seam from the hem up, over joints in it; False where too little would stay sewn."""
    step = -1 if at_end else 1
    open_sides: list[tuple[int, int]] = []
    while True:
        partner = bench.partner(seam)
        if partner is None:
            return False
        rest = bench.piece_of(seam).length(seam) - height
        above, beyond = bench.neighbour(seam, step), bench.neighbour(partner, -step)
        goes_on = bench.partner(above) == beyond and _smooth(bench, seam, above, step)
        if rest > (1.0 if goes_on else LEFT_SEWN_CM):
            break
        if not goes_on:
            return False
        open_sides.append((seam, partner))
        seam, height = above, height - bench.piece_of(seam).length(seam)
        if height < 1.0:
            break
    for side, _ in open_sides:
        bench.unpick(side)
    if height < 1.0:
        return True
    partner = bench.partner(seam)
    assert partner is not None
    for id, last in ((seam, at_end), (partner, not at_end)):
        length = bench.piece_of(id).length(id)
        second = bench.split(id, 1 - height / length if last else height / length)
        if not last:
            bench.resew(id, second)
    return True


def _smooth(bench: Workbench, seam: int, above: int, step: int) -> bool:
    """Whether a side goes on where another ends: a joint in a seam, and not the corner of a panel."""
    piece = bench.piece_of(seam)
    first, second = (above, seam) if step < 0 else (seam, above)
    arriving = curves.derivative(bench.side(first).edge.curve, piece.chord(first), [1.0])[0]
    leaving = curves.derivative(bench.side(second).edge.curve, piece.chord(second), [0.0])[0]
    cosine = float(arriving @ leaving) / max(float(np.hypot(*arriving) * np.hypot(*leaving)), 1e-9)
    return cosine > _STRAIGHT_ON

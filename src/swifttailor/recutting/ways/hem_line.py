"""Bending a hem in front and behind, or slanting it from one side to the other."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.describing.measuring.parts import Face
from swifttailor.pattern import Arc, Cubic, EdgeRef, Line, Pattern, Quadratic
from swifttailor.pattern import curve as curves
from swifttailor.recutting.table.workbench import Workbench, bent_arc
from swifttailor.recutting.ways.ends import End, find_ends

_LONGEST_SHARE = 0.6
"""Of a hem, of what one curve follows."""
MIDDLE_CM = 4.0
"""How far from the middle of the body a centre seam may end."""


def bend_hem(pattern: Pattern, hem: Collection[EdgeRef], falls: Mapping[Face, float]) -> Pattern | None:
    """Moves the middle of a hem down in front and behind.

    Args:
        pattern: Any pattern.
        hem: Edges of the hem.
        falls: How much lower the middle is afterwards on each face, cm.

    Returns:
        The recut pattern, side seams as they were; None where the hem does not go from side to side in one
        panel or two halves in front and behind, open slits in them excepted.
    """
    return _move_hem(pattern, hem, _BENT, falls)


def slant_hem(pattern: Pattern, hem: Collection[EdgeRef], fall: float) -> Pattern | None:
    """Moves a hem down on the wearer's left by `fall` cm, and up on the right by as much.

    Returns:
        The recut pattern, its middle in front and behind as it was; None as for `bend_hem`.
    """
    return _move_hem(pattern, hem, _SLANTED, {"front": fall, "back": fall})


@dataclass(frozen=True)
class _Wave:
    """How far a hem moves from the left side (0) to the right side (1) of a face."""

    of: Callable[[Floats], Floats]
    slope: Callable[[Floats], Floats]

    def of_controls(self, start: float, end: float) -> Floats:
        """How far the two controls of a piece move so that it keeps to the wave, its slope included."""
        at = np.array([start, end])
        return self.of(at) + self.slope(at) * (end - start) / 3 * np.array([1.0, -1.0])


_BENT = _Wave(lambda g: np.sin(np.pi * g) ** 2, lambda g: np.pi * np.sin(2 * np.pi * g))
_SLANTED = _Wave(lambda g: np.cos(np.pi * g), lambda g: -np.pi * np.sin(np.pi * g))


def _move_hem(
    pattern: Pattern, hem: Collection[EdgeRef], wave: _Wave, falls: Mapping[Face, float]
) -> Pattern | None:
    bench = Workbench(pattern)
    ends = find_ends(bench, pattern, hem)
    if not ends:
        return None
    for name in dict.fromkeys(e.panel for e in ends):
        row = _row(bench, [e for e in ends if e.panel == name])
        phase = _phase(bench, row) if row else None
        if phase is None:
            return None
        fall = falls["back" if _is_back(bench, row[0].before) else "front"]
        down = -bench.pieces[name].panel.placement.matrix()[1, :2]
        if not fall:
            continue
        piece = bench.pieces[name]
        whole = sum(piece.length(id) for end in row for id in end.run)
        for end in row:
            for id in list(end.run):  # one curve from end to end cannot follow a wave
                if len(end.run) == 1 or piece.length(id) > _LONGEST_SHARE * whole:
                    end.run.insert(end.run.index(id) + 1, bench.split(id, 0.5))
        if not _move_row(bench, row, phase, wave, fall * down):
            return None
    return bench.pattern()


def _is_back(bench: Workbench, side: int) -> bool:
    return bool(bench.piece_of(side).panel.normal()[2] < 0)


def _row(bench: Workbench, ends: list[End]) -> list[End]:
    """The pieces of a panel's hem as they follow each other around it; none unless slits alone part them."""
    if len(ends) == 1:
        return ends
    piece = bench.pieces[ends[0].panel]
    x = [float(piece.panel.to_world(bench.run_chord(e.run))[:, 0].mean()) for e in ends]
    chord = piece.panel.to_world(bench.run_chord(ends[0].run))[:, 0]
    row = [ends[int(k)] for k in np.argsort(x)]
    row = row if chord[1] > chord[0] else row[::-1]
    inner = [s for e, f in itertools.pairwise(row) for s in (e.after, f.before)]
    return row if all(bench.partner(s) is None for s in inner) else []


def _phase(bench: Workbench, row: list[End]) -> tuple[float, float] | None:
    """From where to where a panel's hem goes: 0 is the left side, 1 the right one, a half the middle."""
    chord = np.array([bench.run_chord(row[0].run)[0], bench.run_chord(row[-1].run)[1]])
    x = bench.pieces[row[0].panel].panel.to_world(chord)[:, 0]
    phase = []
    for k, side in enumerate((row[0].before, row[-1].after)):
        partner = bench.partner(side)
        if partner is None:
            centre = abs(x[k]) <= MIDDLE_CM
        else:
            centre = _is_back(bench, side) == _is_back(bench, partner)
        if centre and (abs(x[k]) > MIDDLE_CM or not isinstance(bench.side(side).edge.curve, Line)):
            return None
        phase.append(0.5 if centre else float(x[k] < x[1 - k]))
    return (phase[0], phase[1]) if phase[0] != phase[1] else None


def _move_row(bench: Workbench, row: list[End], phase: tuple[float, float], wave: _Wave, by: Floats) -> bool:
    """Moves the pieces of a hem by a smooth wave."""
    piece = bench.pieces[row[0].panel]
    run = [id for end in row for id in end.run]
    controls = [_controls(bench, id) for id in run]
    if any(c is None for c in controls):
        return False
    lengths = np.array([piece.length(id) for id in run])
    bounds = phase[0] + (phase[1] - phase[0]) * np.concatenate([[0.0], np.cumsum(lengths)]) / lengths.sum()
    where = dict(zip(run, itertools.pairwise(map(float, bounds)), strict=True))
    starts = {id: ends[0] for id, ends in where.items()}
    for end in row:
        starts[bench.neighbour(end.run[-1], 1)] = where[end.run[-1]][1]
    for id, share in starts.items():
        bench.side(id).start = bench.side(id).start + wave.of(np.array([share]))[0] * by
    for id, old in zip(run, controls, strict=True):
        assert old is not None
        chord, side = piece.chord(id), bench.side(id)
        moved = old + np.outer(wave.of_controls(*where[id]), by)
        first, second = (curves.to_relative(p, chord) for p in moved)
        side.edge = replace(side.edge, curve=Cubic(first, second))
    return True


def _controls(bench: Workbench, id: int) -> Floats | None:
    """The two control points (2, 2) of a side as a cubic Bezier curve, local cm."""
    curve, chord = bench.side(id).edge.curve, bench.piece_of(id).chord(id)
    if isinstance(curve, Line):
        return chord[0] + np.outer([1 / 3, 2 / 3], chord[1] - chord[0])
    if isinstance(curve, Arc):
        bent = bent_arc(curve, chord)
        return None if bent is None else curves.control_polygon(bent, chord)[1:-1]
    polygon = curves.control_polygon(curve, chord)
    if isinstance(curve, Quadratic):
        return np.array([polygon[0] + 2 * polygon[1], polygon[2] + 2 * polygon[1]]) / 3
    return polygon[1:-1]

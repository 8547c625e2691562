"""Bending a hem: its middle in front and behind moves up or down, its ends at the side seams stay."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from swifttailor.data.captions.measure.parts import Face
from swifttailor.data.edits.recutting.ends import End, find_ends
from swifttailor.data.edits.recutting.workbench import Workbench, bent_arc
from swifttailor.pattern import Arc, Cubic, EdgeRef, Line, Pattern, Quadratic
from swifttailor.pattern import curve as curves

Floats = NDArray[np.float64]

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
        panel or two halves in front and behind.
    """
    bench = Workbench(pattern)
    ends = find_ends(bench, pattern, hem)
    phases = [_phase(bench, end) for end in ends]
    if len({e.panel for e in ends}) != len(ends) or None in phases:
        return None
    for end, phase in zip(ends, phases, strict=True):
        fall = falls["back" if _is_back(bench, end.before) else "front"]
        run = end.run if len(end.run) > 1 else [end.run[0], bench.split(end.run[0], 0.5)]
        down = -bench.pieces[end.panel].panel.placement.matrix()[1, :2]
        if fall and phase is not None and not _bend(bench, run, phase, fall * down):
            return None
    return bench.pattern()


def _is_back(bench: Workbench, side: int) -> bool:
    return bool(bench.piece_of(side).panel.normal()[2] < 0)


def _phase(bench: Workbench, end: End) -> tuple[float, float] | None:
    """The part of the wave from side seam to side seam that an end takes: all, or half up to the middle."""
    centre = []
    for side in (end.before, end.after):
        partner = bench.partner(side)
        if partner is None:
            return None
        centre.append(_is_back(bench, side) == _is_back(bench, partner))
        if centre[-1] and not isinstance(bench.side(side).edge.curve, Line):
            return None
    x = np.abs(bench.pieces[end.panel].panel.to_world(bench.run_chord(end.run))[:, 0])
    if any(c and x[k] > MIDDLE_CM for k, c in enumerate(centre)) or all(centre):
        return None
    return (0.5 if centre[0] else 0.0), (0.5 if centre[1] else 1.0)


def _bend(bench: Workbench, run: list[int], phase: tuple[float, float], by: Floats) -> bool:
    """Moves a run of sides by a smooth wave: not at all at the side seams, by all of `by` in the middle."""
    piece = bench.piece_of(run[0])
    controls = [_controls(bench, id) for id in run]
    if any(c is None for c in controls):
        return False
    lengths = np.array([piece.length(id) for id in run])
    bounds = phase[0] + (phase[1] - phase[0]) * np.concatenate([[0.0], np.cumsum(lengths)]) / lengths.sum()
    following = bench.neighbour(run[-1], 1)
    moved = [np.outer(_control_shares(bounds[k], bounds[k + 1]), by) for k in range(len(run))]
    for k, id in enumerate([*run, following]):
        bench.side(id).start = bench.side(id).start + _wave(bounds[k : k + 1])[0] * by
    for id, old, shift in zip(run, controls, moved, strict=True):
        assert old is not None
        chord, side = piece.chord(id), bench.side(id)
        first, second = (curves.to_relative(p, chord) for p in old + shift)
        side.edge = replace(side.edge, curve=Cubic(first, second))
    return True


def _wave(shares: Floats) -> Floats:
    return np.sin(np.pi * shares) ** 2


def _control_shares(start: float, end: float) -> Floats:
    """How far the two controls of a piece move so that the piece keeps to the wave, its slope included."""
    slope = np.pi * np.sin(2 * np.pi * np.array([start, end])) * (end - start) / 3
    return _wave(np.array([start, end])) + slope * np.array([1.0, -1.0])


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

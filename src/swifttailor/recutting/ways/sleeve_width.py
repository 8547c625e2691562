"""Making sleeves wider or narrower across, their seams over the arm kept as they are."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.describing.measuring.anatomy import Anatomy
from swifttailor.describing.measuring.parts import Part, Side
from swifttailor.pattern import EdgeRef, Line, Panel, Pattern
from swifttailor.recutting.table.workbench import Workbench

LEAST_CAP_CM = 1.5
LEAST_UNDER_CM = 3.0
"""Of the seam under the arm, measured along the arm."""
_LOWEST, _HIGHEST = 0.05, 4.0
"""Factors of height or width of a cap that are looked at."""
_FLATTEST, _STEEPEST = 0.35, 1.7
"""How much flatter or higher a cap may become for its head to stay as long."""
_HALVINGS = 24
_AS_LONG = 1e-3
"""Difference of a head's length to what is asked for, as a part of it."""


@dataclass(frozen=True)
class Half:
    """Half a sleeve, in front or behind, between the seam over the arm and the one under it."""

    name: str
    origin: Floats
    """(2,) where the seam over the arm meets the armhole, local cm."""
    along: Floats
    """(2,) unit vector along that seam, to the sleeve's end."""
    across: Floats
    """(2,) unit vector towards the seam under the arm."""
    head: tuple[EdgeRef, ...]
    cap: float
    """Where the seam under the arm starts, cm along the arm from the origin."""
    end: float
    """Where it ends."""

    def stretch(self, cap: float, upper: float, end: float) -> _Stretch:
        """What makes it wider: factors of the cap's height, of its width there, of the width of its end."""
        return _Stretch(self, cap, upper, end)


@dataclass(frozen=True)
class _Stretch:
    half: Half
    cap: float
    upper: float
    end: float

    def __call__(self, points: Floats) -> Floats:
        half = self.half
        away = points - half.origin
        u, v = away @ half.along, away @ half.across
        below = np.clip((u - half.cap) / (half.end - half.cap), 0.0, 1.0)
        raised = (self.cap - 1.0) * np.where(u < half.cap, u, half.cap * (1.0 - below))
        widened = v * (self.upper + (self.end - self.upper) * below)
        return half.origin + np.outer(u + raised, half.along) + np.outer(widened, half.across)


def sleeve_halves(anatomy: Anatomy, side: Side) -> tuple[Half, Half] | None:
    """Front and back of a sleeve of two halves; None where it is not cut like that."""
    panels = anatomy.panels(Part.SLEEVE, side)
    if len(panels) != 2:
        return None
    names = {p.name for p in panels}
    sewn = [s.sides for s in anatomy.cloth.stitches if {r.panel for r in s.sides} == names]
    head = anatomy.seam(Part.SLEEVE, Part.TORSO, side).own
    if len(sewn) != 2 or not head:
        return None
    halves = [_half(anatomy, panel, [r for pair in sewn for r in pair], head) for panel in panels]
    return (halves[0], halves[1]) if halves[0] and halves[1] else None


def _half(anatomy: Anatomy, panel: Panel, seams: Sequence[EdgeRef], head: Sequence[EdgeRef]) -> Half | None:
    own = sorted(
        (r for r in seams if r.panel == panel.name),
        key=lambda r: -float(anatomy.cloth.placed([r])[:, 1].mean()),
    )
    caps = tuple(r for r in head if r.panel == panel.name)
    if len(own) != 2 or not caps or not isinstance(panel.edges[own[0].edge].curve, Line):
        return None
    over, under = (panel.chord(r.edge) for r in own)
    corners = np.concatenate([panel.chord(r.edge) for r in caps])

    def outward(chord: Floats) -> Floats:
        """From the armhole to the end."""
        gaps = [float(np.hypot(*(corners - point).T).min()) for point in chord]
        return chord if gaps[0] <= gaps[1] else chord[::-1]

    over, under = outward(over), outward(under)
    length = float(np.hypot(*(over[1] - over[0])))
    if length < LEAST_UNDER_CM:
        return None
    along = (over[1] - over[0]) / length
    across = np.array([-along[1], along[0]])
    across *= np.sign((under.mean(axis=0) - over[0]) @ across) or 1.0
    cap, end = ((point - over[0]) @ along for point in under)
    if cap < LEAST_CAP_CM or end - cap < 1.0:
        return None
    return Half(
        name=panel.name, origin=over[0], along=along, across=across, head=caps, cap=float(cap), end=float(end)
    )


def stretch_sleeves(
    pattern: Pattern, halves: Sequence[Half], upper: float, end: float, cap: float = 1.0
) -> Pattern | None:
    """Makes sleeves wider or narrower.

    Args:
        pattern: The pattern that the halves are of.
        halves: Both of every sleeve.
        upper: New width at the underarm over old.
        end: New width of the end over old.
        cap: New height of the cap over old.

    Returns:
        The recut pattern; the seams over the arm stay, those under it change alike in front and behind.
        None where too little of the cap or of the seam under the arm is left.
    """
    bench = Workbench(pattern)
    for half in halves:
        if half.cap * cap < LEAST_CAP_CM or half.end - half.cap * cap < min(
            LEAST_UNDER_CM, half.end - half.cap
        ):
            return None
        ids = {s.id for s in bench.pieces[half.name].sides}
        if not bench.map_points(half.name, half.stretch(cap, upper, end), ids, bend_arcs=True):
            return None
    return bench.pattern()


def keep_heads(pattern: Pattern, halves: Sequence[Half], upper: float, end: float) -> Pattern | None:
    """Makes sleeves wider or narrower, their caps so much flatter or higher that the heads stay as long.

    Args:
        pattern: The pattern that the halves are of.
        halves: Both of every sleeve.
        upper: New width at the underarm over old.
        end: New width of the end over old.
    """
    high = _solve(pattern, halves, 1.0, lambda x: (x, upper))
    if high is None or not _FLATTEST <= high <= _STEEPEST:
        return None
    return stretch_sleeves(pattern, halves, upper, end, high)


def gather_heads(
    pattern: Pattern, halves: Sequence[Half], factor: float, end: Callable[[float], float]
) -> Pattern | None:
    """Makes the heads of sleeves longer or shorter by making the sleeves wider or narrower.

    Args:
        pattern: The pattern that the halves are of.
        halves: Both of every sleeve.
        factor: New length of the heads over old.
        end: New width of the end over old, of that at the underarm.
    """
    wide = _solve(pattern, halves, factor, lambda x: (1.0, x))
    return None if wide is None else stretch_sleeves(pattern, halves, wide, end(wide))


def _solve(
    pattern: Pattern, halves: Sequence[Half], factor: float, shape: Callable[[float], tuple[float, float]]
) -> float | None:
    """Finds where heads become longer by a factor; `shape` is their height and width over the old ones."""
    heads = Pattern(tuple(pattern.panel(h.name) for h in halves), ())

    def length(x: float) -> float:
        bench, (high, wide) = Workbench(heads), shape(x)
        for half in halves:
            ids = {s.id for s in bench.pieces[half.name].sides}
            bench.map_points(half.name, half.stretch(high, wide, wide), ids, bend_arcs=True)
        return sum(bench.piece_of(bench.at[r]).length(bench.at[r]) for half in halves for r in half.head)

    wanted = factor * sum(pattern.edge_length(r) for half in halves for r in half.head)
    low, high = _LOWEST, _HIGHEST
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if length(middle) < wanted else (low, middle)
    found = (low + high) / 2
    return found if abs(length(found) - wanted) < _AS_LONG * wanted else None

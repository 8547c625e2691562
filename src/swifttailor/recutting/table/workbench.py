"""A pattern taken apart for recutting: edges keep their stitches while vertices and edges come and go."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from swifttailor.arrays import Floats
from swifttailor.pattern import Arc, Cubic, EdgeRef, Line, Panel, Pattern, Quadratic, Stitch
from swifttailor.pattern import curve as curves
from swifttailor.pattern.panel import Edge

MOST_SWEEP = 2.1
"""Radians of an arc that one Bezier curve can take the place of."""


@dataclass
class Side:
    """An edge on the bench: it starts at its own vertex and ends at that of the next side."""

    id: int
    start: Floats
    """(2,) local cm."""
    edge: Edge


@dataclass
class Piece:
    """A panel on the bench."""

    panel: Panel
    """As it was; its name, label and placement count."""
    sides: list[Side]

    def index(self, id: int) -> int:
        """Where a side stands in the loop."""
        return next(k for k, s in enumerate(self.sides) if s.id == id)

    def end(self, id: int) -> Floats:
        """End (2,) of a side, local cm."""
        return self.sides[(self.index(id) + 1) % len(self.sides)].start

    def chord(self, id: int) -> Floats:
        """Start and end (2, 2) of a side, local cm."""
        return np.array([self.sides[self.index(id)].start, self.end(id)])

    def length(self, id: int) -> float:
        """Arc length of a side, cm."""
        return curves.length(self.sides[self.index(id)].edge.curve, self.chord(id))


class Workbench:
    """Panels whose sides can be moved, cut and sewn, and made into a pattern again."""

    def __init__(self, pattern: Pattern) -> None:
        self._from = pattern
        self._ids = itertools.count()
        self.pieces: dict[str, Piece] = {}
        self._of_side: dict[int, str] = {}
        at: dict[EdgeRef, int] = {}
        for panel in pattern.panels:
            self._lay(panel)
            for k, side in enumerate(self.pieces[panel.name].sides):
                at[EdgeRef(panel.name, k)] = side.id
        self.at = at
        """Side of every edge of the pattern as it came."""
        self.seams: list[tuple[int, int, bool]] = [
            (at[s.first], at[s.second], s.right_wrong)
            for s in pattern.stitches
            if s.first in at and s.second in at
        ]

    def pattern(self) -> Pattern:
        """What lies on the bench, as a pattern in canonical order."""
        where, panels = {}, []
        for name, piece in self.pieces.items():
            where.update({side.id: EdgeRef(name, k) for k, side in enumerate(piece.sides)})
            vertices = np.array([s.start for s in piece.sides])
            panels.append(replace(piece.panel, vertices=vertices, edges=tuple(s.edge for s in piece.sides)))
        stitches = tuple(
            Stitch(where[a], where[b], turned) for a, b, turned in self.seams if a in where and b in where
        )
        return replace(self._from, panels=tuple(panels), stitches=stitches).canonical()

    def piece_of(self, id: int) -> Piece:
        """The panel that a side belongs to."""
        return self.pieces[self._of_side[id]]

    def partner(self, id: int) -> int | None:
        """The side that a side is sewn to."""
        for a, b, _ in self.seams:
            if id in (a, b):
                return b if id == a else a
        return None

    def add(self, panel: Panel) -> list[int]:
        """Lays another panel; returns its sides."""
        self._lay(panel)
        return [s.id for s in self.pieces[panel.name].sides]

    def remove(self, names: Collection[str]) -> None:
        """Takes panels away; what was sewn to them becomes free."""
        gone = {s.id for n in names for s in self.pieces[n].sides}
        for name in names:
            del self.pieces[name]
        self.seams = [s for s in self.seams if s[0] not in gone and s[1] not in gone]

    def sew(self, a: int, b: int, *, right_wrong: bool = False) -> None:
        """Sews two sides, start to end; start to start where a right side lies on a wrong one."""
        self.seams.append((a, b, right_wrong))

    def resew(self, old: int, new: int) -> None:
        """Lets another side take the place of one in its seam."""
        self.seams = [(new if a == old else a, new if b == old else b, turned) for a, b, turned in self.seams]

    def unpick(self, id: int) -> None:
        """Opens the seam of a side."""
        self.seams = [s for s in self.seams if id not in s[:2]]

    def split(self, id: int, fraction: float) -> int:
        """Cuts a side at a fraction of its length; returns the new second part. Its seam is not cut."""
        piece = self.piece_of(id)
        k = piece.index(id)
        side, chord = piece.sides[k], piece.chord(id)
        t = float(curves.parameters_by_length(side.edge.curve, chord, [fraction])[0])
        first, second, point = curves.split(side.edge.curve, chord, t)
        new = Side(next(self._ids), point, replace(side.edge, curve=second))
        side.edge = replace(side.edge, curve=first)
        piece.sides.insert(k + 1, new)
        self._of_side[new.id] = piece.panel.name
        return new.id

    def drop(self, id: int) -> None:
        """Takes a side out of its loop; the one before then ends where it ended."""
        piece = self.piece_of(id)
        piece.sides.pop(piece.index(id))
        del self._of_side[id]
        self.unpick(id)

    def insert_line(self, before: int, start: ArrayLike) -> int:
        """Puts a straight side into the loop that starts at `start` and ends where side `before` starts."""
        piece = self.piece_of(before)
        new = Side(next(self._ids), np.asarray(start, np.float64), Edge(Line()))
        piece.sides.insert(piece.index(before), new)
        self._of_side[new.id] = piece.panel.name
        return new.id

    def map_run(self, run: Sequence[int], old: ArrayLike, new: ArrayLike) -> None:
        """Moves a run of sides by the similarity that takes its old start and end to new ones.

        Shapes stay similar: Bezier curves follow by themselves, radii of arcs are scaled.

        Args:
            run: Sides that follow each other.
            old: Start and end (2, 2) that belong to the inner starts as they are, local cm.
            new: Start and end (2, 2) to be, local cm.
        """
        piece = self.piece_of(run[0])
        old, new = np.asarray(old, np.float64), np.asarray(new, np.float64)
        scale = float(np.hypot(*(new[1] - new[0])) / np.hypot(*(old[1] - old[0])))
        inner = [curves.to_relative(piece.sides[piece.index(i)].start, old) for i in run[1:]]
        for id in run:
            side = piece.sides[piece.index(id)]
            side.edge = replace(side.edge, curve=curves.scale(side.edge.curve, scale))
        piece.sides[piece.index(run[0])].start = new[0]
        piece.sides[(piece.index(run[-1]) + 1) % len(piece.sides)].start = new[1]
        for id, relative in zip(run[1:], inner, strict=True):
            piece.sides[piece.index(id)].start = curves.to_absolute(relative, new)

    def run_chord(self, run: Sequence[int]) -> Floats:
        """Start and end (2, 2) of a run of sides, local cm."""
        piece = self.piece_of(run[0])
        return np.array([piece.sides[piece.index(run[0])].start, piece.end(run[-1])])

    def side(self, id: int) -> Side:
        """A side by its id."""
        piece = self.piece_of(id)
        return piece.sides[piece.index(id)]

    def neighbour(self, id: int, step: int) -> int:
        """The side `step` further along the loop."""
        piece = self.piece_of(id)
        return piece.sides[(piece.index(id) + step) % len(piece.sides)].id

    def map_points(
        self,
        name: str,
        function: Callable[[Floats], Floats],
        ids: Collection[int],
        *,
        bend_arcs: bool = False,
    ) -> bool:
        """Moves the starts of some sides by a function of local points, curves of sides between them too.

        Args:
            name: Of the panel.
            function: New points (n, 2) of old ones.
            ids: Sides whose starts move.
            bend_arcs: Whether arcs that do not move as they are become Bezier curves, as far as they can.

        Returns:
            False, with nothing changed, where an arc would have to become an ellipse.
        """
        piece = self.pieces[name]
        count = len(piece.sides)
        moved = [s.id in ids for s in piece.sides]
        between = [k for k in range(count) if moved[k] and moved[(k + 1) % count]]
        arcs = [k for k in between if isinstance(piece.sides[k].edge.curve, Arc)]
        if arcs and not bend_arcs:
            return False
        bent = {
            k: c
            for k in arcs
            if not _shifted(piece.chord(piece.sides[k].id), function)
            for c in [_bent(piece, k)]
        }
        if None in bent.values():
            return False
        for k, curve in bent.items():
            if curve is not None:
                piece.sides[k].edge = replace(piece.sides[k].edge, curve=curve)
        polygons = {}
        for k in between:
            side = piece.sides[k]
            if not isinstance(side.edge.curve, Line | Arc):
                polygons[k] = curves.control_polygon(side.edge.curve, piece.chord(side.id))[1:-1]
        for k, side in enumerate(piece.sides):
            if moved[k]:
                side.start = np.asarray(function(side.start[None]), np.float64)[0]
        for k, controls in polygons.items():
            side = piece.sides[k]
            chord = piece.chord(side.id)
            relative = [curves.to_relative(p, chord) for p in function(controls)]
            curve = Quadratic(relative[0]) if len(relative) == 1 else Cubic(relative[0], relative[1])
            side.edge = replace(side.edge, curve=curve)
        return True

    def shift(self, names: Collection[str], by: ArrayLike) -> None:
        """Moves the placement of panels by (3,) cm."""
        for name in names:
            piece = self.pieces[name]
            x, y, z = np.add(piece.panel.placement.translation, by)
            placement = replace(piece.panel.placement, translation=(float(x), float(y), float(z)))
            piece.panel = replace(piece.panel, placement=placement)

    def relabel(self, id: int, label: str) -> None:
        """Gives a side another attachment label."""
        side = self.piece_of(id).sides[self.piece_of(id).index(id)]
        side.edge = replace(side.edge, label=label)

    def _lay(self, panel: Panel) -> None:
        sides = [Side(next(self._ids), panel.vertices[k].copy(), edge) for k, edge in enumerate(panel.edges)]
        self.pieces[panel.name] = Piece(panel, sides)
        self._of_side.update({s.id: panel.name for s in sides})


def _shifted(chord: Floats, function: Callable[[Floats], Floats]) -> bool:
    """Whether a function moves both ends of a chord alike."""
    return bool(np.abs(np.diff(function(chord) - chord, axis=0)).max() < 1e-6)


def bent_arc(arc: Arc, chord: Floats) -> Cubic | None:
    """A Bezier curve close to an arc, to a hundredth of its radius; None where it sweeps too far."""
    sweep = curves.length(arc, chord) / arc.radius
    if sweep > MOST_SWEEP:
        return None
    tangents = curves.derivative(arc, chord, [0.0, 1.0])
    tangents = tangents / np.hypot(*tangents.T)[:, None]
    reach = 4.0 / 3.0 * np.tan(sweep / 4.0) * arc.radius
    controls = chord[0] + reach * tangents[0], chord[1] - reach * tangents[1]
    return Cubic(curves.to_relative(controls[0], chord), curves.to_relative(controls[1], chord))


def _bent(piece: Piece, k: int) -> Cubic | None:
    side = piece.sides[k]
    assert isinstance(side.edge.curve, Arc)
    return bent_arc(side.edge.curve, piece.chord(side.id))

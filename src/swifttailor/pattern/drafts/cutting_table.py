"""Where drafted outlines become placed panels and are sewn together by the names of their edges."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from swifttailor.errors import PatternError
from swifttailor.pattern.drafts.outline import Outline, Side
from swifttailor.pattern.names import canonical_key
from swifttailor.pattern.panel import Edge, Panel, Placement
from swifttailor.pattern.pattern import EdgeRef, Pattern, Stitch

SAME_POINT_CM = 1e-3
"""Seam points closer than this on both sides are one point."""
GATHER_SNAP = 0.01
"""On a gathered seam, points closer than this fraction of the seam are sewn together as they are."""


@dataclass
class Piece:
    """An outline with a name, a place and a body part."""

    name: str
    sides: list[Side]
    placement: Placement
    label: str

    def find(self, name: str) -> list[Side]:
        """The edges of that name, in loop order."""
        found = [s for s in self.sides if s.name == name]
        if not found:
            raise KeyError(f"panel '{self.name}' has no edge '{name}', only {[s.name for s in self.sides]}")
        if self.sides[0].name == name and self.sides[-1].name == name and len(found) < len(self.sides):
            first = next(k for k, s in enumerate(self.sides) if s.name != name)
            found = found[first:] + found[:first]
        return found

    def length(self, name: str) -> float:
        """Length of all edges of that name together, cm."""
        return sum(s.length for s in self.find(name))


class CuttingTable:
    """Collects pieces and seams and makes the pattern of them."""

    def __init__(self, name: str, cloth_stretch: float = 0.0) -> None:
        self.name = name
        self.cloth_stretch = cloth_stretch
        """See `Pattern.cloth_stretch`."""
        self.pieces: dict[str, Piece] = {}
        self._stitches: list[tuple[int, int]] = []
        self._folded: set[tuple[int, int]] = set()
        """Those of the stitches whose edges run the same way."""
        self._labels: dict[int, str] = {}

    def lay(
        self,
        name: str,
        outline: Outline,
        *,
        label: str,
        at: tuple[float, float, float] = (0.0, 0.0, 0.0),
        rotation: tuple[float, float, float] = (0.0, 0.0, 0.0),
        back: bool = False,
    ) -> Piece:
        """Adds a panel and sews its darts.

        Args:
            name: GarmentCode's panel name.
            outline: A closed counter-clockwise outline, local cm.
            label: Body part: ``body``, ``arm`` or ``leg``.
            at: World position of the local origin, cm.
            rotation: Degrees about x, y, z.
            back: Turn the loop, so that the right side of the cloth faces the other way.
        """
        sides = [s.reversed() for s in reversed(outline.sides)] if back else list(outline.sides)
        self.pieces[name] = Piece(name, sides, Placement(at, rotation), label)
        self._stitches += outline.darts
        return self.pieces[name]

    def label(self, edge: str, label: str) -> None:
        """Puts an attachment label on an edge given as ``panel.edge``."""
        piece, name = self._resolve(edge)
        for side in piece.find(name):
            self._labels[side.serial] = label

    def length(self, *edges: str) -> float:
        """Length of edges given as ``panel.edge`` together, cm."""
        return sum(piece.length(name) for piece, name in map(self._resolve, edges))

    def seam(
        self,
        first: str | list[str],
        second: str | list[str],
        *,
        gathered: bool = False,
        folded: bool = False,
    ) -> None:
        """Sews two chains of edges, cutting edges where the other side has a seam (T-joints).

        Args:
            first: ``panel.edge`` or a list of them, in the order of travel along their loops.
            second: What they are sewn to, in the order met on that way (against their loops).
            gathered: Whether the lengths may differ; fullness is then spread evenly.
            folded: Whether one side lies folded upon the other, so that both chains run the same way.

        Raises:
            PatternError: The lengths differ by more than 0.1 % and the seam is not gathered.
        """
        first, second = ([c] if isinstance(c, str) else c for c in (first, second))
        ours = [(p, s) for p, n in map(self._resolve, first) for s in p.find(n)]
        way = list if folded else reversed
        theirs = [(p, s) for p, n in map(self._resolve, second) for s in way(p.find(n))]
        lengths = [sum(s.length for _, s in chain) for chain in (ours, theirs)]
        if not gathered and abs(lengths[0] - lengths[1]) > 1e-3 * max(lengths):
            raise PatternError(
                f"Draft '{self.name}': the seam {'+'.join(first)} is {lengths[0]:.2f} cm long and "
                f"{'+'.join(second)} is {lengths[1]:.2f} cm. Only gathered seams may differ."
            )
        tolerance = GATHER_SNAP if gathered else SAME_POINT_CM / max(lengths)
        our_stops, their_stops = _stops(ours), _stops(theirs)
        our_cuts, their_cuts = _missing_joints(our_stops, their_stops, tolerance)
        ours = self._cut(ours, our_stops, our_cuts, against=False)
        theirs = self._cut(theirs, their_stops, their_cuts, against=not folded)
        assert len(ours) == len(theirs), "both sides of a seam have the same joints"
        stitches = [(a.serial, b.serial) for (_, a), (_, b) in zip(ours, theirs, strict=True)]
        self._stitches += stitches
        self._folded.update(stitches if folded else ())

    def cut_seam(self, edge: str, fraction: float) -> None:
        """Cuts an edge that is sewn in one, and what it is sewn to, at a fraction of the edge's length."""
        piece, name = self._resolve(edge)
        (side,) = piece.find(name)
        self.cut_side(piece, side, fraction)

    def cut_side(self, piece: Piece, side: Side, fraction: float) -> None:
        """Cuts one edge of a piece, and what it may be sewn to, at a fraction of the edge's length."""
        seams = [k for k, pair in enumerate(self._stitches) if side.serial in pair]
        ours = self._cut([(piece, side)], [0.0, 1.0], [fraction], against=False)
        if not seams:
            return
        pair = self._stitches.pop(seams[0])
        (partner,) = {*pair} - {side.serial}
        other, twin = next((p, s) for p in self.pieces.values() for s in p.sides if s.serial == partner)
        theirs = self._cut([(other, twin)], [0.0, 1.0], [fraction], against=pair not in self._folded)
        stitches = [(a.serial, b.serial) for (_, a), (_, b) in zip(ours, theirs, strict=True)]
        self._stitches += stitches
        self._folded.update(stitches if pair in self._folded else ())

    def replace_sides(self, piece: Piece, at: int, count: int, new: list[Side]) -> None:
        """Puts other edges in the place of some that follow each other; seams of these are undone."""
        gone = {side.serial for side in piece.sides[at : at + count]}
        piece.sides[at : at + count] = new
        self._stitches = [pair for pair in self._stitches if not gone.intersection(pair)]

    def mirror(self) -> None:
        """Adds the right-hand twin of every left-hand piece, and of every seam between left-hand pieces."""
        twins: dict[int, int] = {}
        for piece in list(self.pieces.values()):
            name = _right_name(piece.name)
            if name == piece.name:
                continue
            sides = []
            for side in reversed(piece.sides):
                twin = side.mirrored()
                twins[side.serial] = twin.serial
                if side.serial in self._labels:
                    self._labels[twin.serial] = _right_name(self._labels[side.serial])
                sides.append(twin)
            (x, y, z), (a, b, c) = piece.placement.translation, piece.placement.rotation
            self.pieces[name] = Piece(name, sides, Placement((-x, y, z), (a, -b, -c)), piece.label)
        reflected = {
            pair: (twins[pair[0]], twins[pair[1]]) for pair in self._stitches if twins.keys() >= {*pair}
        }
        self._stitches += reflected.values()
        self._folded |= {twin for pair, twin in reflected.items() if pair in self._folded}

    def finish(self) -> Pattern:
        """The pattern: every panel's first corner in its local origin, names in canonical order."""
        where = {
            side.serial: EdgeRef(piece.name, k)
            for piece in self.pieces.values()
            for k, side in enumerate(piece.sides)
        }
        stitches = tuple(
            Stitch(where[a], where[b], right_wrong=(a, b) in self._folded) for a, b in self._stitches
        )
        panels = sorted(map(self._panel, self.pieces.values()), key=lambda p: canonical_key(p.name))
        pattern = Pattern(tuple(panels), stitches, self.name, cloth_stretch=self.cloth_stretch)
        return pattern.canonical()

    def _panel(self, piece: Piece) -> Panel:
        vertices = np.array([s.start for s in piece.sides])
        origin = piece.placement.apply(vertices[:1])[0]
        x, y, z = (float(v) for v in origin)
        edges = tuple(Edge(s.curve, self._labels.get(s.serial, "")) for s in piece.sides)
        return Panel(
            piece.name,
            vertices - vertices[0],
            edges,
            replace(piece.placement, translation=(x, y, z)),
            piece.label,
        )

    def _resolve(self, edge: str) -> tuple[Piece, str]:
        panel, _, name = edge.partition(".")
        return self.pieces[panel], name

    def _cut(
        self,
        chain: list[tuple[Piece, Side]],
        stops: list[float],
        cuts: list[float],
        *,
        against: bool,
    ) -> list[tuple[Piece, Side]]:
        """Cuts the edges of a chain, whose joints lie at `stops`, at fractions `cuts` of its length."""
        result: list[tuple[Piece, Side]] = []
        for (piece, side), low, high in zip(chain, stops[:-1], stops[1:], strict=True):
            inside = [(f - low) / (high - low) for f in cuts if low < f < high]
            if not inside:
                result.append((piece, side))
                continue
            if against:
                inside = [1 - f for f in reversed(inside)]
            parts = side.split(inside)
            at = piece.sides.index(side)
            piece.sides[at : at + 1] = parts
            if side.serial in self._labels:
                label = self._labels.pop(side.serial)
                self._labels.update({part.serial: label for part in parts})
            result += [(piece, part) for part in (reversed(parts) if against else parts)]
        return result


def _stops(chain: list[tuple[Piece, Side]]) -> list[float]:
    """Joints of a chain as fractions of its length, 0 and 1 included."""
    lengths = np.array([s.length for _, s in chain])
    stops = np.concatenate([[0.0], np.cumsum(lengths)]) / lengths.sum()
    return [*map(float, stops[:-1]), 1.0]


def _missing_joints(
    ours: list[float], theirs: list[float], tolerance: float
) -> tuple[list[float], list[float]]:
    """Where each side must be cut so that both have a joint wherever one has: (our cuts, their cuts)."""
    pairs = sorted((abs(a - b), i, j) for i, a in enumerate(ours) for j, b in enumerate(theirs))
    free_ours, free_theirs = set(range(len(ours))), set(range(len(theirs)))
    for distance, i, j in pairs:
        if distance <= tolerance and i in free_ours and j in free_theirs:
            free_ours.remove(i)
            free_theirs.remove(j)
    return sorted(theirs[j] for j in free_theirs), sorted(ours[i] for i in free_ours)


def _right_name(name: str) -> str:
    """The wearer's right-hand twin of a left-hand panel name or label; other names stay."""
    if name.startswith("pant_"):
        return "_".join("r" if part == "l" else part for part in name.split("_"))
    return name.replace("left_", "right_")


def turned(outline: Outline, degrees: float) -> Outline:
    """The outline turned about the local origin, for a panel whose placement turns it back."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))

    def turn(p: tuple[float, float]) -> tuple[float, float]:
        return c * p[0] - s * p[1], s * p[0] + c * p[1]

    outline.sides = [replace(side, start=turn(side.start), end=turn(side.end)) for side in outline.sides]
    return outline

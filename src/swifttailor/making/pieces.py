"""Pieces to cut: what lies on the table, with allowance, notches, grain and marks."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.making.allowances import Allowances, EdgeKind
from swifttailor.making.cut_line import CutLine, Run, cut_line
from swifttailor.making.darts import dart_peak
from swifttailor.making.finished_measures import wearer_findings
from swifttailor.making.notches import Notch, NotchPair, pair_notches, panel_notches
from swifttailor.making.overlaps import overlap_findings
from swifttailor.making.piece_names import piece_names
from swifttailor.making.seams import Seam, find_seams, gather
from swifttailor.making.sewn_pattern import FlatPanel, SewnPattern, read_pattern
from swifttailor.making.twins import Match, Shape, along, on_edge
from swifttailor.pattern import EdgeRef, Finding, Pattern

FOLD_FROM_CM = 20.0
"""From this width on, pieces that are their own mirror image are cut on the fold; others are drawn whole."""


@dataclass(frozen=True, eq=False)
class PlacedNotch:
    """A notch where it is drawn."""

    point: Floats
    """(2,) on the sew line, cm."""
    outward: Floats
    """(2,) unit vector out of the piece."""
    depth: float
    """Of the allowance there, cm."""
    teeth: int


@dataclass(frozen=True, eq=False)
class DartMark:
    """A dart as it is drawn: two legs to a point."""

    legs: tuple[Floats, Floats]
    """Polylines, both from the mouth to the point, cm."""


@dataclass(frozen=True, eq=False)
class EdgeMark:
    """What is to be done with an edge."""

    points: Floats
    """The edge, cm."""
    text: str
    """``gather to 23.1 cm``."""


@dataclass(frozen=True, eq=False)
class SeamMark:
    """The numbers of an edge's seams: several where panels that are cut alike are sewn differently."""

    numbers: tuple[int, ...]
    point: Floats
    """(2,) middle of the edge, cm."""
    inward: Floats
    """(2,) unit vector into the piece."""
    length: float
    """Of the edge, cm."""


@dataclass(frozen=True, eq=False)
class Piece:
    """One shape to cut, once or several times. Seen from the right side, grain upright, y up, cm."""

    name: str
    panels: tuple[str, ...]
    """Panels of the pattern that are cut as drawn."""
    mirrored: tuple[str, ...]
    """Panels that are cut with the drawing turned over."""
    runs: tuple[Run, ...]
    """The sew line."""
    cut: CutLine
    notches: tuple[PlacedNotch, ...]
    darts: tuple[DartMark, ...]
    edge_marks: tuple[EdgeMark, ...]
    seam_marks: tuple[SeamMark, ...]
    symmetric: bool
    """Whether it is its own mirror image, at x = `middle`."""
    middle: float
    size: str = ""
    """Name of the size, where a file holds several."""

    @property
    def sew_line(self) -> Floats:
        """Closed polyline (n, 2), cm."""
        return np.concatenate([r.points[:-1] for r in self.runs])

    @property
    def count(self) -> int:
        """How many are cut in all."""
        return len(self.panels) + len(self.mirrored)

    @property
    def box(self) -> Floats:
        """[[min x, min y], [max x, max y]] of the cut line, cm."""
        return np.array([self.cut.outline.min(axis=0), self.cut.outline.max(axis=0)])

    @property
    def on_fold(self) -> bool:
        """Whether half of it is drawn, to be cut on the fold of the cloth."""
        return self.symmetric and float(np.ptp(self.box[:, 0])) >= FOLD_FROM_CM

    @property
    def instruction(self) -> str:
        """How often and how it is cut, in words."""
        if self.on_fold:
            return f"Cut {self.count} on the fold"
        if self.symmetric or not self.mirrored:
            return f"Cut {self.count}"
        if len(self.panels) == len(self.mirrored):
            return (
                f"Cut {self.count}, mirrored"
                if self.count == 2
                else f"Cut {self.count}, half of them mirrored"
            )
        return f"Cut {self.count}, {len(self.mirrored)} of them mirrored"

    @property
    def grain(self) -> Floats:
        """Ends (2, 2) of the grain line, cm."""
        low, high = self.box
        if self.on_fold:
            choices = [self.middle + share * (high[0] - self.middle) for share in (0.8, 0.7, 0.3)]
        else:
            choices = [low[0] + share * (high[0] - low[0]) for share in (0.3, 0.7, 0.25, 0.75)]
        spans = [(x, *_inside_span(self.cut.outline, x)) for x in choices]
        longest = max(top - bottom for _, bottom, top in spans)
        # The first that is about as long as any: beside the label, which stands in the middle.
        x, *span = next(s for s in spans if s[2] - s[1] > 0.75 * longest)
        inset = 0.2 * (span[1] - span[0])
        return np.array([[x, span[0] + inset], [x, span[1] - inset]])


@dataclass(frozen=True, eq=False)
class CuttingPlan:
    """All pieces of a pattern and how they are sewn together."""

    sewn: SewnPattern
    pieces: tuple[Piece, ...]
    seams: tuple[Seam, ...]
    pairs: tuple[NotchPair, ...]
    allowances: Allowances
    findings: tuple[Finding, ...]

    @property
    def name(self) -> str:
        """Of the pattern."""
        return self.sewn.pattern.name

    def piece_of(self, panel: str) -> Piece:
        """The piece that a panel is cut from."""
        return next(p for p in self.pieces if panel in (*p.panels, *p.mirrored))


def cutting_plan(
    pattern: Pattern,
    allowances: Allowances | None = None,
    *,
    alike: Collection[frozenset[str]] | None = None,
) -> CuttingPlan:
    """Makes pieces to cut from a pattern.

    Args:
        pattern: A pattern placed around a body.
        allowances: Around each kind of edge; usual ones when None.
        alike: Sets of panels that may become one piece where they are alike; all may when None.

    Raises:
        PatternError: It cannot be cut or sewn.
    """
    allowances = allowances or Allowances()
    sewn = read_pattern(pattern)
    pairs = pair_notches(sewn)
    notches = panel_notches(sewn, pairs)
    marks = {p.name: _edge_marks(sewn, p) for p in sewn.panels}
    shapes = {p.name: Shape.of(p, notches[p.name], tuple(m[0] for m in marks[p.name])) for p in sewn.panels}
    groups = _group(sewn.panels, shapes, alike)
    names = piece_names([[sewn.panel(n).placed for n, _ in group] for group in groups])
    own_mirrors = {name: shape.onto(shape, mirrored=True) for name, shape in shapes.items()}
    seams = _numbered(sewn, find_seams(sewn), groups, own_mirrors)
    numbers = {
        ref: seam.number for seam in seams for k in seam.stitches for ref in sewn.pattern.stitches[k].sides
    }
    pieces, findings = [], wearer_findings(pattern)
    for name, group in zip(names, groups, strict=True):
        panel = sewn.panel(group[0][0])
        runs = _runs(sewn, panel, allowances)
        outline = cut_line(runs)
        piece = Piece(
            name,
            tuple(n for n, match in group if not match.mirrored),
            tuple(n for n, match in group if match.mirrored),
            runs,
            outline,
            _placed(notches[panel.name], sewn, panel, allowances),
            tuple(
                DartMark((panel.edges[d.leg_in], panel.edges[d.leg_out][::-1]))
                for d in sewn.darts
                if d.panel == panel.name
            ),
            tuple(EdgeMark(panel.edges[k], text) for k, (_, text) in enumerate(marks[panel.name]) if text),
            _seam_marks(panel, group, numbers),
            own_mirrors[panel.name] is not None,
            float(panel.outline[:, 0].min() + panel.outline[:, 0].max()) / 2,
        )
        pieces.append(piece)
        findings += overlap_findings(name, panel.name, runs, outline)
    return CuttingPlan(sewn, tuple(pieces), seams, pairs, allowances, tuple(findings))


def _group(
    panels: Sequence[FlatPanel], shapes: dict[str, Shape], alike: Collection[frozenset[str]] | None
) -> list[list[tuple[str, Match]]]:
    """Panels by the piece they are cut from, each with how it lies on the first of its group."""
    groups: list[list[tuple[str, Match]]] = []
    parts = {p.name: p.placed.part for p in panels}
    for panel in panels:
        shape = shapes[panel.name]
        for group in groups:
            first = shapes[group[0][0]]
            if parts[panel.name] is not parts[group[0][0]]:
                continue
            if alike is not None and not any({panel.name, group[0][0]} <= own for own in alike):
                continue
            match = shape.onto(first, mirrored=False) or shape.onto(first, mirrored=True)
            if match is not None:
                group.append((panel.name, match))
                break
        else:
            groups.append([(panel.name, Match(False, 0))])
    return groups


def _numbered(
    sewn: SewnPattern,
    seams: Sequence[Seam],
    groups: Sequence[Sequence[tuple[str, Match]]],
    own_mirrors: Mapping[str, Match | None],
) -> tuple[Seam, ...]:
    """Gives seams numbers in the order of sewing; those between the same edges of the same pieces share one.

    Both halves of a piece that is its own mirror image count as the same edges.
    """
    place = {name: (k, match) for k, group in enumerate(groups) for name, match in group}

    def on_piece(ref: EdgeRef) -> tuple[int, int]:
        piece, match = place[ref.panel]
        count = len(sewn.panel(ref.panel).edges)
        edge = on_edge(match, ref.edge, count)
        own = own_mirrors[groups[piece][0][0]]
        return piece, edge if own is None else min(edge, on_edge(own, edge, count))

    known: dict[frozenset[frozenset[tuple[int, int]]], int] = {}
    numbered = []
    for seam in seams:
        key = frozenset(
            frozenset(on_piece(ref) for ref in sewn.pattern.stitches[k].sides) for k in seam.stitches
        )
        numbered.append(replace(seam, number=known.setdefault(key, len(known) + 1)))
    return tuple(numbered)


def _edge_marks(sewn: SewnPattern, panel: FlatPanel) -> list[tuple[str, str]]:
    """Of every edge, what must agree between twins, and the text that is printed."""
    marks = []
    for k, length in enumerate(panel.lengths):
        ref = EdgeRef(panel.name, k)
        partner = sewn.partner.get(ref)
        kind = gather(length, sewn.length(partner)) if partner and panel.kinds[k] is EdgeKind.SEAM else ""
        to = round(sewn.length(partner), 1) if partner and kind else 0.0
        text = {"gather": f"gather to {to:g} cm", "ease": f"ease to {to:g} cm"}.get(kind, "")
        marks.append((text or ("" if partner else "free"), text))
    return marks


def _runs(sewn: SewnPattern, panel: FlatPanel, allowances: Allowances) -> tuple[Run, ...]:
    """The sew line as it is cut: closed over the mouths of darts."""
    darts = {d.leg_in: d for d in sewn.darts if d.panel == panel.name}
    count = len(panel.edges)
    out_legs = {d.leg_out for d in darts.values()}
    runs = []
    for k in range(count):
        if k in out_legs:
            continue
        if k not in darts:
            kind = panel.kinds[k]
            runs.append(Run(panel.edges[k], kind, allowances.of(kind), k))
            continue
        leg_in, leg_out = panel.edges[k], panel.edges[darts[k].leg_out]
        before, after = (k - 1) % count, (darts[k].leg_out + 1) % count
        peak = dart_peak(panel.edges[before], leg_in, leg_out, panel.edges[after])
        kinds = [panel.kinds[e] for e in (before, after) if panel.kinds[e] is not EdgeKind.DART]
        kind = max(kinds, key=allowances.of, default=EdgeKind.SEAM)
        runs.append(Run(np.array([leg_in[0], peak, leg_out[-1]]), kind, allowances.of(kind), -1))
    # The run across the dart that begins the loop may end it too; runs follow each other either way.
    start = 1 if (count - 1) in darts and 0 in out_legs else 0
    return tuple(runs) if not start else (runs[-1], *runs[:-1])


def _placed(
    notches: Sequence[Notch], sewn: SewnPattern, panel: FlatPanel, allowances: Allowances
) -> tuple[PlacedNotch, ...]:
    marks = []
    for notch in notches:
        point, normal = _at(panel, notch.edge, notch.fraction)
        depths = [allowances.of(panel.kinds[notch.edge])]
        if notch.fraction == 0.0:
            depths.append(allowances.of(panel.kinds[notch.edge - 1]))
        marks.append(PlacedNotch(point, normal, max(depths), notch.teeth))
    count = len(panel.edges)
    for dart in (d for d in sewn.darts if d.panel == panel.name):
        for edge, fraction in (((dart.leg_in - 1) % count, 1.0), ((dart.leg_out + 1) % count, 0.0)):
            point, normal = _at(panel, edge, fraction)
            marks.append(PlacedNotch(point, normal, allowances.of(panel.kinds[edge]), 1))
    return tuple(marks)


def _at(panel: FlatPanel, edge: int, fraction: float) -> tuple[Floats, Floats]:
    """Point and outward unit normal at a fraction of an edge."""
    points = panel.edges[edge]
    point = along(points, (fraction,))[0]
    length = max(panel.lengths[edge], 1e-9)
    step = min(0.05 / length, 0.02)
    low, high = along(points, (max(fraction - step, 0.0), min(fraction + step, 1.0)))
    tangent = (high - low) / max(float(np.hypot(*(high - low))), 1e-12)
    return point, np.array([tangent[1], -tangent[0]])


def _seam_marks(
    panel: FlatPanel, group: Sequence[tuple[str, Match]], numbers: dict[EdgeRef, int]
) -> tuple[SeamMark, ...]:
    """The numbers of every seam, at the middle of its longest edge on the piece."""
    count = len(panel.edges)
    of_edge: dict[int, set[int]] = {}
    for name, match in group:
        for k in range(count):
            number = numbers.get(EdgeRef(name, k))
            on_piece = on_edge(match, k, count)
            if number and panel.kinds[on_piece] is EdgeKind.SEAM:
                of_edge.setdefault(on_piece, set()).add(number)
    longest: dict[tuple[int, ...], int] = {}
    for k in sorted(of_edge):
        key = tuple(sorted(of_edge[k]))
        if key not in longest or panel.lengths[k] > panel.lengths[longest[key]] + 1e-9:
            longest[key] = k
    marks = []
    for own, k in longest.items():
        point, normal = _at(panel, k, 0.5 if panel.lengths[k] < 25 else 0.45)
        marks.append(SeamMark(own, point, -normal, panel.lengths[k]))
    return tuple(marks)


def _inside_span(outline: Floats, x: float) -> tuple[float, float]:
    """The longest stretch (low, high) of the upright line at x inside a closed polyline (n, 2)."""
    start, end = outline, np.roll(outline, -1, axis=0)
    crossing = (start[:, 0] <= x) != (end[:, 0] <= x)
    a, b = start[crossing], end[crossing]
    heights = np.sort(a[:, 1] + (x - a[:, 0]) / (b[:, 0] - a[:, 0]) * (b[:, 1] - a[:, 1]))
    if len(heights) < 2:
        return float(outline[:, 1].min()), float(outline[:, 1].max())
    pairs = heights[: len(heights) // 2 * 2].reshape(-1, 2)
    low, high = pairs[int(np.argmax(pairs[:, 1] - pairs[:, 0]))]
    return float(low), float(high)

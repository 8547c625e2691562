"""Pieces to cut: what lies on the table, with allowance, notches, grain and marks."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.making.allowances import FOLDED_UP, Allowances, EdgeKind
from swifttailor.making.closings import Closing, front_closing
from swifttailor.making.cut_line import Run, cut_line
from swifttailor.making.darts import dart_peak
from swifttailor.making.finished_measures import wearer_findings
from swifttailor.making.notches import Notch, NotchPair, pair_notches, panel_notches
from swifttailor.making.overlaps import overlap_findings
from swifttailor.making.piece import DartMark, EdgeMark, Piece, PlacedNotch, SeamMark
from swifttailor.making.piece_names import piece_names
from swifttailor.making.seams import Seam, find_seams, gather
from swifttailor.making.sewn_pattern import FlatPanel, SewnPattern, read_pattern
from swifttailor.making.trim_marks import panel_marks, piece_marks
from swifttailor.making.trim_pieces import trim_pieces
from swifttailor.making.twins import Match, Shape, along, on_edge
from swifttailor.pattern import EdgeRef, Finding, Pattern
from swifttailor.pattern.trims import Trim, place_trims


@dataclass(frozen=True, eq=False)
class CuttingPlan:
    """All pieces of a pattern and how they are sewn together."""

    sewn: SewnPattern
    pieces: tuple[Piece, ...]
    seams: tuple[Seam, ...]
    pairs: tuple[NotchPair, ...]
    allowances: Allowances
    findings: tuple[Finding, ...]
    trims: tuple[Trim, ...] = ()
    """Where pockets, buttons and the like lie on the panels, panel-local."""
    closing: Closing | None = None
    """How the front closes, where it is not sewn together."""

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
    trims: Sequence[Trim] | None = None,
) -> CuttingPlan:
    """Makes pieces to cut from a pattern.

    Args:
        pattern: A pattern placed around a body.
        allowances: Around each kind of edge; usual ones when None.
        alike: Sets of panels that may become one piece where they are alike; all may when None.
        trims: Where the trims lie that the pattern names; where `place_trims` puts them when None. Patterns
            whose middle is folded bring them along, since their panels have other names.

    Raises:
        PatternError: It cannot be cut or sewn.
    """
    allowances = allowances or Allowances()
    sewn = read_pattern(pattern)
    trims = tuple(place_trims(sewn.pattern) if trims is None else trims)
    pairs = pair_notches(sewn)
    notches = panel_notches(sewn, pairs)
    marks = {p.name: _edge_marks(sewn, p) for p in sewn.panels}
    shapes = {p.name: Shape.of(p, notches[p.name], tuple(m[0] for m in marks[p.name])) for p in sewn.panels}
    groups = _group(sewn.panels, shapes, alike)
    names = piece_names([[sewn.panel(n).placed for n, _ in group] for group in groups])
    own_mirrors = {name: shape.onto(shape, mirrored=True) for name, shape in shapes.items()}
    seams = _numbered(sewn, find_seams(sewn), groups, own_mirrors)
    closing = front_closing(sewn, seams, trims)
    put_on = panel_marks(sewn, trims, closing)
    numbers = {
        ref: seam.number for seam in seams for k in seam.stitches for ref in sewn.pattern.stitches[k].sides
    }
    pieces, findings = [], wearer_findings(pattern)
    for name, group in zip(names, groups, strict=True):
        panel = sewn.panel(group[0][0])
        runs = _runs(sewn, panel, allowances, closing)
        falling = (
            []
            if closing is None
            else closing.falling(runs, panel.name, allowances.edge, _hem_width(panel, allowances))
        )
        outline = cut_line(runs, falling)
        piece = Piece(
            name,
            tuple(n for n, match in group if not match.mirrored),
            tuple(n for n, match in group if match.mirrored),
            runs,
            outline,
            _placed(notches[panel.name], sewn, panel, allowances, closing),
            tuple(
                DartMark((panel.edges[d.leg_in], panel.edges[d.leg_out][::-1]))
                for d in sewn.darts
                if d.panel == panel.name
            ),
            tuple(EdgeMark(panel.edges[k], text) for k, (_, text) in enumerate(marks[panel.name]) if text),
            _seam_marks(panel, group, numbers),
            own_mirrors[panel.name] is not None,
            float(panel.outline[:, 0].min() + panel.outline[:, 0].max()) / 2,
            marks=piece_marks(sewn, group, put_on),
        )
        pieces.append(piece)
        # Free edges of a front that laps are meant to lie under its wider edge.
        free = set() if closing is None else {ref.edge for ref in closing.below if ref.panel == panel.name}
        kept = tuple([run for run in runs if run.edge not in free])
        findings += overlap_findings(name, panel.name, kept, outline)
    pieces += trim_pieces(sewn, pieces, trims, closing, allowances)
    return CuttingPlan(sewn, tuple(pieces), seams, pairs, allowances, tuple(findings), trims, closing)


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


def _runs(
    sewn: SewnPattern, panel: FlatPanel, allowances: Allowances, closing: Closing | None
) -> tuple[Run, ...]:
    """The sew line as it is cut: closed over the mouths of darts, wider where fronts lap."""
    darts = {d.leg_in: d for d in sewn.darts if d.panel == panel.name}
    count = len(panel.edges)
    out_legs = {d.leg_out for d in darts.values()}
    runs = []
    for k in range(count):
        if k in out_legs:
            continue
        if k not in darts:
            kind = panel.kinds[k]
            width = allowances.of(kind) + _wider(closing, panel, k)
            runs.append(Run(panel.edges[k], kind, width, k))
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


def _hem_width(panel: FlatPanel, allowances: Allowances) -> float:
    hems = [kind for kind in panel.kinds if kind in FOLDED_UP]
    return max(map(allowances.of, hems), default=allowances.edge)


def _wider(closing: Closing | None, panel: FlatPanel, edge: int) -> float:
    return 0.0 if closing is None else closing.wider(EdgeRef(panel.name, edge))


def _placed(
    notches: Sequence[Notch],
    sewn: SewnPattern,
    panel: FlatPanel,
    allowances: Allowances,
    closing: Closing | None,
) -> tuple[PlacedNotch, ...]:
    marks = []
    for notch in notches:
        point, normal = _at(panel, notch.edge, notch.fraction)
        at = EdgeRef(panel.name, notch.edge)
        if closing is not None and closing.extension > 0 and at in closing.edges | closing.below:
            continue  # it is not sewn, and the cut line lies further out
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

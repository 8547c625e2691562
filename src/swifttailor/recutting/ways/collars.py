"""Sewing collars and hoods to a free neckline: stands, lapels, hoods of two panels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from swifttailor.describing.facts import CollarKind
from swifttailor.describing.measuring.chain import edge_runs
from swifttailor.describing.measuring.parts import Face
from swifttailor.pattern import EdgeRef, Line, Panel, Pattern, Placement, Quadratic
from swifttailor.pattern import curve as curves
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.hood import BACK_Z, SIDE_X, hood_outline
from swifttailor.pattern.drafts.outline import Outline
from swifttailor.pattern.panel import Edge
from swifttailor.recutting.table.workbench import Workbench

ArmSide = Literal["left", "right"]
_FACES: tuple[Face, Face] = ("front", "back")
_SIDES: tuple[ArmSide, ArmSide] = ("left", "right")
_FRONT_Z, _BACK_Z, _LAPEL_Z = 10.0, -10.0, 35.0
"""Where collars stand before sewing, cm; as GarmentCode places them."""
_ABOVE_NECK_CM = 2.0
_LAPEL_X = 3.0
_LAPEL_EDGE = Quadratic((0.7, -0.2))
"""The free edge of a lapel, from its point to the shoulder."""
_CORRECTIONS = 12


@dataclass(frozen=True)
class NeckQuarter:
    """The neckline of one panel, in the order of its loop."""

    panel: str
    run: tuple[EdgeRef, ...]
    outward: bool
    """Whether the loop leads from the middle to the shoulder."""
    lengths: tuple[float, ...]
    """Of its edges, cm."""

    @property
    def length(self) -> float:
        """Of all of it, cm."""
        return sum(self.lengths)


Quarters = dict[tuple[Face, ArmSide], NeckQuarter]
"""By face and side."""


def neck_quarters(pattern: Pattern, front: Sequence[EdgeRef], back: Sequence[EdgeRef]) -> Quarters | None:
    """The neckline in four: left and right, in front and behind.

    Args:
        pattern: Any pattern.
        front: Edges of the front neckline.
        back: Of the back one.

    Returns:
        The quarters, all the way around; None where it is cut otherwise, or not closed.
    """
    found: Quarters = {}
    for face, refs in zip(_FACES, (front, back), strict=True):
        for name in dict.fromkeys(r.panel for r in refs):
            panel = pattern.panel(name)
            runs = edge_runs(panel, [r.edge for r in refs if r.panel == name])
            if len(runs) != 1 or len(runs[0]) > len(panel.edges) - 3:
                return None
            run = tuple(EdgeRef(name, k) for k in runs[0])
            ends = panel.to_world(
                np.array([panel.vertices[runs[0][0]], panel.vertices[(runs[0][-1] + 1) % len(panel.edges)]])
            )[:, 0]
            side: ArmSide = "left" if ends.sum() > 0 else "right"
            if (face, side) in found:
                return None
            outward = bool(abs(ends[1]) > abs(ends[0]))
            if outward != ((side == "left") == (face == "back")):  # it is turned wrong side out
                return None
            found[face, side] = NeckQuarter(name, run, outward, tuple(map(pattern.edge_length, run)))
    return found if len(found) == 4 and _meet(pattern, found) else None


def _meet(pattern: Pattern, quarters: Quarters) -> bool:
    """Whether halves are sewn to each other in the middle and at the shoulders."""
    bench = Workbench(pattern)

    def beside(quarter: NeckQuarter, *, shoulder: bool) -> int:
        last = quarter.outward == shoulder
        return bench.neighbour(bench.at[quarter.run[-1 if last else 0]], 1 if last else -1)

    middles = [[beside(quarters[f, s], shoulder=False) for s in _SIDES] for f in _FACES]
    shoulders = [[beside(quarters[f, s], shoulder=True) for f in _FACES] for s in _SIDES]
    return all(bench.partner(a) == b for a, b in (*middles, *shoulders))


def add_collar(
    pattern: Pattern, quarters: Quarters, figure: Figure, kind: CollarKind, height: float
) -> Pattern | None:
    """Sews a collar to the neckline, exactly as long as that is.

    Args:
        pattern: Any pattern with a free neckline.
        quarters: Of the neckline.
        figure: Who it is for.
        kind: A stand all around, or lapels in front that go on behind as a stand.
        height: Of the collar behind, cm.

    Returns:
        The pattern with four panels more; None where a name is taken.
    """
    bench = Workbench(pattern)
    base = figure.neck_y + _ABOVE_NECK_CM
    middles: dict[tuple[Face, ArmSide], int] = {}
    shoulders: dict[tuple[Face, ArmSide], int] = {}
    for (face, side), quarter in quarters.items():
        name = f"{side}_collar_{face}"
        if name in bench.pieces:
            return None
        sign = 1.0 if side == "left" else -1.0
        runs = [bench.at[r] for r in quarter.run]
        if kind == "lapel" and face == "front":
            ids = bench.add(replace(_lapel(quarter, sign, height, base), name=name))
            for own, neck in zip(ids, runs, strict=False):
                bench.sew(neck, own, right_wrong=True)
            shoulders[face, side] = ids[len(runs)] if quarter.outward else ids[-1]
            continue
        z = _FRONT_Z if face == "front" else _BACK_Z
        ids = bench.add(replace(_stand(quarter, sign, height, base, z), name=name))
        for own, neck in zip(ids, reversed(runs), strict=False):
            bench.sew(neck, own)
        ends = ids[len(runs)], ids[-1]
        middles[face, side], shoulders[face, side] = ends if quarter.outward else ends[::-1]
    for side in _SIDES:
        bench.sew(shoulders["front", side], shoulders["back", side], right_wrong=kind == "lapel")
    for face in _FACES:
        if (face, "left") in middles:
            bench.sew(middles[face, "left"], middles[face, "right"])
    return bench.pattern()


def _stand(quarter: NeckQuarter, sign: float, height: float, base: float, z: float) -> Panel:
    """A straight strip; its lower sides run against the neckline's, then come the ends and the upper side."""
    way = np.concatenate([[0.0], np.cumsum(quarter.lengths[::-1])])
    x = sign * (way[-1] - way if quarter.outward else way)
    lower = np.stack([x, np.zeros_like(x)], axis=1)
    upper = np.array([[x[-1], height], [x[0], height]])
    vertices = np.concatenate([lower, upper])
    placement = Placement((float(x[0]), base, z), (0.0, 0.0, 0.0))
    return Panel("", vertices - vertices[0], (Edge(Line()),) * len(vertices), placement, "body")


def _lapel(quarter: NeckQuarter, sign: float, height: float, base: float) -> Panel:
    """A triangle on the front, wrong side out: its loop follows the neckline's, then goes over its point."""
    way = np.concatenate([[0.0], np.cumsum(quarter.lengths)])
    way = way[-1] - way if quarter.outward else way
    neck = np.stack([np.full_like(way, sign * _LAPEL_X), base + height - way], axis=1)
    vertices = np.concatenate([neck, [[sign * (_LAPEL_X + height), base + height]]])
    edges = [Edge(Line()) for _ in vertices]
    if quarter.outward:
        edges[-1] = Edge(curves.reverse(curves.mirror(_LAPEL_EDGE)))
    else:
        edges[-2] = Edge(_LAPEL_EDGE)
    placement = Placement((float(vertices[0, 0]), float(vertices[0, 1]), _LAPEL_Z), (0.0, 0.0, 0.0))
    return Panel("", vertices - vertices[0], tuple(edges), placement, "body")


def add_hood(
    pattern: Pattern, quarters: Quarters, figure: Figure, height: float, depth: float
) -> Pattern | None:
    """Sews a hood of two panels to the neckline.

    Args:
        pattern: Any pattern with a free neckline.
        quarters: Of the neckline.
        figure: Who it is for.
        height: From the lowest point of a panel to its highest, cm.
        depth: From its face to its back, cm.

    Returns:
        The pattern with two panels more; None where a name is taken, or the neckline is too long for a hood
        of that depth.
    """
    bench = Workbench(pattern)
    centres: list[list[int]] = []
    for side in _SIDES:
        front, back = quarters["front", side], quarters["back", side]
        outline = _fitted_hood(front.length, back.length, height, depth)
        if outline is None or f"{side}_hood" in bench.pieces:
            return None
        sides = []
        for edge in outline.sides:
            own = {"neck_front": front, "neck_back": back}.get(edge.name)
            if own is None:
                sides.append(edge)
                continue
            # Towards the nape: from the middle to the shoulder in front, from there to the middle behind.
            outward = edge.name == "neck_front"
            lengths = own.lengths if own.outward == outward else own.lengths[::-1]
            cuts = np.cumsum(lengths)[:-1] / own.length
            sides += edge.split(list(map(float, cuts))) if len(cuts) else [edge]
        at = np.array([max(SIDE_X, figure.neck_x + 5.0), figure.neck_y + 4.0, BACK_Z])
        angle = 90.0
        if side == "right":
            sides, at[0], angle = [e.mirrored() for e in reversed(sides)], -at[0], -angle
        x, y, z = map(float, Placement(tuple(at), (0.0, angle, 0.0)).apply(np.array([sides[0].start]))[0])
        vertices = np.array([e.start for e in sides])
        placement = Placement((x, y, z), (0.0, angle, 0.0))
        edges = tuple(Edge(e.curve) for e in sides)
        ids = bench.add(Panel(f"{side}_hood", vertices - vertices[0], edges, placement, "body"))
        for quarter, name in ((front, "neck_front"), (back, "neck_back")):
            own = [i for i, e in zip(ids, sides, strict=True) if e.name == name]
            for ref, id in zip(quarter.run, reversed(own), strict=True):
                bench.sew(bench.at[ref], id)
        centres.append([i for i, e in zip(ids, sides, strict=True) if e.name == "centre"])
    for one, other in zip(centres[0], reversed(centres[1]), strict=True):
        bench.sew(one, other)
    return bench.pattern()


def _fitted_hood(front: float, back: float, height: float, depth: float) -> Outline | None:
    """Draws half a hood whose panel measures what is asked for, to a millimetre."""
    up, deep = height, depth
    for _ in range(_CORRECTIONS):
        outline = hood_outline(front, back, up, deep, folded=True)
        points = np.concatenate([curves.flatten(e.curve, e.chord, 0.1) for e in outline.sides])
        missing = np.array([depth, height]) - np.ptp(points, axis=0)
        fits = all(
            abs(_length(outline, name) - own) < 0.05
            for name, own in (("neck_front", front), ("neck_back", back))
        )
        if np.abs(missing).max() < 0.1:
            return outline if fits else None
        deep, up = deep + float(missing[0]), up + float(missing[1])
    return None


def _length(outline: Outline, name: str) -> float:
    return sum(e.length for e in outline.sides if e.name == name)

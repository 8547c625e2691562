"""Sewing sleeves on to free armholes: two half sleeves each, their caps fitted to front and back."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.describing.measuring.anatomy import Anatomy, Border
from swifttailor.describing.measuring.chain import edge_runs
from swifttailor.describing.measuring.parts import ARM_PARTS, Face, Part
from swifttailor.pattern import EdgeRef, Panel, Pattern, Placement, Stitch
from swifttailor.pattern import curve as curves
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.outline import Outline, Side
from swifttailor.pattern.drafts.sleeve import HIGHEST_CAP, fit_cap, sleeve_outline
from swifttailor.pattern.panel import Edge
from swifttailor.recutting.table.workbench import Workbench

ArmSide = Literal["left", "right"]

ARM_EASE_CM = 7.0
"""On top of the girth of the arm, at the underarm and at the sleeve's end."""
BELOW_CAP_CM = 3.0
"""Shortest seam under the arm."""
LEAST_DROP_CM = 8.0
"""From the shoulder to the underarm."""
NARROWEST, WIDEST = 1.05, 2.5
"""Width at the underarm over the girth of the upper arm."""
_DEEP_CAP = 0.72
"""Highest cap over the length of half an armhole: the deeper that lies, the more of the sleeve slants."""
FRONT_Z, BACK_Z = 17.5, -12.5
"""Where the halves stand before sewing, cm; as GarmentCode places them."""
GAP_CM, LIFT_CM = 3.0, 4.0
"""From the armhole's upper end to that of the cap before sewing, along and across the arm."""
_STEEPEST = 1.0
"""Narrowing of half a sleeve over the length of its seam under the arm."""


@dataclass(frozen=True)
class Hole:
    """The free armhole of one side."""

    side: ArmSide
    front: tuple[EdgeRef, ...]
    """From the shoulder to the underarm."""
    back: tuple[EdgeRef, ...]
    tip: tuple[float, float]
    """Its upper end: distance from the middle of the body and height, cm."""


def find_hole(anatomy: Anatomy, side: ArmSide) -> Hole | None:
    """The free armhole of a side that runs on one panel in front and one behind; None without such a one."""
    sign = 1.0 if side == "left" else -1.0
    loops = [
        loop
        for loop in anatomy.loops(Border.ARM)
        if sign * loop.center[0] > 0 and all(anatomy.part_of(r) is Part.TORSO for r in loop.edges)
    ]
    if len(loops) != 1:
        return None
    front, back = (_down(anatomy, loops[0].edges, face) for face in ("front", "back"))
    if not front or not back or len(front) + len(back) != len(loops[0].edges):
        return None
    ends = np.array([_line(anatomy, run)[[0, -1]] for run in (front, back)])
    tip, under = ends.mean(axis=0)
    if tip[1] - under[1] < LEAST_DROP_CM or sign * tip[0] <= 0:
        return None
    return Hole(side, front, back, (abs(float(tip[0])), float(tip[1])))


def add_sleeves(
    pattern: Pattern, anatomy: Anatomy, holes: Sequence[Hole], length: float, ease: float = ARM_EASE_CM
) -> Pattern | None:
    """Sews sleeves into free armholes; what they are sewn to stays as it is.

    Args:
        pattern: The pattern that `anatomy` is of.
        anatomy: Gives the figure, too, that the sleeves are cut for.
        holes: The armholes.
        length: From the tip of the body's shoulder along the arm, cm.
        ease: On top of the girth of the arm, cm around; more where an armhole asks for it.

    Returns:
        The pattern with two panels more for each armhole, their caps as long as what they are sewn to; None
        where a name is taken, or an armhole asks for a sleeve that no arm fits or that is no sleeve any more.
    """
    bench = Workbench(pattern)
    for hole in holes:
        halves = _draw(anatomy, hole, length, ease)
        if halves is None or not _sew_in(bench, anatomy, hole, halves):
            return None
    return bench.pattern()


def mirror_sleeve(pattern: Pattern, anatomy: Anatomy, hole: Hole) -> Pattern | None:
    """Sews the mirrored sleeve of the other arm, with its cuff, into a free armhole.

    Args:
        pattern: The pattern that `anatomy` is of.
        anatomy: Knows the other sleeve.
        hole: Must be cut like the armhole of the other sleeve.

    Returns:
        The pattern with two like sleeves; None where the armholes differ or a name is taken.
    """
    other: ArmSide = "right" if hole.side == "left" else "left"
    models = {p.name: p for p in anatomy.panels(ARM_PARTS, other)}
    names = {n: n.replace(other, hole.side) for n in models}
    taken = {p.name for p in pattern.panels}
    if not models or taken & set(names.values()) or names.keys() & set(names.values()):
        return None
    twins = {
        EdgeRef(n, k): EdgeRef(names[n], (len(p.edges) - 2 - k) % len(p.edges))
        for n, p in models.items()
        for k in range(len(p.edges))
    }
    holes: dict[EdgeRef, EdgeRef] = {}
    for face, run in (("front", hole.front), ("back", hole.back)):
        sewn = [b for _, b in anatomy.seam(Part.SLEEVE, Part.TORSO, other).pairs]
        sewn = [r for r in sewn if anatomy.parts[r.panel].face == face]
        sewn.sort(key=lambda r: -float(anatomy.cloth.placed([r])[:, 1].mean()))
        lengths = [[anatomy.edge_length(r) for r in refs] for refs in (sewn, run)]
        if len(sewn) != len(run) or not np.allclose(*lengths, rtol=1e-3):
            return None
        holes.update(zip(sewn, run, strict=True))
    where = twins | holes
    stitches = [
        Stitch(where[s.first], where[s.second], s.right_wrong)
        for s in pattern.stitches
        if all(r in where for r in s.sides) and any(r in twins for r in s.sides)
    ]
    panels = tuple(_mirrored(p, names[n]) for n, p in models.items())
    whole = replace(pattern, panels=(*pattern.panels, *panels), stitches=(*pattern.stitches, *stitches))
    return whole.canonical()


def _mirrored(panel: Panel, name: str) -> Panel:
    """The twin of a panel on the other side of the body; edge k becomes edge n - 2 - k."""
    edges = [replace(e, curve=curves.reverse(curves.mirror(e.curve))) for e in panel.edges]
    (x, y, z), (a, b, c) = panel.placement.translation, panel.placement.rotation
    placement = replace(panel.placement, translation=(-x, y, z), rotation=(a, -b, -c))
    vertices = panel.vertices[::-1] * [-1.0, 1.0]
    return Panel(name, vertices, (*edges[-2::-1], edges[-1]), placement, panel.label)


def _draw(anatomy: Anatomy, hole: Hole, length: float, ease: float) -> tuple[Outline, Outline] | None:
    """Front and back of a sleeve, of the left arm."""
    figure = anatomy.figure
    length -= (hole.tip[0] - figure.shoulder_x) * float(np.hypot(1.0, figure.slope))
    front, back = (sum(map(anatomy.edge_length, run)) for run in (hole.front, hole.back))
    highest = min(max(HIGHEST_CAP, _DEEP_CAP * min(front, back)), length - BELOW_CAP_CM)
    cap = fit_cap(front, back, figure.upper_arm + ease, highest)
    width = cap.front + cap.back
    if not NARROWEST * figure.upper_arm <= width <= WIDEST * figure.upper_arm:
        return None
    if length < cap.height + BELOW_CAP_CM - 1e-6:
        return None
    narrowing = max((width - figure.arm_girth(length) - ease) / 2, 0.0)
    narrowing = min(narrowing, min(cap.front, cap.back) - 3.0, _STEEPEST * (length - cap.height))
    return (
        sleeve_outline(cap, length, narrowing, front=True),
        sleeve_outline(cap, length, narrowing, front=False),
    )


def _sew_in(bench: Workbench, anatomy: Anatomy, hole: Hole, halves: tuple[Outline, Outline]) -> bool:
    seams: list[dict[str, int]] = []
    for run, outline, letter in zip((hole.front, hole.back), halves, "fb", strict=True):
        name = f"{hole.side}_sleeve_{letter}"
        if name in bench.pieces:
            return False
        lengths = np.array([anatomy.edge_length(r) for r in run])
        sides = _cut_cap(outline.sides, list(map(float, np.cumsum(lengths)[:-1] / lengths.sum())))
        panel, names = _panel(anatomy.figure, hole, name, sides)
        own = dict(zip(names, bench.add(panel), strict=True))
        for k, ref in enumerate(run):
            bench.sew(bench.at[ref], own[f"cap {k}"])
        seams.append(own)
    for edge in ("top", "under"):
        bench.sew(seams[0][edge], seams[1][edge])
    return True


def _cut_cap(sides: Sequence[Side], fractions: list[float]) -> list[Side]:
    """The outline with its cap cut where the armhole has joints, from the shoulder down."""
    *others, cap = sides
    parts = cap.split(fractions) if fractions else [cap]
    parts[-1] = replace(parts[-1], end=cap.end)
    return [*others, *(part.renamed(f"cap {k}") for k, part in enumerate(parts))]


def _panel(figure: Figure, hole: Hole, name: str, sides: list[Side]) -> tuple[Panel, list[str]]:
    """Places half a sleeve beside the arm; the names of its edges come with it."""
    back = name.endswith("_b")
    angle = -figure.arm_angle
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    x, y = hole.tip[0] + GAP_CM * c - LIFT_CM * s, hole.tip[1] + GAP_CM * s + LIFT_CM * c
    if hole.side == "right":
        sides, x, angle = [e.mirrored() for e in reversed(sides)], -x, -angle
    if back:  # its right side is turned to the back
        sides = [e.reversed() for e in reversed(sides)]
    vertices = np.array([e.start for e in sides])
    placement = Placement((x, y, BACK_Z if back else FRONT_Z), (0.0, 0.0, angle))
    x, y, z = map(float, placement.apply(vertices[:1])[0])
    placement = replace(placement, translation=(x, y, z))
    edges = tuple(Edge(e.curve) for e in sides)
    return Panel(name, vertices - vertices[0], edges, placement, "arm"), [e.name for e in sides]


def _down(anatomy: Anatomy, edges: Sequence[EdgeRef], face: Face) -> tuple[EdgeRef, ...]:
    """The edges of an armhole on one face from the shoulder down, where they are one run of one panel."""
    own = [r for r in edges if anatomy.parts[r.panel].face == face]
    names = {r.panel for r in own}
    if len(names) != 1:
        return ()
    panel = anatomy.parts[own[0].panel].panel
    runs = edge_runs(panel, [r.edge for r in own])
    if len(runs) != 1 or len(own) == len(panel.edges):
        return ()
    run = tuple(EdgeRef(panel.name, k) for k in runs[0])
    line = np.concatenate([panel.to_world(panel.flatten_edge(r.edge)) for r in run])
    # Seen from outside, a panel runs anticlockwise: up the armhole on the left front and the right back.
    upward = line[-1, 1] > line[0, 1]
    left = line[:, 0].mean() > 0
    if upward != (left == (face == "front")):
        return ()
    return run[::-1] if upward else run


def _line(anatomy: Anatomy, down: Sequence[EdgeRef]) -> Floats:
    """Placed ends (2, 3) of a run of edges that goes down, cm."""
    panel = anatomy.parts[down[0].panel].panel
    points = np.concatenate([panel.to_world(panel.chord(r.edge)) for r in down])
    return points[[points[:, 1].argmax(), points[:, 1].argmin()]]

"""Exchanging halves of a garment for newly drafted ones: skirts, trousers, bodices; bands between them."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from swifttailor.describing.measuring.anatomy import Border
from swifttailor.describing.measuring.parts import LOWER_PARTS, Face, Part
from swifttailor.describing.measuring.skirts import upper_edges
from swifttailor.errors import PatternError
from swifttailor.pattern import EdgeRef, Line, Panel, Pattern, Placement
from swifttailor.pattern.drafts.bodice import sew_centres
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Halves
from swifttailor.pattern.drafts.fitted_bodice import FittedBodice, lay_fitted_bodice
from swifttailor.pattern.drafts.fitted_skirt import FittedSkirt, lay_fitted_skirt
from swifttailor.pattern.drafts.flared_skirt import lay_flared_skirt
from swifttailor.pattern.drafts.neckline import Neckline
from swifttailor.pattern.drafts.trousers import Trousers, lay_trousers, sew_legs
from swifttailor.pattern.panel import Edge
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.grafting import lay_pattern, sew_across
from swifttailor.recutting.ways.removal import WAIST_LABEL

_FACES: tuple[Face, Face] = ("front", "back")
_BELOW_CM = 2.0
"""From what holds a new part down to it, as placed."""
_HIP_EASE_CM = 5.0
_BODICE = FittedBodice(
    neckline=Neckline("round", 2.0, 11.0, 3.0),
    bust_ease=4.0,
    waist_ease=3.0,
    armhole_drop=2.0,
    shoulder_extension=-1.0,
)


@dataclass(frozen=True)
class FlaredCut:
    """A skirt cut from a circle."""

    fraction: float
    """Of a full circle."""
    length: float
    """cm."""


@dataclass(frozen=True)
class StraightCut:
    """A skirt shaped by side seams and darts."""

    length: float
    """From its upper edge, cm."""
    flare: float
    """Slant of the side seams below the hips, degrees."""


@dataclass(frozen=True)
class LegsCut:
    """Trousers."""

    length: float
    """From their upper edge, cm."""
    flare: float
    """Extra width of the hem, cm around."""


def exchange_lower(cutter: Cutter, new: FlaredCut | StraightCut | LegsCut) -> Pattern | None:
    """Takes skirt or trousers off and sews new ones to what held them, as wide above as that is.

    What nothing holds is cut anew as wide as its own upper edge. None where what holds it does not go all the
    way around.
    """
    names = cutter.names(*LOWER_PARTS)
    alone = len(names) == len(cutter.pattern.panels)
    holder = _tops(cutter) if alone else _holder(cutter, LOWER_PARTS)
    if not holder or not names:
        return None
    bench = Workbench(cutter.pattern)
    held = {face: [bench.at[r] for r in refs] for face, refs in holder.items()}
    lengths = {face: sum(bench.piece_of(s).length(s) for s in sides) for face, sides in held.items()}
    waist = Halves(lengths["front"] / 2, lengths["back"] / 2)
    try:
        drafted = _draft(cutter, new, waist, _level(bench, held) - (0.0 if alone else _BELOW_CM))
    except PatternError:  # no legs fit below a waist that is so uneven
        return None
    bench.remove(names)
    laid = lay_pattern(bench, drafted)
    if laid is None:
        return None
    own = cutter.with_pattern(drafted)
    for face, refs in _tops(own).items():
        sides = [laid[r] for r in refs]
        if not cutter.anatomy.has(Part.WAISTBAND):
            for side in sides:
                bench.relabel(side, WAIST_LABEL)
        if not alone and not sew_across(bench, held[face], sides):
            return None
    return bench.pattern()


def _tops(cutter: Cutter) -> dict[Face, list[EdgeRef]]:
    """Upper edges of a skirt or of trousers by face; nothing where a face has none."""
    part = Part.TROUSER if cutter.anatomy.has(Part.TROUSER) else Part.SKIRT
    refs = upper_edges(cutter.anatomy, part)[0]
    found = {f: [r for r in refs if cutter.anatomy.parts[r.panel].face == f] for f in _FACES}
    return found if all(found.values()) else {}


def _draft(cutter: Cutter, new: FlaredCut | StraightCut | LegsCut, waist: Halves, top_y: float) -> Pattern:
    figure, table = cutter.anatomy.figure, CuttingTable("lower")
    if isinstance(new, FlaredCut):
        lay_flared_skirt(table, waist, new.length, top_y, new.fraction)
    elif isinstance(new, StraightCut):
        below_waist = new.length + figure.waist_y - top_y
        lay_fitted_skirt(table, figure, FittedSkirt(below_waist, _HIP_EASE_CM, new.flare), waist, top_y)
    else:
        legs = Trousers(new.length + figure.waist_y - top_y, _HIP_EASE_CM, 12.0, new.flare, 3.0)
        lay_trousers(table, figure, legs, waist, top_y)
        table.mirror()
        sew_legs(table)
    return table.finish()


def sew_bodice(cutter: Cutter) -> Pattern | None:
    """Sews a fitted bodice without sleeves to the upper edge of a skirt or trousers."""
    if cutter.anatomy.has(Part.TORSO):
        return None
    top = cutter.anatomy.loops(Border.TOP)
    refs = [r for loop in top for r in loop.edges]
    table = CuttingTable("bodice")
    lay_fitted_bodice(table, cutter.anatomy.figure, _BODICE)
    table.mirror()
    sew_centres(table)
    bodice = table.finish()
    bench = Workbench(cutter.pattern)
    own = cutter.with_pattern(bodice)
    hem = own.anatomy.hem
    laid = lay_pattern(bench, bodice)
    if laid is None or hem is None:
        return None
    lower = {f: [laid[r] for r in hem.edges if own.anatomy.parts[r.panel].face == f] for f in _FACES}
    upper = {f: [bench.at[r] for r in refs if cutter.anatomy.parts[r.panel].face == f] for f in _FACES}
    if not all(upper.values()):
        return None
    bench.shift(
        [p.name for p in cutter.pattern.panels],
        [0.0, _level(bench, lower) - _BELOW_CM - _level(bench, upper), 0.0],
    )
    for face in _FACES:
        for side in upper[face]:
            bench.relabel(side, WAIST_LABEL)
        if not sew_across(bench, lower[face], upper[face]):
            return None
    return bench.pattern()


def take_band_out(cutter: Cutter) -> Pattern | None:
    """Takes out a waistband that holds a bodice and what hangs below, and sews these to each other."""
    anatomy = cutter.anatomy
    above = anatomy.seam(Part.TORSO, Part.WAISTBAND).own
    below = anatomy.seam(LOWER_PARTS, Part.WAISTBAND).own
    if not above or not below:
        return None
    bench = Workbench(cutter.pattern)
    height = cutter.facts.waistband.height if cutter.facts.waistband else 0.0
    bench.remove(cutter.names(Part.WAISTBAND))
    bench.shift(cutter.names(*LOWER_PARTS), [0.0, height, 0.0])
    for face in _FACES:
        upper, lower = (
            [bench.at[r] for r in refs if anatomy.parts[r.panel].face == face] for refs in (above, below)
        )
        for side in lower:
            bench.relabel(side, WAIST_LABEL)
        if not sew_across(bench, upper, lower):
            return None
    return bench.pattern()


def put_band_in(cutter: Cutter, height: float) -> Pattern | None:
    """Sews a straight waistband between a bodice and what hangs from it, as long as the shorter of both."""
    anatomy = cutter.anatomy
    if anatomy.has(Part.WAISTBAND):
        return None
    seam = anatomy.seam(Part.TORSO, LOWER_PARTS)
    if not seam.pairs:
        return None
    bench = Workbench(cutter.pattern)
    ends: dict[str, tuple[int, int]] = {}
    for a, _ in seam.pairs:
        bench.unpick(bench.at[a])
    bench.shift(cutter.names(*LOWER_PARTS), [0.0, -height, 0.0])
    for face in _FACES:
        upper = [bench.at[a] for a, _ in seam.pairs if anatomy.parts[a.panel].face == face]
        lower = [bench.at[b] for _, b in seam.pairs if anatomy.parts[b.panel].face == face]
        if not upper or not lower:
            return None
        width = min(sum(bench.piece_of(s).length(s) for s in sides) for sides in (upper, lower))
        level = np.mean([_level(bench, {face: sides}) for sides in (upper, lower)])
        model = bench.piece_of(upper[0]).panel
        band = _strip(f"wb_{face}", width, height, float(level), model)
        if band.name in bench.pieces:
            return None
        ids = bench.add(band)
        # Bottom, one end, top, the other end; the loop goes round as the panel above does.
        for side in lower:
            bench.relabel(side, "")
        bench.relabel(ids[2], WAIST_LABEL)
        if not sew_across(bench, upper, [ids[2]]) or not sew_across(bench, [ids[0]], lower):
            return None
        ends[face] = (ids[1], ids[3])
    _sew_ends(bench, ends)
    return bench.pattern()


def _sew_ends(bench: Workbench, ends: dict[str, tuple[int, int]]) -> None:
    for left in (True, False):
        sides = []
        for pair in ends.values():
            x = [
                float(bench.piece_of(s).panel.to_world(bench.piece_of(s).chord(s))[:, 0].mean()) for s in pair
            ]
            sides.append(pair[int(np.argmax(x) if left else np.argmin(x))])
        bench.sew(*sides)


def _strip(name: str, width: float, height: float, middle_y: float, model: Panel) -> Panel:
    half = width / 2
    corners = np.array([[-half, 0.0], [half, 0.0], [half, height], [-half, height]])
    z = 20.0
    if model.normal()[2] < 0:
        corners, z = corners * [-1.0, 1.0], -15.0
    placement = Placement((float(corners[0, 0]), middle_y - height / 2, z), (0.0, 0.0, 0.0))
    return Panel(name, corners - corners[0], (Edge(Line()),) * 4, placement, "body")


def _holder(cutter: Cutter, parts: Collection[Part]) -> dict[Face, list[EdgeRef]]:
    """Edges of bodice or band that skirt or trousers hang from, by face; nothing where a face has none."""
    seam = cutter.anatomy.seam({Part.TORSO, Part.WAISTBAND}, parts)
    found: dict[Face, list[EdgeRef]] = {f: [] for f in _FACES}
    for ref, other in seam.pairs:
        if cutter.anatomy.parts[ref.panel].face != cutter.anatomy.parts[other.panel].face:
            return {}
        found[cutter.anatomy.parts[ref.panel].face].append(ref)
    return found if all(found.values()) else {}


def _level(bench: Workbench, sides: dict[Face, list[int]]) -> float:
    """Mean placed height of sides, cm."""
    heights = [
        bench.piece_of(s).panel.to_world(bench.piece_of(s).chord(s))[:, 1].mean()
        for own in sides.values()
        for s in own
    ]
    return float(np.mean(heights))

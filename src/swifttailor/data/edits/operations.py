"""Geometric edits of any pattern: what can be recut, added or taken off, by random amounts."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

from swifttailor.body import Body, BodyMeasurements
from swifttailor.data.captions.facts import GarmentFacts
from swifttailor.data.captions.measure.anatomy import Anatomy, Border
from swifttailor.data.captions.measure.hems import find_hem
from swifttailor.data.captions.measure.measuring import measure_anatomy
from swifttailor.data.captions.measure.parts import (
    LOWER_PARTS,
    SKIRT_PARTS,
    UPPER_PARTS,
    Face,
    Part,
)
from swifttailor.data.captions.measure.skirts import upper_edges
from swifttailor.data.captions.measure.wear import wear
from swifttailor.data.edits.recutting.bands import BandPlan, add_band
from swifttailor.data.edits.recutting.ends import move_ends, swing_sides
from swifttailor.data.edits.recutting.fullness import widen_panels
from swifttailor.data.edits.recutting.necklines import NewShape, deepen_neckline, reshape_neckline
from swifttailor.data.edits.recutting.removal import WAIST_LABEL, remove_panels
from swifttailor.data.edits.recutting.slits import open_side
from swifttailor.pattern import EdgeRef, Pattern, Severity, check_pattern

_FACES: tuple[Face, Face] = ("front", "back")


class Cutter:
    """A pattern that is about to be recut, and what is known of it."""

    def __init__(self, pattern: Pattern, body: BodyMeasurements | None = None) -> None:
        self.pattern = pattern.canonical()
        self.anatomy = Anatomy.of(self.pattern, Body.default().measurements if body is None else body)

    @cached_property
    def facts(self) -> GarmentFacts:
        """What the pattern shows."""
        return measure_anatomy(self.anatomy)

    @cached_property
    def faults(self) -> frozenset[tuple[str, str]]:
        """Codes of errors and warnings, and the panels they are about."""
        found = check_pattern(self.pattern)
        return frozenset((f.code, f.panel) for f in found if f.severity is not Severity.INFO)

    @cached_property
    def seam_ratios(self) -> dict[tuple[str, str], float]:
        """For every two panels sewn together, the length of one's edges over that of the other's."""
        sums: dict[tuple[str, str], list[float]] = {}
        for s in self.pattern.stitches:
            first, second = sorted(s.sides)
            lengths = sums.setdefault((first.panel, second.panel), [0.0, 0.0])
            lengths[0] += self.anatomy.edge_length(first)
            lengths[1] += self.anatomy.edge_length(second)
        return {pair: a / b for pair, (a, b) in sums.items() if b > 0.5}

    @cached_property
    def hem(self) -> tuple[EdgeRef, ...]:
        """The hem, slits left out; of both legs."""
        return find_hem(self.anatomy, wear(self.anatomy)).edges

    def names(self, *parts: Part) -> list[str]:
        """Panels of some parts."""
        return [p.name for p in self.anatomy.panels(parts)]

    def hem_of(self, *parts: Part) -> tuple[EdgeRef, ...]:
        """The hem, if all of it belongs to some parts; else nothing."""
        return self.hem if self.hem and all(self.anatomy.part_of(r) in parts for r in self.hem) else ()

    def ends_of(self, part: Part, border: Border) -> tuple[EdgeRef, ...]:
        """Free edges of a part on one kind of border."""
        free = {r for loop in self.anatomy.loops(border) for r in loop.edges}
        return tuple(r for r in self.anatomy.free_edges(part) if r in free)

    def neckline(self, face: Face) -> tuple[EdgeRef, ...]:
        """Free edges of the neckline of a face; none where a shoulder is bare or something is sewn to it."""
        if (
            not all(wear(self.anatomy).shoulders)
            or self.anatomy.has(Part.COLLAR)
            or self.anatomy.has(Part.HOOD)
        ):
            return ()
        top = self.anatomy.top.edges if self.anatomy.top else ()
        return tuple(
            r
            for r in top
            if self.anatomy.part_of(r) is Part.TORSO and self.anatomy.parts[r.panel].face == face
        )


Apply = Callable[[Cutter, random.Random], Pattern | None]


@dataclass(frozen=True)
class Operation:
    """One way to edit a pattern."""

    name: str
    about: str
    apply: Apply
    """Makes an edited pattern by chance; None where the pattern does not allow it."""


def _change(rng: random.Random, least: float, most: float) -> float:
    """A length to add (mostly shorter ones) or to take off, cm."""
    size = least + (most - least) * rng.random() ** 1.5
    return size if rng.random() < 0.5 else -size


def _hem_length(cutter: Cutter, rng: random.Random) -> Pattern | None:
    hem = cutter.hem_of(*SKIRT_PARTS) or cutter.hem_of(Part.TORSO)
    return move_ends(cutter.pattern, hem, _change(rng, 5.0, 40.0)) if hem else None


def _leg_length(cutter: Cutter, rng: random.Random) -> Pattern | None:
    ends = cutter.ends_of(Part.TROUSER, Border.LEG)
    if ends:
        return move_ends(cutter.pattern, ends, _change(rng, 5.0, 45.0))
    ends = cutter.anatomy.seam(Part.TROUSER, Part.LEG_CUFF).own
    return (
        move_ends(cutter.pattern, ends, _change(rng, 5.0, 30.0), cutter.names(Part.LEG_CUFF))
        if ends
        else None
    )


def _sleeve_length(cutter: Cutter, rng: random.Random) -> Pattern | None:
    pattern, distance = cutter.pattern, _change(rng, 5.0, 30.0)
    done = False
    for side in ("left", "right"):
        sleeves = {p.name for p in cutter.anatomy.panels(Part.SLEEVE, side)}
        cuffs = [p.name for p in cutter.anatomy.panels(Part.CUFF, side)]
        free = [r for r in cutter.ends_of(Part.SLEEVE, Border.ARM) if r.panel in sleeves]
        ends = free or cutter.anatomy.seam(Part.SLEEVE, Part.CUFF, side).own
        if not ends:
            continue
        moved = move_ends(pattern, ends, distance, cuffs)
        if moved is None:
            return None
        pattern, done = moved, True
    return pattern if done else None


def _cuff_length(cutter: Cutter, rng: random.Random) -> Pattern | None:
    cuffs = [cutter.ends_of(p, b) for p, b in ((Part.CUFF, Border.ARM), (Part.LEG_CUFF, Border.LEG))]
    ends = rng.choice([c for c in cuffs if c] or [()])
    return move_ends(cutter.pattern, ends, _change(rng, 2.0, 12.0)) if ends else None


def _band_height(cutter: Cutter, rng: random.Random) -> Pattern | None:
    anatomy, distance = cutter.anatomy, _change(rng, 2.0, 10.0)
    hem = cutter.hem_of(Part.WAISTBAND)
    if hem:
        return move_ends(cutter.pattern, hem, distance)
    below = anatomy.seam(Part.WAISTBAND, LOWER_PARTS)
    if not below.pairs:
        return None
    return move_ends(cutter.pattern, below.own, distance, cutter.names(*LOWER_PARTS))


def _bodice_length(cutter: Cutter, rng: random.Random) -> Pattern | None:
    lower = cutter.anatomy.seam(Part.TORSO, {Part.WAISTBAND} | LOWER_PARTS)
    if not lower.pairs:
        return None
    carried = cutter.names(Part.WAISTBAND, *LOWER_PARTS)
    return move_ends(cutter.pattern, lower.own, _change(rng, 4.0, 18.0), carried)


def _collar_height(cutter: Cutter, rng: random.Random) -> Pattern | None:
    ends = cutter.anatomy.free_edges(Part.COLLAR)
    return move_ends(cutter.pattern, ends, _change(rng, 1.5, 6.0)) if ends else None


def _flare_hem(cutter: Cutter, rng: random.Random) -> Pattern | None:
    hem = cutter.hem_of(*SKIRT_PARTS) or cutter.hem_of(Part.TORSO)
    if not hem:
        return None
    gored = len(cutter.names(Part.SKIRT)) > 3
    width = _change(rng, 2.5, 12.0) * (0.4 if gored else 1.0)
    return swing_sides(cutter.pattern, hem, width, all_seams=gored)


def _flare_legs(cutter: Cutter, rng: random.Random) -> Pattern | None:
    ends = cutter.ends_of(Part.TROUSER, Border.LEG)
    return swing_sides(cutter.pattern, ends, _change(rng, 1.5, 6.0)) if ends else None


def _flare_sleeves(cutter: Cutter, rng: random.Random) -> Pattern | None:
    ends = cutter.ends_of(Part.SLEEVE, Border.ARM)
    return swing_sides(cutter.pattern, ends, _change(rng, 2.0, 9.0)) if ends else None


def _more_gathers(cutter: Cutter, rng: random.Random) -> Pattern | None:
    """Widens or narrows a skirt that hangs from a seam, or the lower rows of a tiered one."""
    anatomy = cutter.anatomy
    _, seam = upper_edges(anatomy, Part.SKIRT)
    if not seam.pairs or anatomy.darts(Part.SKIRT) or anatomy.has(Part.GODET):
        return None
    factor = rng.uniform(1.2, 1.8) if rng.random() < 0.6 else rng.uniform(0.6, 0.85)
    if not 0.99 <= seam.gather * factor <= 2.8:
        return None
    return widen_panels(cutter.pattern, cutter.names(Part.SKIRT), factor)


def _remove(*parts: Part) -> Apply:
    def apply(cutter: Cutter, rng: random.Random) -> Pattern | None:
        if not cutter.anatomy.has(parts[0]):
            return None
        return remove_panels(cutter.pattern, cutter.names(*parts))

    return apply


def _remove_skirt(cutter: Cutter, rng: random.Random) -> Pattern | None:
    """Leaves the upper part of a dress or jumpsuit."""
    if not cutter.anatomy.has(Part.TORSO) or not any(cutter.anatomy.has(p) for p in LOWER_PARTS):
        return None
    return remove_panels(cutter.pattern, cutter.names(*LOWER_PARTS))


def _remove_upper(cutter: Cutter, rng: random.Random) -> Pattern | None:
    """Leaves the skirt of a dress or the trousers of a jumpsuit."""
    if not cutter.anatomy.has(Part.TORSO) or not any(cutter.anatomy.has(p) for p in LOWER_PARTS):
        return None
    return remove_panels(cutter.pattern, cutter.names(*UPPER_PARTS))


def _remove_one_sleeve(cutter: Cutter, rng: random.Random) -> Pattern | None:
    side = rng.choice(("left", "right"))
    names = [p.name for p in cutter.anatomy.panels((Part.SLEEVE, Part.CUFF), side)]
    both = all(cutter.anatomy.panels(Part.SLEEVE, s) for s in ("left", "right"))
    return remove_panels(cutter.pattern, names) if names and both else None


def _remove_waistband(cutter: Cutter, rng: random.Random) -> Pattern | None:
    """Only where nothing hangs on both sides of it."""
    anatomy = cutter.anatomy
    between = (
        anatomy.seam(Part.WAISTBAND, Part.TORSO).pairs and anatomy.seam(Part.WAISTBAND, LOWER_PARTS).pairs
    )
    if between or not anatomy.has(Part.WAISTBAND):
        return None
    return remove_panels(cutter.pattern, cutter.names(Part.WAISTBAND))


def _band_style(rng: random.Random) -> tuple[float, float, float]:
    """Height in cm, share of the length it is sewn to, and flare of a new cuff."""
    height = rng.choice((4.0, 5.0, 6.0, 8.0, 12.0)) + rng.uniform(-0.5, 0.5)
    if rng.random() < 0.35:
        return height + 3.0, 1.0, rng.uniform(1.4, 2.2)
    return height, rng.choice((1.0, 0.9, 0.75, 0.6, 0.5)), 1.0


def _add_cuffs(cutter: Cutter, rng: random.Random) -> Pattern | None:
    return _add_at_ends(cutter, rng, Part.SLEEVE, Part.CUFF, Border.ARM)


def _add_leg_cuffs(cutter: Cutter, rng: random.Random) -> Pattern | None:
    return _add_at_ends(cutter, rng, Part.TROUSER, Part.LEG_CUFF, Border.LEG)


def _add_at_ends(
    cutter: Cutter, rng: random.Random, upper: Part, lower: Part, border: Border
) -> Pattern | None:
    ends = cutter.ends_of(upper, border)
    if not ends or cutter.anatomy.has(lower):
        return None
    plans = [
        BandPlan(cuff_name(name), tuple(r for r in ends if r.panel == name))
        for name in dict.fromkeys(r.panel for r in ends)
    ]
    height, share, flare = _band_style(rng)
    length = sum(map(cutter.pattern.edge_length, ends))
    body = cutter.anatomy.body
    least = 2 * (1.25 * body.wrist if upper is Part.SLEEVE else 0.5 * body.leg_circ)
    share = max(share, min(1.0, least / length))
    return add_band(cutter.pattern, plans, height, share=share, flare=flare)


def _add_hem_band(cutter: Cutter, rng: random.Random) -> Pattern | None:
    hem = cutter.hem_of(Part.TORSO)
    if not hem or cutter.anatomy.has(Part.WAISTBAND):
        return None
    share = rng.choice((1.0, 0.95, 0.85, 0.75))
    length = sum(map(cutter.pattern.edge_length, hem))
    share = max(share, min(1.0, cutter.anatomy.body.waist / length))
    return add_band(cutter.pattern, _front_and_back(cutter, hem), rng.uniform(3.0, 10.0), share=share)


def _add_waistband(cutter: Cutter, rng: random.Random) -> Pattern | None:
    anatomy = cutter.anatomy
    if anatomy.has(Part.TORSO) or anatomy.has(Part.WAISTBAND):
        return None
    part = Part.TROUSER if anatomy.has(Part.TROUSER) else Part.SKIRT
    top, _ = upper_edges(anatomy, part)
    if not top:
        return None
    plans = _front_and_back(cutter, top)
    return add_band(cutter.pattern, plans, rng.uniform(3.0, 9.0), label=WAIST_LABEL)


def _front_and_back(cutter: Cutter, edges: Sequence[EdgeRef]) -> list[BandPlan]:
    parts = cutter.anatomy.parts
    plans = [BandPlan(f"wb_{f}", tuple(r for r in edges if parts[r.panel].face == f)) for f in _FACES]
    return [p for p in plans if p.edges]


def _deepen_neckline(cutter: Cutter, rng: random.Random) -> Pattern | None:
    edges = cutter.neckline(rng.choice(("front", "front", "back")))
    return deepen_neckline(cutter.pattern, edges, _change(rng, 3.0, 15.0)) if edges else None


def _reshape_neckline(cutter: Cutter, rng: random.Random) -> Pattern | None:
    edges = cutter.neckline(rng.choice(("front", "front", "front", "back")))
    shapes: tuple[NewShape, ...] = ("round", "v", "square")
    return reshape_neckline(cutter.pattern, edges, rng.choice(shapes)) if edges else None


def _side_slits(cutter: Cutter, rng: random.Random) -> Pattern | None:
    hem = cutter.hem_of(*SKIRT_PARTS)
    if not hem or len(cutter.names(Part.SKIRT)) > 3:
        return None
    height = rng.uniform(10.0, 45.0)
    sides = rng.choice((("left",), ("right",), ("left", "right")))
    pattern: Pattern | None = cutter.pattern
    for side in sides:
        edges = Cutter(pattern).hem if pattern is not cutter.pattern and pattern is not None else hem
        pattern = open_side(pattern, edges, height, side) if pattern is not None else None
    return pattern


OPERATIONS: tuple[Operation, ...] = (
    Operation("hem length", "lengthens or shortens a skirt, dress or top at its hem", _hem_length),
    Operation("leg length", "lengthens or shortens the legs", _leg_length),
    Operation("sleeve length", "lengthens or shortens the sleeves, cuffs moving along", _sleeve_length),
    Operation("cuff length", "lengthens or shortens cuffs of sleeves or legs", _cuff_length),
    Operation("band height", "widens or narrows the waistband or hem band", _band_height),
    Operation("bodice length", "lengthens or shortens the bodice, all below it moving along", _bodice_length),
    Operation("collar height", "widens or narrows a collar", _collar_height),
    Operation("flare hem", "flares or narrows a skirt or top by turning its side seams", _flare_hem),
    Operation("flare legs", "flares or narrows the legs", _flare_legs),
    Operation("flare sleeves", "flares or narrows the sleeves", _flare_sleeves),
    Operation("gather skirt", "widens or narrows a skirt, more or less of it gathered in", _more_gathers),
    Operation("remove sleeves", "takes the sleeves off", _remove(Part.SLEEVE, Part.CUFF)),
    Operation("remove one sleeve", "takes one sleeve off", _remove_one_sleeve),
    Operation("remove cuffs", "takes the cuffs off the sleeves", _remove(Part.CUFF)),
    Operation("remove leg cuffs", "takes the cuffs off the legs", _remove(Part.LEG_CUFF)),
    Operation("remove hood", "takes the hood off", _remove(Part.HOOD)),
    Operation("remove collar", "takes the collar off", _remove(Part.COLLAR)),
    Operation("remove waistband", "takes a waistband or hem band off", _remove_waistband),
    Operation("remove lower part", "leaves the upper part of a dress or jumpsuit", _remove_skirt),
    Operation("remove upper part", "leaves the lower part of a dress or jumpsuit", _remove_upper),
    Operation("add cuffs", "sews cuffs or flounces to the sleeves", _add_cuffs),
    Operation("add leg cuffs", "sews cuffs or flounces to the legs", _add_leg_cuffs),
    Operation("add hem band", "sews a band to the hem of a top", _add_hem_band),
    Operation("add waistband", "sews a waistband to a skirt or trousers", _add_waistband),
    Operation("deepen neckline", "lowers or raises the neckline in front or behind", _deepen_neckline),
    Operation("reshape neckline", "cuts the neckline round, square or to a V", _reshape_neckline),
    Operation("side slits", "opens one or both side seams of a skirt", _side_slits),
)
"""All of them. Each edit is used in both directions, so that what is removed is also added."""


def cuff_name(upper: str) -> str:
    """GarmentCode's name of the cuff panel below a sleeve or leg panel; a like name for other makers'."""
    parts = upper.split("_")
    if len(parts) == 3 and parts[1] == "sleeve":
        return f"sl_{parts[0]}_cuff_{parts[2]}"
    if len(parts) == 3 and parts[0] == "pant":
        return f"pant_{parts[2]}_cuff_{parts[1]}"
    return f"{upper}_cuff"

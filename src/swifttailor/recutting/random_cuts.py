"""Geometric edits of any pattern: what can be recut, added or taken off, by random amounts."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass

from swifttailor.describing.measuring.anatomy import Border
from swifttailor.describing.measuring.parts import LOWER_PARTS, SKIRT_PARTS, Part
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import cuts
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.necklines import NewShape, deepen_neckline, reshape_neckline
from swifttailor.recutting.ways.slits import open_side

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
    return cuts.lengthen_hem(cutter, _change(rng, 5.0, 40.0)) if cuts.free_hem(cutter) else None


def _leg_length(cutter: Cutter, rng: random.Random) -> Pattern | None:
    ends, cuffs = cuts.leg_ends(cutter)
    return cuts.lengthen_legs(cutter, _change(rng, 5.0, 30.0 if cuffs else 45.0)) if ends else None


def _sleeve_length(cutter: Cutter, rng: random.Random) -> Pattern | None:
    return cuts.lengthen_sleeves(cutter, _change(rng, 5.0, 30.0))


def _cuff_length(cutter: Cutter, rng: random.Random) -> Pattern | None:
    parts = [p for p in (Part.CUFF, Part.LEG_CUFF) if cuts.cuff_ends(cutter, p)]
    part = rng.choice(parts or [None])
    return cuts.lengthen_cuffs(cutter, _change(rng, 2.0, 12.0), part) if part else None


def _band_height(cutter: Cutter, rng: random.Random) -> Pattern | None:
    return cuts.raise_band(cutter, _change(rng, 2.0, 10.0))


def _bodice_length(cutter: Cutter, rng: random.Random) -> Pattern | None:
    lower = cutter.anatomy.seam(Part.TORSO, {Part.WAISTBAND} | LOWER_PARTS)
    return cuts.lengthen_bodice(cutter, _change(rng, 4.0, 18.0)) if lower.pairs else None


def _collar_height(cutter: Cutter, rng: random.Random) -> Pattern | None:
    has = cutter.anatomy.free_edges(Part.COLLAR)
    return cuts.raise_collar(cutter, _change(rng, 1.5, 6.0)) if has else None


def _flare_hem(cutter: Cutter, rng: random.Random) -> Pattern | None:
    if not cuts.free_hem(cutter):
        return None
    return cuts.flare_hem(cutter, _change(rng, 2.5, 12.0) * (0.4 if cuts.is_gored(cutter) else 1.0))


def _flare_legs(cutter: Cutter, rng: random.Random) -> Pattern | None:
    ends = cutter.ends_of(Part.TROUSER, Border.LEG)
    return cuts.flare_legs(cutter, _change(rng, 1.5, 6.0)) if ends else None


def _flare_sleeves(cutter: Cutter, rng: random.Random) -> Pattern | None:
    ends = cutter.ends_of(Part.SLEEVE, Border.ARM)
    return cuts.flare_sleeves(cutter, _change(rng, 2.0, 9.0)) if ends else None


def _more_gathers(cutter: Cutter, rng: random.Random) -> Pattern | None:
    """Widens or narrows a skirt that hangs from a seam, or the lower rows of a tiered one."""
    if cuts.skirt_gather(cutter) is None:
        return None
    factor = rng.uniform(1.2, 1.8) if rng.random() < 0.6 else rng.uniform(0.6, 0.85)
    return cuts.gather_skirt(cutter, factor)


def _remove(*parts: Part) -> Apply:
    return lambda cutter, rng: cuts.remove_parts(cutter, *parts)


def _remove_one_sleeve(cutter: Cutter, rng: random.Random) -> Pattern | None:
    return cuts.remove_sleeve(cutter, rng.choice(("left", "right")))


def _band_style(rng: random.Random) -> tuple[float, float, float]:
    """Height in cm, share of the length it is sewn to, and flare of a new cuff."""
    height = rng.choice((4.0, 5.0, 6.0, 8.0, 12.0)) + rng.uniform(-0.5, 0.5)
    if rng.random() < 0.35:
        return height + 3.0, 1.0, rng.uniform(1.4, 2.2)
    return height, rng.choice((1.0, 0.9, 0.75, 0.6, 0.5)), 1.0


def _add_at_ends(upper: Part, lower: Part, border: Border) -> Apply:
    def apply(cutter: Cutter, rng: random.Random) -> Pattern | None:
        if not cutter.ends_of(upper, border) or cutter.anatomy.has(lower):
            return None
        return cuts.add_cuffs(cutter, *_band_style(rng), upper=upper)

    return apply


def _add_hem_band(cutter: Cutter, rng: random.Random) -> Pattern | None:
    if not cuts.can_add_hem_band(cutter):
        return None
    share = rng.choice((1.0, 0.95, 0.85, 0.75))
    return cuts.add_hem_band(cutter, rng.uniform(3.0, 10.0), share)


def _add_waistband(cutter: Cutter, rng: random.Random) -> Pattern | None:
    return cuts.add_waistband(cutter, rng.uniform(3.0, 9.0)) if cuts.free_waist(cutter) else None


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
    Operation(
        "remove waistband", "takes a waistband or hem band off", lambda cutter, rng: cuts.remove_band(cutter)
    ),
    Operation(
        "remove lower part",
        "leaves the upper part of a dress or jumpsuit",
        lambda cutter, rng: cuts.remove_lower(cutter),
    ),
    Operation(
        "remove upper part",
        "leaves the lower part of a dress or jumpsuit",
        lambda cutter, rng: cuts.remove_upper(cutter),
    ),
    Operation(
        "add cuffs", "sews cuffs or flounces to the sleeves", _add_at_ends(Part.SLEEVE, Part.CUFF, Border.ARM)
    ),
    Operation(
        "add leg cuffs",
        "sews cuffs or flounces to the legs",
        _add_at_ends(Part.TROUSER, Part.LEG_CUFF, Border.LEG),
    ),
    Operation("add hem band", "sews a band to the hem of a top", _add_hem_band),
    Operation("add waistband", "sews a waistband to a skirt or trousers", _add_waistband),
    Operation("deepen neckline", "lowers or raises the neckline in front or behind", _deepen_neckline),
    Operation("reshape neckline", "cuts the neckline round, square or to a V", _reshape_neckline),
    Operation("side slits", "opens one or both side seams of a skirt", _side_slits),
)
"""All of them. Each edit is used in both directions, so that what is removed is also added."""

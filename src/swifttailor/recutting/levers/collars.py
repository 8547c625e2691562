"""Levers of collars and hoods: sewn on, and hoods of another size."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.describing.facts import Collar, CollarKind, GarmentFacts, Hood
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import neck_cuts
from swifttailor.recutting.levers.lever import Lever, fixed
from swifttailor.recutting.table.cutter import Cutter

_HOOD_HEIGHT_CM, _HOOD_DEPTH_CM = 52.0, 32.0
"""Of a new hood: what GarmentCode's have on average."""
_NATURAL: dict[CollarKind, float] = {"stand": 5.0, "lapel": 6.0}


def _has_neck(facts: GarmentFacts) -> bool:
    """Whether there is a neckline of two shoulders that nothing is sewn to."""
    necks = facts.front_neck, facts.back_neck
    if facts.collar is not None or facts.hood is not None:
        return False
    return all(n is not None and n.left is not None and n.right is not None for n in necks)


def _collar_added(kind: CollarKind) -> Lever:
    def imagine(facts: GarmentFacts, height: float) -> GarmentFacts:
        return replace(facts, collar=Collar(kind, height)) if _has_neck(facts) else facts

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        return neck_cuts.sew_collar(cutter, kind, amount)

    return Lever(
        "stand collar sewn on" if kind == "stand" else "lapels sewn on",
        5,
        lambda f: f.collar.height if f.collar else None,
        imagine,
        cut,
        fixed(2.0, 12.0),
        step=0.5,
        makes=True,
        moves=False,
        natural=_NATURAL[kind],
        only_for=("collar", "collar_cm"),
    )


def _add_hood(cutter: Cutter, depth: float) -> Pattern | None:
    return neck_cuts.sew_hood(cutter, _HOOD_HEIGHT_CM, depth)


def _with_hood(facts: GarmentFacts, depth: float) -> GarmentFacts:
    return replace(facts, hood=Hood(_HOOD_HEIGHT_CM, depth)) if _has_neck(facts) else facts


def _set_depth(facts: GarmentFacts, depth: float) -> GarmentFacts:
    return replace(facts, hood=replace(facts.hood, depth=depth)) if facts.hood else facts


def _set_height(facts: GarmentFacts, height: float) -> GarmentFacts:
    return replace(facts, hood=replace(facts.hood, height=height)) if facts.hood else facts


COLLAR_LEVERS: tuple[Lever, ...] = (
    _collar_added("stand"),
    _collar_added("lapel"),
    Lever(
        "hood sewn on, its depth",
        5,
        lambda f: f.hood.depth if f.hood else None,
        _with_hood,
        _add_hood,
        fixed(24.0, 44.0),
        makes=True,
        moves=False,
        natural=_HOOD_DEPTH_CM,
        only_for=("hood",),
    ),
    Lever(
        "hood",
        5,
        lambda f: f.hood.depth if f.hood else None,
        _set_depth,
        lambda cutter, amount: neck_cuts.resize_hood(cutter, 0.0, amount),
        fixed(22.0, 48.0),
        words=("deeper", "shallower"),
        only_for=("hood depth",),
    ),
    Lever(
        "hood",
        6,
        lambda f: f.hood.height if f.hood else None,
        _set_height,
        lambda cutter, amount: neck_cuts.resize_hood(cutter, amount, 0.0),
        fixed(42.0, 70.0),
        words=("taller", "lower"),
        only_for=("hood height",),
    ),
)

"""Two sides that differ made alike: one is cut like the other."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

from swifttailor.describing.facts import GarmentFacts, Neckline
from swifttailor.pattern import Pattern
from swifttailor.pattern.tidying.from_one_side import from_one_side
from swifttailor.pattern.tidying.symmetry import OTHER_SIDE
from swifttailor.recutting.levers.lever import Trick
from swifttailor.recutting.table.cutter import Cutter

_Side = Literal["left", "right"]


def _other(side: _Side) -> _Side:
    return "right" if side == "left" else "left"


def _like(side: _Side) -> Trick:
    """The other side made like one that has more: a shoulder, a sleeve, a longer one."""

    def imagine(facts: GarmentFacts) -> GarmentFacts | None:
        if facts.torso is None or _has(facts, side) <= _has(facts, _other(side)):
            return None
        return _alike(facts, side)

    def cut(cutter: Cutter) -> Pattern | None:
        parts = cutter.anatomy.parts
        own = frozenset(p for p, placed in parts.items() if p in OTHER_SIDE and placed.side == side)
        return from_one_side(cutter.pattern, own) if own else None

    return Trick(
        name=f"{_other(side)} side made like the {side}",
        stage=0,
        imagine=imagine,
        cut=cut,
        only_for=("sides", "shoulders: both"),
    )


def _has(facts: GarmentFacts, side: _Side) -> tuple[bool, bool, float, float, bool]:
    """How much a side has of what the other may lack."""
    torso = facts.torso
    assert torso is not None
    shoulder = getattr(torso, f"{side}_shoulder")
    sleeve = getattr(facts, f"{side}_sleeve")
    length, width = (sleeve.length, sleeve.upper_width) if sleeve else (0.0, 0.0)
    return shoulder is not None, sleeve is not None, length, width, side == "left"


def _alike(facts: GarmentFacts, side: _Side) -> GarmentFacts:
    torso, other = facts.torso, _other(side)
    assert torso is not None
    torso = replace(
        torso,
        **{f"{other}_{what}": getattr(torso, f"{side}_{what}") for what in ("shoulder", "armhole")},
    )

    def neck(own: Neckline | None) -> Neckline | None:
        half = None if own is None else getattr(own, side)
        return None if own is None or half is None else Neckline(half, half)

    return replace(
        facts,
        torso=torso,
        front_neck=neck(facts.front_neck),
        back_neck=neck(facts.back_neck),
        **{f"{other}_sleeve": getattr(facts, f"{side}_sleeve")},
    )


SIDE_TRICKS: tuple[Trick, ...] = (_like("left"), _like("right"))

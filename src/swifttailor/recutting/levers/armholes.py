"""Levers of the armholes of garments without sleeves: how deep they are, and how far out on the shoulder."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from swifttailor.describing.dimensions import DIMENSIONS
from swifttailor.describing.facts import Armhole, GarmentFacts, Neckline
from swifttailor.describing.facts_paths import mean
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import sleeve_cuts
from swifttailor.recutting.levers.lever import Lever, Trick, fixed
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.armhole_shapes import HoleShape, reshape_armholes
from swifttailor.recutting.ways.bare_shoulders import bare_shoulders
from swifttailor.recutting.ways.sleeves import ArmSide

_FURTHEST_CM = 20.0
"""From the middle of the body to the ends of lengthened shoulder seams."""

_SLIPS_CM = 9.0
"""A bodice that is wider than the chest by more does not stay up without shoulders."""


def _sleeveless(facts: GarmentFacts) -> bool:
    return facts.torso is not None and facts.left_sleeve is None and facts.right_sleeve is None


def _depth(facts: GarmentFacts) -> float | None:
    return DIMENSIONS["armholes"].of(facts) if _sleeveless(facts) else None


def _set_depth(facts: GarmentFacts, depth: float) -> GarmentFacts:
    by = depth - (_depth(facts) or 0.0)
    return _with_holes(facts, lambda hole: replace(hole, depth=hole.depth + by)) or facts


def _shoulder(facts: GarmentFacts) -> float | None:
    torso = facts.torso
    seams = [s for s in (torso.left_shoulder, torso.right_shoulder) if s is not None] if torso else []
    return mean(seams) if _sleeveless(facts) else None


def _set_shoulder(facts: GarmentFacts, length: float) -> GarmentFacts:
    by, torso = length - (_shoulder(facts) or 0.0), facts.torso
    if torso is None:
        return facts
    left, right = (s if s is None else s + by for s in (torso.left_shoulder, torso.right_shoulder))
    return replace(facts, torso=replace(torso, left_shoulder=left, right_shoulder=right))


def _shoulder_span(facts: GarmentFacts) -> tuple[float, float]:
    neck = facts.front_neck.width if facts.front_neck else 0.0
    return 3.0, max(_FURTHEST_CM - neck, (_shoulder(facts) or 0.0) + 0.1)


ARMHOLE_LEVERS: tuple[Lever, ...] = (
    Lever(
        name="armholes",
        serves=("armholes",),
        stage=4,
        of=_depth,
        imagine=_set_depth,
        cut=sleeve_cuts.deepen_armholes,
        span=fixed(12.0, 38.0),
        step=0.5,
        words=("deeper", "shallower"),
        only_for=("armholes",),
    ),
    Lever(
        name="shoulder seams at the armholes",
        serves=("shoulders",),
        stage=4,
        of=_shoulder,
        imagine=_set_shoulder,
        cut=sleeve_cuts.widen_shoulders,
        span=_shoulder_span,
        step=0.5,
        only_for=("shoulders", "straps"),
    ),
)


def _with_holes(facts: GarmentFacts, change: Callable[[Armhole], Armhole]) -> GarmentFacts | None:
    torso = facts.torso
    if torso is None or not (torso.left_armhole or torso.right_armhole):
        return None
    left, right = (h and change(h) for h in (torso.left_armhole, torso.right_armhole))
    return replace(facts, torso=replace(torso, left_armhole=left, right_armhole=right))


def _cut_to(shape: HoleShape) -> Trick:
    def imagine(facts: GarmentFacts) -> GarmentFacts | None:
        return _with_holes(facts, lambda hole: replace(hole, shape=shape)) if _sleeveless(facts) else None

    def cut(cutter: Cutter) -> Pattern | None:
        holes = sleeve_cuts.free_armholes(cutter)
        return reshape_armholes(cutter.pattern, holes, shape) if holes else None

    name = "armholes cut " + {"round": "round", "square": "square", "angled": "at an angle"}[shape]
    return Trick(name=name, stage=4, imagine=imagine, cut=cut, only_for=("armholes",))


def _bared(sides: tuple[ArmSide, ...]) -> Trick:
    """Shoulders cut off: of both sides, or of one of two."""

    def imagine(facts: GarmentFacts) -> GarmentFacts | None:
        torso = facts.torso
        if torso is None or facts.collar or facts.hood or torso.chest_ease > _SLIPS_CM:
            return None
        sleeves = {"left": facts.left_sleeve, "right": facts.right_sleeve}
        shoulders = {"left": torso.left_shoulder, "right": torso.right_shoulder}
        if any(sleeves[s] is not None or shoulders[s] is None for s in sides):
            return None
        if "left" in sides:
            torso = replace(torso, left_shoulder=None, left_armhole=None)
        if "right" in sides:
            torso = replace(torso, right_shoulder=None, right_armhole=None)

        def halved(neck: Neckline | None) -> Neckline | None:
            left = neck.left if neck and "left" not in sides else None
            right = neck.right if neck and "right" not in sides else None
            return Neckline(left, right) if left or right else None

        necks = halved(facts.front_neck), halved(facts.back_neck)
        return replace(facts, torso=torso, front_neck=necks[0], back_neck=necks[1])

    def cut(cutter: Cutter) -> Pattern | None:
        both = len(sides) == 2
        other_bare = not both and cutter.worn.shoulders[1 if sides == ("left",) else 0] is None
        return bare_shoulders(cutter.pattern, cutter.anatomy, sides, other_bare=other_bare)

    name = "shoulders bared" if len(sides) == 2 else f"{sides[0]} shoulder bared"
    return Trick(name=name, stage=4, imagine=imagine, cut=cut, only_for=("shoulders",))


ARMHOLE_TRICKS: tuple[Trick, ...] = (
    *(_cut_to(shape) for shape in ("round", "square", "angled")),
    _bared(("left", "right")),
    _bared(("left",)),
    _bared(("right",)),
)

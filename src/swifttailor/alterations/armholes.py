"""Levers of the armholes of garments without sleeves: how deep they are, and how far out on the shoulder."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.alterations.lever import Lever, fixed
from swifttailor.data.captions.facts import Armhole, GarmentFacts
from swifttailor.data.edits import cuts

_FURTHEST_CM = 20.0
"""From the middle of the body to the ends of lengthened shoulder seams."""


def _sleeveless(facts: GarmentFacts) -> bool:
    return facts.torso is not None and facts.left_sleeve is None and facts.right_sleeve is None


def _depth(facts: GarmentFacts) -> float | None:
    torso = facts.torso
    holes = [h for h in (torso.left_armhole, torso.right_armhole) if h] if torso else []
    return sum(h.depth for h in holes) / len(holes) if holes and _sleeveless(facts) else None


def _set_depth(facts: GarmentFacts, depth: float) -> GarmentFacts:
    by, torso = depth - (_depth(facts) or 0.0), facts.torso
    if torso is None:
        return facts

    def deeper(hole: Armhole | None) -> Armhole | None:
        return hole and replace(hole, depth=hole.depth + by)

    left, right = deeper(torso.left_armhole), deeper(torso.right_armhole)
    return replace(facts, torso=replace(torso, left_armhole=left, right_armhole=right))


def _shoulder(facts: GarmentFacts) -> float | None:
    torso = facts.torso
    seams = [s for s in (torso.left_shoulder, torso.right_shoulder) if s is not None] if torso else []
    return sum(seams) / len(seams) if seams and _sleeveless(facts) else None


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
        "armholes",
        4,
        _depth,
        _set_depth,
        cuts.deepen_armholes,
        fixed(12.0, 38.0),
        step=0.5,
        words=("deeper", "shallower"),
        only_for=("armholes",),
    ),
    Lever(
        "shoulder seams at the armholes",
        4,
        _shoulder,
        _set_shoulder,
        cuts.widen_shoulders,
        _shoulder_span,
        step=0.5,
        only_for=("shoulders", "straps"),
    ),
)

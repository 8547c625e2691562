"""Levers of hems that hang lower behind or in front, or on one side."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.alterations.lever import Lever, fixed
from swifttailor.data.captions.facts import GarmentFacts
from swifttailor.data.edits import cuts
from swifttailor.data.edits.cutter import Cutter
from swifttailor.data.edits.recutting.hem_line import bend_hem, slant_hem
from swifttailor.pattern import Pattern


def _rise(facts: GarmentFacts) -> float | None:
    return facts.hem.front - facts.hem.back if facts.hem and facts.trousers is None else None


def _set_rise(facts: GarmentFacts, rise: float) -> GarmentFacts:
    if facts.hem is None:
        return facts
    by = (rise - facts.hem.front + facts.hem.back) / 2
    return replace(facts, hem=replace(facts.hem, front=facts.hem.front + by, back=facts.hem.back - by))


def _cut(cutter: Cutter, amount: float) -> Pattern | None:
    hem = cuts.free_hem(cutter)
    return bend_hem(cutter.pattern, hem, {"front": -amount / 2, "back": amount / 2}) if hem else None


def _slant(facts: GarmentFacts) -> float | None:
    return facts.hem.right - facts.hem.left if facts.hem and facts.trousers is None else None


def _set_slant(facts: GarmentFacts, slant: float) -> GarmentFacts:
    if facts.hem is None:
        return facts
    by = (slant - facts.hem.right + facts.hem.left) / 2
    return replace(facts, hem=replace(facts.hem, right=facts.hem.right + by, left=facts.hem.left - by))


def _cut_slant(cutter: Cutter, amount: float) -> Pattern | None:
    hem = cuts.free_hem(cutter)
    return slant_hem(cutter.pattern, hem, amount / 2) if hem else None


HEM_SHAPE_LEVERS: tuple[Lever, ...] = (
    Lever(
        "hem bent, its front",
        6,
        _rise,
        _set_rise,
        _cut,
        fixed(-45.0, 45.0),
        words=("higher against its back", "lower against its back"),
        only_for=("hem_shape", "dip"),
    ),
    Lever(
        "hem slanted, its left side",
        6,
        _slant,
        _set_slant,
        _cut_slant,
        fixed(-45.0, 45.0),
        words=("lower against its right", "higher against its right"),
        only_for=("hem_shape",),
    ),
)

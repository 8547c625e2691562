"""Levers of hems that hang lower behind or in front, or on one side."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Literal

from swifttailor.describing.facts import GarmentFacts
from swifttailor.pattern import EdgeRef, Pattern
from swifttailor.recutting.amounts import cuts
from swifttailor.recutting.levers.lever import Lever, fixed
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.hem_line import bend_hem, slant_hem

Place = Literal["front", "back", "left", "right"]


def _tilt(
    name: str,
    high: Place,
    low: Place,
    recut: Callable[[Pattern, tuple[EdgeRef, ...], float], Pattern | None],
    words: tuple[str, str],
    only_for: tuple[str, ...],
) -> Lever:
    """Moves a hem up in one place by as much as it moves down in the opposite one."""

    def of(facts: GarmentFacts) -> float | None:
        if facts.hem is None or facts.trousers is not None:
            return None
        return getattr(facts.hem, high) - getattr(facts.hem, low)

    def imagine(facts: GarmentFacts, tilt: float) -> GarmentFacts:
        hem = facts.hem
        if hem is None:
            return facts
        up, down = getattr(hem, high), getattr(hem, low)
        by = (tilt - up + down) / 2
        return replace(facts, hem=replace(hem, **{high: up + by, low: down - by}))

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        hem = cuts.free_hem(cutter)
        return recut(cutter.pattern, hem, amount / 2) if hem else None

    return Lever(name, 6, of, imagine, cut, fixed(-45.0, 45.0), words=words, only_for=only_for)


HEM_SHAPE_LEVERS: tuple[Lever, ...] = (
    _tilt(
        "hem bent, its front",
        "front",
        "back",
        lambda pattern, hem, by: bend_hem(pattern, hem, {"front": -by, "back": by}),
        ("higher against its back", "lower against its back"),
        ("hem_shape", "dip"),
    ),
    _tilt(
        "hem slanted, its left side",
        "right",
        "left",
        slant_hem,
        ("lower against its right", "higher against its right"),
        ("hem_shape",),
    ),
)

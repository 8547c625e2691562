"""Levers of hems that hang lower behind or in front, or on one side."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from swifttailor.describing.facts import GarmentFacts, Place
from swifttailor.pattern import EdgeRef, Pattern
from swifttailor.recutting.amounts import cuts
from swifttailor.recutting.levers.lever import Lever, fixed
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.hem_line import bend_hem, slant_hem


def _tilt(
    name: str,
    serves: tuple[str, ...],
    *,
    high: Place,
    low: Place,
    recut: Callable[[Pattern, tuple[EdgeRef, ...], float], Pattern | None],
    words: tuple[str, str],
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

    return Lever(
        name=name,
        serves=serves,
        stage=6,
        of=of,
        imagine=imagine,
        cut=cut,
        span=fixed(-45.0, 45.0),
        words=words,
        only_for=serves,
    )


HEM_SHAPE_LEVERS: tuple[Lever, ...] = (
    _tilt(
        "hem bent, its front",
        ("dip", "hem_shape"),
        high="front",
        low="back",
        recut=lambda pattern, hem, by: bend_hem(pattern, hem, {"front": -by, "back": by}),
        words=("higher against its back", "lower against its back"),
    ),
    _tilt(
        "hem slanted, its left side",
        ("hem_shape",),
        high="right",
        low="left",
        recut=slant_hem,
        words=("lower against its right", "higher against its right"),
    ),
)

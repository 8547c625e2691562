"""Facts by their place: ``trousers.cuff.length`` is read, or imagined to be another."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from operator import attrgetter
from typing import Any

from swifttailor.describing.facts import GarmentFacts, Sleeve

Measure = Callable[[GarmentFacts], float | None]
"""cm, pieces or a ratio; None where the garment has no such thing."""
Imagine = Callable[[GarmentFacts, float], GarmentFacts]
"""What a garment would show if a measure had another value."""
BOTH_SIDES = ("left", "right")


def fact_at(place: str) -> Callable[[GarmentFacts], Any]:
    """Reads one fact; None where the garment has no such thing.

    Args:
        place: Names of fields of `GarmentFacts` and of what it consists of, such as ``hood.depth``.
    """
    names = place.split(".")

    def fact(facts: GarmentFacts) -> Any:
        found: Any = facts
        for name in names:
            found = getattr(found, name)
            if found is None:
                break
        return found

    return fact


def measure_at(place: str) -> Measure:
    """Reads one fact that is a number; see `fact_at`."""
    return measure_of(place, float)


def measure_of(place: str, how: Callable[[Any], float | None]) -> Measure:
    """A measure of what is in a place; None where there is nothing.

    Args:
        place: See `fact_at`.
        how: Measures it.
    """
    fact = fact_at(place)
    return lambda facts: None if (found := fact(facts)) is None else how(found)


def imagine_at(*paths: str) -> Imagine:
    """Sets facts of one part to a value; a garment without the part stays as it is.

    Args:
        paths: What is set, such as ``trousers.hem`` and ``trousers.opening``: fields of the same part.
    """
    part = paths[0].split(".")[0]
    names = [path.removeprefix(f"{part}.") for path in paths]
    whole = attrgetter(part)

    def imagine(facts: GarmentFacts, value: float) -> GarmentFacts:
        now = whole(facts)
        if now is None:
            return facts
        return replace(facts, **{part: replace(now, **dict.fromkeys(names, value))})

    return imagine


def sleeves_of(facts: GarmentFacts, sides: Iterable[str] = BOTH_SIDES) -> list[Sleeve]:
    """The sleeves that there are on some sides."""
    found = [facts.left_sleeve if side == "left" else facts.right_sleeve for side in sides]
    return [sleeve for sleeve in found if sleeve is not None]


def mean(values: Sequence[float]) -> float | None:
    """Of some values; None of none."""
    return sum(values) / len(values) if values else None


def mean_of_sleeves(of: Callable[[Sleeve], float | None], sides: Sequence[str] = ()) -> Measure:
    """A measure of sleeves.

    Args:
        of: Of one; None where it has no such thing, and then there is no mean either.
        sides: Where there must be one; whatever sleeves there are when empty.
    """

    def measure(facts: GarmentFacts) -> float | None:
        sleeves = sleeves_of(facts, sides or BOTH_SIDES)
        values = [of(sleeve) for sleeve in sleeves] if len(sleeves) >= len(sides) else []
        known = [value for value in values if value is not None]
        return mean(known) if len(known) == len(values) else None

    return measure


def shift_sleeves(of: Measure, *names: str, sides: Sequence[str] = BOTH_SIDES) -> Imagine:
    """Moves measures of the sleeves of some sides by as much as `of` would have to move to a value."""

    def imagine(facts: GarmentFacts, value: float) -> GarmentFacts:
        by = value - (of(facts) or 0.0)
        return with_sleeves(facts, lambda s: replace(s, **{n: getattr(s, n) + by for n in names}), sides)

    return imagine


def with_sleeves(
    facts: GarmentFacts, change: Callable[[Sleeve], Sleeve], sides: Sequence[str] = BOTH_SIDES
) -> GarmentFacts:
    """The same garment with the sleeves of some sides changed."""
    left, right = facts.left_sleeve, facts.right_sleeve
    return replace(
        facts,
        left_sleeve=change(left) if left and "left" in sides else left,
        right_sleeve=change(right) if right and "right" in sides else right,
    )

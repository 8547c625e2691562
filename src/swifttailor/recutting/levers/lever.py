"""Levers: ways to recut a pattern, each with what it would do to what the pattern shows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TypeVar

from swifttailor.describing.facts import GarmentFacts, HemFacts, Kind
from swifttailor.pattern import Pattern
from swifttailor.recutting.table.cutter import Cutter

T = TypeVar("T")

LOWEST_CM = -3.0
DRESS_BELOW_CROTCH_CM = 5.0


@dataclass(frozen=True)
class Lever:
    """One way to recut a pattern by an amount."""

    name: str
    """What is cut, for reports."""
    stage: int
    """Levers of lower stages are used first, since they move what the others cut."""
    of: Callable[[GarmentFacts], float | None]
    """The measure that it moves; None where there is no such thing."""
    imagine: Callable[[GarmentFacts, float], GarmentFacts]
    """What a garment would show if the measure had another value."""
    cut: Callable[[Cutter, float], Pattern | None]
    """Recuts by an amount."""
    span: Callable[[GarmentFacts], tuple[float, float]]
    """From where to where the measure may go."""
    step: float = 1.0
    """How finely values are looked at."""
    rate: float = 1.0
    """How far the measure moves for an amount of 1, about."""
    words: tuple[str, str] = ("longer", "shorter")
    """For a measure that grew and for one that shrank."""
    sign: float = 1.0
    """-1 where the words mean the opposite of the measure."""
    unit: str = " cm"
    makes: bool = False
    """Whether it makes the thing where there is none."""
    moves: bool = True
    """Whether it moves the measure of what is there."""
    natural: float | None = None
    """The measure that is made where nothing else is asked for."""
    only_for: tuple[str, ...] = ()
    """Claims and quantities it may be used for; all when empty."""
    gathers: bool = False
    """Whether seams are meant to join other lengths afterwards."""

    def said(self, was: float | None, now: float | None) -> str:
        """What was done, in words."""
        if was is None or now is None:
            return f"{self.name}, {now:.1f}{self.unit}" if now is not None else self.name
        change = (now - was) * self.sign
        if abs(change) < 0.05:
            return self.name.rstrip(",")
        return f"{self.name} {abs(change):.{1 if self.unit else 2}f}{self.unit} {self.words[change < 0]}"


@dataclass(frozen=True)
class Trick:
    """A way to recut a pattern that has no amount."""

    name: str
    """What is done, for reports."""
    stage: int
    imagine: Callable[[GarmentFacts], GarmentFacts | None]
    """What a garment would show afterwards; None where it cannot be done."""
    cut: Callable[[Cutter], Pattern | None]
    gathers: bool = False
    only_for: tuple[str, ...] = ()
    """Claims and quantities it may be done for; all when empty."""
    opens: tuple[str, ...] = ()
    """Claims it may be done for so that another lever can be used."""


def with_hem(facts: GarmentFacts, fall: float) -> GarmentFacts:
    """The same garment with its hem `fall` cm lower all around."""
    if facts.hem is None:
        return facts
    hem = facts.hem
    hem = HemFacts(
        hem.level - fall,
        hem.front - fall,
        hem.back - fall,
        hem.left - fall,
        hem.right - fall,
        hem.length,
        hem.dip,
    )
    return replace(facts, hem=hem, length=facts.length + fall, kind=kind_of(facts, hem.level))


def kind_of(facts: GarmentFacts, level: float) -> Kind:
    """What the garment is with its hem at another height."""
    if facts.kind not in ("top", "dress"):
        return facts.kind
    return "dress" if level < facts.body.crotch - DRESS_BELOW_CROTCH_CM else "top"


def fixed(low: float, high: float) -> Callable[[GarmentFacts], tuple[float, float]]:
    """A span that is the same for all garments."""
    return lambda facts: (low, high)

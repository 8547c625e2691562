"""Levers: ways to recut a pattern, each with what it would do to what the pattern shows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from swifttailor.describing.dimensions import DIMENSIONS
from swifttailor.describing.facts import GarmentFacts, Kind
from swifttailor.describing.facts_paths import Imagine, Measure
from swifttailor.pattern import Pattern
from swifttailor.recutting.table.cutter import Cutter

WIDER = ("wider", "narrower")
MORE_GATHERED = ("more gathered", "less gathered")
"""The measure is the length of the gathered edge over that of its seam."""
_HEM_LEVELS = ("level", "front", "back", "left", "right")
LOWEST_CM = -3.0
DRESS_BELOW_CROTCH_CM = 5.0


@dataclass(frozen=True, kw_only=True)
class Lever:
    """One way to recut a pattern by an amount."""

    name: str
    """What is cut, for reports."""
    serves: tuple[str, ...]
    """The dimensions that it is there for, first that which it moves most; a claim where it is none."""
    stage: int
    """Levers of lower stages are used first, since they move what the others cut."""
    of: Measure
    """The measure that it moves; None where there is no such thing."""
    imagine: Imagine
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
    natural: float | None = None
    """The measure of what it makes where there is none, if no other is asked for; None if it makes none."""
    moves: bool = True
    """Whether it moves the measure of what is there."""
    only_for: tuple[str, ...] = ()
    """Claims and quantities it may be used for; all when empty."""
    opens: tuple[str, ...] = ()
    """Claims for which it may make what there is none of, so that another lever can be used."""
    gathers: bool = False
    """Whether seams are meant to join other lengths afterwards."""
    or_less: tuple[float, ...] = ()
    """Parts of the measure to which it may be moved besides, where what it is leaves no room for the cut."""

    @property
    def label(self) -> str:
        """What is cut and how, as no other lever does."""
        name = self.name.rstrip(",")
        return f"{name}: {' or '.join(self.words)}" if self.moves else name

    def applies(self, facts: GarmentFacts) -> bool:
        """Whether a garment has what it moves, or lacks what it makes."""
        return self.natural is not None if self.of(facts) is None else self.moves

    def said(self, was: float | None, now: float | None) -> str:
        """What was done, in words."""
        name = self.name.rstrip(",")
        if was is None or now is None:
            return f"{name}, {now:.{1 if self.unit else 0}f}{self.unit}" if now is not None else name
        change = (now - was) * self.sign
        if abs(change) < 0.05:
            return name
        how = self.words[change < 0]
        if self.words == MORE_GATHERED:
            return f"{self.name} {how}: from {was:.2f} to {now:.2f} times the seam"
        if not self.unit:
            return f"{name}: {abs(change):.0f} {how}"
        return f"{self.name} {abs(change):.1f}{self.unit} {how}"


@dataclass(frozen=True, kw_only=True)
class Trick:
    """A way to recut a pattern that has no amount."""

    name: str
    """What is done, for reports."""
    stage: int
    imagine: Callable[[GarmentFacts], GarmentFacts | None]
    """What a garment would show afterwards; None where it cannot be done."""
    cut: Callable[[Cutter], Pattern | None]
    gathers: bool = False
    only_for: tuple[str, ...]
    """Claims and quantities it may be done for."""
    opens: tuple[str, ...] = ()
    """Claims it may be done for so that another lever can be used."""

    @property
    def label(self) -> str:
        """What is done, as by no other trick."""
        return self.name


def with_hem(facts: GarmentFacts, fall: float) -> GarmentFacts:
    """The same garment with its hem `fall` cm lower all around."""
    if facts.hem is None:
        return facts
    lower = {name: getattr(facts.hem, name) - fall for name in _HEM_LEVELS}
    hem = replace(facts.hem, **lower)
    return replace(facts, hem=hem, length=facts.length + fall, kind=kind_of(facts, hem.level))


def kind_of(facts: GarmentFacts, level: float) -> Kind:
    """What the garment is with its hem at another height."""
    if facts.kind not in ("top", "dress"):
        return facts.kind
    return "dress" if level < facts.body.crotch - DRESS_BELOW_CROTCH_CM else "top"


def fixed(low: float, high: float) -> Callable[[GarmentFacts], tuple[float, float]]:
    """A span that is the same for all garments."""
    return lambda facts: (low, high)


def of_dimension(name: str) -> Measure:
    """The measure of a dimension."""
    return DIMENSIONS[name].of


def of_sides(stem: str, sides: tuple[str, ...]) -> str:
    """What is cut on both sides or on one: ``sleeves``, ``left sleeve``."""
    return f"{stem}s" if len(sides) == 2 else f"{sides[0]} {stem}"

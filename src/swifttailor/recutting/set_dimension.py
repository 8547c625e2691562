"""Moving one dimension of a pattern to a value, as a slider does, by the levers that words pull."""

from __future__ import annotations

import math
from dataclasses import dataclass

from swifttailor.body import BodyMeasurements
from swifttailor.describing.dimensions import DIMENSIONS, QUANTITIES
from swifttailor.describing.facts import GarmentFacts
from swifttailor.errors import InputError, PatternError, SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.recutting.levers.all_levers import LEVERS_OF
from swifttailor.recutting.levers.lever import Lever
from swifttailor.recutting.table.checking import accepted
from swifttailor.recutting.table.cutter import Cutter

_AIMS = 4
_SHARE_OF_STEP = 0.05
"""How near to the value is near enough, as a share of the lever's step: half a millimetre mostly."""


@dataclass(frozen=True)
class Span:
    """Where a dimension may be moved."""

    value: float
    """What it is."""
    low: float
    high: float
    step: float


def dimension_spans(facts: GarmentFacts) -> dict[str, Span]:
    """The dimensions of a garment that levers can move, and from where to where.

    Args:
        facts: What its pattern shows.
    """
    spans = {}
    for name, dimension in QUANTITIES.items():
        value = dimension.of(facts)
        if value is None:
            continue
        ends, step = [value], math.inf
        for lever in _levers(name, facts):
            ends += [
                v for end in lever.span(facts) if (v := dimension.of(lever.imagine(facts, end))) is not None
            ]
            step = min(step, lever.step)
        low, high = min(ends), max(ends)
        if math.isfinite(step) and math.isfinite(low) and math.isfinite(high) and high - low >= step:
            spans[name] = Span(value, low, high, step)
    return spans


def set_dimension(
    pattern: Pattern, name: str, value: float, *, body: BodyMeasurements | None = None
) -> tuple[Pattern, str]:
    """Recuts a pattern until a dimension has a value, or as near to it as a lever comes.

    A cut is kept on the conditions of `alter`: the checker finds nothing new, and seams fit as before.

    Args:
        pattern: Any pattern placed around a body.
        name: A key of `QUANTITIES`.
        value: In its unit.
        body: Who it is made for; the body that the pattern names, else the default body, when None.

    Returns:
        The recut pattern, and what was done, in words.

    Raises:
        InputError: There is no such dimension, or the value is no number.
        PatternError: The pattern cannot be measured, has no such dimension, or cannot be cut so.
    """
    if name not in QUANTITIES:
        raise InputError(f"There is no dimension '{name}'. Known: {', '.join(QUANTITIES)}.")
    if not math.isfinite(value):
        raise InputError(f"The value of '{name}' is {value}; a finite number is accepted.")
    if not pattern.panels:
        raise PatternError("A pattern without panels cannot be altered. Give one with at least one panel.")
    start, of = Cutter(pattern, body), DIMENSIONS[name].of
    was = of(start.facts)
    if was is None:
        raise PatternError(f"This garment has no '{name}' ({DIMENSIONS[name].about}).")
    best, miss, said = start, abs(value - was), ""
    for lever in _levers(name, start.facts):
        found = _aim(start, lever, name, value)
        if found is not None and abs(found[1] - value) < miss - 1e-6:
            best, miss, said = found[0], abs(found[1] - value), lever.name.rstrip(",")
        if miss <= _SHARE_OF_STEP * lever.step:
            break
    if not said:
        if miss <= 0.05:
            return start.pattern, ""
        raise PatternError(
            f"The {name} cannot be made {value:g} from {was:.1f}: the seams would no longer fit, or nobody "
            "could wear it. Choose a value nearer to what it is."
        )
    now = of(best.facts)
    unit = " cm" if QUANTITIES[name].in_cm else ""
    return best.pattern, f"{name}: from {was:.1f} to {now if now is not None else value:.1f}{unit}"


def _levers(name: str, facts: GarmentFacts) -> list[Lever]:
    """Those that move a dimension that is there, the usual one first."""
    return [
        lever
        for lever in LEVERS_OF[name]
        if lever.moves and lever.of(facts) is not None and (not lever.only_for or name in lever.only_for)
    ]


def _aim(start: Cutter, lever: Lever, name: str, value: float) -> tuple[Cutter, float] | None:
    """Moves a lever so that a dimension gets a value, correcting the amount by what it did."""
    of = DIMENSIONS[name].of
    was = of(start.facts)
    assert was is not None
    rate, best = _rate(start.facts, lever, name), None
    amount, factor = (value - was) / rate, 1.0
    for _ in range(_AIMS):
        try:
            after = accepted(start, lever.cut(start, amount), gathers=lever.gathers, as_before=True)
        except SwiftTailorError:
            after = None
        now = of(after.facts) if after is not None else None
        if after is None or now is None:
            factor /= 2
            amount = factor * (value - was) / rate
            continue
        if best is None or abs(now - value) < abs(best[1] - value):
            best = after, now
        if abs(now - value) <= _SHARE_OF_STEP * lever.step or abs(amount) < 1e-6 or factor < 1.0:
            break
        if abs(now - was) > 1e-3:
            rate = (now - was) / amount
        amount += (value - now) / rate
    return best


def _rate(facts: GarmentFacts, lever: Lever, name: str) -> float:
    """How far the dimension moves for an amount of 1, by imagining it."""
    of, measure = DIMENSIONS[name].of, lever.of(facts)
    was = of(facts)
    assert measure is not None and was is not None
    imagined = of(lever.imagine(facts, measure + lever.rate))
    rate = 0.0 if imagined is None else imagined - was
    return rate if abs(rate) > 1e-3 else lever.rate

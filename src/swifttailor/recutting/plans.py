"""Plans: which lever could make a wish come true, and to what measure it would have to be moved.

Levers are tried in imagination: facts are changed as a cut would change them, and the wish is asked whether
it holds. That costs microseconds, and only what works there is cut and measured.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Bools
from swifttailor.describing.claims.claim import CLAIM_TYPES
from swifttailor.describing.claims.judgement import CLAIMING
from swifttailor.describing.differences import QUANTITIES, Change, Gain, Step, subject_of
from swifttailor.describing.facts import GarmentFacts
from swifttailor.recutting.levers.all_levers import LEVERS, TRICKS
from swifttailor.recutting.levers.lever import Lever, Trick

NATURAL_SHARE = 0.13
"""How much of a measure a step without an amount is, at least twice what is seen."""
_MIDDLE_STEPS = 16
"""What lies between closer bounds is cut to their middle; else a little inside the nearer one."""
_INSIDE_STEPS = 4
MOST_VALUES = 1000
"""Of a lever; measures of patterns that make no sense have no bounds either."""


OPENING: tuple[Lever | Trick, ...] = tuple([way for way in (*TRICKS, *LEVERS) if way.opens])
"""What may be done first, so that another lever can be used."""


@dataclass(frozen=True)
class Plan:
    """One way to fulfil a wish."""

    wish: Change
    way: Lever | Trick
    targets: tuple[float, ...]
    """Measures to move the lever to, the best first; none for a trick."""
    gained: int
    """How many other open wishes it would fulfil as well."""
    rank: int

    @property
    def order(self) -> tuple[int, int]:
        """Better plans come first."""
        return -self.gained, self.rank


def find_plans(
    facts: GarmentFacts, original: GarmentFacts, open_wishes: Sequence[Change], held: Sequence[Change]
) -> dict[Change, list[Plan]]:
    """Plans for every open wish, the best first; none that would lose a wish that holds.

    Args:
        facts: Of the garment as it is.
        original: What steps are judged against.
        open_wishes: What does not hold yet.
        held: What holds and must go on to.
    """
    plans: dict[Change, list[Plan]] = {wish: [] for wish in open_wishes}
    for rank, trick in enumerate(TRICKS):
        imagined = trick.imagine(facts)
        if imagined is None:
            continue
        good = [w for w in open_wishes if _meant_for(trick, w) and w.holds(original, imagined)]
        if good and all(w.holds(original, imagined) for w in held):
            for wish in good:
                plans[wish].append(Plan(wish, trick, (), len(good) - 1, rank))
    needed = frozenset[str]().union(*(_fields_read(w, original, facts) for w in open_wishes))
    for rank, lever in enumerate(LEVERS, start=len(TRICKS)):
        now = lever.of(facts)
        if not lever.applies(facts):
            continue
        values = _values(lever, facts, now)
        if not any(_meant_for(lever, w) for w in open_wishes):
            continue
        if not len(values) or not _moves_any(lever, facts, values, needed):
            continue
        imagined = [lever.imagine(facts, float(v)) for v in values]
        meant = [w for w in open_wishes if _meant_for(lever, w)]
        holding = {w: np.array([w.holds(original, i) for i in imagined]) for w in meant}
        useful = {w: mask for w, mask in holding.items() if mask.any()}
        if not useful:
            continue
        kept = np.array(
            [
                any(m[k] for m in useful.values()) and all(w.holds(original, i) for w in held)
                for k, i in enumerate(imagined)
            ]
        )
        count = np.sum(list(useful.values()), axis=0)
        for wish, mask in useful.items():
            possible = mask & kept
            if not possible.any():
                continue
            most = int(count[possible].max())
            possible &= count == most
            start = now if now is not None else lever.natural
            assert start is not None, lever.label
            targets = _targets(lever, wish, facts, original, (values, imagined, possible), start)
            clear = any(map(_claims(wish), (i for i, p in zip(imagined, possible, strict=True) if p)))
            plans[wish].append(Plan(wish, lever, targets, most - 1, rank if clear else rank + len(LEVERS)))
    return {w: sorted(found, key=lambda p: p.order) for w, found in plans.items()}


def opened(way: Lever | Trick, facts: GarmentFacts) -> GarmentFacts | None:
    """What a garment would show after what may be done first; None where that cannot be done."""
    if isinstance(way, Trick):
        return way.imagine(facts)
    if way.of(facts) is not None or way.natural is None:
        return None
    imagined = way.imagine(facts, way.natural)
    return None if imagined == facts else imagined


def names_it(wish: Change, names: Collection[str]) -> bool:
    """Whether a wish is among some claims and quantities, such as ``skirt`` or ``skirt: gathered``."""
    if subject_of(wish) in names:
        return True
    return isinstance(wish, Gain) and f"{wish.claim.name}: {wish.claim.value}" in names


def _meant_for(way: Lever | Trick, wish: Change) -> bool:
    return not way.only_for or names_it(wish, way.only_for)


class _Reader:
    """Facts that note which of them are read."""

    def __init__(self, facts: GarmentFacts) -> None:
        self.facts, self.read = facts, set[str]()

    def __getattr__(self, name: str) -> object:
        self.read.add(name)
        return getattr(self.facts, name)


def _fields_read(wish: Change, original: GarmentFacts, facts: GarmentFacts) -> frozenset[str]:
    """Facts that decide whether a wish holds: unless one of them changes, neither does the answer."""
    reader = _Reader(facts)
    wish.holds(original, cast(GarmentFacts, reader))
    return frozenset(reader.read)


def _moves_any(lever: Lever, facts: GarmentFacts, values: NDArray[np.float64], names: frozenset[str]) -> bool:
    """Whether a lever changes any of some facts."""
    ends = [lever.imagine(facts, float(v)) for v in values[[0, -1]]]
    return any(getattr(facts, n) != getattr(end, n) for n in names for end in ends)


def _values(lever: Lever, facts: GarmentFacts, now: float | None) -> NDArray[np.float64]:
    low, high = lever.span(facts)
    if not high > low:
        return np.zeros(0)
    count = min((high - low + 1e-6) / lever.step, MOST_VALUES)
    values = low + lever.step * np.arange(int(count) + 1, dtype=np.float64)
    return values if now is None else np.sort(np.append(values, now))


def _targets(
    lever: Lever,
    wish: Change,
    facts: GarmentFacts,
    original: GarmentFacts,
    seen: tuple[NDArray[np.float64], list[GarmentFacts], Bools],
    start: float,
) -> tuple[float, ...]:
    values, imagined, possible = seen
    miss = _miss(wish, original)
    if miss is None:
        assert isinstance(wish, Gain)
        test = CLAIM_TYPES[wish.claim.name].words[str(wish.claim.value)]
        strict = np.array([p and test(i, CLAIMING) for p, i in zip(possible, imagined, strict=True)])
        found = _inside(values, strict, start, lever.step) if strict.any() else []
        found += [_nearest_run(values, possible, start)[0] if abs(start - values[possible]).min() else start]
        less = [part * start for part in lever.or_less if strict[np.abs(values - part * start).argmin()]]
        return tuple(dict.fromkeys([*found, *less]))
    missed = np.array([miss(i) if p else np.inf for p, i in zip(possible, imagined, strict=True)])
    best = float(values[int(missed.argmin())])
    fine = best + lever.step * np.linspace(-1.0, 1.0, 21)
    best = float(min(fine, key=lambda v: miss(lever.imagine(facts, float(v)))))
    if isinstance(wish, Step) and wish.amount is not None:
        return (best,)
    near = float(values[possible][np.abs(values[possible] - start).argmin()])
    return tuple(dict.fromkeys((best, (best + near) / 2, near)))


def _inside(values: NDArray[np.float64], mask: Bools, start: float, step: float) -> list[float]:
    """A value well inside the nearest run of a mask, then the near end of the run."""
    near, far = _nearest_run(values, mask, start)
    width = abs(far - near)
    if near <= start <= far or far <= start <= near:
        return [start]
    if width <= _MIDDLE_STEPS * step:
        return [(near + far) / 2, near]
    return [near + np.sign(far - near) * min(_INSIDE_STEPS * step, 0.2 * width), near]


def _nearest_run(values: NDArray[np.float64], mask: Bools, start: float) -> tuple[float, float]:
    """Ends of the run of a mask that is nearest to a value, the near one first."""
    at = np.flatnonzero(mask)
    nearest = int(at[np.abs(values[at] - start).argmin()])
    low = high = nearest
    while low > 0 and mask[low - 1]:
        low -= 1
    while high < len(mask) - 1 and mask[high + 1]:
        high += 1
    a, b = float(values[low]), float(values[high])
    if a <= start <= b:
        return a, b
    return (a, b) if start < a else (b, a)


def _claims(wish: Change) -> Callable[[GarmentFacts], bool]:
    """Whether facts are clearly so, and not only within what is tolerated; always of a number."""
    if not isinstance(wish, Gain) or CLAIM_TYPES[wish.claim.name].measure is not None:
        return lambda facts: True
    test = CLAIM_TYPES[wish.claim.name].words[str(wish.claim.value)]
    return lambda facts: test(facts, CLAIMING)


def _miss(wish: Change, original: GarmentFacts) -> Callable[[GarmentFacts], float] | None:
    """How far facts are from what a wish with a number asks for; None for a word."""
    if isinstance(wish, Gain):
        measure = CLAIM_TYPES[wish.claim.name].measure
        if measure is None:
            return None
        stated = float(wish.claim.value)
        return lambda facts: abs((measure.stated_measure(facts) or 0.0) - stated)
    quantity = QUANTITIES[wish.quantity]
    was = quantity.of(original) or 0.0
    seen = 2.0 * quantity.least if quantity.unit != "pieces" else 1.0
    natural = max(seen, NATURAL_SHARE * abs(was))
    change = wish.direction * (wish.amount if wish.amount is not None else natural)
    return lambda facts: abs((quantity.of(facts) or 0.0) - was - change)

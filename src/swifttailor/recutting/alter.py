"""Altering a pattern: cuts that make wishes hold, one after the other, none at the cost of another."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from typing import cast

from swifttailor.body import BodyMeasurements
from swifttailor.describing import Claim
from swifttailor.describing.change_text import read_change
from swifttailor.describing.differences import Change
from swifttailor.describing.facts import GarmentFacts
from swifttailor.errors import PatternError, SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.recutting.levers.lever import Lever, Trick
from swifttailor.recutting.plans import OPENING, Plan, find_plans, names_it, opened
from swifttailor.recutting.table.checking import accepted
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.unasked import Keep, spoken_parts, unasked, undoing

MOST_CUTS = 12
TRIES_A_CUT = 5
"""Cuts that are measured for each that may be kept."""
MOST_UNDONE = 3
"""Changes elsewhere that are cut back for one wish."""
AIMS = 3
"""Times an amount is corrected."""


@dataclass(frozen=True, eq=False)
class Alteration:
    """What came of altering a pattern."""

    pattern: Pattern
    """Recut as far as possible."""
    facts: GarmentFacts
    """What it shows."""
    done: tuple[Change, ...]
    """Wishes that hold now and did not before."""
    open: tuple[Change, ...]
    """Wishes that still do not hold."""
    cuts: tuple[str, ...]
    """What was done, in words."""


def alter(
    pattern: Pattern,
    wishes: Sequence[Change | Claim | Keep | str],
    *,
    original: GarmentFacts | None = None,
    body: BodyMeasurements | None = None,
    most_cuts: int = MOST_CUTS,
    keep_others: bool = False,
    kept: Collection[str] = (),
) -> Alteration:
    """Recuts a pattern until wishes hold, as many as can be.

    Every cut is kept only if the checker finds nothing new, seams fit as before, lengths are such as are
    worn, and no wish that held is lost.

    Args:
        pattern: Any pattern placed around a body.
        wishes: What the garment should show: changes, claims, or either as text, such as ``sleeves=long`` or
            ``length +10`` (`read_change`); or measures that are to stay (`Keep`).
        original: What steps are judged against; what the pattern shows when None.
        body: Who it is made for; the body that the pattern names, else the default body, when None.
        most_cuts: How many cuts are kept at most.
        keep_others: Whether nothing may be seen to change in parts that no wish speaks of (`unasked`): what a
            cut changes there is cut back, and a wish that cannot be had so stays open.
        kept: Claims and quantities that are to stay, even in those parts.

    Raises:
        PatternError: The pattern cannot be measured.
        InputError: A text is no change of a garment.
    """
    if not pattern.panels:
        raise PatternError("A pattern without panels cannot be altered. Give one with at least one panel.")
    start = Cutter(pattern, body)
    asked = tuple(dict.fromkeys([_as_change(wish) for wish in wishes]))
    parts = spoken_parts(asked) if keep_others else None
    work = _Work(original or start.facts, asked, most_cuts * TRIES_A_CUT, parts, frozenset(kept))
    before = set(work.holding(start.facts))
    now, said = start, []
    failed: set[Change] = set()
    while len(said) < most_cuts:
        waiting = [w for w in work.wishes if w not in failed and not work.holds(w, now)]
        if not waiting or work.tries_left <= 0:
            break
        plans = find_plans(now.facts, work.original, waiting, work.holding(now.facts))
        wish = min(waiting, key=lambda w: plans[w][0].way.stage if plans[w] else 9)
        found = work.fulfil(now, plans[wish]) or work.fulfil_in_two(now, wish)
        if found is None:
            failed.add(wish)
            continue
        now, words = found
        said += words
        failed = {w for w in failed if not plans.get(w)}
    holding = set(work.holding(now.facts))
    return Alteration(
        now.pattern if said else pattern,
        now.facts,
        tuple(w for w in work.wishes if w in holding - before),
        tuple(w for w in work.wishes if w not in holding),
        tuple(said),
    )


def _as_change(wish: Change | Claim | Keep | str) -> Change:
    return cast(Change, wish) if isinstance(wish, Keep) else read_change(wish)


@dataclass
class _Work:
    """The wishes, and how much may still be tried."""

    original: GarmentFacts
    wishes: tuple[Change, ...]
    tries_left: int
    parts: frozenset[str] | None = None
    """That wishes speak of, where nothing else may change."""
    kept: frozenset[str] = frozenset()
    """Subjects that may not change in any part."""
    tried: dict[tuple[Cutter, str, float], Cutter | None] = field(default_factory=dict)

    def holding(self, facts: GarmentFacts) -> tuple[Change, ...]:
        return tuple(w for w in self.wishes if w.holds(self.original, facts))

    def holds(self, wish: Change, cutter: Cutter) -> bool:
        return wish.holds(self.original, cutter.facts)

    def fulfil(self, now: Cutter, plans: Sequence[Plan]) -> tuple[Cutter, list[str]] | None:
        """Carries out the first plan that works; else the first whose harm another cut makes good."""
        harmful: list[tuple[Cutter, str]] = []
        for plan in plans:
            way = plan.way
            found = (
                self._trick(now, plan, way) if isinstance(way, Trick) else self._aim(now, plan, way, harmful)
            )
            found = self._undone(found)
            if found is not None:
                return found
        held = self.holding(now.facts)
        for after, words in harmful[:2]:
            mended = self._mend(after, held)
            found = self._undone(mended and (mended[0], [words, *mended[1]]))
            if found is not None:
                return found
        return None

    def _undone(self, found: tuple[Cutter, list[str]] | None) -> tuple[Cutter, list[str]] | None:
        """What was cut with what it changed elsewhere cut back; None where that cannot be."""
        if found is None or (self.parts is None and not self.kept):
            return found
        after, words = found
        for _ in range(MOST_UNDONE):
            changed = self._changed_elsewhere(after)
            if not changed:
                return after, words
            held = self.holding(after.facts)
            back = None
            for wish in undoing(changed, self.original):
                for plan in find_plans(after.facts, self.original, [wish], held)[wish]:
                    back = self._aim(after, plan, plan.way, []) if isinstance(plan.way, Lever) else None
                    if back is not None and len(self._changed_elsewhere(back[0])) < len(changed):
                        break
                    back = None
                if back is not None:
                    break
            if back is None:
                return None
            after, words = back[0], [*words, *back[1]]
        return None if self._changed_elsewhere(after) else (after, words)

    def _changed_elsewhere(self, after: Cutter) -> tuple[Change, ...]:
        return unasked(self.parts, self.original, after.facts, self.kept)

    def _mend(self, after: Cutter, held: Sequence[Change]) -> tuple[Cutter, list[str]] | None:
        """Brings back the one wish that a cut has lost."""
        lost = [w for w in held if not self.holds(w, after)]
        if len(lost) != 1:
            return None
        holding = self.holding(after.facts)
        for plan in find_plans(after.facts, self.original, lost, holding)[lost[0]]:
            if isinstance(plan.way, Lever):
                found = self._aim(after, plan, plan.way, [])
                if found is not None:
                    return found
        return None

    def fulfil_in_two(
        self, now: Cutter, wish: Change, *, deeper: bool = True
    ) -> tuple[Cutter, list[str]] | None:
        """Takes off or sews on what opens a way first; something else after that where it has to be."""
        held = self.holding(now.facts)
        for way in OPENING:
            imagined = opened(way, now.facts) if names_it(wish, way.opens) else None
            if imagined is None or not all(w.holds(self.original, imagined) for w in held):
                continue
            if not deeper and not find_plans(imagined, self.original, [wish], held)[wish]:
                continue
            natural = way.natural or 0.0 if isinstance(way, Lever) else 0.0
            between = self._cut(now, way, natural)
            if between is None or not self._keeps(held, between):
                continue
            found = self.fulfil(between, find_plans(between.facts, self.original, [wish], held)[wish])
            if found is None and deeper:
                found = self.fulfil_in_two(between, wish, deeper=False)
            if found is not None and self._keeps(held, found[0]):
                return found[0], [way.name.rstrip(","), *found[1]]
        return None

    def _keeps(self, held: Sequence[Change], after: Cutter) -> bool:
        return all(self.holds(w, after) for w in held)

    def _trick(self, now: Cutter, plan: Plan, trick: Trick) -> tuple[Cutter, list[str]] | None:
        after = self._cut(now, trick, 0.0)
        good = (
            after is not None and self.holds(plan.wish, after) and self._keeps(self.holding(now.facts), after)
        )
        return (after, [trick.name]) if after is not None and good else None

    def _aim(
        self, now: Cutter, plan: Plan, lever: Lever, harmful: list[tuple[Cutter, str]]
    ) -> tuple[Cutter, list[str]] | None:
        """Moves a lever to a target, correcting the amount by what it did; notes what does harm as well."""
        held = self.holding(now.facts)
        was = lever.of(now.facts)
        for target in plan.targets:
            rate, amount = lever.rate, (target - (was or 0.0)) / lever.rate
            for _ in range(AIMS):
                after = self._cut(now, lever, amount)
                value = lever.of(after.facts) if after is not None else None
                if after is None:
                    break
                if self.holds(plan.wish, after):  # even where it is no longer what the lever moves
                    if self._keeps(held, after):
                        return after, [lever.said(was, value)]
                    harmful.append((after, lever.said(was, value)))
                if value is None:
                    break
                if abs(amount) > 0.1:
                    rate = (value - (was or 0.0)) / amount
                if abs(rate) < 0.1 * abs(lever.rate) or abs(target - value) < 0.05 * lever.step:
                    break
                amount += (target - value) / rate
        return None

    def _cut(self, now: Cutter, way: Lever | Trick, amount: float) -> Cutter | None:
        """Cuts and checks; remembers what it has tried on the same pattern."""
        key = (now, way.label, round(amount, 3))
        if key not in self.tried:
            if self.tries_left <= 0:
                return None
            try:
                edited = way.cut(now) if isinstance(way, Trick) else way.cut(now, amount)
                self.tries_left -= edited is not None
                self.tried[key] = accepted(now, edited, gathers=way.gathers, as_before=True)
            except SwiftTailorError:
                self.tried[key] = None
        return self.tried[key]

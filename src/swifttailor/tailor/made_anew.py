"""A pattern made anew from a known one, where cutting the given one does not lead to what is asked for.

Everything that is true of the old pattern and that nobody spoke of is to be true of the new one. Where that
cannot be had, nothing is made anew, and what is missing is said.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from swifttailor.describing.claims.claim import CLAIM_TYPES
from swifttailor.describing.differences import Change, Gain, Step, find_differences, subject_of
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.facts import GarmentFacts
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.pattern.trims.names import CLOSES_FRONT
from swifttailor.pattern_library.known import PatternLibrary
from swifttailor.pattern_library.nearest import Weights, log_likelihoods
from swifttailor.pattern_library.sought import Sought
from swifttailor.picture_reader.labels import measure_labels, statement_labels
from swifttailor.picture_reader.truth import TRUE, Truth
from swifttailor.recutting.alter import Alteration, alter
from swifttailor.recutting.amounts.donor_parts import lower_from, upper_from
from swifttailor.recutting.table.checking import accepted
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.unasked import part_of, spoken_parts, unasked, undoing
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.counted import counted_pattern
from swifttailor.tailor.fitting import judged
from swifttailor.tailor.reading import Wanted
from swifttailor.wishes.instructions.changes_of_garment import named_kind

MOST_TRIED = 6
"""Known patterns that are cut for one instruction."""
_LIKE = Weights(panels=0.0, boxes=0.0)
_UNMET = 1000.0
"""What a wish that a known pattern does not fulfil counts for, beside all that it has in common."""
_UPPER = frozenset({"sleeves", "neck", "shoulders", "bodice", "sides"})
_LOWER = frozenset({"skirt", "hem", "legs"})
_COUNTED = frozenset({"tiers", "gores", "godets"})
"""What is asked for by number, and is another garment with one more."""
_SAME_NUMBER = 0.25
GOOD_ENOUGH = 2.0
"""So much that no wish names may change where others might change less; then no other pattern is tried."""


def anew_from_known(wanted: Wanted, library: Callable[[], PatternLibrary | None]) -> Answer | None:
    """The known pattern that does all that is asked and is else what the one to edit is.

    Args:
        wanted: An instruction that cutting does not carry out.
        library: Gives known patterns; called where they are needed.

    Returns:
        None where there is none: then the pattern to edit stays as it is, as far as it cannot be cut.
    """
    edit, original = wanted.order.edit, wanted.original
    changes = tuple(dict.fromkeys([wish.change for wish in wanted.wishes]))
    if edit is None or original is None or not changes:
        return None
    known, cutter, parts = library(), Cutter(edit), spoken_parts(changes)
    if known is None:
        return None
    closed = parts is not None and any(name in CLOSES_FRONT for name in edit.trims)  # no known one is
    best: tuple[float, Answer] | None = None
    for number in _nearest(edit, changes, original, known)[:MOST_TRIED]:
        donor = Cutter(known.pattern(int(number)))
        for whole, start in _starts(cutter, donor, changes):
            found = _kept_like(start, changes, original)
            if found is None or found.open or unasked(parts, original, found.facts, wanted.heard.kept):
                continue
            if whole and (closed or _hangs_otherwise(changes, original, found.facts)):
                continue
            if _is_of_another_kind(changes, original, found.facts):
                continue
            cost = _changed_beside(changes, original, found.facts) + 0.5 * whole
            verdict = judged(found, wanted)
            if verdict.fault or (best is not None and cost >= best[0]):
                continue
            answer = Answer(
                found.pattern,
                verdict,
                wanted=wanted,
                cuts=found.cuts,
                known=known.ids[int(number)],
                anew="all" if whole else "half",
            )
            best = cost, answer
            if cost <= GOOD_ENOUGH:
                return answer
    return best[1] if best is not None else _from_design(wanted, cutter, changes, original)


def _from_design(
    wanted: Wanted, cutter: Cutter, changes: Sequence[Change], original: GarmentFacts
) -> Answer | None:
    """The lower half exchanged for one of as many gores, tiers or godets as are asked for, drafted anew."""
    drafted = counted_pattern(changes, named_kind(original))
    if drafted is None:
        return None
    pattern, design = drafted
    parts = spoken_parts(changes)
    for whole, start in _starts(cutter, Cutter(pattern), changes):
        found = None if whole else _kept_like(start, changes, original)
        if found is None or found.open or unasked(parts, original, found.facts, wanted.heard.kept):
            continue
        verdict = judged(found, wanted)
        if not verdict.fault:
            return Answer(
                found.pattern,
                verdict,
                wanted=wanted,
                cuts=found.cuts,
                design=design,
                anew="half",
            )
    return None


def _nearest(
    edit: Pattern, changes: Sequence[Change], original: GarmentFacts, library: PatternLibrary
) -> NDArray[np.intp]:
    """Numbers of known patterns: what is asked for first, then what is like the old pattern."""
    table = library.table
    gains = [c for c in changes if isinstance(c, Gain)]
    truth = Sought.of_truth(Truth.of(edit, original)).outranked_by(Sought.of_claims(g.claim for g in gains))
    fits = log_likelihoods(table, truth, _LIKE).astype(np.float64)
    labels = {label: k for k, label in enumerate(statement_labels())}
    names = {name: k for k, name in enumerate(measure_labels())}
    for change in changes:
        if isinstance(change, Gain):
            column = labels.get((change.claim.name, str(change.claim.value)))
            if column is not None:
                fits -= _UNMET * (table.statements[:, column] != TRUE)
            elif (kind := CLAIM_TYPES[change.claim.name].measure) is not None and kind.name in names:
                if kind.name in _COUNTED:
                    values = np.nan_to_num(table.measures[:, names[kind.name]], nan=-1e3)
                    fits -= _UNMET * (np.abs(values - float(change.claim.value)) > _SAME_NUMBER)
        elif isinstance(change, Step):
            was = QUANTITIES[change.quantity].of(original)
            values = table.measures[:, names[change.quantity]]
            if was is not None:
                with np.errstate(invalid="ignore"):
                    more = (values - was) * change.direction
                    good = more > QUANTITIES[change.quantity].least
                    if change.quantity in _COUNTED and change.amount is not None:
                        good &= np.abs(more - change.amount) < _SAME_NUMBER
                fits -= _UNMET * ~good
    return np.argsort(-fits, kind="stable")


def _starts(cutter: Cutter, donor: Cutter, changes: Sequence[Change]) -> Iterator[tuple[bool, Cutter]]:
    """What to begin from: the old pattern with one half of the known one, and the known one itself."""
    parts = spoken_parts(changes)
    spoken = {subject_of(c) for c in changes}
    if parts is not None or spoken == {"sides"}:
        own = {part_of(s) for s in spoken}
        ways = []
        if own and own <= _LOWER | {"waist"}:
            ways.append(lower_from)
        if (own and own <= _UPPER | {"waist"}) or spoken == {"sides"}:
            ways.append(upper_from)
        for way in ways:
            try:
                joined = accepted(cutter, way(cutter, donor), gathers=True, as_before=True)
            except SwiftTailorError:
                joined = None
            if joined is not None:
                yield False, joined
    yield True, donor


def _kept_like(start: Cutter, changes: Sequence[Change], original: GarmentFacts) -> Alteration | None:
    """A pattern cut to all that is asked for, and to what the old one shows besides."""
    try:
        found = alter(start.pattern, changes, original=original)
        if found.open:
            return None
        back = [w for w in undoing(_differences(original, found.facts), original) if not _is_of(w, changes)]
        after = alter(found.pattern, [*changes, *back], original=original)
    except SwiftTailorError:
        return None
    missing = tuple(c for c in after.open if c in set(changes))
    return replace(after, open=missing)


def _differences(before: GarmentFacts, after: GarmentFacts) -> tuple[Change, ...]:
    gains, steps = find_differences(before, after)
    return (*gains, *steps)


def _is_of(change: Change, changes: Sequence[Change]) -> bool:
    return subject_of(change) in {subject_of(c) for c in changes}


def _hangs_otherwise(changes: Sequence[Change], before: GarmentFacts, after: GarmentFacts) -> bool:
    """Whether the hem of a top is another where nobody speaks of it: that of a blazer that laps over."""
    if {part_of(subject_of(change)) for change in changes} & {"hem", "bodice", None}:
        return False
    was, now = (QUANTITIES["top width"].of(facts) for facts in (before, after))
    return was is not None and (now is None or QUANTITIES["top width"].seen(was, now))


def _is_of_another_kind(changes: Sequence[Change], before: GarmentFacts, after: GarmentFacts) -> bool:
    """Whether it is called something else, where nobody speaks of kinds or of where it ends: a tunic."""
    if {part_of(subject_of(change)) for change in changes} & {"hem", None}:
        return False
    return named_kind(before) != named_kind(after)


def _changed_beside(changes: Sequence[Change], before: GarmentFacts, after: GarmentFacts) -> float:
    """How much has changed that no wish names, whether or not it hangs on what one does."""
    return float(sum(1 for c in _differences(before, after) if not _is_of(c, changes)))

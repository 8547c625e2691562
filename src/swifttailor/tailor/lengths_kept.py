"""Lengths that words state, after a pattern was refitted: knee length is so on the body that wears it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from swifttailor.body import Body
from swifttailor.describing.differences import Change, Gain
from swifttailor.describing.dimensions import STATED
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.recutting.alter import alter
from swifttailor.tailor.answer import Answer
from swifttailor.wishes.assumed.well_within import as_stated
from swifttailor.wishes.text.from_the_body import length_on

LENGTHS = frozenset({"skirt_hem", "top_hem", "leg_hem", "sleeves", "left_sleeve", "right_sleeve"})
"""Claims about where a part of the garment ends on its wearer."""


def _too_long(asked: Iterable[Gain], facts: GarmentFacts) -> tuple[Change, ...]:
    """By how much legs are longer than their inseam was stated: they would lie on the feet."""
    return as_stated([gain for gain in asked if gain.claim.name == "inseam_cm"], facts)


def _without_open(answer: Answer, had: Iterable[Gain]) -> Answer:
    """An answer of which some wishes are met after all."""
    still = tuple([change for change in answer.verdict.open if change not in frozenset(had)])
    return replace(answer, verdict=replace(answer.verdict, open=still))


def with_lengths_kept(answer: Answer, body: Body) -> Answer:
    """An answer of which the lengths that were asked for, and held before it was refitted, hold again.

    What cannot be had again is no longer said to be met.

    Args:
        answer: Refitted.
        body: Who wears it.
    """
    wanted = answer.wanted
    if wanted is None or wanted.order.edit is not None:
        return answer
    asked = [w.change for w in wanted.wishes if w not in wanted.seen and isinstance(w.change, Gain)]
    # What the default body could not wear, another can: a dress of 60 cm is a child's.
    others = [gain for gain in asked if gain in answer.verdict.open and gain.claim.name in STATED]
    met = [gain for gain in asked if gain not in answer.verdict.open or gain in others]
    lengths = [gain for gain in met if gain.claim.name in LENGTHS or gain.claim.name in STATED]
    if not lengths:
        return answer
    try:
        facts = measure_facts(answer.pattern, body.measurements)
        # "Two inches above the knee" is a shorter dress on a shorter person.
        own = {
            gain: Gain(length_on(wanted.text, gain.claim, facts.body)) if gain in lengths else gain
            for gain in met
        }
        lost = [gain for gain in lengths if not own[gain].holds(facts, facts)]
        if others and not lost:
            answer = _without_open(answer, others)
        if not lost and not _too_long(own.values(), facts):
            return answer
        held = [own[gain] for gain in met if own[gain].holds(facts, facts)]
        again = [*held, *[own[gain] for gain in lost]]
        cut = alter(answer.pattern, again, body=body.measurements) if lost else None
        pattern = answer.pattern if cut is None else cut.pattern
        more = _too_long(own.values(), facts if cut is None else cut.facts)
        if more:  # well within the tolerance of the words, and on the floor
            cuts, missed = ((), ()) if cut is None else (cut.cuts, cut.open)
            shorter = alter(pattern, [*again, *more], body=body.measurements)
            if set(shorter.open) <= {*missed, *more}:
                cut = replace(shorter, cuts=(*cuts, *shorter.cuts), open=missed)
        if cut is None:
            return answer
    except SwiftTailorError:
        return answer
    missing = tuple([gain for gain in lost if own[gain] in cut.open and gain not in others])
    answer = _without_open(answer, [gain for gain in others if own[gain] not in cut.open])
    return replace(
        answer,
        pattern=cut.pattern,
        cuts=(*answer.cuts, *cut.cuts),
        verdict=replace(answer.verdict, open=(*answer.verdict.open, *missing)),
    )

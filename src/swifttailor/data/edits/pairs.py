"""Editing pairs: a pattern, an instruction, and the pattern it asks for, in both directions."""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import islice

from swifttailor.body import BodyMeasurements
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern import Pattern
from swifttailor.recutting.random_cuts import TOPICS, Way, recut_variously
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.wording.instructions.writer import Instruction, write_instruction

_REVERSED = "reversed"


@dataclass(frozen=True, eq=False)
class EditPair:
    """One training or test example of editing."""

    base: Pattern
    instruction: Instruction
    edited: Pattern
    source: str
    """Where it comes from: ``design``, or the label of a way to recut; ``..., reversed`` the other way."""


def pairs_of(
    base: Pattern,
    edited: Pattern,
    seed: int = 0,
    *,
    source: str = "",
    facts: tuple[GarmentFacts, GarmentFacts] | None = None,
    body: BodyMeasurements | None = None,
) -> list[EditPair]:
    """Makes the pairs of two versions of a garment: one each way, where a difference is seen.

    Args:
        base: The original.
        edited: Another version.
        seed: Decides the wording.
        source: What to note as their source.
        facts: Of both, if they have been measured.
        body: Who they are made for; the default body when None.
    """
    before, after = facts or (measure_facts(base, body), measure_facts(edited, body))
    pairs = []
    for one, other, a, b, note, offset in (
        (base, edited, before, after, source, 0),
        (edited, base, after, before, f"{source}, {_REVERSED}".lstrip(", "), 1),
    ):
        instruction = write_instruction(a, b, 2 * seed + offset)
        if instruction is not None:
            pairs.append(EditPair(one, instruction, other, note))
    return pairs


def is_reversed(source: str) -> bool:
    """Whether a pair of this source leads back to the pattern that was edited."""
    return source.endswith(_REVERSED)


def geometric_pairs(
    pattern: Pattern,
    seed: int = 0,
    *,
    count: int = 1,
    topics: Mapping[str, tuple[Way, ...]] = TOPICS,
    body: BodyMeasurements | None = None,
) -> list[EditPair]:
    """Recuts a pattern in a few ways and makes the pairs.

    Args:
        pattern: Any pattern, of any maker.
        seed: Decides the ways to recut, amounts and wording.
        count: How many topics to recut it about, where as many work.
        topics: Ways to choose from.
        body: Who it is made for; the body that the pattern names, else the default body, when None.

    Returns:
        Up to two pairs for each topic.
    """
    rng = random.Random(f"edit {seed}")
    cutter = Cutter(pattern, body)

    def pairs_with(way: Way, after: Cutter) -> list[EditPair]:
        facts = (cutter.facts, after.facts)
        return pairs_of(pattern, after.pattern, rng.randrange(2**31), source=way.label, facts=facts)

    ways = recut_variously(cutter, rng, pairs_with, topics=topics)
    return [pair for pairs in islice(ways, count) for pair in pairs]

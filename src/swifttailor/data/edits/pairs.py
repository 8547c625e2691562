"""Editing pairs: a pattern, an instruction, and the pattern it asks for, in both directions."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import islice
from typing import TypeVar

from swifttailor.body import BodyMeasurements
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.recutting.random_cuts import OPERATIONS, Operation
from swifttailor.recutting.table.checking import accepted
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.wording.instructions.writer import Instruction, write_instruction

T = TypeVar("T")

TRIES = 3
"""Of each operation, with other amounts."""
_REVERSED = "reversed"
_GATHERING = frozenset({"gather skirt"})


@dataclass(frozen=True, eq=False)
class EditPair:
    """One training or test example of editing."""

    base: Pattern
    instruction: Instruction
    edited: Pattern
    source: str
    """Where it comes from: ``design``, or the name of an operation; ``..., reversed`` the other way."""


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
    operations: tuple[Operation, ...] = OPERATIONS,
    body: BodyMeasurements | None = None,
) -> list[EditPair]:
    """Recuts a pattern in a few ways and makes the pairs.

    Args:
        pattern: Any pattern, of any maker.
        seed: Decides the operations, amounts and wording.
        count: How many different operations to use, where as many work.
        operations: Which to choose from.
        body: Who it is made for; the default body when None.

    Returns:
        Up to two pairs for each operation that works.
    """
    rng = random.Random(f"edit {seed}")
    cutter = Cutter(pattern, body)

    def pairs_with(operation: Operation, after: Cutter) -> list[EditPair]:
        facts = (cutter.facts, after.facts)
        return pairs_of(pattern, after.pattern, rng.randrange(2**31), source=operation.name, facts=facts)

    ways = recut_variously(cutter, rng, pairs_with, operations=operations)
    return [pair for pairs in islice(ways, count) for pair in pairs]


def recut_variously(
    cutter: Cutter,
    rng: random.Random,
    use: Callable[[Operation, Cutter], T | None],
    *,
    operations: tuple[Operation, ...] = OPERATIONS,
) -> Iterator[T]:
    """Recuts a pattern in one way after the other, each operation tried a few times with other amounts.

    Args:
        cutter: The pattern.
        rng: Decides order and amounts.
        use: Makes something of what an operation has left; of nothing, or what is empty, there is another
            try.
        operations: Which to try.

    Yields:
        What was made, at most once for each operation.
    """
    for operation in rng.sample(operations, len(operations)):
        for _ in range(TRIES):
            after = recut(cutter, operation, rng)
            made = None if after is None else use(operation, after)
            if made:
                yield made
                break


def recut(cutter: Cutter, operation: Operation, rng: random.Random) -> Cutter | None:
    """Applies an operation and checks what comes out.

    Returns:
        The edited pattern, in which the checker finds no error or warning that was not there before, every
        seam fits as well as it did, and lengths are such as are worn; None where the operation does not
        apply or did harm.
    """
    try:
        edited = operation.apply(cutter, rng)
    except SwiftTailorError:
        return None
    return accepted(cutter, edited, gathers=operation.name in _GATHERING)

"""Whether a pattern is what was asked for: the claims of its prompt, measured again on the pattern."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from swifttailor.describing import CLAIM_TYPES, Claim, GarmentFacts, measure_facts
from swifttailor.describing.differences import Gain
from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.evaluation.text_table import Column, Row, text_table
from swifttailor.pattern import Pattern
from swifttailor.pattern.check.crossings import find_crossing
from swifttailor.pattern.check.outline import trace_outline
from swifttailor.wording.instructions.writer import Instruction

MOST_CROSSINGS = 300
"""Of a panel that is measured."""
Measurable = Pattern | GarmentFacts
"""A pattern, or its facts where they have been measured: that takes a tenth of a second."""


@dataclass(frozen=True)
class Share:
    """How many of some statements hold."""

    held: int = 0
    made: int = 0

    @property
    def share(self) -> float | None:
        """None where none were made."""
        return self.held / self.made if self.made else None


@dataclass(frozen=True)
class Adherence:
    """What held of the prompts of some patterns."""

    claims: Share
    kinds: dict[str, Share] = field(default_factory=dict)
    """By name of the claim, in the order of `CLAIM_TYPES`; for instructions, by claim or quantity."""
    whole: Share = Share()
    """Prompts of which everything holds."""
    unmeasured: int = 0
    """Patterns that are missing or cannot be measured; nothing holds of them."""


def judge_claims(prompts: Sequence[Sequence[Claim]], patterns: Sequence[Measurable | None]) -> Adherence:
    """Measures patterns and judges the claims of their prompts by it, borderline cases in their favour.

    The share that holds is to be read between 1, which the patterns have that captions were written from, and
    `by_chance`.

    Args:
        prompts: The claims of each prompt (`Caption.claims`).
        patterns: What was made of each; None where nothing was.

    Raises:
        InputError: There are more of one than of the other.
    """
    _require_pairs(len(prompts), len(patterns))
    return _judge(prompts, [measured(p) for p in patterns])


def by_chance(prompts: Sequence[Sequence[Claim]], patterns: Sequence[Measurable | None]) -> Adherence:
    """The same with every prompt judged by the pattern of the next one: what holds of any garment."""
    _require_pairs(len(prompts), len(patterns))
    facts = [measured(p) for p in patterns]
    return _judge(prompts, facts[1:] + facts[:1])


def judge_instructions(
    instructions: Sequence[Instruction],
    before: Sequence[Measurable],
    after: Sequence[Measurable | None],
) -> Adherence:
    """Measures patterns before and after an edit, and judges each change that was asked for.

    Args:
        instructions: What was asked for.
        before: The patterns that were to be edited.
        after: What was made of them; None where nothing was.

    Raises:
        InputError: There are not equally many.
    """
    _require_pairs(len(instructions), len(before))
    _require_pairs(len(instructions), len(after))
    verdicts, unmeasured = [], 0
    for instruction, base, edited in zip(instructions, before, after, strict=True):
        first, second = measured(base), measured(edited)
        unmeasured += first is None or second is None
        verdicts.append(
            [
                (
                    change.claim.name if isinstance(change, Gain) else change.quantity,
                    first is not None and second is not None and change.holds(first, second),
                )
                for change in instruction.changes
            ]
        )
    topics = sorted({topic for each in verdicts for topic, _ in each})
    return _adherence(verdicts, topics, unmeasured)


def measured(pattern: Measurable | None) -> GarmentFacts | None:
    """The facts of a pattern; None where there are none to measure.

    Untrained networks write outlines that cross themselves thousands of times, on which measuring takes
    minutes: they have none.
    """
    if pattern is None or isinstance(pattern, GarmentFacts):
        return pattern
    crossings = (find_crossing(trace_outline(panel)) for panel in pattern.panels)
    if any(c is not None and c.places > MOST_CROSSINGS for c in crossings):
        return None
    try:
        return measure_facts(pattern)
    except SwiftTailorError:
        return None


def _judge(prompts: Sequence[Sequence[Claim]], facts: Sequence[GarmentFacts | None]) -> Adherence:
    verdicts = [
        [(claim.name, found is not None and claim.holds(found)) for claim in claims]
        for claims, found in zip(prompts, facts, strict=True)
    ]
    return _adherence(verdicts, CLAIM_TYPES, sum(f is None for f in facts))


def _adherence(
    verdicts: Sequence[Sequence[tuple[str, bool]]], topics: Iterable[str], unmeasured: int
) -> Adherence:
    """From what each prompt says, by topic, and whether it holds; topics come in the order given."""
    said = [one for each in verdicts for one in each]
    kinds = {name: _share(holds for topic, holds in said if topic == name) for name in topics}
    return Adherence(
        _share(holds for _, holds in said),
        {name: share for name, share in kinds.items() if share.made},
        _share(all(holds for _, holds in each) for each in verdicts),
        unmeasured,
    )


def _share(verdicts: Iterable[bool]) -> Share:
    listed = list(verdicts)
    return Share(sum(listed), len(listed))


def _require_pairs(prompts: int, patterns: int) -> None:
    if prompts != patterns:
        raise InputError(
            f"There are {prompts} prompts and {patterns} patterns; give one, or None, for each prompt."
        )


def adherence_table(rows: Sequence[tuple[str, Adherence]]) -> str:
    """Share of the statements that hold, kind by kind.

    Args:
        rows: Name and result of each method, all of the same prompts: the true patterns, ours, by chance, ...
    """
    columns = [Column("n", "d"), *(Column(f"{name} %", ".1f") for name, _ in rows)]
    found = [result for _, result in rows]
    kinds = list(dict.fromkeys(name for result in found for name in result.kinds))
    lines = [_line("all statements", [r.claims for r in found])]
    lines.append(_line("prompts of which all hold", [r.whole for r in found]))
    lines += [_line(kind, [r.kinds.get(kind, Share()) for r in found]) for kind in kinds]
    not_measured = "".join(
        f"{name}: {r.unmeasured} patterns are missing or cannot be measured\n"
        for name, r in rows
        if r.unmeasured
    )
    return text_table(columns, lines) + not_measured


def _line(name: str, shares: Sequence[Share]) -> Row:
    percent = [None if s.share is None else 100 * s.share for s in shares]
    return name, [max((s.made for s in shares), default=0), *percent]

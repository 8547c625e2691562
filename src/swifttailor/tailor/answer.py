"""A pattern on its way from an order to its garment."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from swifttailor.pattern import Pattern
from swifttailor.pattern.check.repair import Change
from swifttailor.tailor.verdict import Verdict

if TYPE_CHECKING:
    from swifttailor.describing.differences import Change as Difference
    from swifttailor.pattern_maker.asking.confidence import Confidence
    from swifttailor.pattern_maker.maker import WrittenPattern
    from swifttailor.tailor.reading import Wanted
    from swifttailor.tailor.refining import Refinement


@dataclass(frozen=True, eq=False)
class Answer:
    """A pattern with all that is known of it; each room that it passes adds its part."""

    pattern: Pattern
    verdict: Verdict = field(default_factory=Verdict)
    """What is wrong with it."""
    changes: tuple[Change, ...] = ()
    """What was mended in it."""
    wanted: Wanted | None = None
    """What it answers; None of a pattern that was given to be sewn."""
    seed: int = 0
    """Of its sample of the order."""
    written: WrittenPattern | None = None
    """What the network wrote for it, or a known pattern; None of a pattern that was given to be sewn, or to
    be edited and left as it was."""
    known: str = ""
    """Id of the known pattern that it is cut from; empty where it was written."""
    cuts: tuple[str, ...] = ()
    """What was altered, in words."""
    of_edit: bool = False
    """Whether it is the pattern to edit that was altered, and what the network wrote was left aside."""
    attempt: int = 0
    """Which of the attempts it is, from 0."""
    failures: tuple[str, ...] = ()
    """What is wrong with the attempts that were not taken, in order."""
    refinement: Refinement | None = None
    """What came of looking again; None where that was not done."""
    prepared: Any = None
    """What the sewer made of it; None where it was not prepared to be sewn."""
    fitted_to: str = ""
    """Name of the body that the pattern was refitted to; empty where it was not."""
    seconds: dict[str, float] = field(default_factory=dict)
    """Its own, by stage: of what is done for all garments of an order together, a `Clock` takes the time."""

    @property
    def is_given(self) -> bool:
        """Whether it is the pattern to edit, and nothing was altered in it."""
        return self.of_edit and not self.cuts

    @cached_property
    def seen(self) -> tuple[Difference, ...] | None:
        """What is different from the pattern to edit; None where there is none, or it cannot be measured."""
        from swifttailor.tailor.changes_seen import changes_seen

        edit = None if self.wanted is None else self.wanted.order.edit
        return None if edit is None else changes_seen(edit, self.pattern)

    @property
    def is_other_than_wanted(self) -> bool:
        """Whether something that was understood does not hold, or nothing was understood of a text."""
        wanted = self.wanted
        guessed = wanted is not None and (wanted.misses or wanted.kind_is_guessed)
        return bool(self.verdict.open or self.verdict.refused) or guessed

    @property
    def rank(self) -> tuple[bool, int, int, float]:
        """Smaller is better: whether it can be sewn, the verdict, the likelihood of what was written."""
        likelihood = 0.0 if self.written is None else self.written.log_likelihood
        return self.prepared is None, *self.verdict.rank, -likelihood

    @property
    def confidence(self) -> Confidence | None:
        """How sure the network is of a picture; None without one, or where that was not measured for it."""
        return None if self.written is None else self.written.confidence

    @property
    def doubts(self) -> list[str]:
        """What to tell a person of whose picture the network is not sure."""
        confidence = self.confidence
        if confidence is None or not confidence.doubtful:
            return []
        return [
            "The picture may show no garment, or one unlike any that the network knows: it is less sure of "
            f"it than of {1 - confidence.value:.1%} of the pictures that it was validated with (confidence "
            f"{confidence.value:.3f})."
        ]

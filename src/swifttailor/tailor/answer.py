"""A pattern on its way from an order to its garment."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

from swifttailor.pattern import Pattern
from swifttailor.pattern.check.repair import Change
from swifttailor.tailor.verdict import Verdict

USUAL = 0.8
"""Certainty of what the names of garments usually mean; what they perhaps mean may be otherwise."""

if TYPE_CHECKING:
    from swifttailor.describing.differences import Change as Difference
    from swifttailor.parameter_reader.reader import Design
    from swifttailor.pattern_maker.asking.confidence import Confidence
    from swifttailor.pattern_maker.maker import WrittenPattern
    from swifttailor.tailor.drafted import DraftCandidate
    from swifttailor.tailor.reading import Wanted
    from swifttailor.tailor.refining import Refinement
    from swifttailor.wishes.reader import Wish


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
    design: Design | None = None
    """The design parameters that it was drafted from; None where it was not."""
    draft: str = ""
    """Name of the draft that it is cut from; empty where it was not."""
    drafted: DraftCandidate | None = None
    """That draft, which can be made for other bodies."""
    anew: Literal["", "half", "all"] = ""
    """How much of an edited pattern was made anew from a known one, which cutting did not lead to."""
    cuts: tuple[str, ...] = ()
    """What was altered, in words."""
    put_on: tuple[str, ...] = ()
    """Trims that its text asked for or meant, by name."""
    meant: tuple[str, ...] = ()
    """Those of them that the text does not say: the name of a garment means them."""
    taken_off: tuple[str, ...] = ()
    """Trims of the pattern to edit that the text does not want."""
    of_edit: bool = False
    """Whether it is the pattern to edit that was altered, and what the network wrote was left aside."""
    attempt: int = 0
    """Which of the attempts it is, from 0."""
    failures: tuple[str, ...] = ()
    """What is wrong with the attempts that were not taken, in order."""
    tried: tuple[Pattern, ...] = ()
    """The patterns of all attempts as they were judged, in order; empty of one that was given."""
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
        return self.of_edit and not self.cuts and not self.put_on and not self.taken_off

    @property
    def is_written(self) -> bool:
        """Whether the network wrote it."""
        return self.written is not None and not self.found and not self.draft

    @property
    def found(self) -> str:
        """Name of the candidate that it is cut from (`Candidate.name`); empty where it was none."""
        return self.known or ("" if self.design is None else "design")

    @cached_property
    def seen(self) -> tuple[Difference, ...] | None:
        """What is different from the pattern to edit; None where there is none, or it cannot be measured."""
        from swifttailor.tailor.changes_seen import changes_seen

        edit = None if self.wanted is None else self.wanted.order.edit
        return None if edit is None else changes_seen(edit, self.pattern)

    @cached_property
    def not_done(self) -> tuple[Wish, ...]:
        """What the text may ask for and is not so: it was not certain enough to be insisted on."""
        from swifttailor.tailor.reading import facts_of

        wanted = self.wanted
        unsure = [] if wanted is None else [w for w in wanted.likely if w not in wanted.seen]
        facts = facts_of(self.pattern) if unsure else None
        return tuple([w for w in unsure if facts is None or not w.change.holds(facts, facts)])

    @cached_property
    def not_usual(self) -> tuple[Wish, ...]:
        """What the names of garments in the text usually mean and is not so."""
        return tuple([wish for wish in self.not_done if wish.certainty >= USUAL])

    @property
    def oddness(self) -> int:
        """How much of it is odd or lacks what is usual."""
        return len(self.verdict.sits_badly) + len(self.verdict.beyond_usual) + len(self.not_usual)

    @cached_property
    def not_so(self) -> tuple[tuple[str, Difference], ...]:
        """Words of a description, and what they say of the cut, where the pattern measures otherwise."""
        from swifttailor.tailor.measured_doubts import said_and_not_so

        return said_and_not_so(self)

    @cached_property
    def unasked(self) -> tuple[Difference, ...]:
        """What an edit changed in parts that nobody spoke of."""
        from swifttailor.tailor.measured_doubts import changed_unasked

        return changed_unasked(self)

    @cached_property
    def moved_waist(self) -> float | None:
        """By how many cm a waist that is to stay became wider, below 0 narrower; None where it stays."""
        from swifttailor.tailor.measured_doubts import moved_waist

        return moved_waist(self)

    @cached_property
    def not_followed(self) -> tuple[Wish, ...]:
        """What pictures show nearly for certain and a draft of all that they show has otherwise."""
        from swifttailor.tailor.reading import facts_of
        from swifttailor.wishes.reader import SURE

        wanted = self.wanted
        seen = (
            [] if wanted is None else [w for w in wanted.likely if w in wanted.seen and w.certainty >= SURE]
        )
        facts = facts_of(self.pattern) if seen else None
        return tuple([w for w in seen if facts is not None and not w.change.holds(facts, facts)])

    @property
    def is_other_than_wanted(self) -> bool:
        """Whether something that was understood does not hold, or too little was understood to tell.

        What the name of a garment usually means counts, too, what cannot be made, and unknown words.
        """
        if self.verdict.open or self.verdict.refused:
            return True
        wanted = self.wanted
        if wanted is None:
            return False
        missing = bool(self.not_usual)
        heard = wanted.heard
        unheard = bool(heard.unread or heard.cannot or heard.unsure or heard.perhaps)
        unheard = unheard or bool(self.not_so or self.unasked) or self.moved_waist is not None
        return missing or unheard or wanted.misses or wanted.kind_is_guessed

    @property
    def rank(self) -> tuple[bool, int, int, int, float]:
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

"""Patterns drawn by a latent diffusion, in the manner of SewingLDM."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.clock import Clock
from swifttailor.errors import PatternError
from swifttailor.evaluation.maker.ask import Content
from swifttailor.evaluation.maker.questions import Question
from swifttailor.evaluation.systems.generator import OfWhatIsRead, kept
from swifttailor.latent_diffusion.designer import LatentDesigner
from swifttailor.pattern import Severity, repair_pattern
from swifttailor.pattern_library.sought import Sought
from swifttailor.tailor import Order


@dataclass(frozen=True, eq=False)
class LatentGenerator(OfWhatIsRead):
    """One drawing for what is read of text and picture, mended as the outputs of other systems are."""

    designer: LatentDesigner

    def _made(self, sought: Sought, order: Order, question: Question, clock: Clock) -> Content:
        drawn = self.designer.draw(sought, seed=order.seed, name=question.id)
        clock.stop("drawing")
        repair = repair_pattern(drawn)
        clock.stop("mending")
        wrong = [finding for finding in repair.remaining if finding.severity is Severity.ERROR]
        if wrong:
            more = f", and {len(wrong) - 1} more" if len(wrong) > 1 else ""
            raise PatternError(f"{wrong[0].message} ({wrong[0].where() or 'the pattern'}){more}.")
        mended = [change.code for change in repair.changes]
        return kept(repair.pattern.canonical(), clock, mended=mended)

"""Patterns drawn by a latent diffusion, in the manner of SewingLDM."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from swifttailor.clock import Clock
from swifttailor.errors import PatternError, SwiftTailorError
from swifttailor.evaluation.maker.ask import Asking, Content
from swifttailor.evaluation.maker.pictures import GarmentPictures
from swifttailor.evaluation.maker.questions import Question
from swifttailor.latent_diffusion.designer import LatentDesigner
from swifttailor.pattern import Severity, repair_pattern, to_specification
from swifttailor.tailor import Tailor


@dataclass(frozen=True, eq=False)
class LatentGenerator:
    """One drawing for what is read of text and picture, mended as the outputs of other systems are."""

    name: str
    tailor: Tailor
    """Reads the questions."""
    designer: LatentDesigner
    asking: Asking
    weights: Mapping[str, Any]
    """The files of all networks, with their checksums."""

    def identity(self) -> dict[str, Any]:
        """See `Generator`."""
        return {"weights": dict(self.weights), "seed": self.asking.seed}

    def answer(
        self, questions: Sequence[Question], pictures: GarmentPictures | None
    ) -> Sequence[Content | SwiftTailorError]:
        """See `Generator`."""
        return [self._one(question, pictures) for question in questions]

    def _one(self, question: Question, pictures: GarmentPictures | None) -> Content | SwiftTailorError:
        clock = Clock()
        order = self.asking.order(question, pictures)
        try:
            sought = self.tailor.read(order).sought
            clock.stop("reading")
            drawn = self.designer.draw(sought, seed=order.seed, name=question.id)
            clock.stop("drawing")
            repair = repair_pattern(drawn)
            clock.stop("mending")
        except SwiftTailorError as error:
            return error
        wrong = [finding for finding in repair.remaining if finding.severity is Severity.ERROR]
        if wrong:
            more = f", and {len(wrong) - 1} more" if len(wrong) > 1 else ""
            return PatternError(f"{wrong[0].message} ({wrong[0].where() or 'the pattern'}){more}.")
        return {
            "pattern": to_specification(repair.pattern.canonical()),
            "mended": [change.code for change in repair.changes],
            "seconds": clock.seconds,
            "together": 1,
        }

"""Where patterns come from: networks, libraries, recorded outputs of other systems, the truth, chance."""

from __future__ import annotations

import hashlib
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

from swifttailor.clock import Clock
from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.evaluation.maker.ask import Asking, Content, tailor_answers
from swifttailor.evaluation.maker.pictures import GarmentPictures
from swifttailor.evaluation.maker.questions import Question, Task, seed_of
from swifttailor.pattern import Pattern, to_specification
from swifttailor.pattern.digest import pattern_digest
from swifttailor.pattern_library.known import PatternLibrary
from swifttailor.pattern_library.nearest import nearest
from swifttailor.pattern_library.sought import Sought
from swifttailor.tailor import Order, Tailor

GENERATIVE: tuple[Task, ...] = ("text", "image", "text+image")


class Generator(Protocol):
    """Answers questions with patterns. Bring your own: `run_systems` takes anything with these three."""

    @property
    def name(self) -> str:
        """In tables; also that of its folder, so of letters, digits, ``-``, ``_`` and ``+``."""
        ...

    def identity(self) -> dict[str, Any]:
        """What decides its answers, as JSON values: answers that are kept were made with the same."""
        ...

    def answer(
        self, questions: Sequence[Question], pictures: GarmentPictures | None
    ) -> Sequence[Content | SwiftTailorError]:
        """Answers questions of one task.

        Args:
            questions: At most `evaluation.maker.ask.BATCH`.
            pictures: Those that go with them.

        Returns:
            For each what is kept of its answer: ``pattern``, a GarmentCode specification; and where they are
            known ``attempts``, the patterns that were made for it, ``until_sound``, those until one could be
            made into a garment, and ``seconds`` of all that were answered together by stage, beside
            ``together``, how many these were. Or why there is none.
        """
        ...


@dataclass(frozen=True, eq=False)
class TailorGenerator:
    """SwiftTailor, asked in one of several ways."""

    name: str
    tailor: Tailor
    asking: Asking
    weights: Mapping[str, Any]
    """The files of its networks, with their checksums."""

    def identity(self) -> dict[str, Any]:
        """See `Generator`."""
        return {"weights": dict(self.weights)} | self.asking.to_json()

    def answer(
        self, questions: Sequence[Question], pictures: GarmentPictures | None
    ) -> Sequence[Content | SwiftTailorError]:
        """See `Generator`."""
        return tailor_answers(self.tailor, questions, self.asking, pictures)


@dataclass(frozen=True, eq=False)
class OfWhatIsRead(ABC):
    """Answers each question by itself, from what a tailor reads of text and picture."""

    name: str
    tailor: Tailor
    """Reads the questions."""
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
            return self._made(sought, order, question, clock)
        except SwiftTailorError as error:
            return error

    @abstractmethod
    def _made(self, sought: Sought, order: Order, question: Question, clock: Clock) -> Content:
        """The answer to what is sought.

        Raises:
            SwiftTailorError: There is none.
        """


@dataclass(frozen=True, eq=False)
class NearestKnown(OfWhatIsRead):
    """The known pattern that fits best what is read of text and picture, as it is: nothing is cut."""

    library: PatternLibrary

    def _made(self, sought: Sought, order: Order, question: Question, clock: Clock) -> Content:
        if sought.is_empty:
            raise InputError("Nothing that was asked for was understood, so no pattern is the nearest.")
        found = nearest(self.library, sought)[0]
        clock.stop("searching")
        return kept(found.pattern, clock, known=found.id)


@dataclass(frozen=True, eq=False)
class Chance:
    """A known pattern drawn by lot, whatever is asked for: what a number is worth that it reaches as well."""

    library: PatternLibrary
    identity_of_library: Mapping[str, Any]
    seed: int = 0
    name: str = "chance"

    def identity(self) -> dict[str, Any]:
        """See `Generator`."""
        return {"library": dict(self.identity_of_library), "seed": self.seed}

    def answer(
        self, questions: Sequence[Question], pictures: GarmentPictures | None
    ) -> Sequence[Content | SwiftTailorError]:
        """See `Generator`."""
        drawn = [seed_of(self.seed, question.id, "chance") % len(self.library) for question in questions]
        return [kept(self.library.pattern(k), known=self.library.ids[k]) for k in drawn]


@dataclass(frozen=True, eq=False)
class Truth:
    """The patterns that are asked for: what an answer without a fault reaches, sewn by the same means."""

    name: str = "truth"

    def identity(self) -> dict[str, Any]:
        """See `Generator`."""
        return {}

    def answer(
        self, questions: Sequence[Question], pictures: GarmentPictures | None
    ) -> Sequence[Content | SwiftTailorError]:
        """See `Generator`."""
        return [kept(question.truth) for question in questions]


@dataclass(frozen=True, eq=False)
class Recorded:
    """Patterns that another system has written into a folder, found by the ids of what was asked for."""

    name: str
    patterns: Mapping[str, Pattern | SwiftTailorError]
    """By id; why one cannot be read."""
    digest: str = field(init=False)
    """Of all ids and patterns."""

    def __post_init__(self) -> None:
        lines = [
            f"{id} {one if isinstance(one, SwiftTailorError) else pattern_digest(one)}"
            for id, one in sorted(self.patterns.items())
        ]
        object.__setattr__(self, "digest", hashlib.sha256("\n".join(lines).encode()).hexdigest())

    def identity(self) -> dict[str, Any]:
        """See `Generator`."""
        return {"recorded": self.digest, "outputs": len(self.patterns)}

    def answer(
        self, questions: Sequence[Question], pictures: GarmentPictures | None
    ) -> Sequence[Content | SwiftTailorError]:
        """See `Generator`."""
        return [self._one(question.id) for question in questions]

    def _one(self, id: str) -> Content | SwiftTailorError:
        found = self.patterns.get(id)
        if found is None:
            return InputError(f"{self.name} has no output for '{id}'.")
        return found if isinstance(found, SwiftTailorError) else kept(found.canonical())


def kept(pattern: Pattern, clock: Clock | None = None, **more: Any) -> Content:
    """What is kept of an answer: its pattern, the seconds that it took, and more that is known of it."""
    seconds = {} if clock is None else {"seconds": clock.seconds, "together": 1}
    return {"pattern": to_specification(pattern)} | seconds | more

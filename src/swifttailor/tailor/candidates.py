"""Patterns that may be what is wanted, before any is written: a draft of read parameters, and known ones."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from swifttailor.parameter_reader.reader import Design
    from swifttailor.pattern_maker.maker import WrittenPattern


@dataclass(frozen=True, eq=False)
class Candidate:
    """A pattern, and where it is from."""

    written: WrittenPattern
    known: str = ""
    """Id of the known pattern that it is."""
    design: Design | None = None
    """The design parameters that it was drafted from."""

    @property
    def name(self) -> str:
        """Tells it from the others for the same garment."""
        return self.known or "design"


class CandidateList(Protocol):
    """Candidates for one garment, the best first."""

    def __len__(self) -> int:
        """How many."""
        ...

    def fit(self, number: int) -> float:
        """How well one fits what is wanted: a log likelihood, see `Search`."""
        ...

    def take(self, number: int) -> Candidate:
        """One of them."""
        ...


@dataclass(frozen=True)
class InTurn:
    """One list after the other."""

    lists: tuple[CandidateList, ...]

    def __len__(self) -> int:
        return sum(map(len, self.lists))

    def fit(self, number: int) -> float:
        """How well one fits what is wanted."""
        which, place = self._find(number)
        return which.fit(place)

    def take(self, number: int) -> Candidate:
        """One of them."""
        which, place = self._find(number)
        return which.take(place)

    def _find(self, number: int) -> tuple[CandidateList, int]:
        for one in self.lists:
            if number < len(one):
                return one, number
            number -= len(one)
        raise IndexError(number)

"""What may be tried for a garment before anything is written, looked up when it is first needed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from swifttailor.parameter_reader.reader import ParameterReader
from swifttailor.pattern_library.known import PatternLibrary
from swifttailor.tailor.candidates import CandidateList, InTurn
from swifttailor.tailor.counted import CountedCandidate
from swifttailor.tailor.designed import designed_candidate
from swifttailor.tailor.known import KNOWN_ATTEMPTS, KnownSearches
from swifttailor.tailor.reading import Wanted
from swifttailor.tailor.second_reading import SecondReading

Sample = tuple[Wanted, int]
"""One garment that is wanted, and its seed."""


@dataclass(frozen=True)
class Offer:
    """Candidates for one garment."""

    listed: CandidateList
    """The best first."""
    count: int
    """So many are tried; pictures are compared with further ones."""


class Offers:
    """What each sample is offered: the draft of a design that is read, known patterns, skirts of a number."""

    def __init__(
        self,
        samples: Sequence[Sample],
        library: PatternLibrary | None,
        designer: ParameterReader | None,
        second: SecondReading | None,
    ) -> None:
        """Looks nothing up yet: most garments that words name are done with the first draft.

        Args:
            samples: What is wanted, each with its seed.
            library: Known patterns; None where none may be taken.
            designer: Reads design parameters; None where nothing is to be drafted so.
            second: Corrects drafts of pictures; None where nobody looks again.
        """
        self._samples, self._designer, self._second = samples, designer, second
        self._library, self._searches = library, KnownSearches(library)
        self._found: dict[int, Offer] = {}

    def __getitem__(self, number: int) -> Offer:
        """What one sample is offered.

        Raises:
            InputError: Only known patterns or drafts of designs may be taken, and nothing is understood.
        """
        if number not in self._found:
            self._found[number] = self._looked_up(*self._samples[number])
        return self._found[number]

    def _looked_up(self, wanted: Wanted, seed: int) -> Offer:
        known = self._searches.candidates(wanted, seed)
        drafted = designed_candidate(self._designer, wanted, seed, self._second)
        count = 0
        if known is not None:
            most = wanted.order.most_attempts if wanted.order.source == "library" else KNOWN_ATTEMPTS
            count = min(len(known), most)
        if drafted is not None:
            drafted.library = self._library
            count += len(drafted)
        counted = None if known is None else CountedCandidate(wanted)
        count += 0 if counted is None else len(counted)
        return Offer(InTurn(tuple(x for x in (drafted, known, counted) if x is not None and len(x))), count)

"""A draft of the design parameters that are read in what is wanted, as a candidate beside known patterns."""

from __future__ import annotations

from itertools import islice

from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.parameter_reader.agreement import Design
from swifttailor.parameter_reader.reader import ParameterReader
from swifttailor.pattern import Pattern, Severity, check_pattern
from swifttailor.pattern_library.known import PatternLibrary
from swifttailor.pattern_library.nearest import Search
from swifttailor.pattern_maker.maker import WrittenPattern
from swifttailor.picture_reader.truth import Truth
from swifttailor.programs import DesignError, make_pattern
from swifttailor.tailor.candidates import Candidate
from swifttailor.tailor.heeded import heeded
from swifttailor.tailor.hidden_backs import with_hidden_back
from swifttailor.tailor.reading import Wanted
from swifttailor.tailor.second_reading import SecondReading

MOST_DESIGNS = 8
"""Drafted until GarmentCode's rules accept one."""
WORTH = 10.0
"""How much better a draft is than a known pattern of the same fit, as a logarithm of likelihood: it was
made for what is sought, with measures between those of all known ones."""
_NOTHING_SOUGHT = (
    "Design parameters are read in what is understood of a text or read in a picture, and nothing was. Say "
    "more of the garment, or let the pattern be written: --source writer"
)


class DesignedCandidate:
    """The draft for one garment, or none where no design is accepted."""

    def __init__(
        self, reader: ParameterReader, wanted: Wanted, seed: int, second: SecondReading | None = None
    ) -> None:
        """Drafts it.

        Args:
            reader: Reads design parameters.
            wanted: What is wanted.
            seed: The first seed has the likeliest design, others have others.
            second: Corrects it; nothing does when None.
        """
        self._wanted = wanted
        self._found: list[Candidate] = []
        place = seed - wanted.order.seed
        seen = None if wanted.part is None else wanted.part.design
        for design in islice(reader.designs(wanted.sought, seen, seed=seed), place, place + MOST_DESIGNS):
            design = with_hidden_back(design, wanted)
            try:
                pattern = make_pattern(design).canonical()
            except DesignError:
                continue
            if second is not None:
                design, pattern = _corrected(second, design, pattern, wanted, reader)
            design, pattern = heeded(design, pattern, wanted, reader)
            self._found.append(Candidate(WrittenPattern(pattern), design=design))
            break
        self.library: PatternLibrary | None = None

    def __len__(self) -> int:
        return len(self._found)

    def fit(self, number: int) -> float:
        """How well it fits, and `WORTH`; without known patterns to compare with, 0."""
        if self.library is None:
            return 0.0
        pattern = self._found[number].written.pattern
        try:
            truth = Truth.of(pattern, measure_facts(pattern))
        except SwiftTailorError:
            return -float("inf")
        return Search(self.library, self._wanted.sought).fit_of(truth) + WORTH

    def take(self, number: int) -> Candidate:
        """The draft."""
        return self._found[number]


def _corrected(
    second: SecondReading, design: Design, pattern: Pattern, wanted: Wanted, reader: ParameterReader
) -> tuple[Design, Pattern]:
    """A design and its draft after the second reading; as they were where nothing sound comes of it."""
    for better in second.corrected(design, pattern, wanted, reader):
        try:
            drafted = make_pattern(better).canonical()
        except DesignError:
            continue
        if not any(found.severity is Severity.ERROR for found in check_pattern(drafted)):
            return better, drafted
    return design, pattern


def designed_candidate(
    reader: ParameterReader | None, wanted: Wanted, seed: int, second: SecondReading | None = None
) -> DesignedCandidate | None:
    """The draft for one sample; None where its pattern is to come from elsewhere.

    Args:
        reader: Reads design parameters; None where nothing is to be drafted.
        wanted: What is wanted.
        seed: Of the sample.
        second: Corrects drafts of what is seen where an order does not forbid to look again.

    Raises:
        InputError: Only drafts of designs are asked for, and nothing is known of what is wanted.
    """
    order = wanted.order
    if reader is None or not order.may_be_designed or wanted.sought.is_empty:
        if order.source == "designs":
            raise InputError(_NOTHING_SOUGHT)
        return None
    looks_again = order.most_refined and wanted.part is not None
    return DesignedCandidate(reader, wanted, seed, second if looks_again else None)

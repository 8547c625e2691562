"""Patterns that are known already, as a source of candidates beside the writer."""

from __future__ import annotations

import numpy as np

from swifttailor.errors import InputError
from swifttailor.pattern_library.known import PatternLibrary
from swifttailor.pattern_library.nearest import Search
from swifttailor.pattern_maker.maker import WrittenPattern
from swifttailor.tailor.candidates import Candidate
from swifttailor.tailor.reading import Wanted

KNOWN_ATTEMPTS = 2
"""So many of the attempts at a garment are with known patterns, before any is written."""
CLOSE, LEAST_CLOSE, MOST_CLOSE = 2.0, 4, 32
"""Patterns whose likelihood is at most by this (its logarithm) below that of the best are as good: the seed
says which of them is taken. At least and at most so many, for who asks with several seeds wants several
garments."""
_NOTHING_SOUGHT = (
    "Known patterns are found by what is understood of a text or read in a picture, and nothing was. Say "
    "more of the garment, or let the pattern be written: --source writer"
)


class KnownCandidates:
    """What a library has for one garment that is wanted, the best first."""

    def __init__(self, search: Search, *, seed: int, temperature: float, most: int) -> None:
        """Puts the patterns in order.

        Args:
            search: What is wanted, asked of a library.
            seed: Which of those that fit as well comes first.
            temperature: 0 takes the best whatever the seed.
            most: How many at most.
        """
        best = np.argsort(-search.fits, kind="stable")[: MOST_CLOSE + most]
        alike = int((search.fits[best[:MOST_CLOSE]] >= search.fits[best[0]] - CLOSE).sum())
        close = min(max(alike, LEAST_CLOSE), len(best))
        first = seed % close if temperature > 0 else 0
        self._library, self._fits = search.library, search.fits
        self._order = np.concatenate([np.roll(best[:close], -first), best[close:]])[:most]

    def __len__(self) -> int:
        return len(self._order)

    def fit(self, number: int) -> float:
        """How well one of them fits what is wanted: a log likelihood, see `Search`."""
        return float(self._fits[self._order[number]])

    def take(self, number: int) -> Candidate:
        """One of them.

        Raises:
            InputError: The file of the library is damaged.
        """
        k = int(self._order[number])
        return Candidate(WrittenPattern(self._library.pattern(k)), known=self._library.ids[k])


class KnownSearches:
    """What a library has for garments; those of one order are looked up once."""

    def __init__(self, library: PatternLibrary | None) -> None:
        """Looks nothing up yet.

        Args:
            library: Known patterns; None where none may be taken.
        """
        self._library = library
        self._searches: dict[int, Search] = {}

    def candidates(self, wanted: Wanted, seed: int) -> KnownCandidates | None:
        """What the library has for one sample; None where its pattern is to come from elsewhere.

        Args:
            wanted: What is wanted; must outlive this object.
            seed: Of the sample.

        Raises:
            InputError: Nothing may be written, and nothing is known of what is wanted.
        """
        order = wanted.order
        may_be_known = order.source in ("both", "library") and order.edit is None and order.alter
        if self._library is None or not may_be_known or wanted.sought.is_empty:
            if order.source == "library":
                raise InputError(_NOTHING_SOUGHT)
            return None
        if id(wanted) not in self._searches:
            self._searches[id(wanted)] = Search(self._library, wanted.sought)
        most = order.most_attempts if order.source == "library" else KNOWN_ATTEMPTS
        if wanted.part is not None:
            most = max(most, order.most_refined)
        search = self._searches[id(wanted)]
        return KnownCandidates(search, seed=seed, temperature=order.temperature, most=most)

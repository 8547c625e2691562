"""How well patterns fit what is sought, as one number: the logarithm of a likelihood."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.pattern import Pattern
from swifttailor.pattern_library.known import PatternLibrary
from swifttailor.pattern_library.sought import EXACT, SURE, Sought
from swifttailor.pattern_library.truth_table import TruthTable
from swifttailor.picture_reader.truth import Truth

MOST_OFF = 4.0
"""Widths of a measure or of a box that count at most: beyond it is another thing, however far."""
BOX_CM = (4.0, 4.0, 6.0, 6.0, 8.0)
"""Width of the distribution of `BOX`."""
NARROWEST_MEASURE, _LEAST = 0.02, 1e-6


@dataclass(frozen=True)
class Weights:
    """What the four sources count for; statements of one garment are far from independent of each other."""

    statements: float = 1.0
    measures: float = 0.3
    panels: float = 1.0
    boxes: float = 0.5
    alike: float = 0.1
    """What garments that fit are like (`alike`), where it is open where panels are: words leave much open."""


CHOSEN = Weights()


def log_likelihoods(table: TruthTable, sought: Sought, weights: Weights = CHOSEN) -> NDArray[np.float64]:
    """(N,) how well each pattern of a table fits what is sought; 0 is best, and only differences count.

    Args:
        table: N patterns.
        sought: What is known of what is wanted.
        weights: What counts for how much.
    """
    total = np.zeros(len(table))
    if sought.said.any():
        total += weights.statements * _of_shares(table.true, sought.statements, sought.said)
    if sought.measures.any():
        total += weights.measures * _of_measures(table, sought)
    if sought.named.any():
        total += weights.panels * _of_shares(table.named, sought.panels, sought.named)
    if sought.placed.any():
        total += weights.boxes * _of_boxes(table, sought)
    return total


def _of_shares(
    true: NDArray[np.float32], probability: NDArray[np.float32], counts: NDArray[np.float32]
) -> NDArray[np.float32]:
    """Of independent statements; one on the border is between true and false."""
    columns = _counting(counts)
    p, c = probability[columns], counts[columns]
    against = c * np.log1p(-p)
    return true[:, columns] @ (c * np.log(p) - against) + against.sum()


def _counting(counts: NDArray[np.float32]) -> NDArray[np.int64] | slice:
    """The columns that count; where all do they are not copied."""
    return slice(None) if counts.all() else np.flatnonzero(counts)


def _of_measures(table: TruthTable, sought: Sought) -> NDArray[np.float32]:
    columns = _counting(sought.measures)
    p, c = sought.has[columns], sought.measures[columns]
    middle, width = sought.measured[columns].T
    has = table.has[:, columns]
    off = table.scaled[:, columns] - middle
    np.abs(off, out=off)
    off /= np.maximum(width, NARROWEST_MEASURE)
    np.minimum(off, MOST_OFF, out=off)
    off *= has
    lacking = c * np.log1p(-p)
    return has @ (c * np.log(p) - lacking) + lacking.sum() - off @ (c * p)


def _of_boxes(table: TruthTable, sought: Sought) -> NDArray[np.float64]:
    """A panel that is lacking costs as much as one that is elsewhere."""
    name, counts = table.name, sought.placed
    off = (np.abs(table.boxes - sought.boxes[name]) / np.array(BOX_CM, np.float32)).mean(axis=1)
    saved = (MOST_OFF - np.minimum(off, MOST_OFF)) * counts[name]
    return np.bincount(table.owner, saved, len(table)) - MOST_OFF * counts.sum()


def alike(table: TruthTable, log_likelihood: NDArray[np.float64]) -> Sought:
    """What the patterns that fit are like: of all that is not said, what is likely.

    Args:
        table: N patterns.
        log_likelihood: (N,) how well they fit, and how common they are.
    """
    share = np.exp(log_likelihood - log_likelihood.max()).astype(np.float32)
    share /= share.sum()
    found = Sought.nothing()
    found.statements[:], found.said[:] = _certain(share @ table.true), 1.0
    has = share @ table.has
    found.has[:], found.measures[:] = _certain(has), 1.0
    least = np.maximum(has, _LEAST)
    work = table.has * table.scaled
    found.measured[:, 0] = share @ work / least
    np.subtract(table.scaled, found.measured[:, 0], out=work)
    np.abs(work, out=work)
    work *= table.has
    found.measured[:, 1] = np.maximum(share @ work / least, EXACT)
    named = share @ table.named
    found.panels[:], found.named[:], found.placed[:] = _certain(named), 1.0, named
    of_row = share[table.owner]
    for column in range(found.boxes.shape[1]):
        summed = np.bincount(table.name, of_row * table.boxes[:, column], len(named))
        found.boxes[:, column] = summed / np.maximum(named, _LEAST)
    return found


def _certain(share: NDArray[np.float32]) -> NDArray[np.float32]:
    return np.clip(share, 1 - SURE, SURE)


@dataclass(frozen=True, eq=False)
class Found:
    """A known pattern that fits what is sought."""

    id: str
    """Of `PatternLibrary.ids`."""
    number: int
    """In the library."""
    fit: float
    """How well it fits; see `Search.fit_of`."""
    pattern: Pattern


class Search:
    """What is sought, asked of a library; judges patterns of other sources by the same number."""

    def __init__(self, library: PatternLibrary, sought: Sought, weights: Weights = CHOSEN) -> None:
        """Compares all patterns of a library.

        Args:
            library: Known patterns.
            sought: What is known of what is wanted.
            weights: What counts for how much.
        """
        self.library, self.sought, self.weights = library, sought, weights
        fits = log_likelihoods(library.table, sought, weights)
        self.usual: Sought | None = None
        """What garments are like that fit; None where it is known where their panels are."""
        if weights.alike and not sought.placed.any():
            self.usual = alike(library.table, fits + np.log(library.stands_for + 1.0))
            fits = fits + weights.alike * log_likelihoods(library.table, self.usual, weights)
        self.fits = fits
        """(N,) of each pattern of the library."""

    def nearest(self, count: int = 1) -> list[Found]:
        """The patterns that fit best, the best first.

        Raises:
            InputError: The file of the library is damaged.
        """
        best = np.argsort(-self.fits, kind="stable")[:count]
        ids, pattern = self.library.ids, self.library.pattern
        return [Found(ids[k], int(k), float(self.fits[k]), pattern(int(k))) for k in best]

    def fit_of(self, truth: Truth) -> float:
        """How well any pattern fits what is sought: a log likelihood, of which only differences count.

        Args:
            truth: What is true of it (`Truth.of`).
        """
        table = TruthTable.of([truth])
        fit = log_likelihoods(table, self.sought, self.weights)
        if self.usual is not None:
            fit = fit + self.weights.alike * log_likelihoods(table, self.usual, self.weights)
        return float(fit[0])


def nearest(library: PatternLibrary, sought: Sought, count: int = 1) -> list[Found]:
    """The known patterns that fit best what is sought, the best first.

    Args:
        library: Known patterns.
        sought: What is known of what is wanted.
        count: How many, at most.
    """
    return Search(library, sought).nearest(count)

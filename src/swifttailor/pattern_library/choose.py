"""Which patterns a library should have: together they come near to as many garments as can be."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from swifttailor.pattern_library.nearest import Weights, log_likelihoods
from swifttailor.pattern_library.sought import Sought
from swifttailor.pattern_library.truth_table import TruthTable

Progress = Callable[[int, int], None]
_NEAR = 3.0
"""Log likelihood: patterns that differ by less are as good as each other."""


def usefulness(
    table: TruthTable,
    wanted: Sequence[int],
    weights: Weights,
    *,
    progress: Progress = lambda done, of: None,
) -> NDArray[np.float32]:
    """(W, N) how well each of N patterns serves who wants another: 1 for the nearest of all, towards 0.

    What differs is counted in units of how far the nearest is, so that garments that are like many others and
    garments that are like few count equally.

    Args:
        table: N patterns.
        wanted: W of them, as if they were asked for; none serves who wants itself.
        weights: See `nearest`.
        progress: Called with how many are done, and of how many.
    """
    use = np.zeros((len(wanted), len(table)), np.float32)
    for row, k in enumerate(wanted):
        fits = log_likelihoods(table, Sought.of_truth(table[k]), weights)
        off = np.maximum(fits[k] - fits, 0.0)
        off[k] = np.inf
        least = off.min()
        use[row] = np.exp((least - off) / max(least, _NEAR))
        progress(row + 1, len(wanted))
    return use


def choose(use: NDArray[np.float32], groups: NDArray[np.integer], count: int) -> list[int]:
    """Chooses patterns one after the other, each the one that adds most to what is covered already.

    Greedy maximisation of a submodular function (Nemhauser et al. 1978), lazily: a gain can only shrink.

    Args:
        use: (W, N) see `usefulness`.
        groups: (N,) the groups take turns, so that equally many are chosen of each while there are any.
        count: How many.

    Returns:
        Their numbers, the most useful first; the same each time.
    """
    covered = np.zeros(len(use), np.float32)
    columns = np.ascontiguousarray(use.T)
    heaps: dict[int, list[tuple[float, int]]] = {}
    for k, gain in enumerate(columns.sum(axis=1)):
        heaps.setdefault(int(groups[k]), []).append((-float(gain), k))
    for heap in heaps.values():
        heapq.heapify(heap)
    taken: list[int] = []
    while len(taken) < count and any(heaps.values()):
        for _, heap in sorted(heaps.items()):
            if heap and len(taken) < count:
                taken.append(_best(heap, columns, covered))
                np.maximum(covered, columns[taken[-1]], out=covered)
    return taken


def _best(heap: list[tuple[float, int]], columns: NDArray[np.float32], covered: NDArray[np.float32]) -> int:
    """Takes the pattern of the largest gain out of a heap of gains as they were once."""
    while True:
        _, k = heapq.heappop(heap)
        gain = float(np.maximum(columns[k] - covered, 0).sum())
        if not heap or (-gain, k) <= heap[0]:
            return k
        heapq.heappush(heap, (-gain, k))


def stands_for(use: NDArray[np.float32], chosen: Sequence[int]) -> NDArray[np.int64]:
    """(n,) for how many of the wanted garments each chosen pattern is the one to take.

    Args:
        use: (W, N) see `usefulness`.
        chosen: n numbers of patterns.
    """
    best = use[:, np.asarray(chosen, np.intp)].argmax(axis=1)
    return np.bincount(best, minlength=len(chosen))

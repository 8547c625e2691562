"""How well a set of generated garments matches a set of references: MMD and COV (Achlioptas et al. 2018)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import GeometryError
from swifttailor.evaluation.garments.cloud_distances import chamfer_below
from swifttailor.evaluation.garments.point_cloud import PointCloud
from swifttailor.progress import CountProgress, unwatched


@dataclass(frozen=True)
class SetDistances:
    """Generated against reference clouds."""

    mmd: float
    """Minimum matching distance: mean over the references of the Chamfer distance to the nearest generated
    one, in the squared unit of the points."""
    coverage: float
    """Share of the references that are the nearest one of some generated cloud."""
    references: int
    failed: int
    """Generated clouds that are missing: they are nobody's nearest."""


def set_distances(
    generated: Sequence[PointCloud | None],
    references: Sequence[PointCloud],
    progress: CountProgress = unwatched,
) -> SetDistances:
    """Compares two sets.

    The result is that of comparing every pair; pairs that can be nobody's nearest are given up early
    (`chamfer_below`), first those of clouds whose boxes differ.

    Args:
        generated: None where nothing was made; the paper's "empty point cloud".
        references: What they should match. Where both sets have one order the result comes faster.
        progress: Called with 1 for every cloud that is done, twice the number of clouds in all.

    Raises:
        GeometryError: A set is empty.
    """
    made = [c for c in generated if c is not None]
    if not made or not references:
        raise GeometryError(
            f"MMD and COV compare two sets of garments, got {len(made)} generated and {len(references)} "
            "references. At least one of each is needed."
        )
    pairs = _Pairs(made, references)
    order = np.linalg.norm(_boxes(made)[:, None] - _boxes(references)[None], axis=2)
    # The pair that belongs together is most often the nearest, and a near one makes the others short.
    places = [k for k, c in enumerate(generated) if c is not None]
    for s, r in enumerate(places):
        if r < len(references):
            order[s, r] = -1.0
    smallest = []
    for r in range(len(references)):
        smallest.append(pairs.nearest_generated(r, np.argsort(order[:, r], kind="stable"))[1])
        progress(1)
    found = set()
    for s in range(len(made)):
        found.add(pairs.nearest_reference(s, np.argsort(order[s], kind="stable"))[0])
        progress(1)
    return SetDistances(
        mmd=float(np.mean(smallest)),
        coverage=len(found) / len(references),
        references=len(references),
        failed=len(generated) - len(made),
    )


class _Pairs:
    """What is known of the distances of all pairs."""

    def __init__(self, generated: Sequence[PointCloud], references: Sequence[PointCloud]) -> None:
        self._generated, self._references = generated, references
        shape = len(generated), len(references)
        self._least: NDArray[np.float64] = np.zeros(shape)
        self._exact: NDArray[np.bool_] = np.zeros(shape, np.bool_)

    def nearest_generated(self, r: int, order: NDArray[np.int64]) -> tuple[int, float]:
        return self._nearest(order, lambda s, limit: self._below(s, r, limit))

    def nearest_reference(self, s: int, order: NDArray[np.int64]) -> tuple[int, float]:
        return self._nearest(order, lambda r, limit: self._below(s, r, limit))

    def _nearest(
        self, order: NDArray[np.int64], below: Callable[[int, float], float | None]
    ) -> tuple[int, float]:
        best, distance = -1, np.inf
        for k in order.tolist():
            found = below(k, distance)
            if found is not None:
                best, distance = k, found
        return best, distance

    def _below(self, s: int, r: int, limit: float) -> float | None:
        """The distance of a pair where it is below a limit."""
        if not self._exact[s, r] and self._least[s, r] < limit:
            self._least[s, r], self._exact[s, r] = chamfer_below(
                self._generated[s], self._references[r], limit
            )
        known = self._exact[s, r] and self._least[s, r] < limit
        return float(self._least[s, r]) if known else None


def _boxes(clouds: Sequence[PointCloud]) -> NDArray[np.float64]:
    """(n, 6) lowest and highest coordinates of each cloud."""
    return np.array([[c.points.min(axis=0), c.points.max(axis=0)] for c in clouds]).reshape(len(clouds), 6)

"""Many garments against their drapes: means, kind by kind, and the distances between the sets."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from swifttailor.errors import InputError
from swifttailor.evaluation.garment_kind import KINDS
from swifttailor.evaluation.garments.point_cloud import PointCloud
from swifttailor.evaluation.garments.score import BOX_SCALE, FEW_POINTS, GarmentScore, Scored
from swifttailor.evaluation.garments.set_distances import SetDistances, set_distances
from swifttailor.evaluation.mean import Means, means_of
from swifttailor.progress import CountProgress, unwatched

_NOT_MEASURED = ("id", "kind", "vertices", "rejected_for")


@dataclass(frozen=True)
class Summary:
    """What came of a set of garments."""

    garments: int
    failed: int
    """Patterns of which no garment was made; they count in the distances between sets alone."""
    means: Means
    kinds: dict[str, tuple[int, Means]]
    """Number of garments and means of each kind that occurs."""
    sets: SetDistances
    """cm^2."""
    sets_floor: SetDistances
    """Two draws of points from the drapes."""
    box_sets: SetDistances
    """In the unit boxes, `FEW_POINTS`, times 1000."""
    box_sets_floor: SetDistances

    def to_json(self) -> dict[str, Any]:
        """Plain JSON values."""
        return asdict(self) | {
            "kinds": {
                kind: {"garments": count, "means": {name: asdict(m) for name, m in means.items()}}
                for kind, (count, means) in self.kinds.items()
            }
        }


def summarize_scores(
    scored: Sequence[Scored], lost: Sequence[PointCloud] = (), progress: CountProgress = unwatched
) -> Summary:
    """Means and distances between sets.

    Args:
        scored: The garments.
        lost: Drapes of patterns of which none was made.
        progress: Called with numbers that add up to `work(len(scored) + len(lost))`.

    Raises:
        InputError: There is no garment at all.
    """
    if not scored:
        raise InputError("No garment was made, so there is nothing to summarize.")
    scores = [s.score for s in scored]
    of_kind = {kind: [s for s in scores if s.kind == kind] for kind in KINDS}
    made: list[PointCloud | None] = [s.clouds.points for s in scored]
    again: list[PointCloud | None] = [s.clouds.reference_again for s in scored]
    references = [s.clouds.reference for s in scored] + list(lost)
    nothing: list[PointCloud | None] = [None] * len(lost)
    boxed_references = _boxed(references)
    return Summary(
        garments=len(scored),
        failed=len(lost),
        means=_means(scores),
        kinds={kind: (len(some), _means(some)) for kind, some in of_kind.items() if some},
        sets=set_distances(made + nothing, references, progress),
        sets_floor=set_distances(again + nothing, references, progress),
        box_sets=_times(set_distances(_boxed(made) + nothing, boxed_references, progress)),
        box_sets_floor=_times(set_distances(_boxed(again) + nothing, boxed_references, progress)),
    )


def work(garments: int) -> int:
    """How much `summarize_scores` reports to `progress` in all, where all garments were made."""
    return 4 * 2 * garments


def _means(scores: Sequence[GarmentScore]) -> Means:
    """Mean and median of every measure over the garments that have it."""
    return means_of([asdict(s) for s in scores], _NOT_MEASURED)


def _boxed(clouds: Sequence[PointCloud | None]) -> list[Any]:
    return [None if c is None else c.first(FEW_POINTS).in_unit_box() for c in clouds]


def _times(found: SetDistances) -> SetDistances:
    return SetDistances(BOX_SCALE * found.mmd, found.coverage, found.references, found.failed)

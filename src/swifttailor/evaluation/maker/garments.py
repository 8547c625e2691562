"""The garments of answers, sewn by a GarmentSewer, as a set beside the drapes of the true patterns.

The paper's tables of generated garments (Sec. 5): MMD and COV.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from swifttailor.data.sample import Sample
from swifttailor.errors import SwiftTailorError
from swifttailor.evaluation.garments.cloud_distances import chamfer
from swifttailor.evaluation.garments.point_cloud import PointCloud, sample_surface
from swifttailor.evaluation.garments.score import POINTS
from swifttailor.evaluation.garments.set_distances import SetDistances, set_distances
from swifttailor.evaluation.maker.questions import seed_of
from swifttailor.evaluation.maker.scores import Scored
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.relaxing import relaxed
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.pattern import Pattern
from swifttailor.progress import CountProgress

FindDrape = Callable[[str], Sample | None]


@dataclass(frozen=True)
class GarmentSets:
    """Of one task. All distances are in cm^2, with 10,000 points to a garment."""

    chamfer: float
    """Mean over the answers that could be sewn: to the drape of the pattern that was asked for."""
    answers: SetDistances
    truth: SetDistances
    """The true patterns, sewn: what answers without a fault would reach."""
    floor: SetDistances
    """The drapes, their points drawn again."""
    unsewable: dict[str, str]
    """Questions whose answer gave no garment, and why."""


@dataclass
class Garments:
    """Sews answers, and remembers what the tasks of an evaluation share."""

    sewer: GarmentSewer
    find_drape: FindDrape
    """The drape of the pattern of an id; None where there is none."""
    seed: int
    """Of the points that are drawn."""
    _known: dict[str, tuple[PointCloud, PointCloud, PointCloud | None]] = field(default_factory=dict)

    def compare(self, scored: Sequence[Scored], progress: CountProgress) -> GarmentSets | None:
        """Compares the answers of a task, those alone whose true pattern has a drape.

        Args:
            scored: The answers.
            progress: Called with 1 after each.

        Returns:
            None where no answer could be sewn, or there is no drape.
        """
        made: list[PointCloud | None] = []
        shared, unsewable, apart = [], {}, []
        for one in scored:
            question = one.answer.question
            known = self._of_truth(question.id, question.truth)
            if known is not None:
                why = str(one.answer.record.get("error", "there is no pattern"))
                cloud = None
                if one.answer.pattern is not None:
                    cloud, why = self._sewn(one.answer.pattern, question.key)
                made.append(cloud)
                shared.append(known)
                if cloud is None:
                    unsewable[question.key] = why
                else:
                    apart.append(chamfer(cloud, known[0]))
            progress(1)
        if not apart:
            return None
        references = [reference for reference, _, _ in shared]
        return GarmentSets(
            chamfer=float(np.mean(apart)),
            answers=set_distances(made, references),
            truth=set_distances([sewn for _, _, sewn in shared], references),
            floor=set_distances([again for _, again, _ in shared], references),
            unsewable=unsewable,
        )

    def _of_truth(self, id: str, truth: Pattern) -> tuple[PointCloud, PointCloud, PointCloud | None] | None:
        """Points of the drape, drawn twice, and of the true pattern sewn."""
        if id not in self._known:
            sample = self.find_drape(id)
            if sample is None:
                return None
            reference, again = (self._points(sample.garment, id, f"drape {k}") for k in (1, 2))
            self._known[id] = reference, again, self._sewn(truth, id)[0]
        return self._known[id]

    def _sewn(self, pattern: Pattern, name: str) -> tuple[PointCloud | None, str]:
        try:
            garment = relaxed(self.sewer.sew(pattern))
            return self._points(garment, name, "sewn"), ""
        except SwiftTailorError as error:
            return None, str(error)

    def _points(self, garment: Garment, *names: str) -> PointCloud:
        return sample_surface(garment.vertices, garment.faces, POINTS, seed_of(self.seed, *names))

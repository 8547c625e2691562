"""Looking again: of several patterns that do, the one that fits and lies best where the pictures show it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from swifttailor.errors import SwiftTailorError
from swifttailor.garment_sewer.sewer import BATCH
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.candidates import CandidateList
from swifttailor.tailor.fitting import cut_from
from swifttailor.tailor.likeness import can_be_compared, distance_cm
from swifttailor.tailor.protocols import Sewer
from swifttailor.tailor.reading import Wanted
from swifttailor.tailor.sewing import SewingOptions, prepare

EDGE_CM = 4.0
"""Edge length of the meshes that are compared."""
CM_WORTH = 3.0
"""A centimetre nearer to what the pictures show counts as much as this in the logarithm of the likelihood."""


@dataclass(frozen=True)
class Refinement:
    """What came of looking again."""

    compared: int
    """Garments that were sewn and compared with the pictures."""
    distance_cm: float
    """Of the one that was taken."""
    first_distance_cm: float
    """Of the one that would have been taken otherwise."""


def refined(
    answer: Answer,
    tried: Sequence[Answer],
    candidates: CandidateList | None,
    wanted: Wanted,
    sewer: Sewer,
    *,
    place: int = 0,
) -> Answer:
    """An answer, or another candidate that does as well and whose garment is more like the pictures.

    Args:
        answer: The best so far, prepared to be sewn.
        tried: All answers so far, this one included.
        candidates: Not written ones, the first of which may have been tried.
        wanted: What is wanted.
        sewer: Makes the garments that are compared.
        place: 0 takes the best, 1 the next, and so on.

    Returns:
        What was taken; as it was given where there is nothing to compare, or to compare with.
    """
    part, count = wanted.part, wanted.order.most_refined
    if candidates is None or part is None or not count or not can_be_compared(wanted.pictures, part.part):
        return answer
    known = {one.found: one for one in tried if one.found}
    others, fits = [], {}
    for number in range(min(count, len(candidates))):
        candidate = candidates.take(number)
        name = candidate.name
        fits[name] = candidates.fit(number)
        one = known.get(name) or cut_from(candidate, wanted, answer.seed)
        if name != answer.found and not one.verdict.unsound and one.verdict.rank <= answer.verdict.rank:
            others.append(one)
    distances = _distances([answer, *others], wanted, part.part, sewer)
    names = [one.found for one in (answer, *others)]
    usual = max(fits.values(), default=0.0)  # of what was written nothing is known
    best = sorted(distances, key=lambda k: CM_WORTH * distances[k] - fits.get(names[k], usual))
    if len(best) < 2 or 0 not in distances:
        return answer
    chosen = best[min(place, len(best) - 1)]
    found = Refinement(len(best), distances[chosen], distances[0])
    if chosen == 0:
        return replace(answer, refinement=found)
    taken = others[chosen - 1]
    asked = {"attempt": answer.attempt, "failures": answer.failures, "tried": answer.tried}
    return replace(taken, **asked, refinement=found)


def _distances(answers: Sequence[Answer], wanted: Wanted, part: str, sewer: Sewer) -> dict[int, float]:
    """How far the garments lie from where the pictures show them; without those that cannot be sewn."""
    ready: list[tuple[int, Answer]] = []
    for k, one in enumerate(answers):
        try:
            ready.append((k, prepare(sewer, one, SewingOptions(EDGE_CM))))
        except SwiftTailorError:
            continue
    found = {}
    for first in range(0, len(ready), BATCH):
        batch = ready[first : first + BATCH]
        predicted = sewer.predict([one.prepared for _, one in batch])
        for (k, one), values in zip(batch, predicted, strict=True):
            try:
                garment = sewer.decode(one.prepared, values)
            except SwiftTailorError:
                continue
            found[k] = distance_cm(wanted.pictures, part, garment.vertices)
    return found

"""Measures what is usual for a trained network, and which measure tells when a picture shows no garment."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.errors import InputError
from swifttailor.pattern_maker.asking.confidence import (
    DOUBT,
    MEASURES,
    QUANTILES,
    Calibration,
    Measure,
    PictureSpace,
    rank,
)
from swifttailor.pattern_maker.asking.pictures import picture_for_network
from swifttailor.pattern_maker.maker import PatternMaker, Request
from swifttailor.pattern_maker.temperatures import USUAL_TEMPERATURE

BATCH = 16

Values = dict[Measure, NDArray[np.float64]]


def calibrate(
    maker: PatternMaker,
    learnt: Iterable[Pixels],
    known: Iterable[Pixels],
    strangers: Mapping[str, Iterable[Pixels]],
    *,
    progress: Callable[[int], None] | None = None,
) -> Calibration:
    """Shows a network pictures.

    Args:
        maker: The network.
        learnt: Pictures that it was trained on, (h, w, 3) each.
        known: Pictures of garments that it was not trained on.
        strangers: By kind, pictures that show no garment.
        progress: Called with the number of pictures after each few.

    Raises:
        InputError: There are too few pictures.
    """
    looks = [_look(maker, batch, progress) for batch in _batches(learnt)]
    space = PictureSpace.fit(np.concatenate(looks) if looks else np.zeros((0, 1)))
    usual = _measure(maker, space, known, progress)
    count = len(usual["certainty"])
    if count < 8:
        raise InputError(f"There are {count} validation pictures; at least 8 are needed.")
    quantiles = {m: np.quantile(v, np.linspace(0, 1, min(QUANTILES, count))) for m, v in usual.items()}
    others = {kind: _measure(maker, space, pictures, progress) for kind, pictures in strangers.items()}
    told = {kind: {m: roc_area(usual[m], v[m]) for m in MEASURES} for kind, v in others.items()}
    # The measure that tells better on the whole; what the network says itself where both tell alike.
    measure = max(MEASURES, key=lambda m: (round(sum(t[m] for t in told.values()), 6), m == "certainty"))
    ranks = {kind: [rank(x, quantiles[measure]) for x in v[measure]] for kind, v in others.items()}
    return Calibration(
        measure,
        space,
        {m: tuple(q.tolist()) for m, q in quantiles.items()},
        count,
        told,
        {kind: float(np.mean(np.array(found) < DOUBT)) for kind, found in ranks.items()},
    )


def roc_area(higher: NDArray[np.float64], lower: NDArray[np.float64]) -> float:
    """Probability that one of `higher` exceeds one of `lower`, ties by half (Mann and Whitney 1947)."""
    ordered = np.sort(lower)
    below = np.searchsorted(ordered, higher, side="left")
    up_to = np.searchsorted(ordered, higher, side="right")
    return float((below + up_to).mean() / (2 * len(lower)))


def _measure(
    maker: PatternMaker,
    space: PictureSpace,
    pictures: Iterable[Pixels],
    progress: Callable[[int], None] | None,
) -> Values:
    certainty, familiarity = [], []
    for batch in _batches(pictures):
        made = maker.answer_all([Request(image=p) for p in batch], temperature=USUAL_TEMPERATURE)
        certainty += [one.certainty for one in made]
        familiarity += space.familiarity(
            np.stack([one.look for one in made if one.look is not None])
        ).tolist()
        if progress is not None:
            progress(len(batch))
    return {"certainty": np.array(certainty), "familiarity": np.array(familiarity)}


def _look(
    maker: PatternMaker, batch: list[Pixels], progress: Callable[[int], None] | None
) -> NDArray[np.floating]:
    """(n, d) what the network makes of pictures, their places averaged."""
    pictures = np.stack([picture_for_network(p, maker.model.image_size) for p in batch])
    looks = maker.model.runtime.look(pictures).mean(axis=1)
    if progress is not None:
        progress(len(batch))
    return looks


def _batches(pictures: Iterable[Pixels]) -> Iterable[list[Pixels]]:
    source = iter(pictures)
    while batch := list(islice(source, BATCH)):
        yield batch

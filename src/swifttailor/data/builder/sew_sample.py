"""One sample of a data set whose garment is GarmentSewer's, not a drape: pictures of many more patterns."""

from __future__ import annotations

import functools
import hashlib
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

from swifttailor.data.builder.make_sample import MadeSample, SampleTask, guarded, packed
from swifttailor.draping.batch.make_garment import read_sewable, shared_body
from swifttailor.draping.cloth import build_cloth
from swifttailor.draping.collider import vertices_ignoring_arms
from swifttailor.draping.known_fabrics import get_fabric
from swifttailor.draping.quality import measure_quality
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.relaxing import relaxed
from swifttailor.garment_sewer.sewer import SHIPPED, GarmentSewer

MOST_INSIDE = 0.02
"""Largest share of the vertices inside the body."""


def sew_sample(task: SampleTask, weights: Path | None = None) -> MadeSample:
    """Sews a pattern by the network; accepted is what can be looked at.

    A garment that no simulation has relaxed is strained and crosses itself where a drape does not, which no
    picture shows. So only what hangs in the wrong place or inside the body is left out.

    Args:
        task: From `build_split`.
        weights: Model file; the one that comes with the package when None.

    Returns:
        The sample or why there is none. Nothing is raised: whatever goes wrong is in the record.
    """
    return guarded(task, lambda: packed(task, _sewn(task, weights)))


def network_of(weights: Path | None) -> str:
    """Checksum of a model file, once it is known that it can be used.

    Raises:
        InputError: There is no such file, or it is damaged or another.
    """
    _sewer(weights)
    return hashlib.sha256((SHIPPED if weights is None else weights).read_bytes()).hexdigest()[:16]


def _sewn(task: SampleTask, weights: Path | None) -> Garment:
    settings = task.settings
    started = time.perf_counter()
    sewable = read_sewable(task.pattern, settings)
    loading = time.perf_counter() - started
    garment = _sewer(weights).sew(sewable.pattern, edge_length=settings.edge_length)
    garment = relaxed(garment, body=shared_body(settings), fabric=settings.fabric)
    started = time.perf_counter()
    quality = measure_quality(
        garment.mesh,
        garment.vertices,
        build_cloth(garment.mesh, get_fabric(settings.fabric)),
        shared_body(settings),
        static=True,
        frames=0,
        ignores_arms=np.asarray(vertices_ignoring_arms(garment.mesh), np.uint8),
    )
    measuring = round(time.perf_counter() - started, 4)
    seconds = garment.report["seconds"] | {"measuring": measuring}
    reasons = []
    if quality.fell_off:
        reasons.append(f"hangs too low: its top is {quality.top_cm:.0f} cm above the floor")
    if quality.penetrating_fraction > MOST_INSIDE:
        share = quality.penetrating_fraction
        reasons.append(f"{share:.1%} of the vertices are inside the body (limit {MOST_INSIDE:.0%})")
    judged = quality.to_json() | {"accepted": not reasons, "reasons": reasons}
    report = garment.report | {"quality": judged, "seconds": seconds}
    return replace(garment, report=sewable.complete_report(report, loading))


@functools.lru_cache(maxsize=1)
def _sewer(weights: Path | None) -> GarmentSewer:
    """The network, loaded once in each worker."""
    return GarmentSewer.load(weights)

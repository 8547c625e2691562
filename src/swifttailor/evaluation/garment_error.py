"""A predicted garment against the drape of the same pattern, vertex by vertex of the panel mesh."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.errors import GeometryError
from swifttailor.evaluation.garment_kind import KINDS, GarmentKind, garment_kind
from swifttailor.garment_sewer.closing import seam_gaps
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.pixels.sewn_prior import vertices_ignoring_arms
from swifttailor.panel_mesh.pattern_mesh import PatternMesh


@dataclass(frozen=True)
class GarmentError:
    """Errors of one predicted garment; lengths in cm."""

    kind: GarmentKind
    mean: float
    """Distance of the welded vertices from where the drape has them: mean."""
    p90: float
    """The same: 90th percentile."""
    offset: float
    """Length of the mean error vector of each panel, weighted by its vertices: what is whole-panel
    displacement."""
    seam_gap: float
    """Distance between vertices that a stitch joins, before they are merged: median."""
    seam_gap_p95: float
    inside: float
    """Share of the welded vertices more than 0.2 cm inside the body."""


INSIDE_CM = 0.2


def measure_error(
    mesh: PatternMesh, flat_positions: Floats, drape: Floats, body: BodyDistance
) -> GarmentError:
    """Compares.

    Args:
        mesh: The panels' mesh.
        flat_positions: (m, 3) predicted position of every flat vertex, before seams are closed.
        drape: (v, 3) welded vertices at rest.
        body: For what is inside it.

    Raises:
        GeometryError: The shapes do not fit the mesh.
    """
    if flat_positions.shape != (len(mesh.weld), 3) or drape.shape != (mesh.vertex_count, 3):
        raise GeometryError(
            f"A mesh of {len(mesh.weld)} flat and {mesh.vertex_count} welded vertices was given positions of "
            f"the shapes {flat_positions.shape} and {drape.shape}."
        )
    merged = mesh.welded_mean(flat_positions)
    distance = np.linalg.norm(merged - drape, axis=1)
    depth, _ = body.sample(merged, vertices_ignoring_arms(mesh))
    gaps = seam_gaps(mesh, flat_positions)
    panels = len(mesh.pattern.panels)
    count = np.bincount(mesh.flat_panel, minlength=panels)
    error = flat_positions - drape[mesh.weld]
    offset = np.stack([np.bincount(mesh.flat_panel, error[:, k], panels) for k in range(3)], axis=1)
    return GarmentError(
        kind=garment_kind(mesh.pattern),
        mean=float(distance.mean()),
        p90=float(np.percentile(distance, 90)),
        offset=float(np.linalg.norm(offset, axis=1).sum() / count.sum()),
        seam_gap=float(np.median(gaps)) if len(gaps) else 0.0,
        seam_gap_p95=float(np.percentile(gaps, 95)) if len(gaps) else 0.0,
        inside=float((depth < -INSIDE_CM).mean()),
    )


def summarize(errors: Sequence[GarmentError]) -> dict[str, Any]:
    """Means over garments, of all and of each kind, as JSON values; `median` is that of `mean`."""

    def means(chosen: Sequence[GarmentError]) -> dict[str, Any]:
        rows = [asdict(e) for e in chosen]
        result: dict[str, Any] = {"garments": len(rows)}
        for name in rows[0]:
            if name != "kind":
                result[name] = float(np.mean([r[name] for r in rows]))
        result["median"] = float(np.median([r["mean"] for r in rows]))
        return result

    if not errors:
        return {"garments": 0}
    kinds = {k: [e for e in errors if e.kind == k] for k in KINDS}
    return means(errors) | {"kinds": {k: means(chosen) for k, chosen in kinds.items() if chosen}}

"""Whether a drape is good enough to learn from or to show, and why not."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.body import Body
from swifttailor.body.parts import ARMS
from swifttailor.draping.cloth import ClothModel
from swifttailor.draping.intersections import mesh_intersections, self_intersections
from swifttailor.draping.worn_height import WornHeight, worn_height
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.panel_mesh.topology import component_count

MAX_BODY_INTERSECTIONS = 35
MAX_SELF_INTERSECTIONS = 300
MAX_STRAIN_P95 = 0.12
WHEN_TOO_TIGHT = (
    'Make it wider where it is tight, as with swifttailor edit ... "make it 5 cm wider", or '
    "drape it over the body that it is for (swifttailor drape --body)."
)
MAX_PENETRATING_FRACTION = 0.01


@dataclass(frozen=True)
class Quality:
    """Measurements of a drape. The limits are GarmentCode's where it has one."""

    accepted: bool
    reasons: tuple[str, ...]
    """Why it was not accepted, in words with the values."""
    static: bool
    """Whether it came to rest; what slides down is not followed to the floor."""
    fell_off: bool
    """Whether its top lies below where it is worn (`worn_height`): it slid down, or never was there."""
    top_cm: float
    """Height of its highest vertex."""
    penetrating_fraction: float
    """Share of the vertices inside the body."""
    max_penetration_cm: float
    body_intersections: int
    """Mesh edges that pass through a face of the body (panels over the legs may pass through the arms)."""
    self_intersections: int
    """Edge-face pairs of the cloth that cross."""
    strain_p50: float
    """Median of abs(length / rest - 1) over the edges that are not gathered."""
    strain_p95: float
    strain_allowed: float
    """What that may be at most: more where the pattern is cut for cloth that stretches."""
    strain_max: float
    """Largest stretch of such an edge."""
    seam_gap_max_cm: float
    """Largest distance between two stitched points; zero, since they are one vertex."""
    components: int
    """Connected pieces of the stitched mesh."""
    frames: int

    def to_json(self) -> dict[str, Any]:
        """Plain JSON values."""
        return asdict(self) | {"reasons": list(self.reasons)}


def measure_quality(
    mesh: PatternMesh,
    positions: Floats,
    cloth: ClothModel,
    body: Body,
    *,
    static: bool,
    frames: int,
    ignores_arms: NDArray[np.uint8],
) -> Quality:
    """Measures a drape and judges it by the limits of this module.

    Args:
        mesh: What was draped.
        positions: (v, 3) resting vertices, cm.
        cloth: Gives the rest lengths.
        body: What it hangs on.
        static: Whether the simulation came to rest.
        frames: Frames it took.
        ignores_arms: (v,) 1 for vertices that may pass through the arms.
    """
    arrays = cloth.arrays
    strain = cloth.strain(positions)
    distance = _body_distance(body, positions, ignores_arms)
    top = float(positions[:, 1].max())
    worn = worn_height(mesh.pattern, body.measurements)
    crossings = self_intersections(positions, arrays.edges, arrays.faces)
    body_crossings = _body_crossings(body, positions, arrays.edges, ignores_arms)
    measured = {
        "static": static,
        "fell_off": top < worn.lowest,
        "top_cm": top,
        "penetrating_fraction": float((distance < 0).mean()),
        "max_penetration_cm": float(max(0.0, -distance.min())),
        "body_intersections": body_crossings,
        "self_intersections": crossings,
        "strain_p50": float(np.percentile(np.abs(strain), 50)),
        "strain_p95": float(np.percentile(np.abs(strain), 95)),
        "strain_allowed": MAX_STRAIN_P95 + mesh.pattern.cloth_stretch,
        "strain_max": float(strain.max()),
        "seam_gap_max_cm": seam_gap(mesh, positions),
        "components": component_count(mesh.faces, mesh.vertex_count),
        "frames": frames,
    }
    reasons = _reasons(measured, worn)
    return Quality(accepted=not reasons, reasons=reasons, **measured)


def seam_gap(mesh: PatternMesh, positions: Floats) -> float:
    """Largest distance in cm between the two sides of any stitch."""
    largest = 0.0
    for stitch in mesh.pattern.stitches:
        first, second = (
            positions[mesh.weld[mesh.edge_vertices[mesh.pattern.panel_index(r.panel)][r.edge]]]
            for r in stitch.sides
        )
        gap = np.linalg.norm(first - (second if stitch.right_wrong else second[::-1]), axis=1)
        largest = max(largest, float(gap.max()))
    return largest


def not_accepted_line(quality: Mapping[str, Any]) -> str:
    """Why a garment is not accepted, and what can be done about it where that is known; empty if it is.

    Args:
        quality: Of a report.
    """
    if quality["accepted"]:
        return ""
    line = f"not accepted: {'; '.join(quality['reasons'])}."
    tight = quality.get("strain_p95", 0.0) > quality.get("strain_allowed", MAX_STRAIN_P95)
    return f"{line} {WHEN_TOO_TIGHT}" if tight else line


def _reasons(q: dict[str, Any], worn: WornHeight) -> tuple[str, ...]:
    limits = [
        (not q["static"] and not q["fell_off"], "did not come to rest"),
        (
            not worn.lowest <= q["top_cm"] <= worn.highest,
            f"not where it is worn: its top is {q['top_cm']:.0f} cm above the floor, that of {worn.kind} "
            f"between {worn.lowest:.0f} and {worn.highest:.0f}",
        ),
        (
            q["body_intersections"] > MAX_BODY_INTERSECTIONS,
            f"{q['body_intersections']} edges pass through the body (limit {MAX_BODY_INTERSECTIONS})",
        ),
        (
            q["self_intersections"] > MAX_SELF_INTERSECTIONS,
            f"the cloth passes through itself at {q['self_intersections']} places "
            f"(limit {MAX_SELF_INTERSECTIONS})",
        ),
        (
            q["penetrating_fraction"] > MAX_PENETRATING_FRACTION,
            f"{q['penetrating_fraction']:.1%} of the vertices are inside the body "
            f"(limit {MAX_PENETRATING_FRACTION:.0%})",
        ),
        (
            q["strain_p95"] > q["strain_allowed"],
            f"too tight: 5 % of the edges are strained by more than {q['strain_p95']:.0%} "
            f"(limit {q['strain_allowed']:.0%})",
        ),
    ]
    return tuple(reason for failed, reason in limits if failed)


def _body_distance(body: Body, positions: Floats, ignores_arms: NDArray[np.uint8]) -> Floats:
    """Exact signed distance (v,) in cm, to the body without arms for vertices that ignore them."""
    distance, _ = body.signed_distance(positions)
    inside = (distance < 0) & (ignores_arms == 1)
    if inside.any():
        from swifttailor.draping.collider import FIELD_SPACING_CM

        armless = body.distance_field(spacing=FIELD_SPACING_CM, without=ARMS)
        distance = distance.copy()
        distance[inside] = armless.sample(positions[inside])[0]
    return distance


def _body_crossings(
    body: Body, positions: Floats, edges: NDArray[np.int32], ignores_arms: NDArray[np.uint8]
) -> int:
    from swifttailor.draping.collider import faces_without_arms

    free = (ignores_arms[edges] == 1).all(axis=1)
    count = mesh_intersections(positions, edges[~free], body.vertices, body.faces)
    if free.any():
        count += mesh_intersections(positions, edges[free], body.vertices, faces_without_arms(body))
    return count

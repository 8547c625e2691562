"""Everything that is measured on one garment against the drape of the same pattern."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.draping.cloth import ClothModel, build_cloth
from swifttailor.draping.known_fabrics import FABRICS
from swifttailor.errors import GeometryError, InputError
from swifttailor.evaluation.garment_kind import KINDS, GarmentKind, garment_kind
from swifttailor.evaluation.garments.cloud_distances import chamfer, earth_mover, surface_distance
from swifttailor.evaluation.garments.point_cloud import PointCloud, sample_surface
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.pixels.sewn_prior import vertices_ignoring_arms
from swifttailor.panel_mesh.topology import Topology, topology

POINTS = 10_000
"""For Chamfer distances in cm^2: with fewer, those of good garments drown in chance (docs/evaluation.md)."""
FEW_POINTS = 2_048
"""For the earth mover's distance, and for everything in the unit box: as many as in the literature."""
BOX_SCALE = 1000.0
"""Distances in the unit box are listed times this."""


@dataclass(frozen=True)
class GarmentScore:
    """One garment against its drape; the names end in their units.

    A ``floor`` is the same distance between two draws of points from the drape: less is chance.
    """

    id: str
    kind: GarmentKind
    vertices: int
    chamfer_cm2: float
    chamfer_floor_cm2: float
    surface_cm: float
    """Mean distance to the nearest point of the other surface."""
    surface_floor_cm: float
    emd_cm: float
    emd_floor_cm: float
    chamfer_box_e3: float
    """Chamfer distance of both in their unit boxes, times 1000."""
    chamfer_box_floor_e3: float
    vertex_mean_cm: float
    """Distance of the vertices from where the drape has them."""
    vertex_p90_cm: float
    inside: float
    """Share of the vertices inside the body."""
    deepest_cm: float
    drape_inside: float
    drape_deepest_cm: float
    strain_p50: float
    """Of abs(length / rest - 1) over the mesh edges that are not gathered."""
    strain_p95: float
    drape_strain_p50: float
    drape_strain_p95: float
    components: int
    nonmanifold_edges: int
    boundary_loops: int
    sound: bool
    """Whether no mesh edge has more than two faces, and it has as many components, boundary loops and edges
    where the cloth turns its wrong side out (lapels) as the drape."""
    seam_gap_median_cm: float | None = None
    """Between vertices that a stitch joins, before seams were closed."""
    seam_gap_p95_cm: float | None = None
    accepted: bool | None = None
    """Whether it is within the limits of quality of drapes, where it was finished by physics."""
    rejected_for: str = ""
    """What is beyond them."""
    seconds: float | None = None
    """That it took to make."""


def score_of_json(value: Any) -> GarmentScore:
    """Reads the JSON values of a `GarmentScore`.

    Raises:
        InputError: It is something else.
    """
    names = {f.name for f in fields(GarmentScore)}
    if not isinstance(value, dict) or value.keys() != names or value["kind"] not in KINDS:
        raise InputError("A line of results does not hold the measurements of this version; start anew.")
    return GarmentScore(**value)


@dataclass(frozen=True, eq=False)
class Clouds:
    """Points that surfaces are compared by."""

    points: PointCloud
    """`POINTS` of the garment."""
    reference: PointCloud
    """`POINTS` of the drape."""
    reference_again: PointCloud
    """Another draw of them."""


@dataclass(frozen=True, eq=False)
class Scored:
    """A score and the points it was made with, for distances between sets."""

    score: GarmentScore
    clouds: Clouds


def draw_clouds(vertices: Floats, drape: Garment, *, seed: int = 0, number: int = 0) -> Clouds:
    """Draws points from a garment and twice from its drape; the same seed and number give the same.

    Args:
        vertices: (v, 3) of the garment, over the drape's mesh.
        drape: The reference.
        seed: Of the draw.
        number: Of the garment in its set, so that each has points of its own.
    """
    surfaces = (vertices, drape.vertices, drape.vertices)
    return Clouds(
        *(sample_surface(v, drape.faces, POINTS, [seed, number, k]) for k, v in enumerate(surfaces))
    )


def score_garment(
    id: str, garment: Garment, drape: Garment, body: BodyDistance, *, seed: int = 0, number: int = 0
) -> Scored:
    """Measures a garment against the drape of the same pattern.

    Args:
        id: Of the pattern.
        garment: What is judged; `report["sewing"]` and `report["seconds"]` are read where there are any.
        drape: The reference, over the same panel mesh.
        body: What both are worn by.
        seed: Of the points that are drawn.
        number: Of the garment in its set (`draw_clouds`).

    Raises:
        GeometryError: The two are not over one panel mesh.
    """
    mesh = drape.mesh
    if garment.vertices.shape != drape.vertices.shape or not np.array_equal(garment.faces, drape.faces):
        raise GeometryError(
            f"'{id}': the garment has {len(garment.vertices)} vertices and {len(garment.faces)} faces, its "
            f"drape {len(drape.vertices)} and {len(drape.faces)}: they are not over one panel mesh. "
            "Make both with the same edge length and version."
        )
    clouds = draw_clouds(garment.vertices, drape, seed=seed, number=number)
    points, reference, again = clouds.points, clouds.reference, clouds.reference_again
    few, few_reference, few_again = (c.first(FEW_POINTS) for c in (points, reference, again))
    boxed, boxed_reference, boxed_again = (c.in_unit_box() for c in (few, few_reference, few_again))
    distance = np.linalg.norm(garment.vertices - drape.vertices, axis=1)
    cloth = build_cloth(mesh, FABRICS["cotton"])  # for rest lengths, which are those of any fabric
    ignores_arms = vertices_ignoring_arms(mesh)
    inside, deepest = _penetration(garment.vertices, body, ignores_arms)
    drape_inside, drape_deepest = _penetration(drape.vertices, body, ignores_arms)
    strain = _strain(garment.vertices, cloth)
    drape_strain = _strain(drape.vertices, cloth)
    made, wanted = (topology(g.faces, len(g.vertices)) for g in (garment, drape))
    sewing, seconds = garment.report.get("sewing", {}), garment.report.get("seconds")
    quality = garment.report.get("quality", {})
    score = GarmentScore(
        id=id,
        kind=garment_kind(mesh.pattern),
        vertices=len(garment.vertices),
        chamfer_cm2=chamfer(points, reference),
        chamfer_floor_cm2=chamfer(again, reference),
        surface_cm=surface_distance(points, reference),
        surface_floor_cm=surface_distance(again, reference),
        emd_cm=earth_mover(few, few_reference),
        emd_floor_cm=earth_mover(few_again, few_reference),
        chamfer_box_e3=BOX_SCALE * chamfer(boxed, boxed_reference),
        chamfer_box_floor_e3=BOX_SCALE * chamfer(boxed_again, boxed_reference),
        vertex_mean_cm=float(distance.mean()),
        vertex_p90_cm=float(np.percentile(distance, 90)),
        inside=inside,
        deepest_cm=deepest,
        drape_inside=drape_inside,
        drape_deepest_cm=drape_deepest,
        strain_p50=strain[0],
        strain_p95=strain[1],
        drape_strain_p50=drape_strain[0],
        drape_strain_p95=drape_strain[1],
        components=made.components,
        nonmanifold_edges=made.nonmanifold_edges,
        boundary_loops=made.boundary_loops,
        sound=made.nonmanifold_edges == 0 and _shape(made) == _shape(wanted),
        seam_gap_median_cm=sewing.get("seam_gap_before_median_cm"),
        seam_gap_p95_cm=sewing.get("seam_gap_before_p95_cm"),
        accepted=quality.get("accepted"),
        rejected_for="; ".join(quality.get("reasons", ())),
        seconds=float(sum(seconds.values())) if seconds else None,
    )
    return Scored(score, clouds)


def _shape(found: Topology) -> tuple[int, int, int]:
    return found.components, found.boundary_loops, found.inconsistent_edges


def _penetration(
    vertices: Floats, body: BodyDistance, ignores_arms: NDArray[np.bool_]
) -> tuple[float, float]:
    """Share of the vertices inside the body, and the depth of the deepest in cm."""
    distance, _ = body.sample(vertices, ignores_arms)
    return float((distance < 0).mean()), float(max(0.0, -distance.min()))


def _strain(vertices: Floats, cloth: ClothModel) -> tuple[float, float]:
    """Median and 95th percentile, as `draping.quality` has them."""
    median, high = np.percentile(np.abs(cloth.strain(vertices)), (50, 95))
    return float(median), float(high)

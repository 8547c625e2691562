"""About where a garment will hang, in a few hundredths of a second: a drape of a few hundred vertices.

The panels are sewn in a third of a second of simulated time and hang for one second, with steps twice as
long as in a drape and without self-collision: layers pass through each other, folds smaller than the mesh
are missing, and nothing is at rest yet. What it does find is where the garment is held and how long it
hangs, which a network is then spared to learn.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.body import BodyMeasurements, DistanceField
from swifttailor.compiled_loop import CompiledLoop
from swifttailor.draping.attachment import find_attachment
from swifttailor.draping.cloth import build_cloth
from swifttailor.draping.collider import join_fields, vertices_ignoring_arms
from swifttailor.draping.fabric import Fabric
from swifttailor.draping.known_fabrics import get_fabric
from swifttailor.draping.loop_arguments import FRAME_RATE, GRAVITY, HeldArrays, StepSettings, coarse_work
from swifttailor.draping.placement import place_vertices
from swifttailor.errors import SimulationError
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern import Pattern

_sew_and_hang = CompiledLoop("swifttailor.draping.coarse_kernels", "sew_and_hang")
_SEWING_BENDING = 20.0
_VERTEX_CM2 = math.sqrt(3) / 2
"""Area of cloth for each vertex of a regular mesh with edges of 1 cm."""


@dataclass(frozen=True)
class CoarseSettings:
    """How finely and how long; frames of 1/60 s."""

    edge_length: float = 5.4
    """Of the mesh, cm."""
    most_vertices: int = 1100
    """Large garments get longer edges, so as not to take much longer."""
    substeps: int = 10
    """More of them for shorter edges: with too few cloth stretches, with too many it hangs short."""
    closing_frames: int = 20
    calming_frames: int = 4
    hanging_frames: int = 60
    damping: float = 8.0
    """Of the hanging, 1/s."""
    max_speed: float = 120.0
    """cm/s"""


HASTY = CoarseSettings(edge_length=7.2, most_vertices=600, substeps=8, hanging_frames=40)
"""For garments that are looked at for a moment, such as while a pattern is dragged: on the examples of the
studio the sewn garment is 1.2 cm from the one that the defaults lead to, on average."""


def coarse_edge_length(pattern: Pattern, settings: CoarseSettings) -> float:
    """Edge length in cm that keeps a garment within the number of vertices, about."""
    area = sum(abs(panel.signed_area()) for panel in pattern.panels)
    return max(settings.edge_length, math.sqrt(area / (_VERTEX_CM2 * settings.most_vertices)))


def drape_coarsely(
    mesh: PatternMesh,
    full: DistanceField,
    armless: DistanceField,
    measurements: BodyMeasurements,
    *,
    fabric: Fabric | str = "cotton",
    settings: CoarseSettings | None = None,
) -> Floats:
    """Sews a coarse mesh on a body and lets it hang for a second.

    Args:
        mesh: Of the pattern, with edges of about `coarse_edge_length`.
        full: Distance to the body.
        armless: The same without the arms, on a part of the same lattice.
        measurements: Of the body.
        fabric: A `Fabric` or the name of a preset.
        settings: How finely and how long; the defaults when None.

    Returns:
        (v, 3) welded vertices, cm.

    Raises:
        SimulationError: The cloth went to infinity.
    """
    c = settings or CoarseSettings()
    fabric = get_fabric(fabric)
    cloth = build_cloth(mesh, fabric, press=_lies_folded(mesh.pattern)).arrays
    attachment = find_attachment(mesh, measurements)
    held = HeldArrays(
        np.ascontiguousarray(attachment.vertices, dtype=np.int32),
        np.array(attachment.levels, dtype=np.float64),
    )
    hanging = StepSettings(
        substeps=c.substeps,
        step=1.0 / (FRAME_RATE * c.substeps),
        gravity=GRAVITY,
        damping=c.damping,
        friction=fabric.friction,
        thickness=fabric.thickness,
        max_speed=c.max_speed,
        bending_factor=0.0,
        lowest_level=2.0,
        long_edges=False,
        self_collision=False,
        untangling=0.0,
        contact_interval=5,
        still=0.0,
    )
    sewing = hanging._replace(
        gravity=0.0,
        damping=20.0,
        friction=0.0,
        max_speed=250.0,
        bending_factor=_SEWING_BENDING,
        long_edges=True,
    )
    caught = min(15, c.hanging_frames)
    positions = np.ascontiguousarray(place_vertices(mesh), dtype=np.float64)
    _sew_and_hang(
        positions,
        cloth._replace(rest=cloth.rest.copy()),
        cloth.rest,
        join_fields(full, armless, vertices_ignoring_arms(mesh)),
        held,
        np.ascontiguousarray(attachment.at_first),
        (c.closing_frames, c.calming_frames, caught, c.hanging_frames - caught),
        sewing,
        hanging._replace(long_edges=True),
        hanging,
        coarse_work(len(positions), len(cloth.edges), len(cloth.hinges)),
    )
    if not np.isfinite(positions).all():
        raise SimulationError(
            "The cloth moved to infinity. Check the pattern for degenerate panels with "
            "'swifttailor check PATTERN'."
        )
    return positions


def _lies_folded(pattern: Pattern) -> bool:
    """Whether its collar lies on the torso all around, or is turned down over itself.

    Those of GarmentCode are folded in front and stand behind. GarmentSewer has learnt from drapes in which
    they spring up, so that what it begins from must, too.
    """
    collars = [(len([r for r in s.sides if "collar" in r.panel]), s.right_wrong) for s in pattern.stitches]
    if any(both == 2 and folded for both, folded in collars):
        return True
    seams = [folded for sides, folded in collars if sides == 1]
    return bool(seams) and all(seams)

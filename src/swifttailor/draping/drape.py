"""From a pattern to a draped garment: mesh, sew, settle, measure."""

from __future__ import annotations

import platform
from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor import __version__
from swifttailor.body import Body
from swifttailor.body.wearer import body_of
from swifttailor.clock import Clock
from swifttailor.draping.attachment import find_attachment
from swifttailor.draping.cloth import ClothModel, build_cloth
from swifttailor.draping.cloth_need import cloth_need
from swifttailor.draping.engine import Engine, SewnGarment, require_settled
from swifttailor.draping.engines import find_engine
from swifttailor.draping.fabric import Fabric
from swifttailor.draping.known_fabrics import get_fabric
from swifttailor.draping.placement import place_vertices
from swifttailor.errors import InputError, SimulationError
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern import Pattern
from swifttailor.progress import StageProgress

if TYPE_CHECKING:
    from swifttailor.draping.simulation import Simulation, SimulationSettings


def drape(
    pattern: Pattern,
    *,
    body: Body | None = None,
    fabric: Fabric | str = "cotton",
    edge_length: float = 2.0,
    engine: Engine | str = "xpbd",
    seed: int = 0,
    settings: SimulationSettings | None = None,
    progress: StageProgress | None = None,
) -> Garment:
    """Sews a pattern together on a body and lets it hang to rest.

    Args:
        pattern: Any order of panels and stitches gives the same garment.
        body: What it is worn by; the one that the pattern was drafted for, else the default body, when None.
        fabric: A `Fabric` or the name of a preset (`known_fabrics.FABRICS`).
        edge_length: Target edge length of the mesh, cm.
        engine: What does the last stage: an `Engine`, or the name of one: ``xpbd``, ``newton`` for Newton's
            Style3D solver (extra `newton`), or another that is registered (`register_engine`).
        seed: Moves every starting position by a hundredth of a millimetre at random when not 0, to see how
            much a drape depends on chance.
        settings: How long and how finely to simulate.
        progress: Called with the stage's name and the share of it that is done.

    Returns:
        The garment; its report holds `quality`, `seconds` per stage and what it was made with.

    Raises:
        InputError: An argument is out of range, or no body has the measures that the pattern names.
        PatternError: The pattern cannot be sewn.
        GeometryError: A panel cannot be meshed.
        SimulationError: The cloth went to infinity.
        MissingExtraError: The engine is not installed.
    """
    from swifttailor.draping.quality import measure_quality  # the loops load numba: half a second
    from swifttailor.draping.simulation import SimulationSettings

    last_stage = find_engine(engine) if isinstance(engine, str) else engine
    if not isinstance(seed, int) or not 0 <= seed < 2**63:
        raise InputError(f"The seed must be a whole number from 0 to 2^63 - 1, got {seed!r}.")
    fabric = get_fabric(fabric)
    body = body_of(pattern.drafted_for) if body is None else body
    settings = SimulationSettings() if settings is None else settings
    report_progress = progress if progress is not None else (lambda stage, share: None)

    clock = Clock()
    report_progress("meshing", 0.0)
    pattern = pattern.canonical()
    mesh = mesh_pattern(pattern, edge_length)
    cloth = build_cloth(mesh, fabric)
    clock.stop("meshing")

    simulation = _dress(mesh, cloth, body, fabric, settings, seed, report_progress)
    clock.stop("sewing")
    sewn = SewnGarment(mesh, body, fabric, cloth, simulation)
    settled = require_settled(last_stage.settle(sewn, report_progress), sewn)
    clock.stop("draping")
    quality = measure_quality(
        mesh,
        settled.positions,
        cloth,
        body,
        static=settled.static,
        frames=settled.frames,
        ignores_arms=simulation.field.ignores_arms,
    )
    clock.stop("measuring")
    report: dict[str, Any] = {
        "quality": quality.to_json(),
        "seconds": clock.seconds,
        "engine": engine if isinstance(engine, str) else type(engine).__name__,
        "fabric": fabric.name,
        "cloth": cloth_need(mesh, fabric),
        "edge_length_cm": edge_length,
        "rotation": pattern.panels[0].placement.reading,
        "seed": seed,
        "body": body.name,
        "vertices": mesh.vertex_count,
        "faces": len(mesh.faces),
        "panels": len(pattern.panels),
        "stitches": len(pattern.stitches),
        "versions": {
            "swifttailor": __version__,
            "python": platform.python_version(),
            "numpy": np.__version__,
        },
    }
    report_progress("draping", 1.0)
    return Garment(mesh, settled.positions, report)


def _dress(
    mesh: PatternMesh,
    cloth: ClothModel,
    body: Body,
    fabric: Fabric,
    settings: SimulationSettings,
    seed: int,
    progress: StageProgress,
) -> Simulation:
    """Sews the panels on in the first way of `DRESSINGS` that leaves them untangled, else in the best."""
    from swifttailor.draping.simulation import DRESSINGS, Simulation, sew
    from swifttailor.draping.untangle import FEW_CROSSINGS, untangle

    attachment = find_attachment(mesh, body.measurements)
    best, fewest = None, float("inf")
    for dressing in DRESSINGS:
        positions = place_vertices(mesh, sleeves_out=dressing.sleeves_out)
        if seed:
            positions = positions + np.random.default_rng(seed).normal(0.0, 1e-3, positions.shape)
        simulation = Simulation(mesh, cloth, body, fabric, attachment, positions, settings)
        sew(simulation, dressing, progress)
        _require_finite(simulation)
        crossings = untangle(simulation, progress, "sewing") if settings.self_collision else 0
        if crossings < fewest:
            best, fewest = simulation, crossings
        if fewest <= FEW_CROSSINGS or not simulation.sleeve_edges.any():
            break
    assert best is not None
    return best


def _require_finite(simulation: Simulation) -> None:
    if not np.isfinite(simulation.positions).all():
        raise SimulationError(
            "The cloth moved to infinity. Check the pattern for degenerate panels with "
            "'swifttailor check', or use a longer edge length or a softer fabric."
        )

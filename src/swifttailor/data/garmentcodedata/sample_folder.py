"""One folder of GarmentCodeData as a sample."""

from __future__ import annotations

from typing import Any

import numpy as np

from swifttailor.data.garmentcodedata.dataset import SampleFolder
from swifttailor.data.garmentcodedata.panels import locate
from swifttailor.data.garmentcodedata.resample import resample
from swifttailor.data.garmentcodedata.split_mesh import read_segmentation, read_split_mesh
from swifttailor.data.sample import Sample
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import read_specification
from swifttailor.pattern.json_values import read_json_file
from swifttailor.pattern.panel import RotationReading


def read_sample_folder(
    folder: SampleFolder, *, edge_length: float = 2.0, rotation: RotationReading = "intrinsic"
) -> Sample:
    """Reads specification and simulated mesh, and carries the drape over to this package's panel mesh.

    Args:
        folder: From `GarmentCodeData.samples`.
        edge_length: Of the panel mesh, cm.
        rotation: How to read the placement angles; the drape does not depend on it.

    Returns:
        The sample. Its `about` holds `source`, `quality` (as far as it can be told without the body), `body`
        and `seam_spread_cm`, by how much the panels disagreed about the vertices they share.

    Raises:
        InputError: A file is missing, damaged, or they do not belong together.
        PatternError: The specification is no pattern.
        GeometryError: A panel cannot be meshed.
    """
    specification = read_json_file(folder.file("specification.json"))
    reading = read_specification(specification, name=folder.name, rotation=rotation)
    pattern = reading.pattern.canonical()
    simulated = read_split_mesh(folder.file("sim.ply"))
    segmentation_file = folder.file("sim_segmentation.txt")
    segmentation = read_segmentation(segmentation_file) if segmentation_file.is_file() else []
    order = [panel.name for panel in reading.pattern.panels]
    at = locate(simulated, segmentation, pattern, order)
    mesh = mesh_pattern(pattern, edge_length)
    vertices, spread = resample(mesh, simulated, at)
    about = {
        "source": folder.path,
        "body": folder.body,
        "quality": _quality(Garment(mesh, vertices), folder),
        "seam_spread_cm": round(spread, 4),
    }
    return Sample.of_garment(folder.name, Garment(mesh, vertices), edge_length, about)


def _quality(garment: Garment, folder: SampleFolder) -> dict[str, Any]:
    """What can be said without a simulation: the data set's own verdict, height and strain."""
    mesh = garment.mesh
    pairs = mesh.flat_faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    rest = np.linalg.norm(mesh.flat_vertices[pairs[:, 0]] - mesh.flat_vertices[pairs[:, 1]], axis=1)
    ends = garment.vertices[mesh.weld[pairs]]
    strain = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1) / np.maximum(rest, 1e-6) - 1
    return {
        "accepted": not folder.failures,
        "reasons": [f"listed by the data set as a failure: {name}" for name in folder.failures],
        "top_cm": float(garment.vertices[:, 1].max()),
        "strain_p50": float(np.percentile(np.abs(strain), 50)),
        "strain_p95": float(np.percentile(np.abs(strain), 95)),
    }

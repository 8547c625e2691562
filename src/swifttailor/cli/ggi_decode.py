"""The half of ``swifttailor ggi`` that makes garments of images."""

from __future__ import annotations

import json
import platform
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from swifttailor.errors import InputError
from swifttailor.garment.garment import Garment

if TYPE_CHECKING:
    from swifttailor.cli.ggi import Ggi
    from swifttailor.garment.triangle_mesh import TriangleMesh
    from swifttailor.ggi import GarmentGeometryImage
    from swifttailor.ggi.stitch import SewnGrid
    from swifttailor.output_folder import OutputFolder


def run_ggi_decode(options: Ggi, file: Path, output: OutputFolder) -> Path:
    """Decodes a file, writes the garment's folder, prints what was made, and returns what shows it.

    Args:
        options: Of the command: `method` and `edge_length`.
        file: A ggi.npz.
        output: Where to.

    Raises:
        SwiftTailorError: The file cannot be read or decoded, or the folder not be written.
    """
    from swifttailor.garment.folder import GLB, OBJ, REPORT, names_written, save_garment
    from swifttailor.ggi.decode import decode
    from swifttailor.ggi.file import read_ggi

    if options.edge_length is not None and options.method == "grid":
        raise InputError(
            "With the method 'grid' the pixels are the vertices; leave --edge-length out, "
            "or decode with the method 'outline'."
        )
    method = options.method or "outline"
    names = (GLB, OBJ, REPORT) if method == "grid" else names_written(preview=False)
    output.require_own(names)
    edge_length = 2.0 if options.edge_length is None else options.edge_length
    started = time.perf_counter()
    images = read_ggi(file)
    read = time.perf_counter()
    garment = decode(images, method, edge_length)
    decoded = time.perf_counter()
    report = _report(images, garment, method)
    report["seconds"] = {"reading": round(read - started, 4), "decoding": round(decoded - read, 4)}
    if isinstance(garment, Garment):
        report["edge_length_cm"] = edge_length
        report["rotation"] = garment.pattern.panels[0].placement.reading
        save_garment(Garment(garment.mesh, garment.vertices, report), output, preview=False)
    else:
        _save_grid(mesh_of_grid(garment, images), output, report)
    counts = report["topology"]
    print(  # noqa: T201
        f"{report['vertices']} vertices, {report['faces']} faces; {counts['components']} pieces, "
        f"{counts['boundary_loops']} openings. Wrote {output.folder}"
    )
    return output.folder / GLB


def _report(images: GarmentGeometryImage, garment: Garment | SewnGrid, method: str) -> dict[str, Any]:
    """What is known of the garment; the keys are those of a drape's report where they mean the same."""
    import numpy as np

    from swifttailor import __version__
    from swifttailor.panel_mesh.topology import topology

    counts = topology(garment.faces.astype(np.int32), len(garment.vertices))
    return {
        "source": "garment geometry image",
        "method": method,
        "resolution": images.resolution,
        "cm_per_pixel": None if images.layout is None else images.layout.cm_per_pixel,
        "vertices": len(garment.vertices),
        "faces": len(garment.faces),
        "panels": int(images.panel.max(initial=-1)) + 1,
        "stitches": images.stitching.stitch_count,
        "topology": {
            "components": counts.components,
            "boundary_loops": counts.boundary_loops,
            "euler_characteristic": counts.euler_characteristic,
            "nonmanifold_edges": counts.nonmanifold_edges,
        },
        "versions": {
            "swifttailor": __version__,
            "python": platform.python_version(),
            "numpy": np.__version__,
        },
    }


def mesh_of_grid(grid: SewnGrid, images: GarmentGeometryImage) -> TriangleMesh:
    """The decoded grid as every writer takes it: a group per panel, texture coordinates of the image."""
    import numpy as np

    from swifttailor.garment.triangle_mesh import TriangleMesh
    from swifttailor.ggi.semantic import PANEL_TYPES

    if images.layout is not None:
        names = [p.name for p in images.layout.pattern.panels]
    else:
        names = [""] * (int(images.panel.max(initial=-1)) + 1)
        found, first = np.unique(images.panel, return_index=True)
        for panel, pixel in zip(found.tolist(), first.tolist(), strict=True):
            if panel >= 0:
                names[panel] = f"{PANEL_TYPES[int(images.semantic.ravel()[pixel])]}_{panel}"
    return TriangleMesh(
        grid.vertices, grid.faces, grid.uv, grid.flat_faces, tuple(names), grid.face_panel, grid.seams
    )


def _save_grid(mesh: TriangleMesh, output: OutputFolder, report: dict[str, Any]) -> None:
    from swifttailor.atomic_files import write_text
    from swifttailor.garment.folder import GLB, OBJ, OF_A_GARMENT, REPORT
    from swifttailor.garment.glb import write_glb
    from swifttailor.garment.obj import write_obj

    with output.fill(stale=OF_A_GARMENT) as folder:
        write_glb(mesh, folder / GLB)
        write_obj(mesh, folder / OBJ)
        write_text(folder / REPORT, json.dumps(report, indent=2, allow_nan=False) + "\n")

"""What a folder that a command has written must be, seen from outside: its files alone are read."""

from __future__ import annotations

import json
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.describing import GarmentFacts, measure_facts
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh.topology import edge_faces, topology
from swifttailor.pattern import EdgeRef, Pattern, check_pattern, load_pattern

SEWN_FILES = {".swifttailor", "pattern.json", "pattern.svg", "garment.glb", "garment.obj", "report.json"}
MADE_FILES = SEWN_FILES | {"ggi.npz"}
BORDER = (0.2, 1.2)
"""Length of the open borders of a sewn garment, in lengths of the edges that are not sewn.

A seam that is open would add twice its own. The network lets hems of small garments stand out up to a fifth
wider; those of the fullest skirts (one of 59 m) lose length to folds that it does not make.
"""


def assert_sound(folder: Path, files: set[str]) -> tuple[Pattern, GarmentFacts, dict[str, Any]]:
    """Every file is there and says the same garment, whole, closed along its seams, near the body.

    Returns:
        The pattern as written, what it shows, and the report.
    """
    assert {p.name for p in folder.iterdir()} == files
    pattern = load_pattern(folder / "pattern.json")
    report = json.loads((folder / "report.json").read_text())
    assert report["panels"] == len(pattern.panels) and report["stitches"] == len(pattern.stitches)
    if not report["findings"]:
        assert check_pattern(pattern) == ()
    assert all(f'data-panel="{p.name}"' in (folder / "pattern.svg").read_text() for p in pattern.panels)

    import trimesh

    # glTF is in metres and cuts the mesh along its seams, which are closed where the places are the same.
    # What is put on the cloth is no part of it.
    panels = {panel.name for panel in pattern.panels}
    scene = trimesh.load(folder / "garment.glb", process=False)
    scene.delete_geometry([name for name in scene.geometry if name not in panels])
    glb = scene.to_mesh()
    glb.merge_vertices(merge_tex=True, merge_norm=True)
    assert_sound_mesh(glb.vertices * 100, glb.faces, pattern)
    obj = trimesh.load(folder / "garment.obj", force="mesh", process=False)
    assert len(obj.faces) == len(glb.faces) == report["faces"]
    assert np.allclose(np.ptp(obj.vertices, axis=0), np.ptp(glb.vertices * 100, axis=0), atol=0.01)

    again = Garment.load(folder)
    assert again.pattern.canonical() == pattern.canonical()
    assert len(again.vertices) == len(glb.vertices) == report["vertices"]
    edges, count = edge_faces(again.faces)
    closed = {tuple(edge) for edge in edges[count == 2].tolist()}
    assert len(again.seams) == len(pattern.stitches)
    for seam in again.seams:
        assert {tuple(sorted(pair)) for pair in pairwise(seam.vertices.tolist())} <= closed
    return pattern, measure_facts(pattern), report


def assert_sound_mesh(vertices: np.ndarray, faces: np.ndarray, pattern: Pattern) -> None:
    """One piece, two faces at most to an edge, none without area, open only where nothing is sewn."""
    assert np.isfinite(vertices).all()
    found = topology(faces.astype(np.int32), len(vertices))
    assert found.components == 1
    assert found.nonmanifold_edges == 0
    if not any(s.right_wrong for s in pattern.stitches):  # as at lapels, sewn right side to wrong side
        assert found.inconsistent_edges == 0
    corners = vertices[faces]
    doubled = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (np.linalg.norm(doubled, axis=1) > 1e-6).all()

    low, high = vertices.min(axis=0), vertices.max(axis=0)
    assert low[1] > -60 and high[1] < 190  # of a figure of 172 cm; trains lie on the floor
    assert low[0] < 0 < high[0] and np.abs(vertices[:, [0, 2]]).max() < 150

    edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    once, count = np.unique(edges, axis=0, return_counts=True)
    border = once[count == 1]
    around = np.linalg.norm(vertices[border[:, 0]] - vertices[border[:, 1]], axis=1).sum()
    sewn = {ref for s in pattern.stitches for ref in s.sides}
    edges_of_panels = [EdgeRef(p.name, k) for p in pattern.panels for k in range(len(p.edges))]
    flat = sum(pattern.edge_length(ref) for ref in edges_of_panels if ref not in sewn)
    assert BORDER[0] < around / flat < BORDER[1], (pattern.name, around / flat)


def contents(folder: Path) -> dict[str, Any]:
    """Every file's bytes; of the report what does not tell the time."""
    told = ("report.json", ".swifttailor")
    found: dict[str, Any] = {p.name: p.read_bytes() for p in folder.iterdir() if p.name not in told}
    report = json.loads((folder / "report.json").read_text())
    return found | {"report.json": {k: v for k, v in report.items() if k != "seconds"}}

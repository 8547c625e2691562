from __future__ import annotations

import struct

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.garment.formats import read_garment_mesh, write_garment_mesh
from swifttailor.garment.seam_names import read_seam_name, seam_name, seam_names
from swifttailor.garment.triangle_mesh import TriangleMesh
from swifttailor.pattern import EdgeRef, Stitch

FORMATS = ("glb", "obj", "usda", "usdc", "usdz")
PANELS = st.text(st.characters(exclude_categories=("Cs",)), min_size=1)
EDGES = st.builds(EdgeRef, PANELS, st.integers(0, 999))


@given(st.integers(0, 9999), EDGES, EDGES, st.booleans())
def test_names_say_what_is_sewn(number, first, second, right_wrong):
    stitch = Stitch(first, second, right_wrong)
    name = seam_name(number, stitch)
    assert read_seam_name(name) == (number, stitch)
    assert not set(name) & set(" \t\n#\\/")


@given(st.text())
def test_other_names_are_no_seams(text):
    assert read_seam_name(text) is None or text.startswith("seam_")


@pytest.mark.parametrize("ending", FORMATS)
@pytest.mark.parametrize("then", ["", *FORMATS])
def test_every_seam_is_found_again(tube, tube_mesh, tmp_path, ending, then):
    """Its name, its stitch, and its line of vertices, whatever formats it went through."""
    mesh = read_garment_mesh(write_garment_mesh(tube_mesh, tmp_path / f"a.{ending}"))
    if then:
        mesh = read_garment_mesh(write_garment_mesh(mesh, tmp_path / f"b.{then}"))
    assert mesh.line_names == seam_names(tube.pattern)
    for name, line, seam in zip(mesh.line_names, mesh.lines, tube.seams, strict=True):
        assert read_seam_name(name) == (seam.stitch, tube.pattern.stitches[seam.stitch])
        np.testing.assert_allclose(mesh.vertices[line], tube.vertices[seam.vertices], atol=1e-4)


def test_a_file_that_lies_about_its_seams_is_read_without_them(tube_mesh, tmp_path):
    path = write_garment_mesh(tube_mesh, tmp_path / "a.glb")
    content = bytearray(path.read_bytes())
    content[-4:] = struct.pack("<f", 1e6)  # the last seam ends at a vertex that there is not
    path.write_bytes(content)
    mesh = read_garment_mesh(path)
    assert len(mesh.lines) == len(tube_mesh.lines) - 1 and len(mesh.faces) == len(tube_mesh.faces)


@pytest.mark.parametrize("ending", ["glb", "usdc"])
def test_the_wearer_is_no_cloth(tube_mesh, tmp_path, ending):
    from dataclasses import replace

    body = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]), np.array([[0, 1, 2]])
    path = write_garment_mesh(replace(tube_mesh, wearer=body), tmp_path / f"a.{ending}")
    mesh = read_garment_mesh(path)
    assert len(mesh.faces) == len(tube_mesh.faces) and mesh.groups == tube_mesh.groups
    assert isinstance(mesh, TriangleMesh) and len(mesh.lines) == len(tube_mesh.lines)

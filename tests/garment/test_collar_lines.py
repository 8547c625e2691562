"""Collars are told by their edges, and nothing is drawn across them."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from swifttailor.garment.collar_lines import is_of_collar, seams_within_collars
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.centre_seams import needless_centre_seams
from swifttailor.pattern.drafts import draft


@pytest.mark.parametrize(("name", "many"), [("shirt", True), ("blazer", True), ("t-shirt", False)])
def test_seams_within_collars(name, many):
    pattern = draft(name)
    found = [pattern.stitches[k] for k in seams_within_collars(pattern)]
    assert bool(found) is many
    assert all("collar" in side.panel for stitch in found for side in stitch.sides)


def test_vertices_of_collars():
    pattern = draft("shirt")
    mesh = mesh_pattern(pattern, 3.0)
    garment = SimpleNamespace(pattern=pattern, mesh=mesh, faces=mesh.flat_faces, vertices=mesh.flat_vertices)
    own = is_of_collar(garment)
    panels = [pattern.panels[k].name for k in mesh.flat_panel]
    assert [("collar" in name) for name in panels] == own.tolist()


@pytest.mark.parametrize("name", ["camisole", "slip-dress"])
def test_what_widens_from_the_top_has_no_seam_in_the_middle(name):
    pattern = draft(name)
    assert not needless_centre_seams(pattern)
    assert len(needless_centre_seams(pattern, aslant=True)) == 2

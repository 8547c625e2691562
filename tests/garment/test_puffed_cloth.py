"""Quilted cloth stands off between its lines, in pictures alone."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from swifttailor.garment.garment import Garment
from swifttailor.garment.puffed_cloth import with_puffs
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module")
def jacket() -> Garment:
    pattern = replace(draft("turtleneck"), trims=("zip", "quilting"))
    mesh = mesh_pattern(pattern, 3.0)
    flat = [p.to_world(mesh.flat_vertices[mesh.flat_panel == k]) for k, p in enumerate(pattern.panels)]
    return Garment(mesh, mesh.welded_mean(np.concatenate(flat)))


def test_cloth_moves_outward_by_no_more_than_a_cushion(jacket):
    off = np.einsum("nk,nk->n", with_puffs(jacket).vertices - jacket.vertices, jacket.vertex_normals)
    assert off.min() > -1e-9 and 1.0 < off.max() < 2.0
    assert np.median(off) > 0.4


def test_what_has_no_quilting_stays(jacket):
    plain = replace(jacket, mesh=replace(jacket.mesh, pattern=replace(jacket.pattern, trims=("zip",))))
    assert with_puffs(plain) is plain

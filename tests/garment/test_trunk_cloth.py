"""Belts go around the trunk and leave sleeves out, also those that are cut in one with it."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from swifttailor.garment.trunk_cloth import around_trunk
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft


@pytest.mark.parametrize(
    ("name", "armhole"),
    [*[("t-shirt", armhole) for armhole in ("set-in", "raglan", "cut-in-one")], ("wrap-top", "cut-in-one")],
)
def test_nothing_beyond_the_side_counts(name, armhole):
    pattern = draft(name, armhole=armhole, sleeve_length=50.0, sleeve_end=28.0)
    mesh = mesh_pattern(pattern, 3.0)
    found = around_trunk(SimpleNamespace(mesh=mesh, pattern=pattern))
    panels = [pattern.panels[k] for k in mesh.flat_panel]
    x = np.array([p.to_world(v[None])[0, 0] for p, v in zip(panels, mesh.flat_vertices, strict=True)])
    assert np.abs(x[found]).max() < 30.0 < np.abs(x).max()
    assert found.mean() > 0.4

"""Ease is measured across the panels as a cutter does it: folds are no more cloth."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.level_lines import BELOW_ARMHOLE_CM, chest_line, without_folds
from swifttailor.body import Body
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.refitting.cloth_girths import cloth_around


@pytest.fixture(scope="module")
def mesh():
    return mesh_pattern(draft("gathered-skirt"), 2.0)


def width(mesh, heights):
    counted = np.ones(len(mesh.flat_faces), np.bool_)
    return float(np.median(cloth_around(mesh, heights, counted, np.linspace(-2.0, 2.0, 5))))


def levels(mesh):
    """Heights (m,) above the middle of each panel as it is cut, cm."""
    result = np.array(mesh.flat_vertices[:, 1])
    for number in range(len(mesh.pattern.panels)):
        own = mesh.flat_panel == number
        result[own] -= (result[own].min() + result[own].max()) / 2
    return result


@pytest.mark.parametrize("depth", [1.0, 2.0, 3.0])
def test_folds_are_not_counted(mesh, depth):
    flat = levels(mesh)
    folded = flat + depth * np.sin(2 * np.pi * mesh.flat_vertices[:, 0] / 9.0)
    counted, evened = width(mesh, folded), width(mesh, without_folds(mesh, folded))
    true = width(mesh, flat)
    assert counted > true * (1 + 0.06 * depth)  # what the line of one height says
    assert evened == pytest.approx(true, rel=0.01)


def test_a_level_that_leans_or_bends_stays_as_it_is(mesh):
    x = mesh.flat_vertices[:, 0]
    for leaning in (0.2 * x, 0.002 * x**2):
        heights = levels(mesh) + leaning
        assert width(mesh, without_folds(mesh, heights)) == pytest.approx(width(mesh, heights), rel=0.02)


def hung(name, **options):
    """A draft and the heights (m,) of its flat vertices where its panels are placed."""
    mesh = mesh_pattern(draft(name, **options), 2.0)
    panels = mesh.pattern.panels
    world = np.array(
        [panels[k].to_world(v[None])[0] for k, v in zip(mesh.flat_panel, mesh.flat_vertices, strict=True)]
    )
    return mesh, world[:, 1]


@pytest.mark.parametrize("name", ["t-shirt", "tank-top"])
def test_the_chest_is_measured_below_the_armholes(name):
    body = Body.default().measurements
    mesh, heights = hung(name)
    line = chest_line(mesh, heights, body)
    assert line <= body.bust_level
    trunk = np.isin(mesh.flat_panel, [k for k, p in enumerate(mesh.pattern.panels) if "torso" in p.name])
    counted = trunk[mesh.flat_faces].all(axis=1)
    here, lower = cloth_around(mesh, heights, counted, np.array([line, line - 1.0]))[:, 0]
    assert here == pytest.approx(lower, rel=0.01)  # no armhole cuts in
    low = heights - 10.0
    above = cloth_around(mesh, low, counted, np.array([body.bust_level, chest_line(mesh, low, body)]))[:, 0]
    assert above[0] < 0.97 * above[1]  # the bust level would run through the armholes
    assert chest_line(mesh, low, body) < body.bust_level - BELOW_ARMHOLE_CM


def test_without_armholes_the_chest_is_measured_at_the_bust():
    body = Body.default().measurements
    assert chest_line(*hung("strapless-dress"), body) == body.bust_level

"""Twenty outputs of every system: recognised, read, mended, and sewn."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from system_writers import DANGLING_EVERY, FAILED, WRITERS, with_quadratics

from swifttailor.data.released import LAYOUTS, Output, read_outputs
from swifttailor.garment_sewer import GarmentSewer
from swifttailor.garment_sewer.pixels.sewn_prior import vertices_ignoring_arms
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import Pattern, Severity, check_pattern, read_specification, to_specification

T_POSE = {"sewformer", "dresscode", "garment-pattern-generator"}
NUMBERED = {"dresscode", "garmagenet"}
KEEPS_FLAGS = {"garmentcode", "chatgarment", "design2garmentcode", "sewingldm", "garmagenet"}
"""Who says which seams join right to wrong side; of the others it is worked out where evidence agrees."""
SEWER = Path(__file__).parents[2] / "garment_sewer" / "tiny_sewer.onnx"
"""An untrained network: it predicts its prior."""


@pytest.fixture(scope="module")
def folders(tmp_path_factory, garments) -> dict[str, tuple[Path, list[str]]]:
    """A folder of each system, and the ids to be found in it."""
    made = {}
    for layout, write in WRITERS.items():
        folder = tmp_path_factory.mktemp(layout) / "run"
        made[layout] = folder, write(folder, garments)
    return made


@pytest.fixture(scope="module")
def outputs(folders) -> dict[str, list[Output]]:
    return {layout: list(read_outputs(folder)) for layout, (folder, _) in folders.items()}


def test_every_layout_is_tested():
    assert set(WRITERS) == set(LAYOUTS)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_all_twenty_are_found_under_their_names(layout, folders, outputs):
    folder, ids = folders[layout]
    made = [o for o in outputs[layout] if o.pattern is not None]
    assert sorted(o.id for o in made) == sorted(ids) and len(ids) == 20
    assert {o.layout for o in outputs[layout]} == {layout}
    failed = [o for o in outputs[layout] if o.pattern is None]
    assert len(failed) == FAILED.get(layout, 0)
    assert all("wrote no pattern for this input" in o.error for o in failed)
    assert [o.pattern for o in read_outputs(folder, layout)] == [o.pattern for o in outputs[layout]]
    assert not list(folder.rglob("unpickled")), "a pickle was opened"


@pytest.mark.parametrize("layout", LAYOUTS)
def test_they_are_the_garments_that_were_written(layout, garments, outputs):
    """Panels, shapes, places and seams; the output's panels are in the order that they were written in."""
    for original, output in paired(layout, garments, outputs):
        pattern = output.pattern
        assert output.error == "" and output.garment is None
        assert len(pattern.panels) == len(original.panels)
        for before, after in zip(original.panels, pattern.panels, strict=True):
            assert (after.name == before.name) or layout in NUMBERED or after.name.startswith("bottom_panel_")
            area = abs(before.signed_area())
            close = 0.03 if layout == "garmagenet" else 1e-3
            dangling = any(c.code == "open-loop" and c.panel == after.name for c in output.changes)
            assert abs(after.signed_area()) == pytest.approx(area, rel=0.3 if dangling else close, abs=8.0)
            gap = np.linalg.norm(middle(after) - middle(before))
            assert gap < (12.0 if layout in T_POSE else 3.0 if dangling else 1.0), (output.id, after.name)
        if layout == "garmagenet":  # cut anew, and without what is shorter than 1 cm
            assert 0.97 < sewn_length(pattern) / sewn_length(original) < 1.01
        else:
            assert len(pattern.stitches) == len(original.stitches)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_seams_join_the_same_edges_the_same_way(layout, garments, outputs):
    if layout == "garmagenet":
        pytest.skip("its outlines are cut anew; test_garmagenet.py compares seams by their ends")
    for original, output in paired(layout, garments, outputs):
        turned = {c.panel for c in output.changes if c.code == "inside-out-panel"}
        assert turned == set()
        number = {p.name: k for k, p in enumerate(output.pattern.panels)}
        names = [p.name for p in original.panels]
        found = {
            (frozenset((names[number[r.panel]], r.edge) for r in s.sides), s.right_wrong)
            for s in output.pattern.stitches
        }
        written = {(frozenset((r.panel, r.edge) for r in s.sides), s.right_wrong) for s in original.stitches}
        if layout in KEEPS_FLAGS:
            assert found == written
        else:
            assert {sides for sides, _ in found} == {sides for sides, _ in written}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_a_list_of_them_means_the_same(layout, outputs):
    """Files do not tell how angles are meant: what is written is read as it was."""
    for output in outputs[layout]:
        if output.pattern is not None:
            again = read_specification(to_specification(output.pattern))
            assert again.findings == () and again.pattern == output.pattern


@pytest.mark.parametrize("layout", LAYOUTS)
def test_what_was_left_open_is_closed(layout, outputs):
    closed = [o for o in outputs[layout] if any(c.code == "open-loop" for c in o.changes)]
    assert len(closed) == (20 // DANGLING_EVERY if layout in ("aipparel", "sewingldm", "sewformer") else 0)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_all_can_be_meshed(layout, outputs):
    for output in outputs[layout]:
        if output.pattern is not None:
            errors = [f for f in check_pattern(output.pattern) if f.severity is Severity.ERROR]
            assert errors == []
            mesh = mesh_pattern(output.pattern.canonical(), 8.0)
            assert len(mesh.seams) == len(output.pattern.stitches) and len(mesh.faces) > 0


@pytest.mark.parametrize("layout", LAYOUTS)
def test_some_are_sewn(layout, outputs):
    sewer = GarmentSewer.load(SEWER)
    for output in [o for o in outputs[layout] if o.pattern is not None][:2]:
        garment = sewer.sew(output.pattern, edge_length=5.0)
        assert np.isfinite(garment.vertices).all()
        low, high = garment.vertices.min(axis=0), garment.vertices.max(axis=0)
        assert 0 < low[1] and high[1] < 180 and np.abs(garment.vertices[:, [0, 2]]).max() < 150
        distance, _ = sewer.body.sample(garment.vertices, vertices_ignoring_arms(garment.mesh))
        assert (distance < -1.0).mean() < 0.02, output.id


def middle(panel) -> np.ndarray:
    space = panel.to_world(panel.outline(0.5))
    return (space.min(axis=0) + space.max(axis=0)) / 2


def paired(layout: str, garments: dict[str, Pattern], outputs: dict[str, list[Output]]):
    """What was written and what was read, garment by garment."""
    made = [o for o in outputs[layout] if o.pattern is not None]
    for place, (name, original) in enumerate(garments.items()):
        original = with_quadratics(original) if layout in T_POSE else original
        if layout == "dresscode":
            yield original, next(o for o in made if o.id == f"{place:03d}")
        elif layout == "chatgarment":
            yield original, next(o for o in made if same_panels(o.pattern, original))
        else:
            yield original, next(o for o in made if name in o.id)


def sewn_length(pattern: Pattern) -> float:
    of = {p.name: p for p in pattern.panels}
    return sum(of[r.panel].edge_length(r.edge) for s in pattern.stitches for r in s.sides)


def same_panels(one: Pattern, other: Pattern) -> bool:
    return one.canonical() == other.canonical()

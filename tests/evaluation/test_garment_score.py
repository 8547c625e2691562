"""What is measured on one garment, and on many."""

from __future__ import annotations

import json
from dataclasses import asdict, replace

import numpy as np
import pytest
from sewn_splits import make_sample

from swifttailor.draping.cloth import build_cloth
from swifttailor.draping.known_fabrics import FABRICS, get_fabric
from swifttailor.errors import GeometryError, InputError
from swifttailor.evaluation.garments.cloud_distances import chamfer
from swifttailor.evaluation.garments.garment_table import garment_tables, paper_table
from swifttailor.evaluation.garments.score import (
    FEW_POINTS,
    POINTS,
    GarmentScore,
    Scored,
    draw_clouds,
    score_garment,
    score_of_json,
)
from swifttailor.evaluation.garments.sheet import chosen, write_sheets
from swifttailor.evaluation.garments.summary import summarize_scores, work
from swifttailor.evaluation.mean import means_of
from swifttailor.evaluation.paper_rows import ABLATION
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft

pytestmark = pytest.mark.usefixtures("fewer_points")


@pytest.fixture(scope="module")
def drape() -> Garment:
    return make_sample("shirt", "t-shirt").garment


def moved(garment: Garment, by, report: dict | None = None) -> Garment:
    return Garment(garment.mesh, garment.vertices + np.asarray(by, float), report or {})


def test_the_drape_itself_is_at_the_floor(drape, body_distance):
    score = score_garment("a", drape, drape, body_distance).score
    assert score.vertex_mean_cm == score.vertex_p90_cm == 0
    assert score.kind == "upper" and score.vertices == len(drape.vertices) and score.sound
    for name in ("chamfer", "chamfer_box", "emd", "surface"):
        unit = {"chamfer": "_cm2", "chamfer_box": "_e3"}.get(name, "_cm")
        value, floor = getattr(score, name + unit), getattr(score, f"{name}_floor{unit}")
        assert 0 < value < 1.3 * floor and floor < 1.3 * value
    assert (score.inside, score.deepest_cm) == (score.drape_inside, score.drape_deepest_cm)
    assert (score.strain_p50, score.strain_p95) == (score.drape_strain_p50, score.drape_strain_p95)
    assert score.seam_gap_median_cm is None and score.seconds is None


def test_a_garment_that_is_elsewhere(drape, body_distance):
    report = {"sewing": {"seam_gap_before_median_cm": 0.2, "seam_gap_before_p95_cm": 0.7}}
    report |= {"seconds": {"drawing": 0.25, "network": 0.5}}
    score = score_garment("a", moved(drape, [0, 300, 0], report), drape, body_distance).score
    assert score.vertex_mean_cm == pytest.approx(300) == score.vertex_p90_cm
    assert score.emd_cm == pytest.approx(300, rel=0.02)
    assert score.surface_cm > 200 and score.chamfer_cm2 > 2 * 200**2
    # In its box it is the same garment.
    assert score.chamfer_box_e3 < 1.5 * score.chamfer_box_floor_e3
    assert score.strain_p95 == pytest.approx(score.drape_strain_p95)
    assert score.inside == score.deepest_cm == 0
    assert (score.seam_gap_median_cm, score.seam_gap_p95_cm, score.seconds) == (0.2, 0.7, 0.75)


def test_a_garment_twice_as_large(drape, body_distance):
    score = score_garment("a", Garment(drape.mesh, drape.vertices * 2), drape, body_distance).score
    cloth = build_cloth(drape.mesh, get_fabric("cotton"))
    a, b = (drape.vertices[cloth.arrays.edges[:, k]] for k in (0, 1))
    strain = np.abs(2 * np.linalg.norm(a - b, axis=1) / cloth.arrays.rest - 1)[~cloth.gathered]
    assert score.strain_p50 == pytest.approx(np.percentile(strain, 50))
    assert score.strain_p95 == pytest.approx(np.percentile(strain, 95))
    assert score.strain_p50 > 0.5 > score.drape_strain_p50


def test_rest_lengths_are_those_of_any_fabric(drape):
    rests = [build_cloth(drape.mesh, fabric) for fabric in FABRICS.values()]
    for cloth in rests[1:]:
        assert np.array_equal(cloth.arrays.rest, rests[0].arrays.rest)
        assert np.array_equal(cloth.gathered, rests[0].gathered)


def test_depth_in_the_body(drape, body_distance):
    vertices = drape.vertices + np.array([0, 0, 200.0])
    vertices[:10] = [0.0, 110.0, 0.0]  # in the middle of the belly
    score = score_garment("a", Garment(drape.mesh, vertices), drape, body_distance).score
    assert score.inside == pytest.approx(10 / len(vertices))
    depth = -body_distance.full.sample(np.array([[0.0, 110.0, 0.0]]))[0][0]
    assert score.deepest_cm == pytest.approx(depth) and depth > 5


def test_a_garment_over_another_mesh_is_refused(drape, body_distance):
    mesh = mesh_pattern(draft("t-shirt").canonical(), 5.0)
    other = Garment(mesh, np.random.default_rng(0).normal(size=(mesh.vertex_count, 3)))
    with pytest.raises(GeometryError, match="same edge length"):
        score_garment("a", other, drape, body_distance)


def test_scores_are_repeatable_and_can_be_read_back(drape, body_distance):
    garment = moved(drape, [1, 2, 3])
    first, again = (score_garment("a", garment, drape, body_distance, seed=4, number=9) for _ in range(2))
    assert first.score == again.score
    assert score_of_json(json.loads(json.dumps(asdict(first.score)))) == first.score
    clouds = draw_clouds(garment.vertices, drape, seed=4, number=9)
    assert np.array_equal(clouds.points.points, first.clouds.points.points)
    assert np.array_equal(clouds.reference.points, first.clouds.reference.points)
    assert not np.array_equal(clouds.reference.points, clouds.reference_again.points)
    other = score_garment("a", garment, drape, body_distance, seed=4, number=10)
    assert other.score.chamfer_cm2 != first.score.chamfer_cm2
    for broken in (
        {},
        [],
        None,
        asdict(first.score) | {"kind": "hat"},
        asdict(first.score) | {"more": 1},
    ):
        with pytest.raises(InputError, match="start anew"):
            score_of_json(broken)


@pytest.fixture(scope="module")
def some(body_distance) -> list[Scored]:
    """Two skirts and a shirt, each a little off."""
    from swifttailor.evaluation.garments import score

    before, score.FEW_POINTS = score.FEW_POINTS, 300
    found = []
    for k, (name, off) in enumerate([("t-shirt", 1.0), ("fitted-skirt", 2.0), ("circle-skirt", 6.0)]):
        drape = make_sample(name, name).garment
        found.append(score_garment(name, moved(drape, [0, off, 0]), drape, body_distance, number=k))
    score.FEW_POINTS = before
    return found


def test_summary_by_kind(some):
    done: list[int] = []
    summary = summarize_scores(some, progress=done.append)
    assert (summary.garments, summary.failed) == (3, 0) and sum(done) == work(3)
    assert summary.means["vertex_mean_cm"].mean == pytest.approx(3)
    assert summary.means["vertex_mean_cm"].median == pytest.approx(2)
    assert {kind: count for kind, (count, _) in summary.kinds.items()} == {"upper": 1, "skirt": 2}
    assert summary.kinds["skirt"][1]["vertex_mean_cm"].mean == pytest.approx(4)
    assert "seconds" not in summary.means and summary.means["sound"].mean == 1
    # The nearest garment of each drape is its own; the two means are rounded differently.
    assert summary.sets.mmd <= summary.means["chamfer_cm2"].mean * (1 + 1e-12) and summary.sets.coverage == 1
    assert summary.sets_floor.mmd < summary.sets.mmd and summary.sets_floor.coverage == 1
    boxed = [
        [c.first(FEW_POINTS).in_unit_box() for c in (s.clouds.reference_again, s.clouds.reference)]
        for s in some
    ]
    assert summary.box_sets_floor.mmd == pytest.approx(1000 * np.mean([chamfer(a, b) for a, b in boxed]))
    assert json.loads(json.dumps(summary.to_json()))["kinds"]["skirt"]["garments"] == 2
    with pytest.raises(InputError, match="nothing to summarize"):
        summarize_scores([])
    assert means_of([]) == {}


def test_what_was_not_made_counts_between_the_sets(some):
    summary = summarize_scores(some[:2], [some[2].clouds.reference])
    assert (summary.garments, summary.failed) == (2, 1)
    assert summary.sets.coverage == pytest.approx(2 / 3) and summary.sets.failed == 1
    assert summary.sets.mmd > summarize_scores(some).sets.mmd


def test_tables_show_what_was_measured(some):
    summary = summarize_scores(some)
    shown = garment_tables(summary)
    lines = {
        line.split()[0]: line.split() for line in shown.splitlines() if line.startswith(("all", "skirt"))
    }
    assert lines["all"][1] == "3" and lines["skirt"][1] == "2"
    assert f"{POINTS:,}" in shown and f"{FEW_POINTS:,}" in shown
    assert " 3.00 " in next(line for line in shown.splitlines() if line.startswith("all"))
    paper = paper_table(summary, "ours", ABLATION)
    assert "neither unit nor number of points" in paper
    row = next(line for line in paper.splitlines() if "L_stitch" in line)
    assert row.split()[-5:] == ["3.40", "4.48", "3.36", "0.88", "-"]
    ours = next(line for line in paper.splitlines() if line.startswith("ours ")).split()
    assert float(ours[1]) == pytest.approx(summary.means["chamfer_cm2"].mean, abs=0.005)
    assert float(ours[3]) == pytest.approx(summary.sets.mmd, abs=0.005)


def test_pictures_are_spread_from_best_to_worst(some, tmp_path):
    from PIL import Image

    from swifttailor.evaluation.garments.sheet import TILE, Shown, caption

    scores = [replace(some[0].score, id=str(k), vertex_mean_cm=float(k)) for k in (3, 0, 4, 1, 2)]
    assert [s.vertex_mean_cm for s in chosen(scores, 3)] == [0, 2, 4]
    assert len(chosen(scores, 99)) == 5 and chosen(scores, 0) == [] and chosen([], 4) == []
    drape = make_sample("a", "fitted-skirt").garment
    text = caption(some[1].score)
    assert "fitted-skirt, skirt" in text and "2.0 cm" in text
    (sheet,) = write_sheets(tmp_path, [Shown(text, moved(drape, [0, 5, 0]), drape)])
    picture = np.asarray(Image.open(sheet))
    left, right = picture[40:, : TILE[0]], picture[40:, -TILE[0] :]
    assert left.std() > 20 and not np.array_equal(left, right)


def test_every_number_has_its_place_in_a_score():
    from dataclasses import fields

    from swifttailor.evaluation.garments import garment_table

    shown = {name for cells in (garment_table._DISTANCES, garment_table._SOUNDNESS) for name, *_ in cells}
    assert shown <= {f.name for f in fields(GarmentScore)}

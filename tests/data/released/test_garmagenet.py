"""Style3D's patterns: stretches of outlines become edges, borders in space become placements."""

from __future__ import annotations

import json
import shutil

import numpy as np
import pytest
from scipy.spatial import KDTree
from system_writers import garmagenet

from swifttailor.data.released import read_outputs
from swifttailor.data.released.stretches import cut_at_stitches
from swifttailor.data.released.style3d_pattern import parse_style3d
from swifttailor.errors import InputError, PatternError
from swifttailor.pattern import Panel, Pattern
from swifttailor.pattern.drafts import draft


def _edge(panel: int, number: int, start: list[float], end: list[float]) -> dict:
    return {"controlPoints": [[*start, 0], [*end, 0]], "id": f"e{panel}_{number}"}


def square(number: int, *, size: float = 400.0) -> dict:
    """A panel of `size` mm, counter-clockwise from its lower left corner."""
    corners = [[0, 0], [size, 0], [size, size], [0, size]]
    edges = [_edge(number, k, corners[k], corners[(k + 1) % 4]) for k in range(4)]
    outline = {"type": 3, "circleType": 0, "edges": edges, "vertices": []}
    return {"center": [0, 0], "seqEdges": [outline], "id": f"p{number}", "label": f"{number:02d}"}


def stretch(panel: int, start: float, end: float, *, backward: bool = False) -> dict:
    def at(parameter: float) -> dict:
        edge = min(int(parameter), 3)
        return {"clothPieceId": f"p{panel}", "edgeId": f"e{panel}_{edge}", "param": parameter - edge}

    return {"start": at(start), "end": at(end), "isCounterClockWise": backward}


def cut(*stitches: tuple[dict, dict]):
    drawn = parse_style3d({"panels": [square(0), square(1)], "stitches": [list(s) for s in stitches]})
    outlines, sewn, lost = cut_at_stitches(drawn)
    panels = [Panel(o.name, c.vertices, c.edges) for o, c in zip(drawn.outlines, outlines, strict=True)]
    return Pattern(tuple(panels), tuple(sewn)), lost


def joined_points(pattern: Pattern) -> list[tuple[np.ndarray, np.ndarray]]:
    """Where each stitch joins its sides: (5, 2) cm on the first and on the second."""
    of = {p.name: p for p in pattern.panels}
    points = []
    for s in pattern.stitches:
        one, other = (of[r.panel].sample_edge(r.edge, 5) for r in s.sides)
        points.append((one, other if s.right_wrong else other[::-1]))
    return points


def test_half_an_edge_is_sewn_to_a_whole_one():
    """10 to 30 cm of one lower edge to all 40 cm of another, run the other way."""
    pattern, lost = cut((stretch(0, 0.25, 0.75), stretch(1, 1.0, 0.0, backward=True)))
    assert lost == 0 and [len(p.edges) for p in pattern.panels] == [6, 4]
    ((one, other),) = joined_points(pattern)
    np.testing.assert_allclose(one[:, 0], [10, 15, 20, 25, 30], atol=1e-9)
    np.testing.assert_allclose(other[:, 0], [40, 30, 20, 10, 0], atol=1e-9)
    assert not pattern.stitches[0].right_wrong


def test_a_stretch_over_a_corner_is_cut_on_both_sides():
    """30 cm of an edge and 20 of the next, to 10 and 40 cm: cut at both corners, in 3 parts."""
    pattern, lost = cut((stretch(0, 0.25, 1.5), stretch(1, 2.25, 1.0, backward=True)))
    assert lost == 0 and len(pattern.stitches) == 3
    lengths = [(np.hypot(*(a[-1] - a[0])), np.hypot(*(b[-1] - b[0]))) for a, b in joined_points(pattern)]
    np.testing.assert_allclose(lengths, [(10, 10), (20, 20), (20, 20)], atol=1e-6)


def test_same_direction_joins_right_to_wrong_side():
    pattern, _ = cut((stretch(0, 0.0, 1.0), stretch(1, 2.0, 3.0)))
    assert [s.right_wrong for s in pattern.stitches] == [True]
    ((one, other),) = joined_points(pattern)
    np.testing.assert_allclose(one[0], [0, 0], atol=1e-9)
    np.testing.assert_allclose(other[0], [40, 40], atol=1e-9)


def test_a_stretch_may_run_over_the_start_of_the_outline():
    pattern, lost = cut((stretch(0, 3.5, 0.5), stretch(1, 2.0, 1.0, backward=True)))
    assert lost == 0 and len(pattern.stitches) == 2
    ends = [one[[0, -1]].round(6).tolist() for one, _ in joined_points(pattern)]
    assert ends == [[[0, 20], [0, 0]], [[0, 0], [20, 0]]]


def test_what_overlaps_or_is_too_short_is_left_out():
    both = (stretch(0, 0.0, 1.0), stretch(1, 1.0, 0.0, backward=True))
    again = (stretch(0, 0.0, 1.0), stretch(1, 3.0, 2.0, backward=True))
    short = (stretch(0, 2.0, 2.01), stretch(1, 4.0, 3.0, backward=True))
    pattern, lost = cut(both, again, short)
    assert lost == 2 and len(pattern.stitches) == 1


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda d: d.pop("panels"), "panels: a list was expected"),
        (lambda d: d.update(panels=[]), "panels is empty"),
        (lambda d: d["panels"][0].update(seqEdges=[]), "one outline"),
        (lambda d: d["panels"][0].pop("id"), "id: text was expected"),
        (
            lambda d: d["panels"][0]["seqEdges"][0]["edges"][0].update(controlPoints=[[0, 0, 0]]),
            "at least 2 points",
        ),
        (
            lambda d: d["panels"][0]["seqEdges"][0]["edges"][0].update(controlPoints=[["a", 0, 0]] * 2),
            "a number",
        ),
        (lambda d: d.update(stitches=[[1]]), "a list of 2 values"),
        (lambda d: d.update(stitches=[[{}, {}]]), "an object was expected"),
        (lambda d: d.update(panels=[square(0)] * 501), "at most 500"),
    ],
)
def test_damaged_files_say_where(change, message):
    drawn = {"panels": [square(0), square(1)], "stitches": []}
    change(drawn)
    with pytest.raises(PatternError, match=message):
        parse_style3d(drawn)


def test_stitches_to_holes_are_left_out():
    away = stretch(1, 0.0, 1.0)
    away["end"]["edgeId"] = "of a hole"
    drawn = parse_style3d({"panels": [square(0), square(1)], "stitches": [[stretch(0, 0.0, 1.0), away]]})
    assert drawn.stitches == () and drawn.left_out == 1


# Folders


@pytest.fixture
def run(tmp_path):
    garmagenet(tmp_path / "run", {"one": draft("t-shirt"), "two": draft("circle-skirt")})
    return tmp_path / "run"


def test_panels_stand_where_their_borders_are(run):
    for output, name in zip(read_outputs(run), ("t-shirt", "circle-skirt"), strict=True):
        assert output.error == "" and output.pattern is not None
        for before, after in zip(draft(name).panels, output.pattern.panels, strict=True):
            outer, found = (
                p.to_world(np.concatenate([p.sample_edge(k, 300) for k in range(len(p.edges))]))
                for p in (before, after)
            )
            assert KDTree(found).query(outer)[0].max() < 0.5 and KDTree(outer).query(found)[0].max() < 0.5
            out = before.placement.matrix()[:, 2] * np.sign(before.signed_area())
            assert out @ after.placement.matrix()[:, 2] * np.sign(after.signed_area()) > 0.99


def test_pickles_alone_are_refused_with_what_to_give(run):
    shutil.rmtree(run / "sketch_cond_extracted")
    shutil.rmtree(run / "garmagejigsaw_output")
    outputs = list(read_outputs(run))
    assert [o.id for o in outputs] == ["one", "two"]
    for output in outputs:
        assert output.pattern is None and "pickle, which is never opened" in output.error
        assert "garmagejigsaw_output/garment_NAME/garment.json" in output.error
    assert not list(run.rglob("unpickled"))


def test_borders_without_stitches_are_refused(run):
    shutil.rmtree(run / "garmagejigsaw_output" / "garment_two")
    first, second = read_outputs(run)
    assert first.error == "" and second.pattern is None
    assert "has not predicted how these panels are sewn" in second.error


def test_a_pattern_without_borders_has_no_place(run):
    outputs = list(read_outputs(run / "garmagejigsaw_output"))
    assert len(outputs) == 2
    assert all(o.pattern is None and "Where the panels are in space" in o.error for o in outputs)


@pytest.mark.parametrize("damage", ["another", "nan", "far", "text", "missing", "notes", "index"])
def test_borders_that_do_not_fit(run, damage):
    folder = run / "sketch_cond_extracted" / "garment_one"
    piece, notes = folder / "piece_00.obj", folder / "annotations" / "annotations.json"
    if damage == "another":
        shutil.copy(
            run / "garmagejigsaw_output/garment_two/garment.json", run / "garmagejigsaw_output/garment_one"
        )
    elif damage == "missing":
        piece.unlink()
    elif damage == "notes":
        notes.write_text("{}")
    elif damage == "index":
        content = json.loads(notes.read_text())
        content["edge_approx"][0] = [0, 10**6]
        notes.write_text(json.dumps(content))
    else:
        piece.write_text({"nan": "v nan 0 0\n", "far": "v 1e9 0 0\n", "text": "v a b c\n"}[damage] * 500)
    first, second = read_outputs(run)
    assert first.pattern is None and first.error and second.pattern is not None
    assert len(first.error) < 2000


def test_a_folder_of_other_pickles_is_of_no_system(tmp_path):
    (tmp_path / "weights.pkl").write_bytes(b"\x80\x04.")
    with pytest.raises(InputError, match="is of no known system"):
        read_outputs(tmp_path)

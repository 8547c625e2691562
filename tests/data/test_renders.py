from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sample_makers import COARSE, make_quickly, run_here

from swifttailor.body import Body
from swifttailor.data.builder import build_split
from swifttailor.data.reader import SplitReader
from swifttailor.data.renders.files import RenderSettings, SplitRenders
from swifttailor.draping import drape
from swifttailor.errors import InputError
from swifttailor.garment.garment import Garment
from swifttailor.looks import Look, draw_look, plain_look, random_look
from swifttailor.looks.draw import draw_body
from swifttailor.looks.look import VIEWS, View
from swifttailor.looks.plain_look import plain_camera
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.pattern_list import read_patterns
from swifttailor.render import Plain

SMALL = RenderSettings(size=32, random=3)


@pytest.fixture(scope="module")
def dress() -> Garment:
    return drape(draft("fitted-dress"), edge_length=5.0)


@given(st.integers(0, 2**32 - 1), st.sampled_from(VIEWS))
@settings(max_examples=60)
def test_every_look_is_possible_and_repeatable(seed, view):
    look = random_look(np.random.default_rng(seed), view)
    assert look == random_look(np.random.default_rng(seed), view)
    towards = np.cos(np.deg2rad(look.view.azimuth))
    assert (view != "front" or towards > 0.5) and (view != "back" or towards < -0.5)
    assert -12 <= look.view.elevation <= 30 and 0 <= look.view.field_of_view <= 36
    cloth = look.print.colors(np.zeros((1, 2), np.float32))[0]
    for color in (cloth, look.inside, look.body or (0, 0, 0), look.backdrop.top, look.backdrop.bottom):
        assert np.min(color) >= 0 and np.max(color) <= 1.1
    if look.body is not None:
        assert np.abs(np.sqrt(look.body) - np.sqrt(cloth)).max() > 0.1, "cloth and body look alike"


def test_looks_differ():
    looks = [random_look(np.random.default_rng(k), "free") for k in range(200)]
    assert len({type(look.print) for look in looks}) == 4
    alone = np.mean([look.body is None for look in looks])
    assert 0.15 < alone < 0.35 and len({look.view.azimuth for look in looks}) == 200
    assert np.ptp([look.view.azimuth for look in looks]) > 340


def test_the_cloth_is_seen_from_the_front_and_the_back(dress):
    body = Body.default()
    for azimuth in (0.0, 180.0, 70.0):
        look = Look(Plain((0.02, 0.5, 0.03), 0.0), (0.02, 0.5, 0.03), View(azimuth, whole_body=False))
        picture = draw_look(dress, body, look, 64)
        assert picture.shape == (64, 64, 3) and picture.dtype == np.uint8
        green = picture[:, :, 1].astype(int) - picture[:, :, [0, 2]].max(axis=2)
        assert 0.12 < (green > 25).mean() < 0.6
        np.testing.assert_array_equal(picture, draw_look(dress, body, look, 64))


@pytest.mark.parametrize("seed", range(3))
def test_small_pictures_show_the_body_as_large_ones_do(dress, seed, monkeypatch):
    look = random_look(np.random.default_rng(seed), "front")
    look = replace(look, body=(0.6, 0.4, 0.3), view=replace(look.view, whole_body=True))
    small = draw_look(dress, Body.default(), look, 128).astype(int)
    monkeypatch.setattr("swifttailor.looks.draw._COARSE_CM", np.inf)
    assert (np.abs(small - draw_look(dress, Body.default(), look, 128)).max(axis=2) > 16).mean() < 0.01


def test_garments_alone_fill_the_picture(dress):
    body = Body.default()
    worn, alone = (
        draw_look(dress, body, Look(Plain((0.5, 0.02, 0.03)), (0.5, 0.1, 0.1), View(), body=b), 64)
        for b in ((0.3, 0.3, 0.3), None)
    )
    red = [(p[:, :, 0].astype(int) - p[:, :, 2] > 40).mean() for p in (worn, alone)]
    assert red[1] > 1.5 * red[0] > 0.05
    white = (alone >= 250).all(axis=2)
    assert white[0].all() and white[-1].all() and white[:, 0].all() and white[:, -1].all()


def test_the_plain_camera_is_that_of_garmentcodedata():
    """By 4 x 4 matrices: a pose in metres, turned about the x axis and then about the y axis."""

    def turn(axis: int, degrees: float) -> np.ndarray:
        c, s = np.cos(np.deg2rad(degrees)), np.sin(np.deg2rad(degrees))
        i, j = [(1, 2), (2, 0)][axis]
        matrix = np.eye(4)
        matrix[i, i] = matrix[j, j] = c
        matrix[i, j], matrix[j, i] = -s, s
        return matrix

    pose = np.eye(4)
    pose[:3, 3] = 0.0, 0.97, 4.15
    pose = turn(1, 20.0) @ turn(0, -15.0) @ pose
    points = np.random.default_rng(0).uniform((-60, 0, -40), (60, 180, 40), (50, 3))
    for view, matrix in (("front", pose), ("back", turn(1, 180.0) @ pose)):
        seen = np.linalg.inv(matrix) @ np.concatenate([points / 100, np.ones((50, 1))], axis=1).T
        x, y = seen[:2] / -seen[2] / np.tan(np.deg2rad(15.0))
        found = plain_camera(view).project(points, (800, 800))
        np.testing.assert_allclose(found[:, 0], 400 + 400 * x, atol=1e-6)
        np.testing.assert_allclose(found[:, 1], 400 - 400 * y, atol=1e-6)
        np.testing.assert_allclose(found[:, 2], -100 * seen[2], atol=1e-6)


def test_the_plain_look_shows_panels_in_tones_on_a_dark_body(dress):
    picture = draw_look(dress, Body.default(), plain_look(), 96)
    assert (picture[0] == 255).all() and (picture[:, :2] == 255).all()
    dark = (picture < 70).all(axis=2).mean()
    assert 0.03 < dark < 0.2, "head, arms and legs"
    assert not np.array_equal(picture, draw_look(dress, Body.default(), plain_look("back"), 96))


# In files


@pytest.fixture
def split(patterns_file, tmp_path) -> Path:
    source = patterns_file("a", "bad-b", "c", "d", "e", "f")
    build_split(read_patterns(source), tmp_path / "set", "train", COARSE, runner=run_here, make=make_quickly)
    return tmp_path / "set" / "train"


def test_renders_of_a_split(split):
    reader = SplitReader(split)
    with pytest.raises(InputError, match=r"has no renders\. Draw them: swifttailor data render"):
        SplitRenders(reader)
    renders = SplitRenders(reader, SMALL)
    assert list(renders.draw(workers=2)) == [(1, 2), (2, 2)] and list(renders.draw()) == []
    assert list(renders.verify()) == []
    again = SplitRenders(SplitReader(split))
    assert again.settings == SMALL and len(again) == 5
    for k in range(5):
        names = [r.name for r in again[k]]
        assert names == ["plain-front", "plain-back", "front", "back", "free-1"]
        for render in again[k]:
            assert render.pixels().shape == (32, 32, 3) and len(render.webp) > 100
    pictures = {r.webp for k in range(5) for r in again[k] if r.name != "plain-front"}
    assert len(pictures) == 20
    with pytest.raises(InputError, match="Other renders were drawn"):
        SplitRenders(reader, RenderSettings(size=64))


def test_renders_do_not_depend_on_workers_or_neighbours(split, tmp_path, patterns_file):
    first = SplitRenders(SplitReader(split), SMALL)
    list(first.draw(workers=2))
    source = patterns_file("f", name="one.jsonl")
    build_split(
        read_patterns(source), tmp_path / "other", "train", COARSE, runner=run_here, make=make_quickly
    )
    second = SplitRenders(SplitReader(tmp_path / "other" / "train"), SMALL)
    list(second.draw())
    assert [r.webp for r in first[4]] == [r.webp for r in second[0]]


def test_faults_of_renders_name_the_file(split):
    renders = SplitRenders(SplitReader(split), SMALL)
    steps = renders.draw()
    next(steps)
    steps.close()  # stopped after the first shard
    assert len(renders[0]) == 5
    with pytest.raises(InputError, match=r"There is no file .*renders-.*swifttailor data render"):
        renders[4]
    faults = list(renders.verify())
    assert len(faults) == 2 and all("draw the renders to the end" in f for f in faults)
    assert list(renders.draw()) == [(2, 2)] and list(renders.verify()) == []
    path = next((split / "renders").glob("*.safetensors"))
    path.write_bytes(path.read_bytes()[:-3])
    (fault,) = renders.verify()
    assert path.name in fault and "damaged" in fault
    (split / "renders" / "renders.json").write_text("{}")
    with pytest.raises(InputError, match=r"renders\.json' is damaged"):
        SplitRenders(SplitReader(split))


@pytest.mark.parametrize(
    "wrong", [{"size": 8}, {"random": 65}, {"quality": 0}, {"random": 0, "plain": False}]
)
def test_settings_that_cannot_be(wrong):
    with pytest.raises(InputError):
        RenderSettings(**wrong)


def test_names_of_renders():
    assert RenderSettings(random=1, plain=False).names() == ["front"]
    assert RenderSettings(random=5).names()[2:] == ["front", "back", "free-1", "free-2", "free-3"]
    assert RenderSettings(random=0).names() == ["plain-front", "plain-back"]


def test_a_body_alone_stands_in_the_picture():
    look = Look(Plain((0.02, 0.5, 0.03), 0.0), (0.02, 0.5, 0.03), View(), body=(0.5, 0.1, 0.1))
    picture = draw_body(Body.default(), look, 64).astype(int)
    red = picture[..., 0] > picture[..., 1] + 20
    rows, columns = np.flatnonzero(red.any(axis=1)), np.flatnonzero(red.any(axis=0))
    assert 0.75 < (rows[-1] - rows[0] + 1) / 64 < 0.95, "from head to foot"
    assert rows[0] > 0 and rows[-1] < 63 and columns[0] > 0 and columns[-1] < 63
    assert not (picture[..., 1] > picture[..., 0] + 20).any(), "no cloth"
    nobody = draw_body(Body.default(), Look(look.print, look.inside, View(), body=None), 64)
    assert nobody.std() > 10

"""What is usual for a PatternMaker, measured with the renders of a data set; its network is untrained."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sewer_data import make_data

from swifttailor.data.reader import SplitReader
from swifttailor.data.renders.files import RenderSettings, SplitRenders
from swifttailor.errors import InputError
from swifttailor.pattern_maker.maker import PatternMaker
from swifttailor.pattern_maker.network.model_file import add_calibration, load_model
from swifttailor.pattern_maker.tokens.grammar import Grammar, Limits
from swifttailor.training.maker_calibration import (
    TILES,
    _some,
    calibrate_by_renders,
    exchange_tiles,
    flowing_colours,
)

TINY = Path(__file__).parents[1] / "pattern_maker" / "tiny_maker.zip"
SETTINGS = RenderSettings(size=32, random=3)


@pytest.fixture(scope="module")
def rendered(tmp_path_factory):
    folder = make_data(tmp_path_factory.mktemp("rendered"))
    for split in ("train", "validation"):
        for _ in SplitRenders(SplitReader(folder / split), SETTINGS).draw():
            pass
    return folder


@pytest.fixture(scope="module")
def maker():
    return PatternMaker(replace(load_model(TINY), grammar=Grammar(Limits(tokens=60))))


def test_what_is_usual_is_measured_and_kept(maker, rendered, tmp_path):
    lines: list[str] = []
    made = calibrate_by_renders(maker, rendered, strangers=2, report=lines.append)
    assert made.pictures == 10, "five pictures of each of two garments"
    assert set(made.told) == set(made.doubted) == {"bare bodies", "exchanged tiles", "flowing colours"}
    assert all(0 <= area <= 1 for kind in made.told.values() for area in kind.values())
    assert lines == ["looking at pictures: 46 of 46"]
    again = calibrate_by_renders(maker, rendered, strangers=2)
    assert again.to_json() == made.to_json()
    path = tmp_path / "model.zip"
    path.write_bytes(TINY.read_bytes())
    add_calibration(path, made)
    kept = load_model(path).calibration
    assert kept is not None and kept.usual == made.usual


def test_a_data_set_that_does_not_do_is_refused(maker, rendered, tmp_path):
    with pytest.raises(InputError, match="no split 'validation'"):
        calibrate_by_renders(maker, rendered / "train")
    bare = make_data(tmp_path / "bare")
    with pytest.raises(InputError, match="has no renders"):
        calibrate_by_renders(maker, bare)
    with pytest.raises(InputError, match="at least 8"):
        calibrate_by_renders(maker, rendered, known=5, strangers=4)


def test_pictures_are_taken_of_as_many_garments_as_possible(rendered):
    renders = SplitRenders(SplitReader(rendered / "train"))
    whole = {p.pixels().tobytes() for k in range(6) for p in renders[k]}

    def some(most, seed=0):
        return [p.tobytes() for p in _some(renders, most, np.random.default_rng(seed))]

    assert set(some(1000)) == whole and len(some(1000)) == 30
    owner = {p.pixels().tobytes(): k for k in range(6) for p in renders[k]}
    assert {owner[p] for p in some(6)} == set(range(6))
    assert some(7) == some(7) and some(7) != some(7, seed=1)


@given(st.integers(0, 1000), st.integers(4, 40), st.integers(4, 40))
def test_no_tile_stays_and_none_is_lost(seed, height, width):
    height, width = height // TILES * TILES, width // TILES * TILES
    tile = np.arange(TILES * TILES, dtype=np.uint8).reshape(TILES, TILES)
    picture = np.repeat(np.repeat(tile, height // TILES, 0), width // TILES, 1)[..., None].repeat(3, axis=2)
    moved = exchange_tiles(picture, np.random.default_rng(seed))
    assert moved.shape == picture.shape and (moved != picture).all()
    assert np.array_equal(np.bincount(moved.ravel()), np.bincount(picture.ravel()))


@given(st.integers(0, 1000), st.integers(16, 70))
def test_colours_flow(seed, size):
    picture = flowing_colours(size, np.random.default_rng(seed))
    assert picture.shape == (size, size, 3) and picture.dtype == np.uint8 and picture.std() > 10


def test_the_export_adds_it_or_says_that_it_did_not(maker, rendered, tmp_path, capsys, monkeypatch):
    from swifttailor.cli.train_export import _calibrate
    from swifttailor.training import maker_calibration

    path = tmp_path / "model.zip"
    path.write_bytes(TINY.read_bytes())
    assert "was not measured" in _calibrate(path, None)
    assert path.read_bytes() == TINY.read_bytes()
    monkeypatch.setattr(PatternMaker, "load", staticmethod(lambda path: maker))
    monkeypatch.setattr(maker_calibration, "calibrate_by_renders", partial(calibrate_by_renders, strangers=2))
    said = _calibrate(path, rendered)
    assert "it doubts 2% of 10 pictures of garments" in said and "of bare bodies" in said
    assert load_model(path).calibration is not None
    assert "looking at pictures" in capsys.readouterr().out
    with pytest.raises(InputError, match="holds no data set"):
        _calibrate(path, tmp_path)

"""How sure a network is of a picture: the measures, what is usual, and the model file that keeps it."""

from __future__ import annotations

import json
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from swifttailor.errors import InputError
from swifttailor.pattern_maker.asking.calibration import calibrate, roc_area
from swifttailor.pattern_maker.asking.confidence import (
    DOUBT,
    MEASURES,
    Calibration,
    PictureSpace,
    rank,
)
from swifttailor.pattern_maker.maker import PatternMaker, Request
from swifttailor.pattern_maker.network.model_file import add_calibration, load_model
from swifttailor.pattern_maker.tokens.grammar import Grammar, Limits

TINY = Path(__file__).with_name("tiny_maker.zip")


@pytest.fixture(scope="module")
def maker():
    """Held to short patterns: left to itself an untrained network writes a thousand tokens."""
    model = load_model(TINY)
    return PatternMaker(replace(model, grammar=Grammar(Limits(tokens=60))))


def cloths(count: int, seed: int) -> list[np.ndarray]:
    """Pictures of one kind: a rectangle of some colour before something light."""
    chance = np.random.default_rng(seed)
    made = []
    for _ in range(count):
        picture = np.full((32, 32, 3), chance.integers(220, 255), np.uint8)
        low, high = chance.integers(3, 10, 2), chance.integers(20, 29, 2)
        picture[low[0] : high[0], low[1] : high[1]] = chance.integers(0, 200, 3)
        made.append(picture)
    return made


def noises(count: int) -> list[np.ndarray]:
    return list(np.random.default_rng(9).integers(0, 255, (count, 32, 32, 3), np.uint8))


@pytest.fixture(scope="module")
def calibration(maker):
    return calibrate(maker, cloths(80, 0), cloths(12, 1), {"noise": noises(8)})


def dense(space: PictureSpace) -> np.ndarray:
    """The covariance that the space stands for, written out."""
    inside = space.directions.T @ np.diag(space.variances) @ space.directions
    outside = np.eye(len(space.mean)) - space.directions.T @ space.directions
    return inside + space.rest * outside


@given(seed=st.integers(0, 1000), size=st.integers(2, 12), count=st.integers(8, 60))
@settings(max_examples=20, deadline=None)
def test_familiarity_is_the_logarithm_of_a_normal_density(seed, size, count):
    from scipy.stats import multivariate_normal

    chance = np.random.default_rng(seed)
    looks = chance.normal(size=(count, size)) * chance.uniform(0.1, 3, size) + chance.normal(size=size)
    space = PictureSpace.fit(looks)
    asked = chance.normal(size=(5, size)) * 2
    expected = multivariate_normal(space.mean, dense(space)).logpdf(asked)
    assert np.allclose(space.familiarity(asked), expected, rtol=1e-8, atol=1e-8)
    total = np.trace(np.atleast_2d(np.cov(looks.T)))
    assert np.trace(dense(space)) == pytest.approx(total, rel=2e-3), "no variance is lost or made up"


def test_what_never_varied_is_no_division_by_zero():
    space = PictureSpace.fit(np.tile([1.0, 2.0, 3.0], (20, 1)))
    values = space.familiarity(np.array([[1.0, 2, 3], [9.0, 2, 3]]))
    assert np.isfinite(values).all() and values[0] > values[1]
    with pytest.raises(InputError, match="at least 8"):
        PictureSpace.fit(np.zeros((7, 3)))


@given(
    arrays.arrays(np.float64, st.integers(1, 30), elements=st.floats(-5, 5).map(lambda x: round(x, 1))),
    arrays.arrays(np.float64, st.integers(1, 30), elements=st.floats(-5, 5).map(lambda x: round(x, 1))),
)
def test_the_area_is_a_share_of_pairs(higher, lower):
    pairs = (higher[:, None] > lower).mean() + 0.5 * (higher[:, None] == lower).mean()
    assert roc_area(higher, lower) == pytest.approx(pairs)


@given(st.lists(st.floats(-100, 100), min_size=1, max_size=50), st.floats(-200, 200))
def test_ranks_lie_between_0_and_1_and_rise(values, asked):
    usual = tuple(sorted(values))
    assert 0 <= rank(asked, usual) <= rank(asked + 1, usual) <= 1
    assert rank(usual[0] - 1, usual) == 0 and rank(usual[-1] + 1, usual) == 1


def test_a_picture_like_the_known_ones_is_trusted_and_noise_is_not(calibration, maker, unmended):
    assert calibration.pictures == 12
    assert calibration.told["noise"][calibration.measure] == max(calibration.told["noise"].values())
    assert calibration.told["noise"]["familiarity"] > 0.95
    made = maker.generate_all([Request(image=p) for p in (*cloths(3, 7), noises(1)[0])], temperature=0.5)
    judged = [calibration.confidence(one.look, one.certainty) for one in made]
    for one, found in zip(made, judged, strict=True):
        assert found.certainty == one.certainty <= 0
        assert found.familiarity == pytest.approx(calibration.space.familiarity(one.look[None])[0])
        assert found.doubtful == (found.value < DOUBT)
    space_only = Calibration(**vars(calibration) | {"measure": "familiarity"})
    assert space_only.confidence(made[3].look, 0.0).doubtful
    assert space_only.confidence(made[3].look, 0.0).value == 0.0
    assert max(space_only.confidence(one.look, 0.0).value for one in made[:3]) > 0.1


def test_of_the_validation_pictures_as_many_are_doubted_as_should_be(calibration, maker, unmended):
    made = maker.generate_all([Request(image=p) for p in cloths(12, 1)], temperature=0.5)
    values = [calibration.confidence(one.look, one.certainty).value for one in made]
    assert np.sort(values) == pytest.approx(np.linspace(0, 1, 12), abs=0.02)


def test_certainty_is_what_the_likeliest_tokens_have(maker, unmended):
    likeliest = maker.generate("a skirt", temperature=0.0)
    assert likeliest.certainty * likeliest.tokens == pytest.approx(likeliest.log_likelihood, rel=1e-9)
    drawn = maker.generate("a skirt", temperature=2.0, seed=4)
    assert drawn.certainty * drawn.tokens > drawn.log_likelihood
    assert likeliest.look is None and likeliest.confidence is None


def test_the_model_file_keeps_it(calibration, tmp_path, unmended):
    path = tmp_path / "model.zip"
    path.write_bytes(TINY.read_bytes())
    add_calibration(path, calibration)
    once = path.read_bytes()
    assert add_calibration(path, calibration).read_bytes() == once, "the same content, the same bytes"
    kept = load_model(path).calibration
    assert (
        kept.told == calibration.told
        and kept.usual == calibration.usual
        and kept.doubted == calibration.doubted
    )
    made = PatternMaker.load(path).generate(image=cloths(1, 5)[0], temperature=0.5)
    expected = calibration.confidence(made.look, made.certainty)
    assert made.confidence.value == pytest.approx(expected.value, abs=1e-3)
    assert made.confidence.measure in MEASURES and set(made.confidence.to_json()) >= {"value", "doubtful"}
    assert PatternMaker.load(TINY).generate(image=cloths(1, 5)[0], temperature=0.5).confidence is None


def changed(calibration, change) -> str:
    content = json.loads(calibration.to_json())
    change(content)
    return json.dumps(content)


@pytest.mark.parametrize(
    "change",
    [
        lambda c: c.clear(),
        lambda c: c.update(format="swifttailor confidence 0"),
        lambda c: c.pop("space"),
        lambda c: c["space"].update(rest=0),
        lambda c: c["space"]["mean"].pop(),
        lambda c: c["space"]["variances"].__setitem__(0, -1.0),
        lambda c: c["space"].update(mean="far"),
        lambda c: c.update(measure="guess"),
        lambda c: c["usual"].pop("certainty"),
        lambda c: c["usual"].update(certainty=[]),
        lambda c: c.update(more=1),
    ],
)
def test_other_files_are_refused(change, calibration):
    with pytest.raises(InputError, match="does not say what is usual"):
        Calibration.from_json(changed(calibration, change), "model.zip")
    for text in ("", "[]", "1", "\xff"):
        with pytest.raises(InputError):
            Calibration.from_json(text, "model.zip")


def test_one_of_another_network_is_refused(calibration, tmp_path):
    path = tmp_path / "model.zip"
    path.write_bytes(TINY.read_bytes())
    narrow = PictureSpace(np.zeros(3), np.eye(3)[:1], np.ones(1), 1.0)
    add_calibration(path, Calibration(**vars(calibration) | {"space": narrow}))
    with pytest.raises(InputError, match="what is usual for pictures should be 16"):
        load_model(path)


def test_a_model_file_with_something_else_in_it_is_still_refused(tmp_path):
    path = tmp_path / "model.zip"
    path.write_bytes(TINY.read_bytes())
    with zipfile.ZipFile(path, "a") as archive:
        archive.writestr("more.txt", "more")
    with pytest.raises(InputError, match="is not a PatternMaker"):
        load_model(path)


@pytest.mark.parametrize("count", [0, 7])
def test_too_few_pictures_are_no_measure(count, maker):
    with pytest.raises(InputError, match="at least 8"):
        calibrate(maker, cloths(count, 0), cloths(8, 1), {})
    with pytest.raises(InputError, match="at least 8 are needed"):
        calibrate(maker, cloths(8, 0), cloths(count, 1), {})

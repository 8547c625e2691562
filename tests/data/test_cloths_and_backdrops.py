"""Cloths, backdrops and cameras of pictures that leave the studio, and where garments are seen."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.body import Body
from swifttailor.data.renders.backdrops import Scenery, backdrop
from swifttailor.data.renders.camera_effects import CameraEffects, random_effects
from swifttailor.data.renders.cloths import random_cloth
from swifttailor.data.renders.foreground import random_before
from swifttailor.draping import drape
from swifttailor.garment.garment import Garment
from swifttailor.looks import Look, draw_look, draw_seen, random_look
from swifttailor.looks.draw import ClothMesh
from swifttailor.looks.look import View
from swifttailor.pattern.drafts import draft
from swifttailor.render import Plain

SEEDS = st.integers(0, 2**32 - 1)


@pytest.fixture(scope="module")
def dress() -> Garment:
    return drape(draft("fitted-dress"), edge_length=5.0)


@given(SEEDS)
@settings(max_examples=60, deadline=None)
def test_every_cloth_is_possible_and_repeatable(seed):
    drawn = random_cloth(np.random.default_rng(seed))
    assert drawn == random_cloth(np.random.default_rng(seed))
    points = np.random.default_rng(seed).uniform(-50, 50, (50, 2))
    rest = np.random.default_rng(seed).uniform((-30, 0, -20), (30, 150, 20), (50, 3))
    colors = drawn.cloth.colors(points, rest)
    assert np.isfinite(colors).all() and colors.min() >= -0.01 and colors.max() < 1.5


def test_cloths_are_of_many_kinds():
    drawn = [random_cloth(np.random.default_rng(k)) for k in range(400)]
    assert len({type(d.cloth.base) for d in drawn}) == 6
    weaves = [d.cloth.weave.kind for d in drawn if d.cloth.weave is not None]
    assert len(set(weaves)) >= 7 and 0.2 < len(weaves) / 400 < 0.5
    for part in ("wear", "graphic", "block", "fade"):
        assert 0.01 < np.mean([getattr(d.cloth, part) is not None for d in drawn]) < 0.25, part
    assert 0.15 < np.mean([bool(d.cloth.marks) for d in drawn]) < 0.35


def test_the_same_picture_with_and_without_masks(dress):
    body = Body.default()
    for seed in range(4):
        look = random_look(np.random.default_rng(seed), "front")
        seen = draw_seen(ClothMesh.of(dress), body, look, 64)
        np.testing.assert_array_equal(seen.pixels, draw_look(dress, body, look, 64))
        assert seen.shares.shape == (64, 64, 1 if look.body is None else 2)


def test_the_mask_is_where_the_cloth_is(dress):
    body = Body.default()
    look = Look(
        Plain((0.02, 0.5, 0.03), 0.0), (0.02, 0.5, 0.03), View(whole_body=False), body=(0.5, 0.3, 0.2)
    )
    drawn = draw_seen(ClothMesh.of(dress), body, look, 96)
    green = drawn.pixels[:, :, 1].astype(int) - drawn.pixels[:, :, [0, 2]].max(axis=2) > 20
    cloth = drawn.shares[:, :, 1]
    assert green[cloth == 1.0].mean() > 0.98 and green[cloth == 0.0].mean() < 0.001


def test_backdrops_are_many_and_show_their_part():
    light = Scenery(3).light(backdrop(3).shape[0])
    np.testing.assert_allclose(light, backdrop(3), atol=1e-5)
    np.testing.assert_allclose(Scenery(3, flip=True).light(160), light[:, ::-1], atol=1e-5)
    corner = Scenery(3, corner=(1.0, 0.0), part=0.5).light(80)
    np.testing.assert_allclose(corner[-1, 0], backdrop(3)[-1, 0], atol=1e-5)
    np.testing.assert_allclose(
        Scenery(3, tint=(0.5, 1, 1)).light(40)[..., 0] * 2, Scenery(3).light(40)[..., 0], rtol=1e-4
    )
    bank = [backdrop(k) for k in range(48)]
    assert all(p.shape == (160, 160, 3) and np.isfinite(p).all() and p.min() >= 0 for p in bank)
    means = np.array([p.mean(axis=(0, 1)) for p in bank])
    assert means.std(axis=0).min() > 0.1


@given(SEEDS)
@settings(max_examples=40, deadline=None)
def test_things_before_the_figure_hide_what_they_cover(seed):
    for thing in random_before(np.random.default_rng(seed)):
        picture, cover = np.full((48, 48, 3), np.float32(0.5)), np.ones((48, 48), np.float32)
        thing.put(picture, cover)
        assert cover.min() >= 0 and cover.max() == 1 and np.isfinite(picture).all()
        assert (picture[cover == 1] == 0.5).all()


@given(SEEDS)
@settings(max_examples=30, deadline=None)
def test_cameras_keep_the_picture_recognisable(seed):
    y, x = np.mgrid[0:64, 0:64]
    picture = np.stack([x * 4, y * 4, 255 - 2 * (x + y)], axis=2).astype(np.uint8)
    effects = random_effects(np.random.default_rng(seed))
    found = effects.apply(picture)
    assert found.shape == picture.shape and found.dtype == np.uint8
    np.testing.assert_array_equal(found, effects.apply(picture))
    assert np.corrcoef(found.ravel(), picture.ravel())[0, 1] > 0.9
    np.testing.assert_array_equal(CameraEffects().apply(picture), picture)


def test_exposure_never_turns_light_into_dark():
    ramp = np.repeat(np.arange(256, dtype=np.uint8)[None, :, None], 3, axis=2)
    for exposure in (-1.0, -0.3, 0.3, 1.0):
        found = CameraEffects(exposure=exposure).apply(ramp).astype(int)[0, :, 0]
        assert (np.diff(found) >= 0).all() and np.sign(found[100] - 100) == np.sign(exposure)

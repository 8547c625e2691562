"""What a network that has seen nothing but photographs tells of somebody, and where it looks."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from swifttailor.errors import InputError
from swifttailor.picture_reader.body_joints import ANKLES, HIPS, KNEES, SHOULDERS, BodyJoints
from swifttailor.picture_reader.labels import statement_labels
from swifttailor.picture_reader.person_finder import PersonFinder
from swifttailor.picture_reader.worn_heads import COLLARED, HEADS, SHIPPED, WornHeads, views_of

PHOTOGRAPH = Path(__file__).parents[2] / "docs/images/woman-with-dog.jpg"
"""A hooded jumper, sleeves to the wrists, and leggings."""


@pytest.fixture(scope="module")
def heads():
    return WornHeads.load()


def somebody(turned=1.0, knees=0.9):
    places, seen = np.zeros((39, 2)), np.full(39, 0.9)
    places[list(SHOULDERS)] = (100 + 30 * turned, 100), (100 - 30 * turned, 100)
    places[list(HIPS)] = (110, 200), (90, 200)
    places[list(KNEES)], places[list(ANKLES)] = (100, 280), (100, 360)
    seen[list(KNEES)] = knees
    return BodyJoints(places, seen)


def test_it_looks_at_necks_torsos_and_legs():
    pixels = np.zeros((400, 200, 3), np.uint8)
    alone = np.full_like(pixels, 255)
    views = views_of(pixels, (alone, (0, 0, 400)), somebody())
    assert views["whole"] == (alone, (0, 0, 400))
    assert views["neck"][0] is pixels and all(views[name][0] is alone for name in ("torso", "legs"))
    squares = {name: square for name, (_, square) in views.items()}
    assert squares["neck"] == (55, 63, 90) and squares["torso"] == (15, 65, 170)
    left, top, side = squares["legs"]
    assert side == 220 and (left + side / 2, top + side / 2) == (100, 280)
    aside = views_of(pixels, (alone, (0, 0, 400)), somebody(turned=0.0))
    assert aside["neck"][1][2] == 75, "as high as seen from in front"


def test_legs_that_are_not_seen_are_not_looked_at(heads):
    pixels = np.random.default_rng(0).integers(0, 256, (400, 200, 3), np.uint8)
    views = views_of(pixels, (pixels, (0, 0, 400)), somebody(knees=0.2))
    assert set(views) == {"whole", "torso", "neck"}
    assert set(heads.told(views)) == {"collar", "sleeves"}


def test_a_photograph_is_told_by_shares(heads):
    pixels = np.asarray(Image.open(PHOTOGRAPH).convert("RGB"))
    person = PersonFinder.load().find(pixels)
    views = views_of(pixels, person.cut_out(pixels), person.joints)
    told = heads.told(views)
    assert set(told) == set(HEADS)
    for shares in told.values():
        assert np.exp(list(shares.values())).sum() == pytest.approx(1)
    likeliest = {claim: max(shares, key=shares.__getitem__) for claim, shares in told.items()}
    assert likeliest["sleeves"] == "long" and likeliest["kind"] == "trousers"
    mirrored = {name: (one[:, ::-1], square) for name, (one, square) in views.items() if name == "whole"}
    assert heads.told(mirrored) == {}


def test_words_are_those_that_readers_know(heads):
    known = {claim: {word for name, word in statement_labels() if name == claim} for claim in HEADS}
    assert set(heads.words["collar"]) == {"none", COLLARED}
    for claim in ("sleeves", "kind", "leg_hem"):
        assert set(heads.words[claim]) <= known[claim]


def test_a_damaged_file_is_refused(tmp_path):
    damaged = tmp_path / "heads.zip"
    damaged.write_bytes(SHIPPED.read_bytes()[:-5000])
    with pytest.raises(InputError, match=r"heads\.zip"):
        WornHeads.load(damaged)
    with pytest.raises(InputError, match=r"not a network for photographs"):
        WornHeads.load(SHIPPED.with_name("person_finder.zip"))

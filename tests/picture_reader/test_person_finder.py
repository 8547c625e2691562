"""People are found in photographs, and cut out of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from swifttailor.errors import InputError
from swifttailor.picture_reader.leg_joints import LegJoints
from swifttailor.picture_reader.person_finder import (
    SHIPPED,
    PersonFinder,
    before_white,
    largest_piece,
    square_around,
)

PHOTOGRAPH = Path(__file__).parents[2] / "docs" / "images" / "woman-with-dog.jpg"
CLOTHES, GRASS, DOG = (560, 130), (300, 20), (260, 340)
"""A row and a column of the leggings, of what is behind, and of the dog before her."""


@pytest.fixture(scope="module")
def finder():
    return PersonFinder.load()


@pytest.fixture(scope="module")
def photograph():
    return np.asarray(Image.open(PHOTOGRAPH).convert("RGB"))


def test_somebody_is_found_and_cut_out(finder, photograph):
    person = finder.find(photograph)
    mask = person.mask
    assert (
        0.5 < person.certainty <= 1
        and mask.shape == photograph.shape[:2]
        and 0.25 < (mask > 0.5).mean() < 0.4
    )
    assert mask[CLOTHES] > 0.9 and mask[GRASS] < 0.1 and mask[DOG] < 0.1
    cut, square = person.cut_out(photograph)
    assert (cut[CLOTHES] == photograph[CLOTHES]).all() and (cut[GRASS] == 255).all()
    left, top, side = square
    rows, columns = np.nonzero(mask > 0.5)
    assert (
        top <= rows.min()
        and rows.max() < top + side
        and left <= columns.min()
        and columns.max() < left + side
    )
    assert side < 1.2 * (rows.max() - rows.min())


def test_joints_of_legs_are_where_legs_are(finder, photograph):
    joints, high = LegJoints.of(finder.find(photograph).joints), len(photograph)
    assert joints.hips == pytest.approx(0.49 * high, abs=0.04 * high)
    assert joints.knees == pytest.approx(0.69 * high, abs=0.04 * high)
    assert joints.ankles == pytest.approx(0.88 * high, abs=0.05 * high)


def test_somebody_small_is_found_too(finder, photograph):
    high, across = 260, 123
    small = np.asarray(Image.fromarray(photograph).resize((across, high)))
    street = np.full((1200, 1800, 3), 90, np.uint8)
    street[700 : 700 + high, 300 : 300 + across] = small
    far, near = finder.find(street, small=False), finder.find(street)
    assert near.certainty > 0.5 and (far is None or far.certainty < near.certainty)
    mask = near.mask > 0.5
    assert mask[690 : 710 + high, 290 : 310 + across].sum() == mask.sum()
    assert 0.2 < mask.sum() / (high * across) < 0.7


@pytest.mark.parametrize("size", [(300, 200), (300, 1), (1, 1), (64, 64)])
@pytest.mark.parametrize("what", ["noise", 0, 255])
def test_nobody_is_found_in_nothing(finder, size, what):
    pixels = np.random.default_rng(0).integers(0, 256, (*size, 3), dtype=np.uint8)
    if what != "noise":
        pixels[:] = what
    assert finder.find(pixels) is None


@pytest.mark.parametrize("cut_off", [False, True])
def test_the_square_leaves_space_but_not_below_somebody_who_is_cut_off(cut_off):
    mask = np.zeros((200, 150), np.float32)
    mask[100 : 200 if cut_off else 190, 60:80] = 1
    left, top, side = square_around(mask)
    assert left + side / 2 == pytest.approx(70, abs=1)
    assert 92 < top < 96 and top + side == pytest.approx(200 if cut_off else 195, abs=1)


def test_only_small_pieces_are_left_away():
    mask = np.zeros((40, 40), np.float32)
    mask[5:25, 5:25], mask[30:36, 30:36], mask[30:32, 5:7], mask[2, 2] = 0.9, 0.8, 1.0, 0.4
    found = largest_piece(mask)
    assert (found[30:32, 5:7] == 0).all()
    found[30:32, 5:7] = 1.0
    assert (found == mask).all()
    assert largest_piece(np.full((4, 4), 0.4, np.float32)) is None


def test_what_is_surely_shown_stays_and_the_rest_is_white():
    pixels = np.full((1, 3, 3), 100, np.uint8)
    shown = before_white(pixels, np.array([[0.95, 0.5, 0.05]], np.float32))
    assert shown[0, :, 0].tolist() == [100, 178, 255]


def test_a_file_of_another_kind_is_refused(tmp_path):
    from swifttailor.picture_reader.reader import SHIPPED as OF_A_READER

    with pytest.raises(InputError, match="person finder"):
        PersonFinder.load(OF_A_READER)
    damaged = tmp_path / "person_finder.zip"
    data = bytearray(SHIPPED.read_bytes())
    data[len(data) // 2] ^= 1
    damaged.write_bytes(data)
    with pytest.raises(InputError, match="damaged"):
        PersonFinder.load(damaged)

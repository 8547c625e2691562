"""Who is cut out of which photographs, and read so."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from swifttailor.picture_reader.body_joints import PLACES, BodyJoints
from swifttailor.picture_reader.person_finder import Person
from swifttailor.picture_reader.photographed import (
    MOST_DESIGNED,
    SURELY_SOMEBODY,
    as_photograph,
    says_no_design,
    surely_somebody,
)
from swifttailor.picture_reader.reading import PartReading, PictureReading
from swifttailor.picture_reader.seen_design import SeenDesign
from swifttailor.picture_reader.worn_signs import WornSigns
from swifttailor.programs.read_parameter import ReadParameter
from swifttailor.render import Camera

WHOLE = -5, 0, 90
UNSEEN = BodyJoints(np.zeros((PLACES, 2)), np.zeros(PLACES))
CAMERA = Camera((0.0, 100.0, 0.0), 180.0)


def worn(certainty):
    """A top of whose design so much is read."""
    shares = np.full(8, (1 - certainty) / 7)
    shares[3] = certainty
    design = SeenDesign((ReadParameter("a", tuple("abcdefgh")),), (shares,))
    return (PartReading("upper", 0.9, (), (), (), np.full((90, 80), 0.8, np.float32), design=design),)


VAGUE, SURE = worn(MOST_DESIGNED - 0.01), worn(MOST_DESIGNED + 0.01)
ALL, CUT = (PictureReading(VAGUE, CAMERA, (0, 0, side, side)) for side in (90, 45))


def below(square):
    """The row below it."""
    return square[1] + square[2]


class Finder:
    """Finds somebody who is so sure; nobody where that is None."""

    def __init__(self, certainty):
        self.certainty, self.looked = certainty, []

    def __call__(self):
        return self

    def find(self, pixels, *, small=True):
        self.looked.append(small)
        mask = np.zeros(pixels.shape[:2], np.float32)
        mask[20:60, 30:50] = 1
        return None if self.certainty is None else Person(self.certainty, mask, (40.0, 42.0), 20.0, UNSEEN)


@pytest.fixture
def street():
    return np.random.default_rng(0).integers(0, 256, (90, 80, 3), np.uint8)


@pytest.mark.parametrize("sure", [0.4, 0.9, None])
@pytest.mark.parametrize("figures", ["none", "one", "several"])
def test_people_are_cut_out_of_streets(street, figures, sure):
    shown = []

    def read(*views, chest, legs, signs):
        shown.extend(views)
        assert signs == WornSigns()
        (of_chest, chest_square), ((legs_alone, legs_square), (with_rest, same)) = chest, legs
        assert of_chest is with_rest is views[0][0] and same == legs_square
        assert below(chest_square) == 38 and chest_square[1] <= 20
        assert 30 < legs_square[1] < 36 and below(legs_square) >= 60
        assert (legs_alone[:35] == 255).all() and (legs_alone[35:60, 30:50] == street[35:60, 30:50]).all()
        return replace(CUT, figures="none")

    found = as_photograph((street, WHOLE), replace(ALL, figures=figures), Finder(sure), read)
    if sure is None or (figures == "none" and sure < SURELY_SOMEBODY):
        assert found is None and not shown
        return
    ((cut, (left, top, side)),) = shown
    assert (cut[20:60, 30:50] == street[20:60, 30:50]).all() and (cut[:15] == 255).all()
    assert top < 20 and 60 < top + side and left < 30 and 50 < left + side
    assert found.box == CUT.box and found.is_photograph
    assert found.figures == ("several" if figures == "several" else "one")
    (part,) = found.parts
    assert np.allclose(part.mask[20:60, 30:50], 0.8) and part.mask.sum() == pytest.approx(0.8 * 40 * 20)


def test_before_a_plain_ground_people_are_read_as_they_are_too(street):
    street[:, :25] = street[:15] = 255
    shown = []

    def read(*views, chest, signs, legs=()):
        assert chest[0] is views[0][0] and below(chest[1]) == 38 and bool(legs) == (len(views) == 1)
        shown.append(views)
        return CUT

    found = as_photograph((street, WHOLE), ALL, Finder(0.4), read)
    assert found.box == CUT.box and found.is_photograph
    (((cut, _), (pixels, square)),) = shown
    assert pixels is street and square == WHOLE and (cut[:15] == 255).all()
    found = as_photograph((street, WHOLE), ALL, Finder(None), read)
    assert found.box == ALL.box and found.is_photograph and len(shown) == 1, "legs alone are nobody"
    assert as_photograph((street, WHOLE), replace(ALL, figures="several"), Finder(0.4), read)
    assert len(shown[1]) == 1


def test_nobody_is_cut_out_without_a_finder(street):
    assert as_photograph((street, WHOLE), ALL, None, lambda *_, **__: CUT) is None
    assert not surely_somebody(street, None)


@pytest.mark.parametrize(("certainty", "sure"), [(None, False), (0.7, False), (0.85, True)])
def test_somebody_sure_is_large(street, certainty, sure):
    finder = Finder(certainty)
    assert surely_somebody(street, finder) == sure and finder.looked == [False]


@pytest.mark.parametrize("above", [False, True])
def test_a_photograph_has_no_design(above):
    part = (SURE if above else VAGUE)[0]
    assert part.design.certainty == pytest.approx(MOST_DESIGNED, abs=0.011)
    assert says_no_design(replace(ALL, parts=(part,))) != above
    assert not says_no_design(replace(ALL, parts=())), "where nothing is worn nothing is told"
    assert not says_no_design(replace(ALL, parts=(replace(part, design=None),)))


def test_drawn_people_are_never_cut_out(street):
    finder = Finder(0.99)
    assert as_photograph((street, WHOLE), replace(ALL, parts=SURE), finder, lambda *_, **__: CUT) is None
    assert not finder.looked


@pytest.mark.parametrize("real", [True, False])
def test_what_looks_like_a_photograph_is_one_whatever_is_read_of_it(street, real):
    asked = []

    def looks_real():
        asked.append(True)
        return real

    of_all, finder = replace(ALL, parts=SURE), Finder(0.99)
    found = as_photograph((street, WHOLE), of_all, finder, lambda *_, **__: CUT, None, looks_real)
    assert (found is not None and found.is_photograph) == real and asked
    asked.clear()
    assert as_photograph((street, WHOLE), ALL, finder, lambda *_, **__: CUT, None, looks_real) and not asked


@pytest.mark.parametrize("sure", [0.7, 0.9])
@pytest.mark.parametrize("parts", [(), VAGUE, SURE])
def test_where_nothing_is_seen_of_all_of_it_the_cut_out_tells(street, sure, parts):
    cut = replace(CUT, parts=parts, figures="none")
    found = as_photograph(
        (street, WHOLE), replace(ALL, parts=(), figures="none"), Finder(sure), lambda *_, **__: cut
    )
    if parts is VAGUE and sure > SURELY_SOMEBODY:
        assert found.parts[0].design is VAGUE[0].design and found.figures == "one" and found.is_photograph
    else:
        assert found is None


@pytest.mark.parametrize("hangs_over", [0.7, 0.95])
def test_what_hangs_over_trousers_hides_them(street, hangs_over):
    top, trousers = np.zeros((90, 80), np.float32), np.zeros((90, 80), np.float32)
    trousers[30:50] = 0.9
    top[20 : 30 + round(20 * hangs_over)] = 0.9
    parts = tuple(
        replace(VAGUE[0], part=name, mask=mask) for name, mask in (("lower", trousers), ("upper", top))
    )
    found = as_photograph((street, WHOLE), ALL, Finder(0.9), lambda *_, **__: replace(CUT, parts=parts))
    lower, upper = (part.mask[20:60, 30:50] > 0.5 for part in found.parts)
    assert (upper[:, 0].nonzero()[0] == np.arange(10 + round(20 * hangs_over))).all()
    assert lower[:, 0].nonzero()[0].min() == (24 if hangs_over < 0.9 else 10)
    assert lower[:, 0].nonzero()[0].max() == 29

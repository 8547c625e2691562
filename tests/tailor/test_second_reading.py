"""Drafts that are drawn like their picture and read again: what is read otherwise corrects their numbers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scripted_maker import scripted_maker
from seeing import Seeing, worn

from swifttailor.errors import PatternError
from swifttailor.parameter_reader.reader import ParameterReader
from swifttailor.pattern import Finding, Severity, check_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.picture_reader.seen_design import SeenDesign
from swifttailor.programs.read_parameter import ReadParameter
from swifttailor.tailor import Order, Tailor, second_reading
from swifttailor.tailor.second_reading import MOST_PLACES

PICTURE = np.full((300, 200, 3), 200, np.uint8)
LENGTHS = tuple(round(0.3 + 0.05 * k, 2) for k in range(11))
LENGTH = ReadParameter("pencil-skirt.length", LENGTHS, tuple(v + 0.025 for v in LENGTHS[:-1]))
BOTTOM = ReadParameter("meta.bottom", ("PencilSkirt", "SkirtCircle"))
WAIST = ReadParameter("meta.wb", ("StraightWB", None))
CHOICES = BOTTOM, WAIST, LENGTH
FIRST = 4
"""Where the picture and what follows from its reading have the length."""


class Heard:
    """Says a length of what it is told first, and another of anything else."""

    def __init__(self, with_words: int = FIRST) -> None:
        self.with_words, self.words = with_words, None

    def run(self, names, given):
        self.words = given["features"] if self.words is None else self.words
        place = self.with_words if (given["features"] == self.words).all() else FIRST
        return [np.array([[9.0, 0.0, 9.0, 0.0, *_sharp(place)]], np.float32)]


def _sharp(place: int) -> list[float]:
    return [30.0 if k == place else 0.0 for k in range(len(LENGTHS))]


def seen_with(place: float) -> SeenDesign:
    """A length between two ranges, or in one."""
    lower = int(np.floor(place))
    shares = np.zeros(len(LENGTHS))
    shares[lower] = 1 - (place - lower)
    if place > lower:
        shares[lower + 1] = place - lower
    return SeenDesign((LENGTH,), (shares,))


def eyes(*places: float, **more) -> Seeing:
    """Sees lengths one after the other."""
    part = worn("lower", {"kind": ("skirt", 0.99)})
    return Seeing(*((replace(part, design=seen_with(place)),) for place in places), **more)


def length_of(
    sewer, seeing: Seeing, *, text: str = "", heard: Heard | None = None, refine: int | None = None
):
    reader = ParameterReader(heard or Heard(), CHOICES, {})
    tailor = Tailor(
        scripted_maker([draft("fitted-dress")]), sewer, picture_reader=seeing, parameter_reader=reader
    )
    order = Order(text, PICTURE, source="designs", refine=refine)
    (answer,) = tailor.write([order])
    assert not isinstance(answer, Exception) and answer.design is not None
    return LENGTHS.index(answer.design["pencil-skirt.length"])


@pytest.mark.parametrize(("again", "place"), [(4, 4), (2, 6), (5.2, 3), (4.4, 4)])
def test_what_is_read_otherwise_of_the_drawing_corrects_the_design(sewer, again, place):
    seeing = eyes(FIRST, again, is_plain=True)
    assert length_of(sewer, seeing) == place
    assert len(seeing.shown) == 2
    drawing = seeing.shown[1]
    assert drawing.shape == (300, 300, 3), "as large as the picture"
    figure = (drawing != drawing[0, 0]).any(axis=2)
    assert 0.02 < figure.mean() < 0.6, "a figure before a plain backdrop"


def test_fronts_and_backs_are_drawn_as_they_were_seen(sewer):
    drawings = []
    for azimuth in (0.0, 180.0):
        seeing = eyes(FIRST, FIRST, is_plain=True, azimuth=azimuth)
        length_of(sewer, seeing)
        drawings.append(seeing.shown[1])
    assert (drawings[0] != drawings[1]).any(axis=2).mean() > 0.02


def test_no_number_moves_far(sewer):
    assert length_of(sewer, eyes(FIRST, 10, is_plain=True)) == 0
    unmoved = length_of(sewer, eyes(FIRST + 1, 0, is_plain=True), refine=0)
    assert length_of(sewer, eyes(FIRST + 1, 0, is_plain=True)) == unmoved + MOST_PLACES


@pytest.mark.parametrize("more", [{}, {"is_plain": True, "azimuth": 90.0}])
def test_other_pictures_are_read_once(sewer, more):
    seeing = eyes(FIRST, 2, **more)
    assert length_of(sewer, seeing) == FIRST and len(seeing.shown) == 1


def test_who_wants_no_second_look_gets_none(sewer):
    seeing = eyes(FIRST, 2, is_plain=True)
    assert length_of(sewer, seeing, refine=0) == FIRST and len(seeing.shown) == 1


def test_what_words_move_the_picture_does_not_move_back(sewer):
    assert length_of(sewer, eyes(FIRST, 6, is_plain=True), text="a skirt", heard=Heard(FIRST)) == 2
    asked = {"text": "a long skirt", "heard": Heard(9)}
    unmoved = length_of(sewer, eyes(FIRST, 6, is_plain=True), refine=0, **asked)
    assert length_of(sewer, eyes(FIRST, 6, is_plain=True), **asked) == unmoved != FIRST


def test_a_draft_that_cannot_be_sewn_or_is_not_seen_stays(sewer):
    class Torn:
        def prepare(self, pattern, /, *, edge_length, resolution):
            if edge_length == second_reading.EDGE_CM:
                raise PatternError("It cannot be meshed.")
            return sewer.prepare(pattern, edge_length=edge_length, resolution=resolution)

        predict, decode = sewer.predict, sewer.decode

    assert length_of(Torn(), eyes(FIRST, 2, is_plain=True)) == FIRST
    nothing = Seeing(eyes(FIRST).readings[0], (), is_plain=True)
    assert length_of(sewer, nothing) == FIRST and len(nothing.shown) == 2


@pytest.mark.parametrize(("unsound", "place"), [(1, 5), (2, FIRST)])
def test_what_cannot_be_cut_goes_half_the_way_or_stays(sewer, monkeypatch, unsound, place):
    asked = []

    def check(pattern):
        asked.append(pattern)
        return check_pattern(pattern) if len(asked) > unsound else (_ERROR,)

    monkeypatch.setattr("swifttailor.tailor.designed.check_pattern", check)
    assert length_of(sewer, eyes(FIRST, 2, is_plain=True)) == place
    assert len(asked) == 2


_ERROR = Finding("self-crossing", Severity.ERROR, "The outline crosses itself.")


@given(st.floats(-20, 20), st.integers(0, len(LENGTHS) - 1))
def test_numbers_stay_among_their_ranges_and_choices_as_they_are(off, place):
    reader = ParameterReader(Heard(), CHOICES, {})
    design = {"meta.bottom": "PencilSkirt", "meta.wb": None, "pencil-skirt.length": LENGTHS[place]}
    moved = second_reading._moved(design, {"pencil-skirt.length": off, "pants.length": 3.0}, reader)
    assert moved | {"pencil-skirt.length": 0} == design | {"pencil-skirt.length": 0}
    now = LENGTHS.index(moved["pencil-skirt.length"])
    assert abs(now - place) <= min(MOST_PLACES, abs(off) + 0.5)
    assert now == place or (now > place) == (off > 0)

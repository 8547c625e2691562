"""Design parameters as pictures show them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from swifttailor.picture_reader.reading import PartReading
from swifttailor.picture_reader.seen_design import SeenDesign, mixed
from swifttailor.picture_reader.together import together
from swifttailor.programs.read_parameter import ReadParameter

BOTTOM = ReadParameter("meta.bottom", ("Pants", "PencilSkirt"))
LENGTH = ReadParameter("pencil-skirt.length", (0.3, 0.5, 0.8), (0.4, 0.6))
LOGITS = np.array([[0.0, np.log(3.0), 50.0], [1.0, 1.0, 1.0]], np.float32)


def part(design: SeenDesign | None) -> PartReading:
    return PartReading("lower", 0.9, (), (), (), np.zeros((2, 2), np.float32), design=design)


def test_values_that_a_parameter_has_not_do_not_count():
    seen = SeenDesign.of_logits((BOTTOM, LENGTH), LOGITS)
    assert np.allclose(seen.shares[0], [0.25, 0.75]) and np.allclose(seen.shares[1], 1 / 3)


def test_of_numbers_the_middle_is_told():
    ranges = (np.array([0.9, 0.1]), np.array([0.5, 0.0, 0.5]))
    assert SeenDesign((BOTTOM, LENGTH), ranges).middles() == {"pencil-skirt.length": 1.0}


def test_several_pictures_count_alike():
    one = SeenDesign((BOTTOM,), (np.array([0.9, 0.1]),))
    other = SeenDesign((BOTTOM,), (np.array([0.1, 0.9]),))
    found = together([part(one), part(other), part(other)]).design
    assert found is not None and found.shares[0][1] > found.shares[0][0]
    assert np.allclose(SeenDesign.together([one, other]).shares[0], 0.5)


def test_where_one_picture_says_nothing_of_designs_none_is_said():
    one = SeenDesign((BOTTOM,), (np.array([0.9, 0.1]),))
    assert together([part(one), part(None)]).design is None
    assert together([part(one), part(replace(one, parameters=(LENGTH,)))]).design is None


_SHARES = arrays(np.float64, 5, elements=st.floats(0.01, 1)).map(lambda v: v / v.sum())


@given(_SHARES, _SHARES, st.floats(0.05, 1))
def test_a_mixture_adds_up_and_lies_between(one, other, weight):
    found = mixed([one, other], [1 - weight, weight])
    assert abs(found.sum() - 1) < 1e-9
    assert np.allclose(mixed([one, one]), one)
    if weight == 1:
        assert np.allclose(found, other)
    # Ratios lie between those of both.
    ratios = [np.log(v[0] / v[1]) for v in (one, found, other)]
    assert min(ratios[0], ratios[2]) - 1e-6 <= ratios[1] <= max(ratios[0], ratios[2]) + 1e-6

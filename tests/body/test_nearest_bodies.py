"""Bodies that nobody has as the nearest that there are, and girths by weight."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.body.made_to_measure import body_to_measure
from swifttailor.body.wearer import Wearer, body_of
from swifttailor.body.weight import kilograms, waist_of_weight
from swifttailor.errors import InputError


@settings(max_examples=8, deadline=None)
@given(
    st.dictionaries(st.sampled_from(["bust", "waist", "hips", "height"]), st.floats(20.0, 400.0), min_size=1),
    st.sampled_from([None, "women", "men"]),
)
def test_no_measures_are_refused_where_the_nearest_is_wanted(measures, figure):
    wearer = Wearer(measures=measures, figure=figure, nearest=True)
    body = wearer.body()
    # What the pattern's file names can be made again.
    assert body_of(body.made_for).measurements.bust == pytest.approx(body.measurements.bust, abs=1.0)


def test_what_is_not_had_is_said():
    wearer = Wearer(measures={"waist": 220.0}, nearest=True)
    assert "waist 220" in wearer.not_had
    assert Wearer(measures={"waist": 110.0}, nearest=True).not_had == ""
    with pytest.raises(InputError):
        Wearer(measures={"waist": 220.0}).body()


def test_girths_of_a_size_give_way_to_those_that_are_said():
    body = Wearer(size="women 4XL", measures={"waist": 150.0}, nearest=True).body()
    assert body.measurements.waist == pytest.approx(150.0, abs=1.5)


@pytest.mark.parametrize(
    ("kg", "height", "figure"), [(95.0, 188.0, "men"), (55.0, 160.0, "women"), (130.0, 175.0, None)]
)
def test_a_body_of_a_weight_weighs_it(kg, height, figure):
    waist = waist_of_weight(kg, height, figure)
    body = body_to_measure({"height": height, "waist": waist}, figure=figure).body
    assert kilograms(body) == pytest.approx(kg, abs=1.0)


def test_a_weight_makes_a_wearer():
    body = Wearer(measures={"height": 188.0}, figure="men", weight=95.0, nearest=True).body()
    assert kilograms(body) == pytest.approx(95.0, abs=1.0)
    assert body.made_for is not None and body.made_for.name == "height 188, 95 kg"

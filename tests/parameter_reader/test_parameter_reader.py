"""Design parameters that are read, with a network that is scripted and with the one in the package."""

from __future__ import annotations

from itertools import islice

import numpy as np
import pytest

from swifttailor.describing import measure_facts
from swifttailor.errors import InputError
from swifttailor.parameter_reader.features import features_of
from swifttailor.parameter_reader.reader import SHIPPED, ParameterReader
from swifttailor.parameter_reader.which_matter import matters
from swifttailor.pattern_library.sought import Sought
from swifttailor.picture_reader.seen_design import SeenDesign
from swifttailor.picture_reader.truth import Truth
from swifttailor.programs import complete_design, make_pattern
from swifttailor.programs.read_parameter import RANGES, ReadParameter, read_parameters

BOTTOM = ReadParameter("meta.bottom", ("Pants", "PencilSkirt"))
LENGTH = ReadParameter("pencil-skirt.length", (0.3, 0.5, 0.8), (0.4, 0.6))
SKIRT = {"meta.bottom": "PencilSkirt", "meta.wb": "StraightWB", "pencil-skirt.length": 0.55}
DRESS = {"meta.upper": "FittedShirt", "meta.bottom": "SkirtCircle", "flare-skirt.length": 0.5}


class Session:
    """Says the same of everything."""

    def __init__(self, logits):
        self.logits = np.array([logits], np.float32)

    def run(self, names, given):
        return [self.logits]


def reader(*logits: float) -> ParameterReader:
    return ParameterReader(Session(logits), (BOTTOM, LENGTH), {})


def truth_of(design) -> Truth:
    pattern = make_pattern(design).canonical()
    return Truth.of(pattern, measure_facts(pattern))


def test_the_first_design_is_the_likeliest_with_the_median_of_a_number():
    eyes = reader(0.0, 2.0, np.log(0.4), np.log(0.2), np.log(0.4))
    shares = eyes.shares(Sought.nothing())
    assert [len(one) for one in shares] == [2, 3] and all(abs(one.sum() - 1) < 1e-9 for one in shares)
    first = next(eyes.designs(Sought.nothing()))
    assert first == {"meta.bottom": "PencilSkirt", "pencil-skirt.length": 0.5}


def test_later_designs_differ_in_choices_and_are_the_same_again():
    eyes = reader(0.0, 0.3, 0.0, 3.0, 0.0)
    found = list(islice(eyes.designs(Sought.nothing(), seed=3), 30))
    assert {one["meta.bottom"] for one in found} == {"Pants", "PencilSkirt"}
    assert {one["pencil-skirt.length"] for one in found} == {0.5}
    assert found == list(islice(eyes.designs(Sought.nothing(), seed=3), 30))


def test_numbers_that_are_none_are_refused():
    with pytest.raises(InputError, match="weights are damaged"):
        reader(np.nan, 0.0, 0.0, 0.0, 0.0).shares(Sought.nothing())


def test_what_is_not_known_says_nothing():
    assert not features_of(Sought.nothing()).any()
    told = features_of(Sought.of_truth(truth_of(SKIRT)))
    assert np.isfinite(told).all() and told.any() and len(told) == len(features_of(Sought.nothing()))
    assert (told != features_of(Sought.of_truth(truth_of(DRESS)))).any()


def test_numbers_become_ranges_and_choices_stay_choices():
    designs = [complete_design(SKIRT | {"pencil-skirt.length": 0.2 + 0.005 * k}) for k in range(100)]
    designs += [complete_design({"meta.bottom": "Pants"}) for _ in range(100)]
    found = {one.name: one for one in read_parameters(designs, [matters(d) for d in designs])}
    assert set(found) == {"meta.bottom", "meta.wb", "pencil-skirt.length"}
    length = found["pencil-skirt.length"]
    assert length.edges is not None and len(length.values) == RANGES
    assert sorted(length.values) == list(length.values)
    counts = np.bincount([length.place_of(0.2 + 0.005 * k) for k in range(100)])
    assert counts.min() >= 3 and counts.max() <= 4
    assert found["meta.bottom"].values[found["meta.bottom"].place_of("Pants")] == "Pants"
    again = ReadParameter.from_json(length.to_json())
    assert again == length


@pytest.mark.parametrize(
    ("about", "says"),
    [
        ({"name": "meta.hat", "values": [1, 2], "edges": None}, "no design parameter 'meta.hat'"),
        ({"name": "pants.length", "values": [1, 2], "edges": [1, 2]}, "2 ranges and 2 edges"),
        ({"name": "pants.length", "values": [], "edges": None}, "no values"),
    ],
)
def test_cards_that_contradict_themselves_are_refused(about, says):
    with pytest.raises(InputError, match=says):
        ReadParameter.from_json(about)


@pytest.mark.skipif(not SHIPPED.is_file(), reason="the package has no weights")
@pytest.mark.parametrize("design", [SKIRT, DRESS, {"meta.bottom": "Pants", "pants.length": 0.8}])
def test_the_network_of_the_package_reads_what_is_true_of_a_design(design):
    eyes = ParameterReader.load()
    sought = truth_of(design)
    found = make_pattern(next(eyes.designs(Sought.of_truth(sought)))).canonical()
    again = truth_of(design)
    made = Truth.of(found, measure_facts(found))
    assert (made.panels == again.panels).mean() > 0.97
    known = np.isfinite(again.measures) & np.isfinite(made.measures)
    apart = np.abs(made.measures - again.measures)[known] / np.maximum(np.abs(again.measures[known]), 10.0)
    assert np.median(apart) < 0.08


def test_whole_numbers_stay_whole():
    designs = [complete_design({"meta.bottom": "Skirt2", "skirt.flare": k % 21}) for k in range(200)]
    designs += [
        complete_design(
            {"meta.bottom": "GodetSkirt", "meta.wb": "StraightWB", "godet-skirt.insert_w": 10 + k % 41}
        )
        for k in range(200)
    ]
    found = {one.name: one for one in read_parameters(designs, [matters(d) for d in designs])}
    width = found["godet-skirt.insert_w"]
    assert width.edges is not None and all(type(value) is int for value in width.values)
    assert all(width.place_of(value) == k for k, value in enumerate(width.values))


def test_what_a_picture_shows_of_a_parameter_counts_beside_what_follows_from_its_reading():
    eyes = reader(1.0, 0.0, 0.0, 0.0, 3.0)
    seen = SeenDesign((BOTTOM,), (np.array([0.2, 0.8]),))
    shares = eyes.shares(Sought.nothing(), seen)
    assert 0.5 < shares[0][1] < 0.8 and abs(shares[0].sum() - 1) < 1e-9
    assert np.allclose(shares[1], eyes.shares(Sought.nothing())[1]), "of lengths the picture says nothing"
    assert next(eyes.designs(Sought.nothing(), seen))["meta.bottom"] == "PencilSkirt"
    assert next(eyes.designs(Sought.nothing()))["meta.bottom"] == "Pants"


def test_a_parameter_with_other_values_is_not_heard():
    eyes = reader(1.0, 0.0, 0.0, 0.0, 3.0)
    seen = SeenDesign(
        (ReadParameter("meta.bottom", ("SkirtCircle", "PencilSkirt")),), (np.array([0.0, 1.0]),)
    )
    assert next(eyes.designs(Sought.nothing(), seen))["meta.bottom"] == "Pants"

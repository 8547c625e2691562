"""A design read in a picture is changed, where it is least certain, to what words ask for."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.describing.measuring import measure_facts
from swifttailor.parameter_reader.reader import ParameterReader
from swifttailor.programs import make_pattern
from swifttailor.programs.read_parameter import ReadParameter
from swifttailor.tailor import Order
from swifttailor.tailor.heeded import heeded
from swifttailor.tailor.reading import Wanted
from swifttailor.wishes.reader import Wish

SKIRT = (
    ReadParameter("meta.bottom", ("PencilSkirt", "SkirtCircle")),
    ReadParameter("pencil-skirt.length", (0.4, 0.7, 0.95), (0.55, 0.85)),
    ReadParameter("pencil-skirt.rise", (0.7, 1.0), (0.85,)),
    ReadParameter("meta.wb", ("StraightWB", None)),
)
NECKS = ("CircleNeckHalf", "SquareNeckHalf", "VNeckHalf")
TOP = (
    ReadParameter("meta.upper", ("Shirt",)),
    ReadParameter("left.enable_asym", (False, True)),
    ReadParameter("collar.f_collar", NECKS),
    ReadParameter("left.collar.f_collar", NECKS),
)


class Says:
    def __init__(self, logits):
        self.logits = np.array([logits], np.float32)

    def run(self, names, given):
        return [self.logits]


def read(parameters, *logits):
    return ParameterReader(Says([float(x) for some in logits for x in some]), parameters, {})


def wanting(**claims):
    wishes = tuple(Wish(Gain(Claim(name, value)), 1.0) for name, value in claims.items())
    return Wanted(Order("as said"), "as said", wishes=wishes)


def made(reader, design, wanted):
    return heeded(design, make_pattern(design).canonical(), wanted, reader)


@pytest.fixture
def short():
    return {
        "meta.bottom": "PencilSkirt",
        "pencil-skirt.length": 0.4,
        "pencil-skirt.rise": 1.0,
        "meta.wb": None,
    }


def test_the_likeliest_value_that_does_what_is_asked_is_taken(short):
    reader = read(SKIRT, (5, 0), (5, 2, 1), (0, 5), (0, 5))
    design, pattern = made(reader, short, wanting(skirt_hem="midi"))
    assert design == short | {"pencil-skirt.length": 0.7}
    assert Claim("skirt_hem", "midi").holds(measure_facts(pattern))
    assert pattern == make_pattern(design).canonical()


def test_of_two_wishes_each_changes_what_it_is_about(short):
    reader = read(SKIRT, (5, 0), (5, 2, 1), (0, 5), (0, 9))
    design, pattern = made(reader, short, wanting(skirt_hem="midi", waistband="waist"))
    facts = measure_facts(pattern)
    assert design["meta.wb"] == "StraightWB" and design["meta.bottom"] == "PencilSkirt"
    assert Claim("skirt_hem", "midi").holds(facts) and Claim("waistband", "waist").holds(facts)


@pytest.mark.parametrize("claims", [{}, {"kind": "skirt"}, {"collar": "lapel"}])
def test_what_is_so_and_what_cannot_be_had_change_nothing(short, claims):
    reader = read(SKIRT, (5, 0), (5, 2, 1), (0, 5), (0, 5))
    pattern = make_pattern(short).canonical()
    same = heeded(short, pattern, wanting(**claims), reader)
    assert same[0] is short and same[1] is pattern


def test_a_side_is_made_otherwise_where_words_tell_sides_apart():
    reader = read(TOP, (0,), (9, 0), (5, 0, 0), (0, 0, 5))
    even = {
        "meta.upper": "Shirt",
        "left.enable_asym": False,
        "collar.f_collar": "CircleNeckHalf",
        "left.collar.f_collar": "CircleNeckHalf",
    }
    assert not Claim("neckline", "asymmetric").holds(measure_facts(make_pattern(even).canonical()))
    design, pattern = made(reader, even, wanting(neckline="asymmetric"))
    assert design["left.enable_asym"] and design["left.collar.f_collar"] == "VNeckHalf", "the likeliest"
    assert Claim("neckline", "asymmetric").holds(measure_facts(pattern))

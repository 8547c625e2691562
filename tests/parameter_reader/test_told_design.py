"""Design parameters that a picture shows, told to people."""

from __future__ import annotations

import numpy as np

from swifttailor.parameter_reader.told_design import told_design
from swifttailor.picture_reader.seen_design import SeenDesign
from swifttailor.programs.read_parameter import ReadParameter

UPPER = ReadParameter("meta.upper", ("FittedShirt", None))
BOTTOM = ReadParameter("meta.bottom", ("Pants", "PencilSkirt"))
LENGTH = ReadParameter("pencil-skirt.length", (0.3, 0.5, 0.7, 0.9), (0.4, 0.6, 0.8))
LEGS = ReadParameter("pants.length", (0.3, 0.8), (0.5,))
PARAMETERS = (UPPER, BOTTOM, LENGTH, LEGS)


def told(upper, bottom, length=(0.3, 0.4, 0.2, 0.1), legs=(0.9, 0.1)):
    shares = (np.array(values) for values in (upper, bottom, length, legs))
    return told_design(SeenDesign(PARAMETERS, tuple(shares)))


def test_only_what_matters_for_the_likeliest_design_is_told():
    skirt = told((0.1, 0.9), (0.25, 0.75))
    assert [one.name for one in skirt] == ["meta.upper", "meta.bottom", "pencil-skirt.length"]
    trousers = told((0.1, 0.9), (0.75, 0.25))
    assert [one.name for one in trousers] == ["meta.upper", "meta.bottom", "pants.length"]


def test_choices_have_a_certainty_and_numbers_lie_between_others():
    upper, bottom, length = told((0.1, 0.9), (0.25, 0.75))
    assert upper.to_json() == {"name": "meta.upper", "value": None, "certainty": 0.9}
    assert upper.line() == "meta.upper: none (90%)" and bottom.line() == "meta.bottom: PencilSkirt (75%)"
    assert length.to_json() == {"name": "pencil-skirt.length", "value": 0.5, "between": [0.3, 0.7]}
    assert length.line() == "pencil-skirt.length: 0.50, between 0.30 and 0.70"


def test_values_that_no_program_accepts_are_told_all_the_same():
    odd = SeenDesign((ReadParameter("meta.upper", ("Cape",)), LEGS), (np.array([1.0]), np.array([0.9, 0.1])))
    assert [one.name for one in told_design(odd)] == ["meta.upper", "pants.length"]

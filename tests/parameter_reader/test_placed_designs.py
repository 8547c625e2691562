"""Designs by the places of their values, in memory and in files."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.errors import InputError
from swifttailor.parameter_reader.drawn import drawn_designs
from swifttailor.parameter_reader.placed_designs import PlacedDesigns, nearly_right
from swifttailor.parameter_reader.reader import ParameterReader
from swifttailor.parameter_reader.which_matter import matters
from swifttailor.programs import complete_design
from swifttailor.programs.read_parameter import ReadParameter

SKIRT = complete_design({"meta.bottom": "PencilSkirt", "meta.wb": "StraightWB", "pencil-skirt.flare": 1.2})
PARAMETERS = (
    ReadParameter("meta.bottom", ("PencilSkirt", "SkirtCircle")),
    ReadParameter("pencil-skirt.flare", (0.8, 1.0, 1.3), (0.9, 1.1)),
    ReadParameter("flare-skirt.suns", (0.5, 1.5), (1.0,)),
)


def test_a_value_has_its_place_where_it_matters():
    placed = PlacedDesigns.of({"skirt": SKIRT}, PARAMETERS)
    places, matter = placed.of_ids(["skirt", "nobody's"])
    assert places.tolist() == [[0, 2, 0], [0, 0, 0]]
    assert matter.tolist() == [[True, True, False], [False, False, False]]
    assert placed.values == (2, 3, 2)


def test_a_choice_that_is_not_known_leaves_the_garment_out():
    trousers = complete_design({"meta.bottom": "Pants"})
    placed = PlacedDesigns.of({"trousers": trousers, "skirt": SKIRT}, PARAMETERS)
    assert list(placed.rows) == ["skirt"] and placed.places.shape == (1, 3)
    none = PlacedDesigns.of({"trousers": trousers}, PARAMETERS)
    assert none.places.shape == (0, 3) and not none.of_ids(["trousers", "skirt"])[1].any()


def test_values_come_back_from_their_places():
    parameters = ParameterReader.load().parameters
    designs = {str(k): design for k, (design, _) in zip(range(12), drawn_designs(seed=4), strict=False)}
    placed = PlacedDesigns.of(designs, parameters)
    assert len(placed.rows) >= 10
    for id, row in placed.rows.items():
        names = matters(designs[id])
        assert {p.name for p, m in zip(parameters, placed.matter[row], strict=True) if m} <= names
        for one, place, counts in zip(parameters, placed.places[row], placed.matter[row], strict=True):
            if counts:
                assert one.place_of(designs[id][one.name]) == place
                assert one.is_number or one.values[place] == designs[id][one.name]


def test_a_file_holds_the_same(tmp_path):
    placed = PlacedDesigns.of({"a skirt": SKIRT, "gc_2": SKIRT}, PARAMETERS)
    placed.write(tmp_path / "designs.safetensors")
    found = PlacedDesigns.read(tmp_path / "designs.safetensors")
    assert found.parameters == placed.parameters and found.rows == placed.rows
    assert (found.places == placed.places).all() and (found.matter == placed.matter).all()
    with pytest.raises(InputError):
        placed.write(tmp_path / "designs.safetensors")


def test_damaged_files_are_refused(tmp_path):
    path = tmp_path / "designs.safetensors"
    placed = PlacedDesigns.of({"skirt": SKIRT}, PARAMETERS)
    with pytest.raises(InputError, match="place_designs"):
        PlacedDesigns.read(path)
    path.write_bytes(b"nothing of the kind")
    with pytest.raises(InputError, match="place_designs"):
        PlacedDesigns.read(path)
    for places in (np.full((1, 3), 9, np.uint8), np.zeros((2, 3), np.uint8), np.zeros((1, 3), np.int32)):
        PlacedDesigns(PARAMETERS, placed.rows, places, placed.matter).write(path, overwrite=True)
        with pytest.raises(InputError, match="place_designs"):
            PlacedDesigns.read(path)


@given(st.integers(1, 40), st.booleans())
def test_what_is_nearly_right_adds_up_and_is_most_right_where_it_is(values, is_number):
    right = nearly_right(values, is_number=is_number)
    assert np.allclose(right.sum(axis=1), 1) and (right.argmax(axis=1) == np.arange(values)).all()
    assert (right > 0).sum() == (3 * values - 2 if is_number else values)

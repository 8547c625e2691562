"""Parameters that are said not to matter change nothing in the pattern; those that do, do."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest

from swifttailor.parameter_reader.which_matter import matters
from swifttailor.programs import DESIGN_PARAMETERS, DesignError, complete_design, make_pattern


def drawn(chance: random.Random) -> dict:
    """Any design that is accepted, with its pattern."""
    while True:
        design = {name: value_of(one, chance) for name, one in DESIGN_PARAMETERS.items()}
        design["pencil-skirt.style_side_cut"] = None
        try:
            make_pattern(design)
        except DesignError:
            continue
        return complete_design(design)


def value_of(parameter, chance: random.Random):
    if parameter.choices:
        return chance.choice(parameter.choices)
    low, high = parameter.range
    return chance.randint(int(low), int(high)) if parameter.kind == "int" else chance.uniform(low, high)


def shape(design) -> object:
    """All of a pattern but its name."""
    return replace(make_pattern(design).canonical(), name="")


@pytest.mark.parametrize("seed", range(24))
def test_what_does_not_matter_changes_nothing(seed):
    chance = random.Random(seed)
    design = drawn(chance)
    names = matters(design)
    other = {
        name: value if name in names else value_of(DESIGN_PARAMETERS[name], chance)
        for name, value in design.items()
    }
    other["pencil-skirt.style_side_cut"] = None
    assert matters(other) == names
    assert same(shape(design), shape(other))


def same(one, other) -> bool:
    if [p.name for p in one.panels] != [p.name for p in other.panels] or one.stitches != other.stitches:
        return False
    pairs = zip(one.panels, other.panels, strict=True)
    return all(a.vertices.tolist() == b.vertices.tolist() and a.edges == b.edges for a, b in pairs)


def test_a_name_that_matters_is_a_parameter():
    for seed in range(40):
        assert matters(drawn(random.Random(seed))) <= DESIGN_PARAMETERS.keys()


def test_of_a_pencil_skirt_its_own_parameters_matter():
    names = matters(complete_design({"meta.bottom": "PencilSkirt"}))
    assert names == {"meta.upper", "meta.wb", "meta.bottom"} | {
        f"pencil-skirt.{name}"
        for name in (
            "length", "rise", "flare", "low_angle", "front_slit", "back_slit", "left_slit", "right_slit"
        )
    }  # fmt: skip

"""Which design parameters close-ups tell, and what is said of them altogether."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.parameter_reader import ParameterReader
from swifttailor.picture_reader.close_designs import ASYMMETRIC, sees_designs
from swifttailor.picture_reader.close_looks import DESIGN_SHARE, with_close_designs
from swifttailor.picture_reader.close_ups import CLOSE_UPS, WHOLE

PARAMETERS = ParameterReader.load().parameters
NAMES = tuple(one.name for one in PARAMETERS)
NUMBER = {close_up.name: k for k, close_up in enumerate(CLOSE_UPS)}
MOST = max(len(one.values) for one in PARAMETERS)
FRONT, SIDE, BACK = 1.0, 0.0, -1.0


def told(name, cosine=SIDE, *, asymmetric=False):
    number = WHOLE if name == "whole" else NUMBER[name]
    seen = sees_designs(np.array([number]), np.array([cosine]), np.array([asymmetric]), NAMES)
    return {name for name, sees in zip(NAMES, seen[0], strict=True) if sees}


def test_each_close_up_tells_what_it_shows_and_all_of_it_is_told_of_whole_garments():
    assert told("whole") == told("whole", BACK, asymmetric=True) == set(NAMES)
    everything = set().union(*(told(one.name) for one in CLOSE_UPS))
    assert all(told(one.name) for one in CLOSE_UPS)
    assert not {name for name in everything if name.endswith(".rise")}, "a waist alone shows where it sits"
    assert told("waist") == {"meta.wb", "waistband.waist", "waistband.width"}
    assert "levels-skirt.num_levels" in told("skirt") and "meta.bottom" in told("skirt")
    assert "sleeve.cuff.type" in told("end of the right sleeve")
    assert not told("end of the right sleeve") & told("right armhole")
    rest = set(NAMES) - everything
    assert {"meta.upper", "shirt.length", "sleeve.length", "pants.length", ASYMMETRIC} <= rest


@pytest.mark.parametrize("what", ["armhole", "end of the {} sleeve", "neck"])
def test_each_side_tells_of_itself(what):
    left, right = (
        what.format(side) if "{" in what else what if what == "neck" else f"{side} {what}"
        for side in ("left", "right")
    )
    of_right = {name for name in told(right) if not name.startswith("left.")}
    assert of_right
    mirrored = {f"left.{name}" for name in of_right} & set(NAMES)
    assert told(left) == of_right | mirrored
    assert mirrored
    if what == "neck":
        assert told(left, asymmetric=True) == told(left)
    else:
        assert told(right, asymmetric=True) == told(right) == of_right
        assert told(left, asymmetric=True) == mirrored, "its right side has others"


def test_what_is_on_the_other_side_is_not_seen():
    hidden = told("neck") - told("neck", FRONT), told("neck") - told("neck", BACK)
    behind = ("b_collar", "bc_depth", "bc_angle", "b_bezier_x", "b_bezier_y", "b_flip_curve")
    assert {name.removeprefix("left.") for name in hidden[0]} == {f"collar.{name}" for name in behind}
    assert {name.replace(".f", ".b") for name in hidden[1]} == hidden[0]
    assert told("skirt") - told("skirt", FRONT) == {"pencil-skirt.back_slit"}
    assert told("skirt") - told("skirt", BACK) == {"pencil-skirt.front_slit"}
    assert told("waist", FRONT) == told("waist", BACK) == told("waist")


def shares_of(logits):
    """(D, V) of logits (D, V), of the values that there are."""
    found = np.zeros_like(logits)
    for row, one, part in zip(found, PARAMETERS, logits, strict=True):
        raised = np.exp(part[: len(one.values)] - part[: len(one.values)].max())
        row[: len(one.values)] = raised / raised.sum()
    return found


def look(chance, cosine=FRONT):
    view = np.array([0.0, cosine, 0.0, 0.0, 0.0, 0.0])
    return {"designs": chance.normal(0, 2, (2, len(NAMES), MOST)), "camera_view": view}


def symmetric(designs, unlike=False):
    row = NAMES.index(ASYMMETRIC)
    designs[:, row, :2] = np.where(np.array(PARAMETERS[row].values) == unlike, 3.0, -3.0)
    return designs


@given(st.integers(0, 2**32 - 1), st.sets(st.sampled_from(sorted(NUMBER))), st.booleans())
def test_altogether_is_the_geometric_mean_of_who_tells(seed, names, unlike):
    chance = np.random.default_rng(seed)
    whole = symmetric(look(chance)["designs"], unlike)
    near = {NUMBER[name]: look(chance) for name in names}
    found = with_close_designs(whole, 1, near, PARAMETERS)
    np.testing.assert_array_equal(found[0], whole[0])
    of_whole, of_near = shares_of(whole[1]), {k: shares_of(one["designs"][1]) for k, one in near.items()}
    told_by = {one: told(one, FRONT, asymmetric=unlike) for one in names}
    altogether = shares_of(found[1])
    for k, name in enumerate(NAMES):
        tell = [of_near[NUMBER[one]] for one in names if name in told_by[one]]
        values = slice(len(PARAMETERS[k].values))
        expected = of_whole[k, values]
        if tell:
            logs = np.mean([np.log(shares[k, values]) for shares in tell], axis=0)
            expected = np.exp((1 - DESIGN_SHARE) * np.log(expected) + DESIGN_SHARE * logs)
            expected /= expected.sum()
        np.testing.assert_allclose(altogether[k, values], expected, atol=1e-7)


def test_a_network_that_reads_no_designs_is_told_of_none():
    close_up, unlike = np.array([NUMBER["left armhole"], WHOLE]), np.array([True, False])
    assert sees_designs(close_up, np.array([FRONT, BACK]), unlike, ()).shape == (2, 0)


def test_without_near_looks_nothing_changes():
    whole = look(np.random.default_rng(0))["designs"]
    np.testing.assert_array_equal(with_close_designs(whole, 0, {}, PARAMETERS), whole)

"""What is looked at from near, where that is in a picture, and what is then said altogether."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.close_looks import close_squares, with_close_looks
from swifttailor.picture_reader.close_ups import ALL_PARTS, CLOSE_UPS, WHOLE, sees, told_by
from swifttailor.picture_reader.labels import measure_labels, statement_labels
from swifttailor.picture_reader.panel_kinds import PANEL_KINDS

NAMES = tuple(close_up.name for close_up in CLOSE_UPS)
NUMBER = {name: k for k, name in enumerate(NAMES)}
KIND = {name: k for k, name in enumerate(PANEL_KINDS)}
CELLS = 48
FRAME_CM = 160.0


def shown(name, places, kind):
    return CLOSE_UPS[NUMBER[name]].points(np.asarray(places, float), np.full(len(places), KIND[kind]))


def test_whole_pictures_tell_of_everything_and_close_ups_of_what_they_show():
    told = told_by()
    assert [len(table) for table in told] == [WHOLE + 1] * 3
    assert all(table[WHOLE].all() for table in told)
    for k in range(WHOLE):
        assert 0 < told.statements[k].sum() < len(statement_labels()) / 2
        assert told.measures[k].any() and told.panels[k].any()
    neck, cuff = told.statements[NUMBER["neck"]], told.statements[NUMBER["end of the left sleeve"]]
    for k, (claim, _) in enumerate(statement_labels()):
        assert neck[k] == (claim in CLOSE_UPS[0].claims)
        assert cuff[k] == (claim == "cuffs")
    assert told.panels[NUMBER["waist"]].tolist() == [name.startswith("wb_") for name in PANEL_NAMES]


def test_a_close_up_tells_nothing_of_the_other_side_of_a_neck():
    labels, measures = statement_labels(), measure_labels()
    cosine = np.cos(np.deg2rad([20, 200, 90, 20, 200]))
    seen = sees(np.array([NUMBER["neck"]] * 3 + [WHOLE, NUMBER["waist"]]), cosine)
    told = told_by()
    hidden = {"back_neckline", "back_depth"}, {"neckline", "left_neckline", "right_neckline", "neck_depth"}
    for row, names in enumerate(hidden):
        lost = {labels[k][0] for k in np.flatnonzero(told.statements[0] & ~seen.statements[row])}
        assert lost == names and not (seen.statements[row] & ~told.statements[0]).any()
        lost = {measures[k] for k in np.flatnonzero(told.measures[0] & ~seen.measures[row])}
        assert lost == ({"back depth"}, {"neck depth"})[row]
    for row, number in ((2, NUMBER["neck"]), (3, WHOLE), (4, NUMBER["waist"])):
        for table, of_all in zip(seen, told, strict=True):
            np.testing.assert_array_equal(table[row], of_all[number])
    assert (seen.panels[:3] == told.panels[0]).all()
    assert ALL_PARTS == ("neck", "waist", "sleeve", "leg", "skirt", "armhole")


def test_the_parts_are_where_they_are_worn():
    grid = np.stack(np.meshgrid(np.arange(-60.0, 61, 2), np.arange(0.0, 151, 2), [5.0]), -1).reshape(-1, 3)
    torso = grid[(np.abs(grid[:, 0]) < 25) & (grid[:, 1] > 80)]
    neck = torso[shown("neck", torso, "front bodice")]
    assert neck[:, 1].min() > 115 and np.abs(neck[:, 0]).max() < 22
    waist = torso[shown("waist", torso, "front bodice")]
    assert 85 <= waist[:, 1].min() < 90 and 118 < waist[:, 1].max() < 126
    low = grid[(np.abs(grid[:, 0]) < 25) & (grid[:, 1] < 95)]
    skirt = low[shown("waist", low, "skirt")]
    assert skirt[:, 1].max() == low[:, 1].max() and skirt[:, 1].min() > 55, "what begins lower, at its top"
    arms = grid[(np.abs(grid[:, 0]) > 20) & (grid[:, 1] > 90)]
    for name, side in (("end of the left sleeve", 1), ("end of the right sleeve", -1)):
        end = arms[shown(name, arms, "sleeve")]
        assert (side * end[:, 0] > 40).all() and len(end)
    for name, side in (("left armhole", 1), ("right armhole", -1)):
        for of, kind in ((torso, "back bodice"), (arms, "sleeve")):
            near = of[shown(name, of, kind)]
            assert len(near) and (side * near[:, 0] > 5).all() and near[:, 1].min() > 110
            assert np.abs(near[:, 0]).max() < 35
        assert not shown(name, low, "skirt").any()
    legs = grid[np.abs(grid[:, 0]) < 20]
    end = legs[shown("end of the left leg", legs, "leg")]
    assert (end[:, 0] >= 0).all() and end[:, 1].max() < 25


def test_there_is_nothing_to_look_at_where_a_garment_has_no_such_part():
    places = np.array([[0.0, 60.0, 0.0], [5.0, 70.0, 0.0], [np.nan, np.nan, np.nan]])
    assert not any(shown(name, places, "skirt").any() for name in NAMES if name not in ("waist", "skirt"))
    assert not shown("neck", np.full((4, 3), np.nan), "front bodice").any()
    assert not shown("neck", np.zeros((0, 3)), "front bodice").any()


@given(st.integers(0, 2**32 - 1))
def test_the_left_end_is_the_right_one_in_a_mirror(seed):
    chance = np.random.default_rng(seed)
    places = chance.uniform((-70, 0, -20), (70, 160, 20), (900, 3))
    kinds = chance.integers(0, len(PANEL_KINDS), 900)
    for what in ("end of the {} sleeve", "end of the {} leg", "{} armhole"):
        left, right = (CLOSE_UPS[NUMBER[what.format(side)]] for side in ("left", "right"))
        found = left.points(places, kinds)
        np.testing.assert_array_equal(found, right.points(places * (-1, 1, 1), kinds))
        assert found.any()
        assert set(kinds[found]) <= {KIND[k] for k in left.kinds} and (places[found, 0] >= 0).all()


def looked(kind="front bodice"):
    """A look at a vest in the middle of a frame of 160 cm, whose upper edge is 180 cm above the floor."""
    at = (np.arange(CELLS) + 0.5) / CELLS * FRAME_CM
    x, y = np.meshgrid(at - FRAME_CM / 2, 180 - at)
    there = (np.abs(x) < 24) & (y > 90) & (y < 145)
    kinds = np.zeros((len(PANEL_KINDS), CELLS, CELLS))
    kinds[KIND[kind]] = 5.0
    return {
        "masks": np.stack([np.where(there, 5.0, -5.0), np.full_like(x, -5.0)]),
        "worn_places": np.stack([x, y, np.zeros_like(x)]) / 100,
        "panel_kinds": kinds,
        "camera_view": np.array([0, 1, 0, np.log(80 / FRAME_CM), 0, 0]),
    }


def test_squares_to_look_at_lie_around_the_parts():
    found = close_squares(looked(), 0, (100, 50, 960), NAMES)
    armholes = {NUMBER["left armhole"], NUMBER["right armhole"]}
    assert set(found) == {NUMBER["neck"], NUMBER["waist"]} | armholes
    pixel = 960 / FRAME_CM
    middles = [found[NUMBER[name]] for name in ("right armhole", "neck", "left armhole")]
    assert np.all(np.diff([left + side / 2 for left, _, side in middles]) > 10 * pixel), "he faces us"
    left, top, side = found[NUMBER["neck"]]
    assert abs(left + side / 2 - (100 + 480)) <= pixel * 4
    assert top < 50 + (180 - 145) * pixel < 50 + (180 - 117) * pixel < top + side
    assert 45 * pixel < side < 70 * pixel
    waist = found[NUMBER["waist"]]
    assert waist[1] > top and waist[2] < 960 * 0.6
    assert close_squares(looked(), 1, (100, 50, 960), NAMES) == {}, "nothing is worn below"
    assert set(close_squares(looked(), 0, (100, 50, 960), ("waist",))) == {NUMBER["waist"]}
    assert close_squares(looked(), 0, (100, 50, 960), ()) == {}
    assert close_squares(looked(), 0, (0, 0, 28), NAMES) == {}, "too few pixels to look nearer"


@pytest.mark.parametrize("seen", [(), ("neck",), ("neck", "waist"), NAMES])
def test_what_is_said_altogether_is_a_mean_of_those_that_tell(seen):
    chance = np.random.default_rng(len(seen))
    told = told_by()
    sizes = {"statements": (len(statement_labels()),), "has": (len(measure_labels()),)}
    sizes |= {"measures": (len(measure_labels()), 2), "panels": (len(PANEL_NAMES),)}
    sizes |= {"boxes": (len(PANEL_NAMES), 5)}

    def answers():
        found = {name: chance.normal(size=(2, *size)) for name, size in sizes.items()}
        return found | {"camera_view": np.zeros(6)}

    whole, near = answers(), {NUMBER[name]: answers() for name in seen}
    found = with_close_looks(whole | {"seams": np.ones(3)}, 1, near)
    np.testing.assert_array_equal(found["seams"], np.ones(3))
    each = [told.statements, told.measures, told.measures, told.panels, told.panels]
    tables = dict(zip(sizes, each, strict=True))
    for name, table in tables.items():
        np.testing.assert_array_equal(found[name][0], whole[name][0])
        for k in range(sizes[name][0]):
            tell = [near[number][name][1, k] for number in near if table[number, k]]
            expected = 0.4 * whole[name][1, k] + 0.6 * np.mean(tell, axis=0) if tell else whole[name][1, k]
            np.testing.assert_allclose(found[name][1, k], expected, atol=1e-12)

"""Size charts and the names of measures."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.body.body_measures import MEASURES
from swifttailor.body.measure_names import FREESEWING, measure_name, parse_measures, read_measures
from swifttailor.body.size_charts import charts, find_size, size_run
from swifttailor.body.wearer import Wearer
from swifttailor.errors import InputError


@pytest.mark.parametrize(
    ("text", "title", "bust"),
    [
        ("44", "women EU 44", 100),
        ("EU 44", "women EU 44", 100),
        ("eu44", "women EU 44", 100),
        ("uk 12", "women UK 12", 92),
        ("12 UK", "women UK 12", 92),
        ("US 8", "women US 8", 92.1),
        ("men 50", "men EU 50", 100),
        ("men's US 40", "men US 40", 101.6),
        ("children 128", "children EU 128", 66),
        ("child UK 8", "children UK 8", 66),
        ("m", "women M", 94),
        ("men XL", "men XL", 114),
        ("2XL", "women XXL", 125),
    ],
)
def test_sizes_are_found_by_what_people_write(text, title, bust):
    size = find_size(text)
    assert (size.title, size.measures["bust"]) == (title, bust)
    assert find_size(size.title) == size


@pytest.mark.parametrize("text", ["", "99", "men 12", "children XL", "UK 44", "forty", "44 46", "EU"])
def test_other_sizes_are_refused_with_those_that_there_are(text):
    with pytest.raises(InputError, match="there are"):
        find_size(text)


def test_charts_grow_in_every_measure():
    for chart in charts().values():
        sizes = list(chart.values())
        for a, b in pairwise(sizes):
            for name in a.measures.keys() & b.measures.keys():
                assert b.measures[name] >= a.measures[name], (a.title, b.title, name)
            assert b.measures["bust"] > a.measures["bust"]


EN_13402_3_WOMEN = {
    "bust": [76, 80, 84, 88, 92, 96, 100, 104, 110, 116, 122, 128],
    "waist": [60, 64, 68, 72, 76, 80, 84, 88, 94, 100, 106, 112],
    "hips": [84, 88, 92, 96, 100, 104, 108, 112, 117, 122, 127, 132],
}
"""The body dimensions of the standard, as they are quoted about it."""


def test_eu_sizes_are_those_of_en_13402_3():
    women, men = charts()["women", "EU"], charts()["men", "EU"]
    assert list(women) == [str(n) for n in range(32, 62, 2)]
    for name, values in EN_13402_3_WOMEN.items():
        assert [size.measures[name] for size in women.values()][: len(values)] == values
    for label, size in men.items():  # half the chest girth, and a drop of 12 cm
        assert (size.measures["bust"], size.measures["waist"]) == (2 * int(label), 2 * int(label) - 12)
        assert "hips" not in size.measures  # left to the likeliest body


def test_hips_of_us_sizes_are_those_of_en_13402_3_beside_the_same_bust():
    """ASTM's own are not public."""
    for size in charts()["women", "US"].values():
        bust, hips = (EN_13402_3_WOMEN[name] for name in ("bust", "hips"))
        expected = np.interp(size.measures["bust"], bust, hips)
        assert size.measures["hips"] == pytest.approx(expected, abs=0.6), size.title


def test_uk_numbers_are_28_less_than_eu_numbers():
    eu, uk = charts()["women", "EU"], charts()["women", "UK"]
    for label, size in uk.items():
        assert size.measures == eu[str(int(label) + 28)].measures


@pytest.mark.parametrize(
    ("text", "labels"),
    [
        ("36-40", ["36", "38", "40"]),
        ("men 46-50", ["46", "48", "50"]),
        ("UK 8 to 12", ["8", "10", "12"]),
        ("S-L", ["S", "M", "L"]),
        ("36,44", ["36", "44"]),
    ],
)
def test_runs_of_sizes(text, labels):
    assert [size.label for size in size_run(text)] == labels


@pytest.mark.parametrize("text", ["46-36", "36-36", "36-99", "S-44"])
def test_no_runs(text):
    with pytest.raises(InputError):
        size_run(text)


@given(st.text(max_size=40))
def test_any_text_is_a_size_or_refused(text):
    try:
        assert find_size(text).title
    except InputError as error:
        assert len(str(error)) < 1500


def test_measures_are_read_with_units_and_other_names():
    assert parse_measures(["chest=96", "height=1720e-1", "waist=30in", "thigh=55cm"]) == pytest.approx(
        {"bust": 96.0, "height": 172.0, "waist": 76.2, "leg_circ": 55.0}
    )


@pytest.mark.parametrize("word", ["bust", "bust=", "bust=abc", "bust=96kg", "girth=90", "=3"])
def test_other_words_are_no_measures(word):
    with pytest.raises(InputError):
        parse_measures([word])


def test_a_slip_of_the_fingers_is_pointed_out():
    with pytest.raises(InputError, match="'waist'"):
        measure_name("wiast")


def test_freesewings_names_are_mapped_where_they_mean_the_same(tmp_path):
    assert set(FREESEWING.values()) <= set(MEASURES)
    path = tmp_path / "me.yaml"
    path.write_text("measurements: {chest: 960, waist: 800, seat: 1010, hips: 900, hpsToBust: 260}")
    found = read_measures(path)
    # FreeSewing's hips lie above the seat: they are not ours.
    assert found == pytest.approx({"bust": 96.0, "waist": 80.0, "hips": 101.0})
    path.write_text("{chest: 96, waist: 80, seat: 101}")
    assert read_measures(path) == pytest.approx({"bust": 96.0, "waist": 80.0, "hips": 101.0})


def test_garmentcodes_file_is_read_but_for_the_pose(tmp_path):
    path = tmp_path / "body.yaml"
    path.write_text("body: {bust: 96, waist: 80, hips: 101, height: 170, arm_pose_angle: 45, back_width: 46}")
    assert read_measures(path) == {"bust": 96.0, "waist": 80.0, "hips": 101.0, "height": 170.0}


@pytest.mark.parametrize(
    "content", ["", "[1, 2]", "{a: 1}", "!!python/object/apply:os.system [ls]", "{bust: x}", "{"]
)
def test_other_files_are_refused(tmp_path, content):
    path = tmp_path / "me.yaml"
    path.write_text(content)
    with pytest.raises(InputError):
        read_measures(path)


def test_measures_outrank_the_size_and_the_body_says_what_it_was_made_for():
    body = Wearer(size="44", measures={"waist": 90.0}).body()
    assert body.measurements.waist == pytest.approx(90.0, abs=0.5)
    assert body.measurements.bust == pytest.approx(100.0, abs=0.5)
    assert body.made_for is not None and dict(body.made_for.measures)["waist"] == 90.0
    assert body.made_for.figure == "women"


def test_a_mesh_and_a_size_are_too_much(tmp_path):
    with pytest.raises(InputError, match="one of them"):
        Wearer(size="44", file=tmp_path / "me.obj").body()
    with pytest.raises(InputError, match="is accepted"):
        Wearer(file=tmp_path / "me.txt").body()

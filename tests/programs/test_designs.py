from __future__ import annotations

import json

import pytest

from swifttailor.errors import InputError
from swifttailor.programs import DESIGN_PARAMETERS, BodyParameters, DesignError, make_pattern, read_design
from swifttailor.programs.design_reader import complete_design

NESTED = """
design:
  meta:
    bottom: {v: Pants, range: [Pants, null], type: select_null}
  pants:
    length:
      v: 0.5
    cuff: {type: {v: null}}
"""


def test_the_table_has_all_parameters_with_defaults_that_are_accepted():
    assert len(DESIGN_PARAMETERS) == 122
    defaults = {name: p.default for name, p in DESIGN_PARAMETERS.items()}
    assert dict(complete_design(defaults)) == defaults == dict(complete_design({}))


def test_every_sampled_design_is_accepted(real_samples):
    designs = [sample["design"] for sample in real_samples("repository")]
    designs += [sample["design"] for sample in real_samples("train", every=50)]
    for design in designs:
        assert list(design) == list(DESIGN_PARAMETERS)
        assert dict(complete_design(design)) == design


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ({"pants.lenght": 0.5}, "no design parameter 'pants.lenght'; did you mean 'pants.length'"),
        ({"pants.length": 3}, "pants.length is '3'; accepted is a number from 0.2 to 0.9"),
        ({"pants.length": float("nan")}, "pants.length is 'nan'"),
        ({"pants.length": True}, "pants.length is 'True'"),
        ({"pants.length": "long"}, "pants.length is 'long'"),
        ({"collar.fc_angle": 95.5}, "accepted is a whole number from 70 to 110"),
        ({"meta.upper": "Coat"}, "accepted is FittedShirt or Shirt or null"),
        ({"sleeve.sleeveless": 1}, "accepted is false or true"),
        ({"sleeve.sleeveless": "x" * 5000}, "accepted is false or true"),
        ({7: 1}, "no design parameter '7'"),
    ],
)
def test_what_is_not_accepted_is_refused_with_what_is(values, text):
    with pytest.raises(DesignError) as refused:
        complete_design(values)
    assert text in str(refused.value) and len(str(refused.value)) < 300


def test_whole_numbers_may_be_written_as_fractions():
    assert complete_design({"collar.fc_angle": 95.0})["collar.fc_angle"] == 95
    assert complete_design({"pants.width": 1})["pants.width"] == 1.0


def test_files_are_read_nested_and_flat(tmp_path):
    expected = {"meta.bottom": "Pants", "pants.length": 0.5, "pants.cuff.type": None}
    nested = tmp_path / "nested.yaml"
    nested.write_text(NESTED)
    assert read_design(nested) == expected
    flat = tmp_path / "flat.json"
    flat.write_text(json.dumps(expected))
    assert read_design(flat) == expected
    flat.write_text(json.dumps({"design": {"meta": {"bottom": {"v": "Pants"}}, "pants.length": 0.5}}))
    assert read_design(flat) == {"meta.bottom": "Pants", "pants.length": 0.5}


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.json", b""),
        ("a.json", b"[]"),
        ("a.json", b"{}"),
        ("a.json", b"\xff\xfe"),
        ("a.json", b"[" * 100_000),
        ("a.json", b'{"a":' * 50 + b"1" + b"}" * 50),
        ("a.json", b'{"pants": {"length": {"v": 99}}}'),
        ("a.json", b'{"pants": {"length": [1, 2]}}'),
        ("a.json", b" " * 1_000_001),
        ("a.yaml", b"a: [b"),
        ("a.yaml", b"!!python/object:os.system {}"),
        ("a.yaml", b"7: {8: {v: 1}}"),
        ("a.yaml", b"a: &a {x: 1}\n" + b"b: *a\n" * 10),
    ],
)
def test_other_files_are_refused(tmp_path, name, content):
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(InputError):
        read_design(path)


def test_groups_named_a_million_times_are_not_followed(tmp_path):
    path = tmp_path / "many.yaml"
    lines = ["a0: &a0 {x: {}}"]
    lines += [f"a{k}: &a{k} {{{', '.join(f'k{i}: *a{k - 1}' for i in range(30))}}}" for k in range(1, 4)]
    path.write_text("\n".join(lines))
    with pytest.raises(InputError, match="more than 200 groups"):
        read_design(path)


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(InputError, match="Cannot read the design"):
        read_design(tmp_path / "none.yaml")


def test_a_file_makes_a_pattern(tmp_path):
    path = tmp_path / "trousers.yaml"
    path.write_text(NESTED)
    pattern = make_pattern(read_design(path))
    assert {p.name for p in pattern.panels} == {"pant_f_r", "pant_f_l", "pant_b_r", "pant_b_l"}


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ({}, "would be empty: meta.upper and meta.bottom are both null"),
        ({"meta.wb": "FittedWB"}, "would be only a waistband"),
        ({"meta.bottom": "Skirt2"}, "skirt.ruffle 1.3) would slide down"),
        ({"meta.bottom": "GodetSkirt", "godet-skirt.base": "Skirt2"}, "would slide down"),
        ({"meta.bottom": "SkirtCircle", "flare-skirt.length": 0.6}, "heavy skirt (flare-skirt.length 0.6"),
        (
            {"meta.bottom": "SkirtLevels", "levels-skirt.base": "SkirtCircle", "levels-skirt.length": 0.8},
            "heavy skirt (levels-skirt.length 0.8",
        ),
        (
            {"meta.upper": "Shirt", "shirt.length": 3.5, "meta.bottom": "Pants", "pants.length": 0.9},
            "shirt.length is 3.5, pants.length is 0.9",
        ),
    ],
)
def test_garments_that_garmentcode_refuses(values, text):
    with pytest.raises(DesignError) as refused:
        make_pattern(values)
    assert text in str(refused.value)


def test_a_waistband_holds_what_would_slide_down():
    belt = {"meta.wb": "FittedWB", "waistband.width": 0.3}
    make_pattern({"meta.bottom": "Skirt2", **belt})
    make_pattern({"meta.bottom": "SkirtCircle", "flare-skirt.suns": 1.0, **belt})


def test_the_body_decides_how_large_it_is():
    usual = BodyParameters.default()
    tall = usual.with_measures(height=usual["height"] + 10)
    assert tall["_leg_length"] == pytest.approx(usual["_leg_length"] + 10)
    design = {"meta.bottom": "PencilSkirt", "pencil-skirt.length": 0.5}
    heights = [height_of(make_pattern(design, body).panel("skirt_front")) for body in (usual, tall)]
    assert heights[1] - heights[0] == pytest.approx(5)


@pytest.mark.parametrize(
    "values", [{"size": 40}, {"_waist_level": 100}, {"waist": -1}, {"waist": float("nan")}]
)
def test_bodies_that_cannot_be_are_refused(values):
    with pytest.raises(InputError):
        BodyParameters.default().with_measures(**values)


def test_a_body_needs_all_measurements():
    with pytest.raises(InputError, match="missing: height"):
        BodyParameters({"waist": 80})


def height_of(panel):
    low, high = panel.bounding_box()
    return high[1] - low[1]


def test_the_default_body_is_garmentcode_s_mean_body(garmentcode_folder):
    from swifttailor.body.measurements import read_measurements

    measured = read_measurements(garmentcode_folder / "body" / "mean_all.yaml")
    usual = BodyParameters.default()
    assert {name: usual[name] for name in measured} == measured

"""The tables of ``scripts/archetypes``: garments that shops sell, as parameters of GarmentCode."""

from __future__ import annotations

import os
import random
import sys
from collections import Counter
from pathlib import Path

import pytest
import yaml

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))

import drawing_archetypes as drawing  # noqa: E402

PARAMETERS = yaml.safe_load(
    Path(__file__).with_name("garmentcode_parameters.yaml").read_text(encoding="utf-8")
)
BEYOND = {"collar.fc_depth": (0, 2), "skirt.length": (-0.2, 0.95)}
"""Where the tables go further than GarmentCode's own sampler, whose crew necks hang on the chest."""


@pytest.fixture(scope="module")
def archetypes():
    return drawing.read_archetypes(SCRIPTS / "archetypes")


@pytest.fixture(scope="module")
def defaults():
    return {path: known["default"] for path, known in PARAMETERS.items()}


def bounds(spread):
    """All that a spread may come to: its options, or its ends."""
    return [*spread] if isinstance(spread, dict) else spread if isinstance(spread, list) else [spread]


def test_there_are_eighty_and_each_has_names_of_its_own(archetypes):
    names = Counter(name.casefold() for kind in archetypes for name in (kind.name, *kind.also))
    assert len(archetypes) >= 80
    assert [name for name, times in names.items() if times > 1] == []


def test_every_parameter_and_value_is_one_of_garmentcode(archetypes):
    for kind in archetypes:
        for path, spread in kind.spreads():
            known, values = PARAMETERS[path], bounds(spread)
            if known["type"] in ("float", "int"):
                low, high = BEYOND.get(path, known["range"])
                assert all(low <= value <= high for value in values), (kind.name, path, spread)
                assert isinstance(spread, dict) or values == sorted(values), (kind.name, path, spread)
                assert known["type"] == "float" or all(isinstance(value, int) for value in values), (
                    kind.name,
                    path,
                )
            else:
                assert all(value in known["range"] for value in values), (kind.name, path, spread)


def test_every_part_is_used():
    parts = yaml.safe_load((SCRIPTS / "archetypes" / "shared.yaml").read_text(encoding="utf-8"))
    tables = (file for file in (SCRIPTS / "archetypes").glob("*.yaml") if file.name != "shared.yaml")
    used = {
        part
        for file in tables
        for entry in yaml.safe_load(file.read_text(encoding="utf-8"))
        for choice in entry.get("take", ())
        for part in (choice if isinstance(choice, dict) else [choice])
    }
    assert parts.keys() - used == set()


def test_each_draw_is_a_garment_with_two_like_sides(archetypes, defaults):
    for kind in archetypes:
        for seed in range(8):
            random.seed(seed)
            design = drawing.complete(kind.draw(), defaults)
            assert design["meta.upper"] or design["meta.bottom"], kind.name
            assert design["left.enable_asym"] == ("one-shoulder" in kind.name), kind.name
            assert design["pencil-skirt.low_angle"] == 0, kind.name  # a hem that slants


def test_gathered_and_heavy_skirts_have_something_to_hang_from(archetypes, defaults):
    """GarmentCode refuses them without a bodice or a waistband that fits, for they slide off."""
    for kind in archetypes:
        for seed in range(8):
            random.seed(seed)
            design = drawing.complete(kind.draw(), defaults)
            if not design["meta.upper"] and design["meta.bottom"] not in ("Pants", "PencilSkirt"):
                held = design["meta.wb"] and design["waistband.waist"] == 1
                base = (design["godet-skirt.base"], design["levels-skirt.base"])
                assert held or "PencilSkirt" in base, kind.name


def test_the_same_seed_draws_the_same_and_another_another(archetypes):
    def drawn(seed):
        random.seed(seed)
        return [kind.draw() for kind in archetypes]

    assert drawn(5) == drawn(5)
    assert drawn(5) != drawn(6)


def test_spreads():
    random.seed(0)
    assert drawing.draw_value(None) is None
    assert drawing.draw_value("VNeckHalf") == "VNeckHalf"
    assert {drawing.draw_value({None: 1, "CuffBand": 3}) for _ in range(50)} == {None, "CuffBand"}
    whole = [drawing.draw_value([3, 8]) for _ in range(200)]
    assert set(whole) == set(range(3, 9)) and all(isinstance(value, int) for value in whole)
    peaked = [drawing.draw_value([0, 0.9, 1]) for _ in range(2000)]
    assert all(0 <= value <= 1 for value in peaked)
    assert sum(peaked) / len(peaked) == pytest.approx((0 + 0.9 + 1) / 3, abs=0.02)


def test_later_parts_win_and_what_is_not_named_stays_the_default(tmp_path):
    (tmp_path / "shared.yaml").write_text("a: {x: 1, y: 1}\nb: {y: 2}\nc: {z: 3}\n")
    (tmp_path / "tops.yaml").write_text("- {name: top, take: [a, {b: 1, c: 0}], design: {x: [4, 4]}}\n")
    (kind,) = drawing.read_archetypes(tmp_path)
    values = kind.draw()
    assert (kind.family, values) == ("tops", {"x": 4, "y": 2})
    defaults = {"x": 0, "y": 0, "z": 9, "left.enable_asym": False, "left.x": 7}
    assert drawing.complete(values, defaults) == defaults | values
    with pytest.raises(KeyError, match="no design parameter w"):
        drawing.complete({"w": 1}, defaults)


def test_an_uneven_garment_has_the_right_side_on_the_left_but_for_what_is_named():
    defaults = {"x": 0, "y": 0, "left.enable_asym": False, "left.x": 7, "left.y": 7, "left.own": 7}
    values = {"x": 1, "y": 2, "left.enable_asym": True, "left.y": 5}
    assert drawing.complete(values, defaults) == values | {"left.x": 1, "left.own": 7}


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ("- {name: top, take: [nowhere]}", "no part named nowhere"),
        ("- {name: top, takes: [a]}", "has \\['takes'\\]"),
        ("- {take: [a]}", "needs a name"),
        ("- {name: top}\n- {name: Top}", "come twice: top"),
    ],
)
def test_what_is_wrong_with_a_table_is_said(tmp_path, table, said):
    (tmp_path / "shared.yaml").write_text("a: {x: 1}\n")
    (tmp_path / "tops.yaml").write_text(table)
    with pytest.raises(ValueError, match=said):
        drawing.read_archetypes(tmp_path)


@pytest.fixture(scope="module")
def sampling():
    """The sampler, prepared with a checkout of GarmentCode in $GARMENTCODE."""
    checkout = os.environ.get("GARMENTCODE")
    if not checkout:
        pytest.skip("set GARMENTCODE to a checkout of GarmentCode, with its requirements installed")
    pytest.importorskip("svgpathtools", reason="GarmentCode's requirements are not installed")
    import sample_garmentcode

    here = os.getcwd()
    sample_garmentcode.prepare(Path(checkout).resolve(), drawing.read_archetypes(SCRIPTS / "archetypes"))
    yield sample_garmentcode
    os.chdir(here)


@pytest.mark.filterwarnings("ignore")  # GarmentCode's own
def test_the_list_of_parameters_is_that_of_the_checkout(sampling, defaults):
    assert dict(sampling.flatten(sampling.given()[0].default())) == defaults


@pytest.mark.filterwarnings("ignore")  # GarmentCode's own
def test_a_seed_gives_one_garment_and_its_name(sampling, archetypes):
    first, again, other = sampling.sample(1), sampling.sample(1), sampling.sample(2)
    assert first["archetype"] in {kind.name for kind in archetypes}
    assert first["id"] == "gc_1" and first["design"] == again["design"] != other["design"]
    assert first["pattern"]["pattern"]["panels"] == again["pattern"]["pattern"]["panels"]

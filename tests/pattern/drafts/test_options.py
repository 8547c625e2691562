from __future__ import annotations

import dataclasses
from types import SimpleNamespace

import pytest

from swifttailor.errors import PatternError
from swifttailor.pattern.drafts import DraftMeasurements, draft, list_drafts


@pytest.mark.parametrize("info", list_drafts(), ids=lambda d: d.name)
def test_every_option_is_declared_in_full(info):
    assert dataclasses.is_dataclass(info.options_class)
    assert info.options_class.__dataclass_params__.frozen  # ty: ignore[unresolved-attribute]
    for field in info.options:
        assert field.option.help.endswith(".")
        if field.kind in (float, int):
            assert field.option.unit
            assert field.option.low <= field.default <= field.option.high


def test_out_of_range_says_option_value_unit_and_range():
    with pytest.raises(PatternError, match=r"'sleeve_length' must be 12 to 74 cm, got 300.*default 22"):
        draft("t-shirt", sleeve_length=300)


@pytest.mark.parametrize("value", [float("nan"), float("inf"), "long", None, True, [1]])
def test_not_a_number_is_refused(value):
    with pytest.raises(PatternError, match="sleeve_length"):
        draft("t-shirt", sleeve_length=value)


@pytest.mark.parametrize(("option", "value"), [("neckline", "boat"), ("neckline", 3), ("neckline", [])])
def test_unknown_choice_names_the_choices(option, value):
    with pytest.raises(PatternError, match="round or v or square or sweetheart"):
        draft("t-shirt", **{option: value})


@pytest.mark.parametrize("value", [1, "yes", None])
def test_a_switch_is_true_or_false(value):
    with pytest.raises(PatternError, match="true or false"):
        draft("hoodie", cuffs=value)


def test_unknown_option_names_the_nearest():
    with pytest.raises(PatternError, match=r"no option 'sleve_lenght'. Did you mean 'sleeve_length'"):
        draft("t-shirt", sleve_lenght=30)


def test_unknown_garment_names_the_nearest():
    with pytest.raises(PatternError, match=r"no draft 'tshirt'. Did you mean 't-shirt'"):
        draft("tshirt")


def test_hyphens_are_underscores():
    assert draft("t-shirt", **{"sleeve-length": 40.0}) == draft("t_shirt", sleeve_length=40)


def test_a_missing_measurement_is_named():
    with pytest.raises(PatternError, match="'height' must be a positive number in cm, got None"):
        draft("t-shirt", measurements=SimpleNamespace())


@pytest.mark.parametrize("value", [0.0, -3.0, float("nan"), float("inf"), "90"])
def test_an_impossible_measurement_is_refused(value):
    with pytest.raises(PatternError, match="'waist' must be a positive number"):
        draft("t-shirt", measurements=dataclasses.replace(DraftMeasurements(), waist=value))

"""The same parameters give the patterns that GarmentCode makes of them.

All training samples are compared by ``python -m benchmarks.garment_programs``.
"""

from __future__ import annotations

import statistics

import pytest

from benchmarks.garment_programs import alike, differences, distance, has_searched_curves
from swifttailor.pattern import read_specification
from swifttailor.programs import make_pattern

EVERY = 60


def pairs(real_samples, wanted):
    for sample in [*real_samples("repository"), *real_samples("train", "train-2", "train-3", every=EVERY)]:
        if has_searched_curves(sample["design"]) == wanted:
            yield sample["id"], make_pattern(sample["design"]), read_specification(sample["pattern"]).pattern


def test_patterns_without_sleeves_and_hoods_are_the_same(real_samples):
    count = 0
    for name, drafted, expected in pairs(real_samples, wanted=False):
        assert differences(drafted, expected) == [], name
        count += 1
    assert count >= 10


def test_patterns_with_sleeves_and_hoods_are_nearly_the_same(real_samples):
    apart, others = [], []
    for name, drafted, expected in pairs(real_samples, wanted=True):
        assert {p.name for p in drafted.panels} == {p.name for p in expected.panels}, name
        if alike(drafted, expected):
            apart.append(distance(drafted, expected))
        else:
            others.append(name)
    assert len(apart) >= 6 and len(others) <= len(apart) / 10, others
    # GarmentCode is as far from itself when it adds up the length of a curve in another order.
    assert statistics.median(apart) < 0.4 and max(apart) < 6


@pytest.mark.parametrize("part", ["SkirtCircle", "Skirt2", "Pants", "SkirtManyPanels", "GodetSkirt"])
def test_drafting_twice_gives_the_same(part):
    design = {"meta.upper": "FittedShirt", "meta.wb": "FittedWB", "meta.bottom": part}
    assert make_pattern(design) == make_pattern(design)

"""What is read without knowing the garment, as the garment can have it."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.measuring import measure_facts
from swifttailor.wishes.instructions.whole_of_kind import of_kind


def gain(name, value):
    return Gain(Claim(name, value))


@pytest.mark.parametrize(
    ("draft", "kind", "read", "meant"),
    [
        ("trousers", "trousers", Step("length", 1), Step("leg length", 1)),
        ("trousers", "trousers", Step("skirt hem", -1, 4.0), Step("leg end", -1, 4.0)),
        ("trousers", "trousers", gain("skirt_hem", "floor"), gain("leg_hem", "full")),
        ("trousers", "trousers", gain("cuffs", "band"), gain("leg_cuffs", "band")),
        ("fitted-skirt", "skirt", Step("leg length", -1), Step("length", -1)),
        ("fitted-skirt", "skirt", Step("thigh", 1), Step("skirt hem", 1)),
        ("fitted-skirt", "skirt", gain("leg_hem", "very short"), gain("skirt_hem", "micro")),
        ("t-shirt", "top", Step("skirt hem", 1), Step("top width", 1)),
        ("t-shirt", "top", gain("leg_hem", "knee"), gain("leg_hem", "knee")),
        ("jumpsuit", "jumpsuit", gain("skirt_hem", "ankle"), gain("leg_hem", "ankle")),
        ("shirt-dress", "dress", Step("length", 1), Step("length", 1)),
        ("shirt-dress", "dress", Step("hood depth", 1), Step("hood depth", 1)),
    ],
)
def test_what_a_garment_lacks_is_read_as_what_it_has_instead(draft, kind, read, meant):
    assert of_kind({read: 0.7}, kind, measure_facts(swifttailor.draft(draft))) == {meant: pytest.approx(0.7)}


def test_what_becomes_the_same_counts_together():
    facts = measure_facts(swifttailor.draft("trousers"))
    found = of_kind(
        {Step("length", -1): 0.5, Step("leg length", -1): 0.4, Step("thigh", 1): 0.1}, "trousers", facts
    )
    assert found == {Step("leg length", -1): pytest.approx(0.7), Step("thigh", 1): pytest.approx(0.1)}

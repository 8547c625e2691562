"""Names of wishes."""

from __future__ import annotations

import pytest

from swifttailor.describing import CLAIM_TYPES, Claim
from swifttailor.describing.differences import QUANTITIES, Gain, Step
from swifttailor.errors import InputError
from swifttailor.wishes.labels import change_of, label_of, number_labels, statement_labels
from swifttailor.wording.wish_lines import wish_line


def test_every_label_names_one_change():
    for label in statement_labels():
        assert label_of(change_of(label)) == label
    for label in number_labels():
        assert label_of(change_of(label, 7.0)) == label
    assert len(set(statement_labels())) == len(statement_labels())
    assert len(set(number_labels())) == len(number_labels())


def test_everything_that_can_be_said_has_a_label():
    said = {label_of(Gain(Claim(t.name, word))) for t in CLAIM_TYPES.values() for word in t.words}
    steps = {label_of(Step(q, d)) for q in QUANTITIES for d in (1, -1)}
    assert said | steps == set(statement_labels())
    measures = {label_of(Gain(Claim(t.name, 3.0))) for t in CLAIM_TYPES.values() if t.measure is not None}
    assert measures | steps == set(number_labels())


@pytest.mark.parametrize("label", ["", "gain", "step:length", "step:length:sideways", "wish:neckline:v"])
def test_other_names_are_refused(label):
    with pytest.raises(InputError, match="There is no"):
        change_of(label)


def test_wishes_in_words():
    assert wish_line(Gain(Claim("skirt_hem", "knee"))) == "where the hem of a dress or skirt ends: knee"
    assert wish_line(Gain(Claim("sleeve_cm", 58.0))).endswith(": 58 cm")
    assert wish_line(Gain(Claim("tiers", 3.0))).endswith(": 3")
    assert wish_line(Step("length", 1, 15.0)).endswith(": more by 15 cm")
    assert wish_line(Step("neck depth", -1)) == "fall of the front neckline from the shoulder: less"


def test_changes_without_a_number_are_made_once():
    for label in statement_labels():
        assert change_of(label) is change_of(label)
        assert label_of(change_of(label)) == label
    with pytest.raises(InputError):
        change_of("measure:sleeve_cm")

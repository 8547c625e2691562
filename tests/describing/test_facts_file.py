"""Facts survive their file."""

from __future__ import annotations

import json

import pytest

from swifttailor.describing import measure_facts
from swifttailor.describing.facts_file import facts_from, facts_values
from swifttailor.pattern.drafts import draft


@pytest.mark.parametrize("name", ["hoodie", "fitted-dress", "jumpsuit", "circle-skirt"])
def test_facts_come_back(name):
    facts = measure_facts(draft(name))
    assert facts_from(json.loads(json.dumps(facts_values(facts)))) == facts


def test_other_values_are_noticed():
    values = facts_values(measure_facts(draft("t-shirt")))
    values.pop("torso")
    with pytest.raises(KeyError):
        facts_from(values)


def test_what_was_kept_before_hips_were_measured_is_read():
    values = facts_values(measure_facts(draft("shift-dress")))
    del values["torso"]["hips"]
    assert facts_from(values).torso.hips is None

"""Instructions: true of the pair they were written for, and of nothing else."""

from __future__ import annotations

import itertools
import re
from dataclasses import replace

import pytest

from swifttailor.describing import Claim, measure_facts
from swifttailor.describing.differences import QUANTITIES, Gain, Step, find_differences
from swifttailor.errors import InputError
from swifttailor.pattern.drafts import draft
from swifttailor.wording.instructions.requests import step_words
from swifttailor.wording.instructions.writer import write_instruction


@pytest.fixture(scope="module")
def some_pairs(draft_facts):
    names = ["t-shirt", "hoodie", "fitted-dress", "shirt-dress", "jumpsuit", "trousers", "circle-skirt"]
    return [(draft_facts[a], draft_facts[b]) for a, b in itertools.permutations(names, 2)]


def test_an_instruction_holds_for_its_pair_and_not_for_a_copy(some_pairs):
    for (before, after), seed in itertools.product(some_pairs, range(5)):
        instruction = write_instruction(before, after, seed)
        assert instruction.holds(before, after), instruction
        assert not instruction.holds(before, before), instruction
        assert not instruction.holds(after, before), instruction


def test_nothing_is_asked_where_nothing_is_seen(draft_facts):
    for facts in draft_facts.values():
        assert find_differences(facts, facts) == ((), ())
        assert write_instruction(facts, facts) is None
        nearly = replace(facts, length=facts.length + 0.5)
        assert write_instruction(facts, nearly) is None


@pytest.mark.parametrize(
    ("options", "other", "pattern"),
    [
        (("t-shirt", {}), {"sleeve_length": 58}, r"sleeves?"),
        (("t-shirt", {}), {"neckline": "v"}, r"\bV\b|round|crew|scoop"),
        (("t-shirt", {}), {"neck_depth": 20}, r"neck|front"),
        (
            ("t-shirt", {}),
            {"chest_ease": 34},
            r"loose|tight|room|chest|oversized|relaxed|fit|snug|let it out",
        ),
        (("circle-skirt", {}), {"length": 95}, r"skirt|length|maxi|ankle|floor"),
        (("hoodie", {}), {"cuffs": False}, r"cuffs?"),
        (("hoodie", {}), {"hem_band": False}, r"band"),
        (("trousers", {}), {"length": 60}, r"legs|length"),
        (("trousers", {}), {"flare": 25}, r"legs?|leg hems"),
        (("circle-skirt", {}), {"band_height": 9}, r"waistband"),
    ],
)
def test_it_speaks_of_what_was_changed(options, other, pattern):
    name, given = options
    before, after = measure_facts(draft(name, **given)), measure_facts(draft(name, **(given | other)))
    for seed in range(12):
        for one, two in ((before, after), (after, before)):
            instruction = write_instruction(one, two, seed)
            assert re.search(pattern, instruction.text, re.IGNORECASE), instruction


def test_amounts_are_those_of_the_pair():
    before, after = (measure_facts(draft("t-shirt", sleeve_length=x)) for x in (22, 42))
    stated = 0
    for seed in range(80):
        instruction = write_instruction(before, after, seed)
        for figure, unit in re.findall(r"(\d+(?:\.\d)?) (cm|inch|inches|in)\b", instruction.text):
            cm = float(figure) * (1.0 if unit == "cm" else 2.54)
            assert cm == pytest.approx(20.0, abs=1.3), instruction
            stated += 1
    assert stated > 5


def test_the_same_seed_asks_the_same_and_others_differ(draft_facts):
    before, after = draft_facts["t-shirt"], draft_facts["hoodie"]
    assert write_instruction(before, after, 3) == write_instruction(before, after, 3)
    assert len({write_instruction(before, after, s).text for s in range(60)}) > 50


def test_texts_are_well_formed(some_pairs):
    for (before, after), seed in itertools.product(some_pairs, range(8)):
        text = write_instruction(before, after, seed).text
        assert text == text.strip() and not re.search(r"[{}@]|  | [,.]|\b[Aa] [aeiou](?!ne\b)", text), text


def test_steps_want_the_right_way_and_the_right_amount(draft_facts):
    facts = draft_facts["t-shirt"]
    sleeve = facts.left_sleeve

    def with_sleeves(length):
        longer = replace(sleeve, length=length)
        return replace(facts, left_sleeve=longer, right_sleeve=longer)

    up, by_ten = Step("sleeve length", 1), Step("sleeve length", 1, 10.0)
    assert up.holds(facts, with_sleeves(sleeve.length + 5))
    assert not up.holds(facts, with_sleeves(sleeve.length - 5))
    assert not up.holds(facts, facts)
    assert by_ten.holds(facts, with_sleeves(sleeve.length + 11))
    assert not by_ten.holds(facts, with_sleeves(sleeve.length + 20))
    assert not up.holds(facts, draft_facts["tank-top"]), "no sleeves are not longer sleeves"


def test_every_quantity_has_words_for_both_ways():
    assert step_words().keys() == {(quantity, way) for quantity in QUANTITIES for way in (1, -1)}
    for (quantity, way), words in step_words().items():
        other = step_words()[quantity, -way]
        assert (words.topic, words.importance) == (other.topic, other.importance), quantity
        assert set(words.texts).isdisjoint(other.texts), quantity
        assert all("{by}" in text for text in words.texts_by)
        assert not any("{by}" in text for text in words.texts)


def test_changes_as_json():
    assert Gain(Claim("hood", "hood")).to_json() == {"gain": {"name": "hood", "value": "hood"}}
    assert Step("length", -1, 5.0).to_json() == {"step": "length", "direction": -1, "amount": 5.0}


def test_unknown_steps_are_refused():
    with pytest.raises(InputError, match="no quantity 'colour'"):
        Step("colour", 1)
    with pytest.raises(InputError, match="up \\(1\\) or down"):
        Step("length", 0)

"""Modest dresses have long sleeves, a high neck and a long skirt, whatever they begin from."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.modest_necks import modest_as_asked
from swifttailor.wording import read_words

LOW = NamedDraft("fitted-dress", (("neck_depth", 13.0), ("neck_widening", 2.0)))


def test_a_modest_one_has_a_high_neck():
    found = dict(modest_as_asked(LOW, read_words("modest evening gown"), []).options)
    assert found["neck_depth"] <= 9.5 and found["neck_widening"] <= -1


@pytest.mark.parametrize(
    ("text", "claims"),
    [
        ("evening gown", []),
        ("modest mini gown with a V neck", [Claim("neckline", "v"), Claim("skirt_hem", "mini")]),
    ],
)
def test_others_keep_theirs(text, claims):
    assert modest_as_asked(LOW, read_words(text), claims) == LOW


def test_its_skirt_covers_the_knees():
    found = modest_as_asked(LOW, read_words("modest office dress"), [])
    assert float(dict(found.options)["skirt_length"]) > 70


@pytest.mark.parametrize("text", ["modest dress", "modest navy dress", "modest midi dress in green"])
def test_a_modest_dress_is_no_kaftan(text):
    [mark] = [mark for mark in read_words(text).marks if mark.role == "garment"]
    assert [draft.name for entry in mark.entries for draft in entry.drafts] == ["skater-dress"]

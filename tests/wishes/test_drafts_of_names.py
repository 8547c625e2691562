"""Drafts for names that the tables give none."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_kinds import DRAFT_KINDS
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.pattern.drafts.options import make_options
from swifttailor.pattern.drafts.registry import find_draft
from swifttailor.wishes.drafts.drafts_of_names import draft_of_kind, draft_of_name
from swifttailor.wording.lexicon import read_words
from swifttailor.wording.lexicon.vocabulary import vocabulary

CUT_AS = {"tunic": "top", "shorts": "trousers", "playsuit": "jumpsuit"}
NAMES = [e for e in vocabulary("en").entries if e.category == "garments" and e.kinds and not e.drafts]


def named(text):
    (entry,) = [e for mark in read_words(text).marks for e in mark.entries if e.category == "garments"]
    return entry


@pytest.mark.parametrize(
    ("text", "kind", "asked", "begun"),
    [
        ("huipil", "dress", [], "shift-dress"),
        ("milkmaid dress", "dress", [], "skater-dress"),
        ("Regency gown", "dress", [], "empire-dress"),
        ("superhero costume", "jumpsuit", [], "jumpsuit"),
        ("gathered dress", "dress", [Claim("shoulders", "strapless")], "strapless-dress"),
        ("tiered dress", "dress", [], "skater-dress"),
        ("backless dress", "dress", [], "skater-dress"),
        ("high low dress", "dress", [], "skater-dress"),
        ("drop waist dress", "dress", [], None),
    ],
)
def test_a_name_begins_from_a_draft_that_has_all_it_means(text, kind, asked, begun):
    found = draft_of_name(named(text), kind, asked)
    assert (found and found.name) == begun


def test_what_a_name_means_is_drafted():
    found = draft_of_name(named("milkmaid dress"), "dress", [])
    assert found is not None
    options = dict(found.options)
    assert options["gathers"] == 2.0
    assert (options["sleeve_shape"], options["sleeves"]) == ("puffed", True)


def test_where_no_name_is_said_a_draft_of_the_kind_has_all_that_is_asked_for():
    bell, floor = Claim("sleeve_shape", "bell"), Claim("skirt_hem", "floor")
    found = draft_of_kind("dress", [Claim("kind", "dress"), bell, floor, Claim("sleeves", "long")])
    assert found is not None and found.name == "skater-dress"
    assert dict(found.options)["sleeve_shape"] == "bell"
    assert draft_of_kind("dress", [Claim("tiers", 3)]) is None, "no such draft has tiers"
    assert draft_of_kind("dress", [Claim("kind", "dress")]) is None, "nothing is told of it"
    assert draft_of_kind("skirt", [floor]) is None and draft_of_kind(None, [floor]) is None


def test_what_is_asked_for_comes_before_what_a_name_means():
    found = draft_of_name(named("milkmaid dress"), "dress", [Claim("sleeves", "none")])
    assert found is not None and "sleeve_shape" not in dict(found.options)


@pytest.mark.parametrize("entry", NAMES, ids=lambda e: e.words[0])
def test_every_draft_of_a_name_can_be_drafted_and_is_of_its_kind(entry):
    for kind in entry.kinds:
        found = draft_of_name(entry, kind, [])
        if found is None:
            continue
        assert isinstance(found, NamedDraft) and DRAFT_KINDS[found.name] == CUT_AS.get(kind, kind)
        assert draft(found.name, **dict(found.options)).panels


def test_drafts_that_tables_name_have_their_options() -> None:
    for entry in vocabulary("en").entries:
        for each in entry.drafts:
            info = find_draft(each.name)
            make_options(info.name, info.options_class, dict(each.options))

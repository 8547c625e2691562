"""Drafts with raglan sleeves, with sleeves cut in one, and with dropped shoulders, from words."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.armholes_as_asked import armholes_as_asked
from swifttailor.wishes.heard import Heard
from swifttailor.wording.lexicon import read_words


def asked(name, text):
    return dict(armholes_as_asked(NamedDraft(name), read_words(text).lacks).options)


@pytest.mark.parametrize(
    ("name", "text", "armhole"),
    [
        ("sweatshirt", "raglan sweatshirt", "raglan"),
        ("coat", "a camel raglan coat", "raglan"),
        ("hoodie", "hoodie with raglan sleeves", "raglan"),
        ("shift-dress", "a dress with raglan sleeves", "raglan"),
        ("sweatshirt", "a sweatshirt with batwing sleeves", "cut-in-one"),
        ("coat", "a coat with kimono sleeves", "cut-in-one"),
        ("t-shirt", "dolman sleeve top", "cut-in-one"),
    ],
)
def test_sleeves_are_joined_as_asked(name, text, armhole):
    options = asked(name, text)
    assert options["armhole"] == armhole
    draft(name, **options)


@pytest.mark.parametrize("name", ["t-shirt", "sweatshirt", "hoodie", "coat", "shift-dress", "robe"])
def test_dropped_shoulders_come_with_room(name):
    options = asked(name, "with dropped shoulders")
    assert options["shoulder_extension"] >= 6.0 and options["armhole_drop"] >= 6.0
    draft(name, **options)


def test_what_is_said_counts_before_what_a_name_means():
    options = asked("coat", "cocoon coat with dropped shoulders")
    assert options["shoulder_extension"] >= 6.0 and "armhole" not in options


def test_drafts_that_cannot_have_it_stay_as_they_are():
    lacks = read_words("raglan").lacks
    for named in (NamedDraft("blazer"), NamedDraft("sweatshirt", (("sleeves", False),))):
        assert armholes_as_asked(named, lacks) == named


@pytest.mark.parametrize(
    ("text", "draft_", "open_"),
    [
        ("raglan sweatshirt", NamedDraft("sweatshirt", (("armhole", "raglan"),)), set()),
        ("raglan sweatshirt", NamedDraft("sweatshirt"), {"raglan"}),
        ("tee with dropped shoulders", NamedDraft("t-shirt", (("shoulder_extension", 7.5),)), set()),
        (
            "tee with dropped shoulders",
            NamedDraft("t-shirt", (("shoulder_extension", 2.0),)),
            {"dropped_shoulder"},
        ),
        ("batwing top", NamedDraft("t-shirt", (("armhole", "cut-in-one"),)), set()),
        ("cocoon coat with dropped shoulders", NamedDraft("coat", (("shoulder_extension", 7.5),)), set()),
    ],
)
def test_what_a_draft_has_is_not_said_to_be_impossible(text, draft_, open_):
    lacks = read_words(text).lacks
    left = {lack.what for lack in Heard(text, lacks=lacks).made_as(draft_).lacks}
    assert left & {"raglan", "cut_in_one", "dropped_shoulder"} == open_


@pytest.mark.parametrize("name", ["tank-top", "shift-dress"])
def test_racerbacks_are_cut_in_where_there_are_no_sleeves(name):
    lacks = read_words("a racerback").lacks
    made = armholes_as_asked(NamedDraft(name), lacks)
    assert dict(made.options)["racer"] and "racerback" in made.shows
    sleeved = NamedDraft("shift-dress", (("sleeves", True),))
    assert armholes_as_asked(sleeved, lacks) == sleeved


def test_wings_are_wide_to_the_eye():
    assert ("sleeve_shape", "wide") in NamedDraft("t-shirt", (("armhole", "cut-in-one"),)).is_to_the_eye


@pytest.mark.parametrize(
    "text", ["batwing top", "batwing jumper", "velvet batwing dress", "baseball tee", "raglan tee"]
)
def test_names_have_drafts_with_such_sleeves(text):
    drafts = [d for mark in read_words(text).marks for entry in mark.entries for d in entry.drafts]
    assert any(dict(d.options).get("armhole") in ("raglan", "cut-in-one") for d in drafts)


def test_saddle_shoulders_are_not_taken_for_raglan():
    assert {lack.what for lack in read_words("a jumper with saddle shoulders").lacks} >= {"saddle"}

"""Dresses whose skirt is laid in pleats."""

from __future__ import annotations

import pytest

from swifttailor import draft
from swifttailor.describing import Claim
from swifttailor.pattern.drafts.draft_names import PLEATED, NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.pleated_dresses import pleats_as_asked
from swifttailor.wishes.reader import WishReader


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("a tennis dress with a pleated skirt part", "skater-dress"),
        ("a gymslip", "pinafore"),
        ("a pinafore with box pleats", "pinafore"),
        ("a pleated dress with long sleeves and a collar", "shirt-dress"),
        ("a strapless pleated maxi dress", "strapless-dress"),
    ],
)
def test_pleated_dresses_are_drafted(reader, text, name):
    heard = hear_description(text, reader)
    first = heard.drafts[0]
    assert first.name == name and PLEATED in first.shows
    assert "pleats" not in heard.made_as(first).cannot


def test_a_close_jersey_dress_keeps_the_flared_skirt_that_its_name_means(reader):
    assert hear_description("tennis dress", reader).drafts[0].name == "skater-dress"


@pytest.mark.parametrize(
    "text", ["a dress with pintucks", "a pencil dress with a kick pleat", "a plain dress"]
)
def test_other_folds_are_no_pleats(reader, text):
    assert not any(PLEATED in d.shows for d in hear_description(text, reader).drafts)


def test_other_drafts_and_close_skirts_stay(reader):
    lacks = hear_description("a pleated dress", reader).lacks
    close = NamedDraft("strapless-dress", (("fitted", True),))
    assert pleats_as_asked(close, lacks, ()) == close
    plain = NamedDraft("skater-dress", (("gathers", 2.0),))
    assert pleats_as_asked(plain, (), ()) == plain
    assert pleats_as_asked(plain, lacks, (Claim("skirt", "pencil"),)) == plain
    assert dict(pleats_as_asked(plain, lacks, ()).options) == {"pleats": 6.0}


@pytest.mark.parametrize(
    "name", ["skater-dress", "shirt-dress", "strappy-dress", "strapless-dress", "pinafore"]
)
@pytest.mark.parametrize("strips", [3, 6])
def test_strips_lie_side_by_side_all_around(name, strips):
    pattern = draft(name, pleats=strips)
    seen = [panel for panel in pattern.panels if panel.name.startswith("skirt_pleat_")]
    assert len(seen) == 2 * strips and "skirt_front" not in [panel.name for panel in pattern.panels]
    assert sum(panel.name.startswith("skirt_under_") for panel in pattern.panels) == 2 * (strips - 1)

"""Sweetheart necklines between shoulders that are covered."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.hearted_drafts import hearted_as_asked
from swifttailor.wishes.reader import WishReader
from swifttailor.wording.lexicon import read_words

HEART = "neckline=sweetheart;neck_widening=4;neck_depth=16"
LACKS = read_words("a sweetheart neckline").lacks


@pytest.mark.parametrize(
    ("named", "claims", "begun"),
    [
        ("fitted-dress(skirt_length=72)", [], f"fitted-dress(skirt_length=72;{HEART})"),
        ("shirt(chest_ease=12;cuffs=true)", [], f"t-shirt(chest_ease=12;{HEART})"),
        ("fitted-dress", [Claim("shoulders", "strapless")], "fitted-dress"),
        ("shirt", [Claim("collar", "lapel")], "shirt"),
        ("coat", [], "coat"),
        (
            "strapless-jumpsuit(flare=4)",
            [Claim("shoulders", "strapless")],
            "strapless-jumpsuit(flare=4;dip=5)",
        ),
    ],
)
def test_a_heart_is_cut_where_shoulders_are_covered(named, claims, begun):
    got, expected = hearted_as_asked(NamedDraft.parse(named), LACKS, claims), NamedDraft.parse(begun)
    assert (got.name, dict(got.options)) == (expected.name, dict(expected.options))


def test_nothing_is_changed_unasked():
    assert hearted_as_asked(NamedDraft("fitted-dress"), (), ()) == NamedDraft("fitted-dress")


def test_its_lobes_lie_above_its_middle():
    front = draft("fitted-dress", neckline="sweetheart", neck_depth=16.0, neck_widening=3.0).panel(
        "left_ftorso"
    )
    outline = front.to_world(front.outline(0.5))
    middle = outline[np.abs(outline[:, 0]) < 0.1][:, 1].max()
    aside = outline[(outline[:, 0] > 3.5) & (outline[:, 0] < 6.0)][:, 1].max()
    assert middle + 2.0 < aside < middle + 8.0


@pytest.mark.parametrize(
    "text", ["blouse with puff sleeves and sweetheart neckline", "long sleeved sweetheart top"]
)
def test_sleeves_are_not_lost_to_it(text):
    heard = hear_description(text, WishReader.load())
    assert Claim("shoulders", "both") in [wish.change.claim for wish in heard.sure]
    assert any("sweetheart" in named.shows for named in heard.drafts)


def test_a_jumpsuit_with_a_straight_edge_has_none():
    assert "sweetheart" in NamedDraft("strapless-jumpsuit", (("dip", 5.0),)).shows
    assert "sweetheart" not in NamedDraft("strapless-jumpsuit").shows


def test_alone_it_is_strapless():
    assert read_words("a sweetheart dress").certainty(Claim("shoulders", "strapless")) == "usual"

"""Sailor collars: from the point of a V to a deep square on the back."""

from __future__ import annotations

import numpy as np
import pytest

import swifttailor
from swifttailor.pattern import check_pattern
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.sailor_collars import with_sailor_collar
from swifttailor.wishes.reader import WishReader

FLAT = "a collar that lies flat"
DRAFTS = ("shirt", "polo-shirt", "shirt-dress", "fitted-dress", "shift-dress", "jumpsuit")


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


@pytest.mark.parametrize("name", DRAFTS)
def test_it_is_square_behind_and_pointed_in_front(name):
    pattern = swifttailor.draft(name, collar="sailor")
    back, front = pattern.panel("left_collar_back"), pattern.panel("left_collar_front")
    neck = pattern.panel("left_btorso")
    shoulder = neck.vertices[:, 0].max()
    low = back.vertices[back.vertices[:, 1] < back.vertices[:, 1].min() + 1e-6]
    across = np.ptp(low[:, 0])
    assert len(low) == 2 and 7.0 < across < shoulder  # a straight lower edge, within the back
    assert np.ptp(back.vertices[:, 1]) > 14.0
    tip = front.vertices[front.vertices[:, 1].argmin()]
    around = front.vertices[np.linalg.norm(front.vertices - tip, axis=1) > 1e-6]
    torso = pattern.panel("left_ftorso")
    # It ends in the middle, where the V of the torso does.
    world = front.to_world(tip[None])[0]
    ends = torso.to_world(torso.vertices)
    world[1] += 5.0  # it is laid so far below, and drawn up
    assert abs(world[0]) < 1e-6 and np.abs(ends[:, :2] - world[:2]).sum(axis=1).min() < 1e-6
    assert around[:, 1].min() > tip[1] + 8.0
    assert not [f for f in check_pattern(pattern) if f.severity.name == "ERROR"]


def test_it_leaves_some_of_the_shoulder_bare():
    pattern = swifttailor.draft("shirt", collar="sailor", hem_opening=0.0)

    collar = max(
        pattern.edge_length(s.first)
        for s in pattern.stitches
        if {side.panel for side in s.sides} == {"left_collar_front", "left_collar_back"}
    )
    torso = [
        pattern.edge_length(s.first)
        for s in pattern.stitches
        if {side.panel for side in s.sides} == {"left_ftorso", "left_btorso"}
    ]
    assert collar < 0.9 * min(torso)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("a sailor blouse", "shirt"),
        ("middy blouse", "shirt"),
        ("navy sailor dress", "shirt-dress"),
        ("a blouse with a sailor collar", "shirt"),
        ("a shift dress with a sailor collar", "shift-dress"),
        ("a jumpsuit with a sailor collar", "jumpsuit"),
        ("ein Kleid mit Matrosenkragen", "shirt-dress"),
        ("eine Bluse mit Matrosenkragen", "shirt"),
        ("une robe à col marin", "shirt-dress"),
        ("vestido con cuello marinero", "shirt-dress"),
    ],
)
def test_words_begin_from_it(text, name, reader):
    heard = hear_description(text, reader)
    draft = heard.drafts[0]
    assert (draft.name, dict(draft.options)["collar"]) == (name, "sailor")
    assert FLAT not in (*heard.made_as(draft).cannot, *heard.made_as(draft).left_out)


def test_the_bow_is_still_left_out(reader):
    heard = hear_description("a sailor blouse", reader)
    assert any("bow" in said for said in heard.made_as(heard.drafts[0]).left_out)


def test_peter_pan_collars_are_rounded_as_before(reader):
    heard = hear_description("a blouse with a Peter Pan collar", reader)
    assert dict(heard.drafts[0].options)["collar"] == "flat"


def test_what_can_have_no_collar_stays():
    assert with_sailor_collar(NamedDraft("circle-skirt")) == NamedDraft("circle-skirt")

"""Tops whose backs are cut in between the shoulder blades."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.pattern.trims.free_edges import armhole_edges
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.armholes_as_asked import armholes_as_asked, one_racer
from swifttailor.wishes.reader import WishReader
from swifttailor.wording.lexicon import read_words


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


LACKS = read_words("a gym vest with a racerback").lacks


@pytest.mark.parametrize(
    ("named", "begun"),
    [
        (
            "tank-top(strap_width=8)",
            {"strap_width": 3.5, "neck_widening": 1.5, "back_neck_depth": 8.0, "racer": True},
        ),
        ("t-shirt", {}),
    ],
)
def test_tank_tops_are_cut_so(named, begun):
    assert dict(armholes_as_asked(NamedDraft.parse(named), LACKS).options) == begun


def test_it_shows_what_is_asked_for():
    made = armholes_as_asked(NamedDraft("tank-top"), LACKS)
    assert "racerback" in made.shows and ("armholes", "angled") in made.is_to_the_eye


def test_little_is_left_between_the_shoulder_blades():
    def least(panel):
        outline = panel.to_world(panel.outline(0.5))
        middle = outline[:, 1].max() - 10.0
        level = outline[np.abs(outline[:, 1] - middle) < 1.5]
        return np.abs(level[np.abs(level[:, 0]) > 1.0][:, 0]).min()

    racer, plain = (draft("tank-top", racer=cut, back_neck_depth=6.0) for cut in (True, False))
    assert least(racer.panel("left_btorso")) < 6.0 < least(plain.panel("left_btorso"))
    assert least(racer.panel("left_ftorso")) == least(plain.panel("left_ftorso"))


@pytest.mark.parametrize("width", [3.0, 3.5, 5.0])
def test_bands_go_all_around_their_armholes(width):
    """The lower part of the armhole behind is an edge of its own."""
    racer = draft("tank-top", racer=True, strap_width=width, neck_widening=1.5, back_neck_depth=8.0)
    assert Counter(ref.panel for ref in armhole_edges(racer)) == {
        "left_btorso": 2, "right_btorso": 2, "left_ftorso": 1, "right_ftorso": 1,
    }  # fmt: skip


@pytest.mark.parametrize("name", ["skater-dress", "bodysuit"])
def test_darted_backs_are_cut_in_as_well_but_for_those_with_sleeves(name):
    def armhole(**options):
        edges = draft(name, **options).panel("left_btorso").edges
        return len(edges)

    assert armhole(racer=True) > armhole() and armhole(racer=True, sleeves=True) == armhole(sleeves=True)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("tennis dress with a racer back", "skater-dress"),
        ("netball dress, racerback", "skater-dress"),
        ("racerback swimsuit", "bodysuit"),
        ("racerback dress", "shift-dress"),
        ("racerback vest", "tank-top"),
    ],
)
def test_what_is_cut_in_keeps_the_skirt_that_its_name_means(text, name, reader):
    first = hear_description(text, reader).drafts[0]
    assert first.name == name and dict(first.options)["racer"] is True


def test_a_word_for_the_back_gives_way_to_a_name():
    named, word = (
        NamedDraft("skater-dress", (("racer", True),)),
        NamedDraft("shift-dress", (("racer", True),)),
    )
    assert one_racer([word, named]) == [named] and one_racer([word]) == [word]


def test_straps_of_a_bodysuit_are_as_wide_as_told_where_its_back_is_cut_in():
    def shoulder(width: float) -> float:
        pattern = draft("bodysuit", sleeves=False, racer=True, strap_width=width, neck_widening=0.0)
        panel = pattern.panel("left_ftorso")
        sewn = [side for one in pattern.stitches for side in one.sides if side.panel == panel.name]
        highest = max(sewn, key=lambda side: float(panel.chord(side.edge)[:, 1].mean()))
        return pattern.edge_length(highest)

    assert shoulder(7.0) - shoulder(4.0) == pytest.approx(3.0, abs=0.5)
    assert shoulder(0.0) == pytest.approx(shoulder(4.0))

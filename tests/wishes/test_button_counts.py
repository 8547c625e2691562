"""How many buttons words ask for."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.trims.button_counts import buttons_stated, closed_as_counted, usual_buttons

STATED = {
    "navy blazer, single button": 1,
    "a one-button blazer": 1,
    "a two-button blazer": 2,
    "tailored waistcoat with four buttons": 4,
    "double-breasted with six buttons": 6,
    "a double-breasted coat, three rows of buttons": 6,
    "a coat with two rows of four buttons": 8,
    "cardigan, 7 small wooden buttons down the front": 7,
    "12 pearl buttons": 12,
    "a duffle coat with three toggles": 3,
    "Blazer mit zwei großen Knöpfen": 2,
    "Zweiknopf-Sakko": 2,
    "colbert met vier knopen": 4,
    "een jasje met één knoop": 1,
    "veste à un bouton": 1,
    "gilet avec cinq boutons": 5,
    "chaqueta de cuatro botones": 4,
    "giacca con tre bottoni": 3,
    "blazer com dois botões": 2,
}
NOT_STATED = (
    "a coat with buttons",
    "two rows of buttons",
    "a shirt with two pockets and buttons",
    "two buttons on each cuff",
    "one button at the neck",
    "five-button fly jeans",
    "a cardigan with 40 buttons",
    "size 12 button-up shirt",
    "one with buttons",
    "une robe à boutons",
    "un vestido con botones",
    "ein Hemd mit Knöpfen",
    "zero buttons",
    "",
)


@pytest.mark.parametrize("text", STATED)
def test_stated(text):
    assert buttons_stated(text) == STATED[text]


@pytest.mark.parametrize("text", NOT_STATED)
def test_not_stated(text):
    assert buttons_stated(text) is None


@pytest.mark.parametrize("count", range(1, 21))
def test_all_from_one_to_twenty_in_figures(count):
    assert buttons_stated(f"a cardigan with {count} button{'s' * (count > 1)}") == count


def test_what_is_usual():
    assert usual_buttons("waistcoat") == 5 and usual_buttons("blazer") in (1, 2)
    assert 5 <= usual_buttons("cardigan") <= 7
    assert usual_buttons("shirt") == usual_buttons("") == 0  # by their length


def test_one_button_closes_a_blazer_at_the_waist():
    blazer = NamedDraft("blazer")
    one = closed_as_counted(blazer, "a blazer with a single button")
    assert dict(one.options)["neck_depth"] > 30.0
    assert closed_as_counted(blazer, "a two-button blazer") == blazer
    deep = NamedDraft("blazer", (("neck_depth", 30.0),))
    assert closed_as_counted(deep, "a blazer with a single button") == deep
    assert closed_as_counted(NamedDraft("coat"), "a coat with a single button") == NamedDraft("coat")

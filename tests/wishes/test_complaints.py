"""What a text tells of other clothes than the one that is wished for."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.reader import WishReader
from swifttailor.wishes.text.complaints import without_complaints


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "left"),
    [
        (
            "every dress I try on rides up, I want a shift dress that stays put",
            "I want a shift dress that stays put",
        ),
        ("everything I try gapes at the bust, a wrap top in green please", "a wrap top in green please"),
        ("everything I own rides up, it clings and it itches, a loose dress", "a loose dress"),
        ("My old jacket makes me look like a sack, so a fitted one please", "a fitted jacket please"),
        (
            "its prom and EVERYONE is getting a corset thing, i want a column dress",
            "its prom and i want a column dress",
        ),
        ("My sister says I should wear stripes, but I would like a navy dress", "I would like a navy dress"),
        ("at home I live in leggings, I want a floaty skirt", "at home I want a floaty skirt"),
        ("everyone wears skinny jeans and I hate them, something loose", "something loose"),
        (
            "I'm tall and every pair of trousers I've ever bought is an ankle swinger. Straight leg",
            "I'm tall and pair of trousers, Straight leg",
        ),
    ],
)
def test_what_tells_of_other_clothes_is_left_out(text: str, left: str) -> None:
    assert without_complaints(text) == left


@pytest.mark.parametrize(
    "text",
    [
        "all my tops are too short, I want one that covers my bum",  # which tells of the length
        "that corset top everyone has",
        "a smoking jacket like my father had, with a shawl collar",
        "My mum has a coat with a hood and I want one like that",
        "everyone at the office wears suits so I need one",
        "The coat should have a hood and everything else is up to you",
        "My daughter says polka dots. We'll see. A swing dress",
    ],
)
def test_what_tells_of_the_wish_stays(text: str) -> None:
    assert without_complaints(text) == text


@given(st.text(max_size=80))
def test_any_text_can_be_read(text: str) -> None:
    assert isinstance(without_complaints(text), str)


def test_a_complaint_about_wrapping_wraps_nothing(reader: WishReader) -> None:
    heard = hear_description("everything I own wraps itself round my legs. I'd love a swing dress", reader)
    assert [draft.name for draft in heard.drafts][:1] == ["swing-dress"]

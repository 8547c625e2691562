"""Necks and collars that differ by a name: boat and jewel necks, collars that stand open in front."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.reader import WishReader


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


def _first(text, reader):
    first = hear_description(text, reader).drafts[0]
    return first, dict(first.options)


@pytest.mark.parametrize(
    "text",
    [
        "dolman sleeve top with a boat neck",
        "a boat neck dress",
        "bateau neck top",
        "a shift dress with a slash neck",
        "a long-sleeved tee with a bateau neckline",
    ],
)
def test_a_boat_neck_is_wide_and_shallow(reader, text):
    _, options = _first(text, reader)
    assert options["neck_widening"] >= 5.5 and options["neck_depth"] <= 8.0


@pytest.mark.parametrize(
    "text",
    ["a jewel neck dress", "blouse with a jewel neckline", "fitted dress, jewel neck, straight skirt"],
)
def test_a_jewel_neck_lies_at_the_base_of_the_neck(reader, text):
    _, options = _first(text, reader)
    assert options["neck_widening"] <= -1 and options["neck_depth"] <= 9.5


@pytest.mark.parametrize(
    ("text", "split"),
    [
        ("nurse tunic with a mandarin collar", True),
        ("mandarin collar dress", True),
        ("a blouse with a Nehru collar", True),
        ("cheongsam", True),
        ("grandad shirt", True),
        ("a top with a high stand collar", False),
        ("funnel neck top", False),
        ("a roll neck dress", False),
    ],
)
def test_a_mandarin_collar_is_open_in_front(reader, text, split):
    first, options = _first(text, reader)
    pattern = draft(first.name, **options)
    ends = {ref.panel for stitch in pattern.stitches for ref in stitch.sides if "collar_front" in ref.panel}
    halves = {"left_collar_front", "right_collar_front"}
    middle = [s for s in pattern.stitches if {ref.panel for ref in s.sides} == halves]
    assert ends and (not middle) is split


@pytest.mark.parametrize(
    ("text", "low", "high"),
    [("mod dress", 34.0, 42.0), ("a 1960s shift dress in orange", 34.0, 42.0), ("a shift dress", 43.0, 99.0)],
)
def test_a_dress_of_the_sixties_ends_in_the_middle_of_the_thigh(reader, text, low, high):
    _, options = _first(text, reader)
    assert low <= options.get("length", 44.0) <= high

"""One slit of several is closed, and a word for cuffs is no word for their size."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.recutting import alter
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.instructions.hearing_changes import hear_instruction
from swifttailor.wishes.reader import WishReader


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


@pytest.fixture(scope="module")
def skirt():
    """With a slit in front and one behind."""
    return alter(swifttailor.draft("fitted-skirt"), [Claim("slit", "back"), Claim("slit", "front")])


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("close the slit in front", ["back"]),
        ("no slit in front please", ["back"]),
        ("remove the front slit", ["back"]),
        ("I don't want the slit at the back", ["front"]),
        ("get rid of the slits", []),
    ],
)
def test_the_other_slit_stays(skirt, reader, text, left):
    heard = hear_instruction(text, reader, skirt.facts)
    after = alter(skirt.pattern, [wish.change for wish in heard.sure], original=skirt.facts)
    assert sorted(slit.place for slit in after.facts.skirt.slits) == left and after.open == ()


def test_a_closed_slit_is_gone_and_not_low(skirt):
    height = next(slit.height for slit in skirt.facts.skirt.slits if slit.place == "front")
    closing = Step("front slit", -1, height)
    lower = alter(skirt.pattern, [Step("front slit", -1, 0.7 * height)]).facts
    assert any(slit.place == "front" for slit in lower.skirt.slits)
    closed = alter(skirt.pattern, [closing]).facts
    assert not closing.holds(skirt.facts, lower) and closing.holds(skirt.facts, closed)


@pytest.mark.parametrize(
    ("text", "name", "deep"),
    [
        ("cargo pants with elastic cuffs", "leg_cuffs", False),
        ("trousers with wide cuffs", "leg_cuffs", True),
        ("shirt with ribbed cuffs", "cuffs", False),
        ("shirt with deep cuffs", "cuffs", True),
    ],
)
def test_cuffs_are_deep_where_it_is_said(reader, text, name, deep):
    heard = hear_description(text, reader)
    meant = {wish.change for wish in (*heard.sure, *heard.likely)}
    assert Gain(Claim(name, "band")) in meant
    assert (Gain(Claim(name, "deep")) in meant) == deep

"""Stripes down sleeves and legs that a text counts."""

from __future__ import annotations

import pytest

from swifttailor.wishes.trims.three_stripes import THREE, three_as_said

ONE = (("side stripes",), ("sleeve stripes",))


@pytest.mark.parametrize(
    "text",
    [
        "track suit, navy, three white stripes down the sleeves",
        "joggers with 3 stripes down the legs",
        "black joggers with a triple stripe",
        "Trainingshose mit drei weißen Streifen",
    ],
)
def test_three_stripes_come_first_and_one_where_there_is_no_room(text):
    assert three_as_said(ONE, text) == ((THREE[0],), (THREE[1],), *ONE)


@pytest.mark.parametrize("text", ["a white stripe down the leg", "three buttons and a stripe", "13 stripes"])
def test_others_stay_one(text):
    assert three_as_said((*ONE, THREE[:1]), text) == ONE

"""Backs that no picture shows."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.tailor.hidden_backs import BACK_DEPTHS, WORN, with_hidden_back
from swifttailor.wishes.reader import Wish

DESIGN = {"collar.fc_depth": 0.6, "collar.bc_depth": 1.2, "left.collar.bc_depth": 0.9, "sleeve.length": 0.4}


def wanted(*faces: str, plain: bool = False, said: tuple[Claim, ...] = ()):
    readings = [SimpleNamespace(face=face, is_plain=plain) for face in faces]
    pictures = tuple(SimpleNamespace(reading=reading) for reading in readings)
    return SimpleNamespace(pictures=pictures, said=tuple(Wish(Gain(claim), 0.97) for claim in said))


@pytest.mark.parametrize("faces", [("front",), ("side",), ("front", "front")])
def test_backs_that_nobody_sees_are_as_people_wear_them(faces):
    design = with_hidden_back(DESIGN, wanted(*faces))
    assert {name: design[name] for name in BACK_DEPTHS} == dict.fromkeys(BACK_DEPTHS, WORN)
    assert {k: v for k, v in design.items() if k not in BACK_DEPTHS} == {
        k: v for k, v in DESIGN.items() if k not in BACK_DEPTHS
    }


@pytest.mark.parametrize(
    "known",
    [
        wanted(),
        wanted("back"),
        wanted("front", "back"),
        wanted("front", plain=True),
        wanted("front", said=(Claim("back_depth", "open"),)),
        wanted("front", said=(Claim("back_neckline", "v"),)),
    ],
)
def test_backs_that_are_seen_or_spoken_of_stay(known):
    assert with_hidden_back(DESIGN, known) == DESIGN


def test_high_backs_stay():
    high = {"collar.bc_depth": 0.1}
    assert with_hidden_back(high, wanted("front")) is high

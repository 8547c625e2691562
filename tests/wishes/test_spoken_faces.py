"""Necklines of which front and back are told apart."""

from __future__ import annotations

import pytest

from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.reader import WishReader
from swifttailor.wishes.text.spoken_faces import spoken_faces


@pytest.mark.parametrize(
    ("text", "claims"),
    [
        ("neckline V in front, round in back", {"neckline": "v", "back_neckline": "round"}),
        ("A round neck in front and a V neck behind", {"neckline": "round", "back_neckline": "v"}),
        ("front neckline square, back neckline round", {"neckline": "square", "back_neckline": "round"}),
        ("high neck in front and open at the back", {"neck_depth": "high", "back_depth": "open"}),
        ("a dress high at the front and low at the back", {}),
        ("V neck front and back", {}),
        ("a V neck in front", {}),
        ("", {}),
    ],
)
def test_each_face_has_its_own(text, claims):
    found = spoken_faces(text)
    assert {claim.name: claim.value for claim in found.claims} == claims
    assert len(found.spans) == len(claims)


def test_what_is_said_of_both_faces_is_asked_for_and_no_contradiction():
    heard = hear_description("a dress with a round neck in front and a v neck behind", WishReader.load())
    asked = {(w.change.claim.name, w.change.claim.value) for w in heard.sure}
    assert {("neckline", "round"), ("back_neckline", "v")} <= asked
    assert ("neckline", "v") not in asked
    assert heard.contradictions == () and heard.unread == ()

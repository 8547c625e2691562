"""Skirts that are to be huge."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.huge_skirts import huge_as_said

DRESS = NamedDraft("strapless-dress", (("skirt_fraction", 0.5),))


@pytest.mark.parametrize(
    "text",
    [
        "prom dress, big poofy skirt to the floor",
        "a ballgown",
        "a dress like a princess",
        "gown whose skirt is huge",
        "wedding dress with a really full skirt",
        "quinceañera dress",
    ],
)
def test_they_are_cut_from_more_than_a_circle(text: str) -> None:
    assert dict(huge_as_said(DRESS, text).options)["skirt_fraction"] == 1.5


@pytest.mark.parametrize(
    "text",
    [
        "prom dress, straight skirt",
        "gown with huge sleeves and a skirt",
        "a dress, no poofy skirt please",
        "tight on top, not like a ball gown",
        "dress with a skirt, big hearts on it",
        "big cats skirt",
    ],
)
def test_others_stay(text: str) -> None:
    assert huge_as_said(DRESS, text) == DRESS


def test_close_and_gathered_skirts_are_no_round_ones():
    close = NamedDraft("strapless-dress", (("fitted", True),))
    assert huge_as_said(close, "a ball gown") == close
    gathered = huge_as_said(NamedDraft("gathered-skirt"), "a huge skirt")
    assert dict(gathered.options)["fullness"] == 3.0


def test_straps_hold_them_up():
    held = dict(huge_as_said(NamedDraft("strappy-dress"), "a ball gown").options)
    assert held["strap_width"] == 3.0 and held["waist_ease"] == 0.0

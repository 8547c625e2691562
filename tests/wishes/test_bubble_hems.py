"""Skirts whose gathered hem is drawn into a band."""

from __future__ import annotations

import pytest

from swifttailor import draft
from swifttailor.describing import Claim
from swifttailor.pattern.drafts.draft_names import PUFFBALL, NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.bubble_hems import bubble_as_asked
from swifttailor.wishes.reader import WishReader


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "name", "length"),
    [
        ("a bubble mini skirt", "gathered-skirt", ("length", 46.0)),
        ("a midi skirt with a bubble hem", "gathered-skirt", ("length", 80.0)),
        ("a bubble hem dress", "skater-dress", ("skirt_length", 50.0)),
        ("a strapless mini dress with a bubble hem", "strapless-dress", ("skirt_length", 46.0)),
        ("a drop waist dress with a bubble hem", "drop-waist-dress", None),
        ("drop waist bubble dress", "drop-waist-dress", ("skirt_length", 50.0)),
        ("a bubble midi skirt", "gathered-skirt", ("length", 80.0)),
        ("a strapless dress with a bubble hem", "strapless-dress", ("skirt_length", 50.0)),
    ],
)
def test_bubble_hems_are_drafted(reader, text, name, length):
    bubble = next(d for d in hear_description(text, reader).drafts if PUFFBALL in d.shows)
    assert bubble.name == name and dict(bubble.options)["hem_band"] == 2.0
    assert length is None or length in bubble.options


def test_no_other_draft_is_changed(reader):
    plain = NamedDraft("gathered-skirt", (("length", 58.0),))
    assert bubble_as_asked(plain, (), ()) == plain
    lacks = hear_description("a bubble skirt", reader).lacks
    pencil = NamedDraft("fitted-skirt")
    assert bubble_as_asked(pencil, lacks, (Claim("skirt_hem", "mini"),)) == pencil


@pytest.mark.parametrize("name", ["gathered-skirt", "skater-dress", "strapless-dress", "drop-waist-dress"])
def test_the_hem_is_drawn_into_a_band(name):
    gathers = "gathers" if name in ("skater-dress", "strapless-dress") else "fullness"
    pattern = draft(name, hem_band=2, **{gathers: 1.6})
    skirt, band = pattern.panel("skirt_front"), pattern.panel("skirt_front_0")
    hem = max(abs(skirt.chord(k)[1, 0] - skirt.chord(k)[0, 0]) for k in range(len(skirt.edges)))
    wide = max(abs(band.chord(k)[1, 0] - band.chord(k)[0, 0]) for k in range(len(band.edges)))
    assert wide < 0.9 * hem
    assert "skirt_front_0" not in draft(name, **{gathers: 1.6}).panels

"""Where close skirts begin to flare, told in figures."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.gored_drafts import gored_as_said
from swifttailor.wishes.text.flare_starts import flare_as_said, flare_figures
from swifttailor.wishes.text.unread import unread_numbers


@pytest.mark.parametrize(
    ("named", "text", "close"),
    [
        ("mermaid-skirt", "flare starting 30 cm above the hem", 66.0),
        ("mermaid-skirt(length=80)", "flaring out 20 cm from the bottom", 60.0),
        ("gored-skirt(length=96)", "the flare begins 10 inches above the hem", 70.6),
        ("mermaid-dress", "flares 10 cm below the knee", 68.0),
        ("mermaid-dress", "flares 10 cm above the knee", 48.0),
        ("mermaid-skirt", "flaring 45 cm below the waist", 45.0),
        ("mermaid-skirt", "with a 20 cm flounce", 76.0),
        ("mermaid-skirt", "flare starting 90 cm above the hem", 30.0),
        ("mermaid-skirt", "a hem 30 cm above the floor", None),
        ("gored-skirt", "panelled skirt, flared, 3 cm below the knee", None),
        ("mermaid-dress(tiers=3)", "flares 10 cm below the knee", None),
        ("circle-skirt", "flare starting 30 cm above the hem", None),
    ],
)
def test_it_flares_where_told(named, text, close):
    assert dict(flare_as_said(NamedDraft.parse(named), text, ()).options).get("close") == close


def test_a_told_length_counts_before_that_of_the_draft():
    said = flare_as_said(
        NamedDraft("mermaid-skirt"), "flared 30 cm above the hem", [Claim("length_cm", 80.0)]
    )
    assert dict(said.options) == {"length": 80.0, "close": 50.0}


def test_such_figures_are_understood():
    text = "trumpet skirt, flare starting 25 cm above the hem"
    assert [text[start:end] for start, end in flare_figures(text)] == ["25 cm"]
    assert unread_numbers(text, ()) == ()


@pytest.mark.parametrize(
    ("text", "claims", "length", "close"),
    [
        ("trumpet skirt, six gores", [], 96.0, 50.0),
        ("trumpet skirt, six gores", [Claim("skirt_hem", "knee")], 60.0, 40.0),
        ("six gores, flared from the knee", [Claim("skirt_hem", "midi")], 78.0, 50.0),
    ],
)
def test_gores_are_as_long_as_their_name_or_a_word_says(text, claims, length, close):
    (gored,) = gored_as_said([NamedDraft("gored-skirt")], text, claims)
    options = dict(gored.options)
    assert (options["length"], options["close"]) == (length, close)
    assert {("skirt", "flared"), ("hips", "close")} <= set(gored.is_to_the_eye)

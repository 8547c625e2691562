"""Yokes, kick pleats, slight flares and nipped waists: what skirts and dresses begin from by words."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.nipped_waists import nipped_as_said
from swifttailor.wishes.drafts.slight_flares import slightly_flared_as_said
from swifttailor.wishes.drafts.yoked_skirts import yoke_as_asked
from swifttailor.wishes.reader import WishReader
from swifttailor.wishes.text.yoke_heights import told_yoke_cm, yoke_figures
from swifttailor.wishes.trims.trims_wanted import trims_wanted


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "name", "options", "trims"),
    [
        ("skirt with a yoke, pleats starting under it", "pleated-skirt", {"yoke": 12.0}, set()),
        ("skirt with a 10 cm yoke and gathers below it", "gathered-skirt", {"yoke": 10.0}, set()),
        ("yoked skirt, knee length, flared", "circle-skirt", {"yoke": 12.0}, set()),
        ("tweed skirt with a kick pleat", "fitted-skirt", {"flare": -2.0}, {"kick pleat"}),
        ("pencil skirt with a kick pleat at the back", "fitted-skirt", {"flare": -7.0}, {"kick pleat"}),
        ("princess line dress, sleeveless", "skater-dress", {"waist_ease": 3.0}, {"princess panels"}),
        ("wrap skirt with a tie at the side", "wrap-skirt", {}, {"hip knot"}),
        ("wrap skirt, tie at waist", "wrap-skirt", {}, {"hip knot"}),
        ("knee length skirt, slightly flared", "fitted-skirt", {"flare": 10.0}, set()),
        ("ein Kleid, der Rock leicht weit", "fitted-dress", {"skirt_flare": 10.0}, set()),
        ("a dress where the skirt is cut on the bias", "fitted-dress", {"skirt_flare": 8.0}, set()),
        ("a dress with the waist high", "empire-dress", {}, set()),
        ("party dress", "skater-dress", {"skirt_fraction": 0.75}, {"sash"}),
        ("dress for work", "fitted-dress", {"sleeves": True}, set()),
        ("dress with a sweetheart neckline", "strapless-dress", {"skirt_length": 66.0}, set()),
        ("skirt with a hip yoke and box pleats below", "pleated-skirt", {"yoke": 12.0, "depth": 6.0}, set()),
        ("Prinzesskleid mit langen Ärmeln", "skater-dress", {"waist_ease": 3.0}, {"princess panels"}),
        ("slightly flared black skirt, knee length", "fitted-skirt", {"flare": 10.0}, set()),
        ("Faltenrock", "pleated-skirt", {"length": 60.0}, set()),
        ("dress with a shallow V neck", "skater-dress", {"neck_depth": 18.0}, set()),
        ("gown, straight across the top, no straps", "strapless-dress", {"dip": 0.0}, set()),
        ("skirt, stretchy", "fitted-skirt", {"flare": 5.0}, {"elastic waist"}),
        ("jersey skirt", "fitted-skirt", {"flare": 4.0, "hip_ease": 6.0}, {"elastic waist"}),
        ("pencil skirt, two back darts", "fitted-skirt", {"hip_ease": 2.5}, set()),
        ("straight skirt, flounce from the knee down", "mermaid-skirt", {"close": 54.0}, set()),
        ("straight skirt with a flounce at the hem", "mermaid-skirt", {"length": 60.0}, set()),
        ("navy dress fitted to the knee, then a big flounce", "mermaid-dress", {"close": 54.0}, set()),
        ("panelled skirt, flared, just below the knee", "gored-skirt", {}, set()),
    ],
)
def test_it_begins_so(text, name, options, trims, reader):
    heard = hear_description(text, reader)
    first = heard.drafts[0]
    assert first.name == name and options.items() <= dict(first.options).items()
    wishes = trims_wanted(heard.made_as(first), first.name, heard.kind or "")
    assert trims <= {trim for wish in wishes for trim in wish.choices[0]}


def test_a_yoke_that_is_cut_is_not_drawn_as_well(reader):
    heard = hear_description("pleated skirt with a hip yoke", reader)
    wishes = trims_wanted(heard.made_as(heard.drafts[0]), "pleated-skirt", "skirt")
    assert "yoke" not in {trim for wish in wishes for choice in wish.choices for trim in choice}


@pytest.mark.parametrize(
    ("text", "height"),
    [
        ("yoke 12 cm deep", 12.0),
        ("a 4 inch hip yoke", 10.16),
        ("yoke: 90 mm", 9.0),
        ("yoke of 40 cm", 20.0),
        ("skirt 60 cm with a yoke", None),
    ],
)
def test_how_high_a_yoke_is_told_to_be(text, height):
    assert told_yoke_cm(text) == (pytest.approx(height) if height else None)
    assert bool(yoke_figures(text)) is (height is not None)


@pytest.mark.parametrize(
    "draft", ["shirt", "pleated-skirt(apron=true)", "gathered-skirt(hem_band=2)", "skater-dress"]
)
def test_others_have_no_yoke(draft):
    named = NamedDraft.parse(draft)
    assert yoke_as_asked(named, {"yoke"}, "with a yoke") == named


@pytest.mark.parametrize(
    "text",
    ["a full skirt", "flared skirt", "sleeves slightly flared, straight skirt", "skirt, a little longer"],
)
def test_what_does_not_flare_slightly_stays(text):
    named = NamedDraft.parse("skater-dress(skirt_fraction=0.4)")
    assert slightly_flared_as_said(named, text) == named


@pytest.mark.parametrize("draft", ["skater-dress(skirt_fraction=1)", "skater-dress(gathers=2)", "trousers"])
def test_full_skirts_stay_full(draft):
    named = NamedDraft.parse(draft)
    assert slightly_flared_as_said(named, "skirt slightly flared") == named


@pytest.mark.parametrize(
    ("text", "close"),
    [
        ("nipped-in waist and a full skirt", True),
        ("close fitting on top", True),
        ("not too tight waist", False),
    ],
)
def test_nipped_waists(text, close):
    named = NamedDraft.parse("skater-dress(bust_ease=8;waist_ease=6)")
    assert (dict(nipped_as_said(named, text).options)["waist_ease"] == 1.5) is close

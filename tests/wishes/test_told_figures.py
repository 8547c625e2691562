"""Figures as customers tell them: laid flat, from a place of the body, one tier after the other."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.corrections.full_hems import shapes_by_figures
from swifttailor.wishes.drafts.measured_legs import legs_as_measured
from swifttailor.wishes.drafts.told_measures import as_told, full_by_figures
from swifttailor.wishes.reader import Wish
from swifttailor.wishes.text.figures_plainly import figures_plainly
from swifttailor.wishes.text.flat_widths import all_around
from swifttailor.wishes.text.spoken_measures import spoken_measures
from swifttailor.wishes.text.tier_heights import listed_tiers, tier_as_said
from swifttailor.wording.lexicon import read_words


def stated(text, kind):
    found = spoken_measures(figures_plainly(text), kind)
    return {m.claim.name: m.claim.value for m in found if m.claim is not None}


@pytest.mark.parametrize(
    ("text", "kind", "claims"),
    [
        ("trousers, 22 cm across the hem", "trousers", {"leg_width_cm": 44}),
        ("trousers with 8 inch hem across", "trousers", {"leg_width_cm": 40.64}),
        ("hem 34 all round", "trousers", {"leg_width_cm": 34}),
        ("wide trousers, hem 60 cm round", "trousers", {"leg_width_cm": 60}),
        ("skirt, 50 cm across the hem", "skirt", {"hem_cm": 100}),
        ("skirt 55 cm wide at the hem, 60 long", "skirt", {"hem_cm": 110, "skirt_length_cm": 60}),
        ("hoodie, 60 cm across the chest, 70 long", "top", {"chest_cm": 120, "length_cm": 70}),
        ("T-shirt pit to pit 50 cm", "top", {"chest_cm": 100}),
        ("finished chest 104 cm", "top", {"chest_cm": 104}),
        ("a skirt that stops 28 inches below the waist", "skirt", {"skirt_length_cm": 71.1}),
        ("a skirt whose yoke sits 5 cm below the waist", "skirt", {}),
        ("a top ending two inches below the waistband", "top", {"length_cm": 39.1}),
        ("trousers ending 5 cm above the ankle", "trousers", {"inseam_cm": 63.5}),
        ("culottes, 75 cm from the waist", "trousers", {"inseam_cm": 43}),
        ("shirt, collar 6 cm, body 80", "top", {"collar_cm": 6, "length_cm": 80}),
        ("hoodie: length 62, cuff 7", "top", {"length_cm": 62, "cuff_cm": 7}),
        ("jacket 28 inches long, sleeve 24", "top", {"length_cm": 71.12, "sleeve_cm": 60.96}),
        ("T-shirt, length 28", "top", {"length_cm": 71.12}),
        ("pencil skirt 60 cm long, 15 cm back vent", "skirt", {"skirt_length_cm": 60, "slit_cm": 15}),
        ("pencil skirt, 6 inch back vent", "skirt", {"slit_cm": 15.24}),
        ("wrap skirt, 50 cm long, ties 90 cm", "skirt", {"skirt_length_cm": 50}),
        ("dress with a 55 cm skirt", "dress", {"skirt_length_cm": 55}),
        ("skirt, hem only 30 cm wider than the hips", "skirt", {"hem_cm": 134}),
        ("falda de 70 cm de largo", "skirt", {"skirt_length_cm": 70}),
        ("gonna a ruota lunga 70 cm", "skirt", {"skirt_length_cm": 70}),
        ("skirt between 60 and 65 cm", "skirt", {"skirt_length_cm": 62.5}),
        ("Tiers 18, 22 and 26 cm. Skirt on elastic.", "skirt", {"tiers": 3, "skirt_length_cm": 66}),
    ],
)
def test_figures_are_heard_as_they_are_meant(text, kind, claims):
    assert stated(text, kind) == pytest.approx(claims, abs=0.1)


def test_what_no_body_goes_through_is_half():
    assert all_around("leg_width_cm", 22.0, "hem 22") == 44.0
    assert all_around("leg_width_cm", 34.0, "hem 34 all round") == 34.0
    assert all_around("leg_width_cm", 22.0, "22 round the ankle") == 22.0
    assert all_around("hem_cm", 300.0, "hem 3 m across") == 300.0
    assert all_around("length_cm", 20.0, "20 across") == 20.0


@pytest.mark.parametrize(
    "text", ["skirt 75 long", 'skirt 26" long', "skirt 70 cm long", "top 18 inches long"]
)
def test_long_beside_a_figure_is_no_length_of_its_own(text):
    assert not any(i.claim.name in ("skirt_hem", "top_hem") for i in read_words(text).implications)


def test_sleeves_of_shirts_are_sold_from_the_nape():
    assert "sleeve 65 cm" in figures_plainly("shirt, collar 16.5, sleeve 34 inches")
    assert figures_plainly("jacket, sleeve 34") == "jacket, sleeve 34"


def test_tiers_that_are_listed():
    assert listed_tiers("tiers of 20, 25 and 30 cm")[0] == (20.0, 25.0, 30.0)
    assert listed_tiers("three tiers, 70 cm long")[0] == ()
    skirt = tier_as_said(NamedDraft("tiered-skirt"), "tiers 18, 22 and 26 cm")
    assert dict(skirt.options) == {"length": 66.0, "tiers": 3, "first": 18.0}


def test_wide_hems_make_full_skirts():
    hem = Claim("hem_cm", 400.0)
    assert full_by_figures("dress", [hem]) == [Claim("skirt", "flared")]
    assert full_by_figures("dress", [Claim("hem_cm", 120.0)]) == []
    gown = as_told(NamedDraft("strapless-dress", (("skirt_length", 99.0),)), [hem])
    assert dict(gown.options)["skirt_fraction"] == pytest.approx(0.5, abs=0.02)
    narrow = as_told(NamedDraft("circle-skirt"), [Claim("hem_cm", 110.0), Claim("skirt_length_cm", 60.0)])
    assert narrow == NamedDraft("fitted-skirt", (("length", 60.0),))
    wishes = [Wish(Gain(claim), 0.9) for claim in (hem, Claim("skirt", "straight"))]
    assert [w.change.claim for w in shapes_by_figures(wishes)] == [hem]


def test_short_tops_and_flares_as_told():
    jumper = as_told(NamedDraft("sweatshirt"), [Claim("top_hem", "cropped"), Claim("length_cm", 45.0)])
    assert dict(jumper.options) == {"length": 11.0}
    flares = legs_as_measured(NamedDraft("flares"), "hem 56 cm, knee 44", [Claim("leg_width_cm", 56.0)])
    assert dict(flares.options) == {"leg_ease": 7.3, "flare": 12.0}

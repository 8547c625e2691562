"""Drafts with slit legs, waistbands that rise behind, straps that cross and trailing sleeves."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.said_details import with_details
from swifttailor.wording import read_words


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("running shorts, split at the sides", "slits"), ("capris with side slits", "slits"),
        ("trousers with slits at the ankles", "slits"), ("jeans with a slit hem", "slits"),
        ("trousers that are higher at the back", "back_rise"),
        ("jeans with a raised back waist", "back_rise"),
        ("a dress with sleeves that hang to the knee", "trailing_sleeves"),
        ("a jacket with a diagonal zip", "asymmetric_closing"), ("a coat with a gun flap", "storm_flap"),
        ("a jacket with reflector strips", "reflective"), ("a tunic, laced at the neck", "lacing"),
        ("sweatpants with a crotch that hangs low", "low_crotch"),
    ],
)  # fmt: skip
def test_words_tell_what_no_claim_does(text, what):
    assert what in {lack.what for lack in read_words(text).lacks if lack.said}


@pytest.mark.parametrize(
    ("name", "lack", "option"),
    [
        ("pull-on-trousers", "slits", "side_slits"), ("jeans", "slits", "side_slits"),
        ("trousers", "back_rise", "back_rise"), ("joggers", "back_rise", "back_rise"),
        ("dungarees", "crossed_straps", "crossed"), ("pinafore", "crossed_straps", "crossed"),
        ("strappy-dress", "crossed_straps", "crossed"), ("camisole", "crossed_straps", "crossed"),
        ("blazer", "shoulder_pads", "shoulder_extension"), ("coat", "huge_shoulders", "shoulder_extension"),
        ("robe", "trailing_sleeves", "sleeve_shape"),
        ("skater-dress", "trailing_sleeves", "sleeve_shape"),
    ],
)  # fmt: skip
def test_drafts_have_them_and_can_be_drafted(name, lack, option):
    plain = NamedDraft(name)
    made = with_details(plain, {lack}, ())
    assert dict(made.options)[option]
    assert lack in ("shoulder_pads", "huge_shoulders") or lack in made.shows
    assert draft(name, **dict(made.options)).panels
    assert with_details(plain, (), ()) == plain


@pytest.mark.parametrize(
    ("named", "braced", "kind"),
    [
        ("trousers(length=92;flare=-7)", "dungarees(bib=false;length=92;flare=-7)", "trousers"),
        ("circle-skirt(fraction=0.5;length=44)", "pinafore(bib=false;length=44)", "skirt"),
        ("fitted-skirt(flare=0)", "pinafore(bib=false;flare=0)", "skirt"),
    ],
)
def test_what_hangs_on_braces_stays_what_it_is(named, braced, kind):
    made = with_details(NamedDraft.parse(named), {"suspenders"}, ())
    assert set(made.options) == set(NamedDraft.parse(braced).options)
    assert made.kind == kind and ("kind", kind) in made.is_to_the_eye and made.shows == ("suspenders",)


def test_sleeves_that_are_asked_to_be_puffed_do_not_trail():
    draft = NamedDraft("skater-dress", (("sleeve_shape", "puffed"), ("sleeves", True)))
    kept = with_details(draft, ["trailing_sleeves"], [Claim("sleeve_shape", "puffed")])
    assert dict(kept.options)["sleeve_shape"] == "puffed"


@pytest.mark.parametrize("which", ["trumpet", "bell", "wide"])
def test_wide_sleeves_to_the_floor_are_of_the_arms_alone(which):
    found = read_words(f"medieval gown with {which} sleeves to the floor")
    assert not any(i.claim == Claim("skirt", "fitted base") for i in found.implications)


def test_loose_dungarees_have_loose_legs():
    made = dict(with_details(NamedDraft("dungarees"), (), {Claim("fit", "loose")}).options)
    assert made["leg_ease"] >= 30.0


@pytest.mark.parametrize(
    "text",
    ["jodhpurs, flared at the thigh and tight below the knee", "trousers, full thighs, close below the knee"],
)
def test_full_thighs_contradict_no_close_legs(text):
    reading = read_words(text)
    assert not reading.contradictions and not reading.unknown
    drafts = [each for mark in reading.marks for entry in mark.entries for each in entry.drafts]
    assert any(dict(each.options).get("bow") for each in drafts)


@pytest.mark.parametrize("words", ["huge shoulders", "massive shoulder pads", "exaggerated shoulders"])
def test_huge_shoulders_are_wider_than_padded_ones(words):
    lacks = {lack.what for lack in read_words(f"an 80s blazer with {words}").lacks if lack.said}
    huge = dict(with_details(NamedDraft("blazer"), lacks, ()).options)
    padded = dict(with_details(NamedDraft("blazer"), {"shoulder_pads"}, ()).options)
    assert 6.0 > huge["shoulder_extension"] > padded["shoulder_extension"]
    assert huge["waist_shaping"] > 3.0

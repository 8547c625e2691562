"""What is to cling is cut smaller, of cloth that stretches, without a seam at the waist."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.clinging_drafts import clinging_as_asked
from swifttailor.wishes.reader import WishReader


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


def stretch(named: NamedDraft) -> float:
    return float(dict(named.options).get("stretch", 0.0))


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("rib knit roll neck dress, midi, skin tight", "shift-dress"),
        ("black bandage dress", "shift-dress"),
        ("tight jersey mini dress with long sleeves", "shift-dress"),
        ("bodycon dress, long sleeves, backless", "fitted-dress"),
        ("bodycon dress, mini, open back", "fitted-dress"),
        ("a wifebeater", "tank-top"),
        ("long line sports bra", "tank-top"),
        ("rash vest", "turtleneck"),
        ("thermal base layer top, slim fit", "t-shirt"),
        ("clingy turtleneck", "turtleneck"),
        ("tight black dress with long sleeves", "shift-dress"),
        ("turtle neck dress, tight, midi", "shift-dress"),
        ("mock neck dress, tight", "shift-dress"),
        ("tight top", "t-shirt"),
        ("eng anliegendes Kleid", "shift-dress"),
    ],
)
def test_words_that_mean_it(text, name, reader):
    first = hear_description(text, reader).drafts[0]
    assert (
        first.name == name and stretch(first) >= 5.0 and dict(first.options).get("waist_shaping", 9.9) >= 2.5
    )


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("bandeau", "bandeau"),
        ("strapless bra", "bandeau"),
        ("bandeau bikini top", "bandeau"),
        ("bra", "camisole"),
    ],
)
def test_what_is_worn_on_the_chest_alone_stretches(text, name, reader):
    first = hear_description(text, reader).drafts[0]
    assert first.name == name and stretch(first) >= 10.0


def test_close_skirts_that_cling_narrow_to_the_hem():
    def slant(named: NamedDraft, option: str) -> float:
        return float(dict(clinging_as_asked(named, []).options)[option])

    assert slant(NamedDraft("fitted-skirt"), "flare") < 0.0
    assert slant(NamedDraft("fitted-skirt", (("flare", 8.0),)), "flare") == 8.0


@pytest.mark.parametrize(
    "text", ["white t-shirt", "close fitting wool dress", "a loose jersey dress", "tight tweed dress"]
)
def test_words_that_do_not(text, reader):
    assert not any(stretch(one) for one in hear_description(text, reader).drafts)


def test_dresses_that_need_a_waist_keep_it():
    dress = NamedDraft("fitted-dress", (("skirt_length", 70.0), ("collar", "rolled")))
    without = clinging_as_asked(dress, [])
    assert without.name == "shift-dress" and dict(without.options)["length"] == 70.0
    assert dict(without.options)["collar"] == "rolled"
    for claim in (Claim("waist_seam", "natural"), Claim("slit", "left"), Claim("skirt", "circle")):
        kept = clinging_as_asked(dress, [claim])
        assert kept.name == "fitted-dress" and stretch(kept) > 0.0


def test_it_is_to_the_eye_what_it_follows():
    tight = clinging_as_asked(NamedDraft("fitted-dress"), [])
    assert ("skirt", "pencil") in tight.is_to_the_eye
    assert ("skirt", "pencil") not in NamedDraft("shift-dress").is_to_the_eye


@pytest.mark.parametrize("name", ["t-shirt", "tank-top", "turtleneck", "shift-dress", "jumpsuit"])
def test_all_of_them_can_be_drafted(name):
    named = clinging_as_asked(NamedDraft(name), [])
    assert draft(named.name, **dict(named.options)).cloth_stretch > 0.0


@pytest.mark.parametrize("name", ["halter-jumpsuit", "strapless-jumpsuit", "strappy-jumpsuit"])
def test_catsuits_have_slim_legs_unless_others_are_asked_for(name):
    slim = clinging_as_asked(NamedDraft(name), [])
    assert dict(slim.options)["leg_ease"] <= 3.0
    assert draft(slim.name, **dict(slim.options)).cloth_stretch > 0.0
    assert "leg_ease" not in dict(clinging_as_asked(NamedDraft(name), [Claim("legs", "wide")]).options)


def test_others_stay_as_they_are():
    assert clinging_as_asked(NamedDraft("coat"), []) == NamedDraft("coat")


def test_sports_tops_end_low_on_the_seat_where_no_length_is_told(reader):
    (first, *_) = hear_description("a compression top with long sleeves", reader).drafts
    assert 25.0 < dict(first.options)["length"] < 30.0
    (bra, *_) = hear_description("a sports bra", reader).drafts
    assert bra.name == "tank-top" and dict(bra.options)["length"] < 0.0


def test_fitted_t_shirts_end_at_the_hip_and_baby_tees_at_the_waist(reader):
    lengths = [
        dict(hear_description(text, reader).drafts[0].options).get("length", 22.0)
        for text in ("a men's fitted T-shirt", "a slim fit tee", "a baby tee")
    ]
    assert lengths == [22.0, 22.0, 6.0]

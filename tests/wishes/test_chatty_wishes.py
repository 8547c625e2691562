"""Wishes with reasons, complaints, comparisons and other people in them, and what is heard of these."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.heard_drafts import drafts_of
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.outfits.named_again import told_behind_names
from swifttailor.wishes.outfits.two_garments import two_garments
from swifttailor.wishes.reader import WishReader
from swifttailor.wishes.text.mentions import find_mentions


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


def _sure(heard: Heard) -> set[str]:
    claims = [w.change.claim for w in heard.sure if isinstance(w.change, Gain)]
    return {f"{claim.name}={claim.value}" for claim in claims}


@pytest.mark.parametrize(
    ("text", "sure", "not_meant"),
    [
        ("My husband says I dress like a librarian. A navy skirt, straight", "kind=skirt", "kind=dress"),
        ("a dress to the calf and no elastic round the neck", "kind=dress", "neck_depth=high"),
        ("a party dress with a bow at the back", "kind=dress", "slit=back"),
        ("an A-line skirt with patch pockets at the front", "skirt=a-line", "slit=front"),
        ("shorts that are longer than hot pants", "leg_hem=mid-thigh", "leg_hem=very short"),
        ("a jumper with a high neck that folds over", "collar=turtleneck", ""),
        ("the trousers should have room at the knee", "kind=trousers", "leg_hem=knee"),
        ("a tunic with slits at both sides, long sleeves, to the knee", "skirt_hem=knee", "kind=tunic"),
        ("sleeveless but not with thin straps, a summer dress", "sleeves=none, straps=wide", "straps=narrow"),
        ("I never wear skirts but I would like a long one, satin", "kind=skirt, skirt_hem=maxi", ""),
        ("I'd prefer a collar to a hood. A fleece jacket", "hood=none", "hood=hood"),
        ("one-shoulder top, the strap on the left", "shoulders=bare right", "shoulders=bare left"),
        ("tracksuit bottoms, no elastic at the bottom, straight leg", "leg_cuffs=none", "leg_cuffs=band"),
        ("black top, sleeves tight to the elbow and then wide", "sleeve_shape=bell, sleeves=long", ""),
        ("My aunt made me a dress and it is too big. I want a close one", "fit=close", "fit=oversized"),
        ("I look like a sausage in anything tight. Loose dress, V neck", "fit=loose", "fit=close"),
        ("can't bear labels or anything tight. Soft T-shirt", "kind=top", "fit=close"),
        ("I don't like things that cling. Loose tank top", "fit=loose", "fit=close"),
        ("if it has a collar I won't wear it. White shirt", "collar=none", ""),
        ("a dress with a square neckline, three-quarter sleeves", "neckline=square", "neck_depth_cm=3.0"),
        ("a dress, floor length, short puffed sleeves", "skirt_hem=floor, sleeves=short", ""),
        ("my legs are short so wide trousers, to the floor", "leg_hem=full", "leg_hem=calf"),
        ("any length but short, any sleeve but long. A dress", "kind=dress", "skirt_hem=mini, sleeves=long"),
        ("my knees are ugly. A dress, a-line", "skirt_hem=below the knee", ""),
        ("pencil skirt, 64 cm, two back darts", "kind=skirt", "kind=dress"),
        ("a dress with no shoulders but with sleeves", "kind=dress, collar=none", "neckline=v"),
        (
            "a cardigan I can wear in the office when the air con is on, V neck",
            "kind=top",
            "kind=dress",
        ),
        ("a jumpsuit you can go to work in, wide legs", "kind=jumpsuit", ""),
        ("long enough to sit down in: a denim skirt", "kind=skirt", "skirt_hem=maxi"),
        ("I'd rather wear trousers but it has to be a skirt, long", "skirt_hem=maxi", "leg_hem=full"),
        ("not a turtleneck but not a V either. A jumper", "kind=top", "neckline=asymmetric"),
        ("dress with a heart shaped top, straps", "kind=dress", "neckline=v"),
        (
            "every skirt in the shops has a slit. I want a black one, midi",
            "skirt_hem=midi",
            "slit=left",
        ),
        ("boyfriend says I look good in green, so a green wrap dress", "neckline=v", "fit=oversized"),
        ("jumper, V neck, nothing that clings to my back", "neckline=v", "fit=close"),
        ("dress, no sleeves, collar or belt, red", "sleeves=none, collar=none", "collar=lapel"),
        ("not skinny, flared or cropped, just jeans", "kind=trousers", "legs=flared, leg_hem=calf"),
        ("I don't want anything short, tight or low. A dress", "kind=dress", "fit=close, skirt_hem=mini"),
        ("a skirt, not too tight, midi or long", "skirt_hem=midi", "skirt_hem=maxi"),
        ("as loose as a nightie but smart, a dress", "fit=loose", "sleeves=short"),
        ("no collar or cuffs, a white shirt", "collar=none, cuffs=none", "cuffs=band"),
        ("a dress with no sleeves, collar and cuffs white", "sleeves=none, collar=lapel", ""),
        ("Top, boat neck, sleeves between my elbow and my wrist", "kind=top, sleeves=three-quarter", ""),
        (
            "bodice: two darts in the back, neckline square 12 cm deep",
            "neck_depth_cm=12.0",
            "back_depth_cm=12.0",
        ),
        ("the coat was long and had big buttons", "skirt_hem=maxi", "fit=oversized"),
        ("a skirt with gathers only at the back", "skirt=gathered", "hem_shape=high-low"),
        ("my arms are too fat for cap sleeves so elbow length ones, a dress", "sleeves=elbow", "sleeves=cap"),
        ("he is getting married in a kilt, so a waistcoat, grey", "kind=top", "kind=skirt"),
        (
            "could the back be lower than the front? An evening dress, long sleeves",
            "sleeves=long",
            "sleeve_shape=bell",
        ),
    ],
)
def test_is_heard(reader, text, sure, not_meant):
    found = _sure(hear_description(text, reader))
    assert set(sure.split(", ")) <= found
    assert found.isdisjoint(not_meant.split(", "))


@pytest.mark.parametrize(
    "text",
    [
        "a jacket without lapels, round neck, buttons to the top, short",
        "long coat, big collar, like a dressing gown but for outside",
        "long coat, like a dressing gown",
        "light jacket for spring, waterproof, to the hip, zip",
        "dress with a full skirt, fitted on top",
        "our choir wears black trousers and I need a top in royal blue",
        "I need a coat with a hood that stays up",
    ],
)
def test_is_one_garment(text):
    assert two_garments(text) is None


@pytest.mark.parametrize(
    ("text", "upper", "lower"),
    [
        (
            "skirt and blouse, the blouse white with a frill, the skirt navy and to the knee",
            "blouse white with a frill",
            "skirt navy and to the knee",
        ),
        ("black polo neck, black slim trousers", "black polo neck top", "black slim trousers"),
        ("I would like a jacket over a dress", "I would like a jacket", "a dress"),
        ("football shorts and shirt, blue", "football shirt, blue", "football shorts, blue"),
    ],
)
def test_are_two_garments(text, upper, lower):
    found = two_garments(text)
    assert found is not None and (found.upper, found.lower) == (upper, lower)


def test_what_is_told_afterwards_stands_behind_its_name():
    text = "A dress and a bolero in blue, the dress to the knee"
    assert told_behind_names(text) == "A dress to the knee, and a bolero in blue"
    for other in ("a dress and a bolero, both blue", "a top and trousers, the hem plain", "the dress"):
        assert told_behind_names(other) == other


def test_three_quarters_are_no_number():
    assert not find_mentions("three-quarter sleeves") and not find_mentions("three quarters long")
    assert [each.value for each in find_mentions("three tiers")] == [3.0]


@pytest.mark.parametrize(
    ("text", "draft", "option"),
    [
        ("leggings, full length", "leggings", ("length", 101.0)),
        ("trousers tight at the hip, wide at the foot", "flares", None),
        ("not cropped, straight black trousers", "trousers", ("length", 102.5)),
        ("straight down dress, no waistband, no waist", "shift-dress", None),
    ],
)
def test_begins_from(reader, text, draft, option):
    named = drafts_of(hear_description(text, reader))[0]
    assert named.name == draft
    assert option is None or option in named.options


@pytest.mark.parametrize(
    ("text", "colors"),
    [
        ("I won't wear orange, brown or mustard. A jumper", []),
        ("no red, pink or purple. A skirt to the knee", []),
        ("a coat, not black, navy", ["navy"]),
        ("collar, white on a dark blue dress", ["dark blue"]),
    ],
)
def test_colors_that_are_refused(reader, text, colors):
    words = hear_description(text, reader).words
    assert words is not None and [color.words for color in words.colors] == colors


def test_a_colour_goes_without_the_print_of_a_guess(reader):
    assert hear_description("for the summer a white skirt", reader).guess in ("", "skirt")
    assert hear_description("skirt, summery", reader).guess == "floral skirt"


def test_a_refused_waist_seam_is_not_guessed(reader):
    heard = hear_description("a dress, no waist seam, straight, mid calf", reader)
    likely = [w.change.claim for w in heard.likely if isinstance(w.change, Gain)]
    assert Claim("waist_seam", "natural") not in likely

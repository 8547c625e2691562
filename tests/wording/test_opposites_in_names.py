"""Names of garments that other words of a text speak against, and those that only sound so."""

from __future__ import annotations

import pytest

from swifttailor.wording.lexicon import read_words


def told(text: str) -> list[tuple[str, str]]:
    return [(pair.first.word, pair.second.word) for pair in read_words(text).contradictions]


@pytest.mark.parametrize(
    ("text", "pair"),
    [
        ("pleated skirt without any pleats", ("pleated skirt", "pleats")),
        ("gathered skirt, no gathers", ("gathered skirt", "gathers")),
        ("belted dress, no belt", ("belted", "belt")),
        ("zip hoodie without a zip", ("zip hoodie", "zip")),
        ("ankle-length hot pants", ("ankle-length", "hot pants")),
        ("ankle-length shorts", ("ankle-length", "shorts")),
        ("narrow very full skirt", ("narrow", "full skirt")),
        ("tight baggy trousers", ("tight", "baggy trousers")),
        ("a tight, very full skirt", ("tight", "full skirt")),
        ("skirt, tight but very wide", ("tight", "very wide")),
        ("cropped floor length trousers", ("cropped", "floor length trousers")),
        ("floor-length crop top", ("floor-length", "crop top")),
        ("V-neck turtleneck", ("V-neck", "turtleneck")),
        ("cropped longline cardigan", ("cropped", "longline cardigan")),
        ("pocketless trousers with pockets", ("pocketless", "pockets")),
        ("a tight tent dress", ("tight", "tent dress")),
        ("a fitted trapeze dress", ("fitted", "trapeze dress")),
        ("crop top that reaches the knees", ("crop top", "knees")),
        ("knee-length crop top", ("knee-length", "crop top")),
        ("cropped jumper to the ankles", ("cropped", "to the ankles")),
        ("floor-length mini", ("floor-length", "mini")),
        ("shorts to the ankle", ("shorts", "to the ankle")),
        ("gathered skirt with no fullness", ("gathered skirt", "fullness")),
        ("V neck jumper with no neckline", ("V neck jumper", "neckline")),
    ],
)
def test_what_speaks_against_a_name_is_told_once(text, pair):
    assert told(text) == [pair]


@pytest.mark.parametrize(
    "text",
    [
        "pleated skirt, no pleats at the front",
        "button down shirt, no buttons on the cuffs",
        "tight at the waist, full skirt",
        "straight boyfriend jeans",
        "tight top, full skirt",
        "slim but wide at the bottom trousers",
        "a fitted top with a loose cowl",
        "cropped jumper over a longline vest",
        "langer Mantel, schmal geschnitten, mit breitem Revers",
        "midi skirt with shorts",
        "crop top and a skirt to the knee",
        "a swing dress, fitted at the bust",
        "langes Kleid, oben eng, unten weit",
        "vestido ajustado arriba, amplio abajo",
    ],
)
def test_what_is_true_of_one_place_or_of_a_part_contradicts_nothing(text):
    assert told(text) == []


def test_an_adjective_before_a_name_is_still_said_of_the_garment():
    loose = [i.claim.value for i in read_words("loose cowl neck jumper").implications if i.said]
    assert loose == ["loose"]


@pytest.mark.parametrize("text", ["sweatpant", "a jogging pant", "a legging", "yoga pant"])
def test_one_of_a_pair_is_the_pair(text):
    reading = read_words(text)
    assert not reading.unknown
    assert "trousers" in {i.claim.value for i in reading.implications}


@pytest.mark.parametrize("text", ["a tight tent dress", "skin-hugging trapeze dress", "fitted muumuu"])
def test_what_stands_off_by_its_name_stays_so(text):
    assert "close" not in [i.claim.value for i in read_words(text).implications]


@pytest.mark.parametrize("text", ["knee-length crop top", "a crop top to the knee"])
def test_a_crop_top_stays_one(text):
    claims = {(i.claim.name, i.claim.value) for i in read_words(text).implications}
    assert ("kind", "top") in claims and "skirt_hem" not in dict(claims)

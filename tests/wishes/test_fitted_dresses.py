"""Fitted dresses, wide straps and skirts that flare at the hem, from words to drafts."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.fitted_dresses import fitted_as_asked
from swifttailor.wishes.drafts.held_drafts import held_as_asked
from swifttailor.wishes.reader import WishReader

CLOSE, STRAIGHT, WIDE = Claim("fit", "close"), Claim("skirt", "straight"), Claim("straps", "wide")
SQUARE = Claim("neckline", "square")


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


@pytest.mark.parametrize(
    ("named", "told", "likely", "name"),
    [
        ("skater-dress(skirt_length=62)", [CLOSE], [STRAIGHT], "fitted-dress"),
        ("skater-dress", [CLOSE], [], "skater-dress"),
        ("skater-dress", [], [STRAIGHT], "skater-dress"),
        ("skater-dress", [CLOSE, Claim("skirt", "flared")], [STRAIGHT], "skater-dress"),
        ("skater-dress", [CLOSE, Claim("waist_seam", "natural")], [STRAIGHT], "skater-dress"),
        ("skater-dress(gathers=2)", [CLOSE], [STRAIGHT], "skater-dress"),
        ("shift-dress", [CLOSE], [STRAIGHT], "shift-dress"),
    ],
)
def test_a_fitted_dress_is_narrow_down_to_its_hem(named, told, likely, name):
    got = fitted_as_asked(NamedDraft.parse(named), told, likely)
    assert got.name == name
    if name == "fitted-dress":
        assert dict(got.options)["skirt_flare"] < 0 < dict(got.options)["skirt_length"]
        draft(got.name, **dict(got.options))


def test_a_fitted_strapless_dress_has_a_close_skirt():
    options = dict(fitted_as_asked(NamedDraft("strapless-dress"), [CLOSE], [STRAIGHT]).options)
    assert options == {"fitted": True, "skirt_flare": 1.0}


@pytest.mark.parametrize(
    ("told", "name"),
    [
        ([WIDE], "strappy-dress"),
        ([WIDE, SQUARE], "strappy-dress"),
        ([WIDE, SQUARE, Claim("sleeves", "none")], "strappy-dress"),
        ([WIDE, Claim("neckline", "v")], "skater-dress"),
        ([WIDE, Claim("sleeves", "short")], "skater-dress"),
        ([SQUARE], "skater-dress"),
    ],
)
def test_wide_straps_have_a_straight_edge_between_them(told, name):
    held = held_as_asked(NamedDraft("skater-dress"), told)
    assert held.name == name
    if name == "strappy-dress":
        assert dict(held.options)["dip"] == 0.0 and dict(held.options)["strap_width"] > 5.0
        assert {("straps", "wide"), ("neckline", "square")} <= set(held.is_to_the_eye)


@pytest.mark.parametrize(
    ("text", "name", "options"),
    [
        ("pencil skirt that flares out at the hem", "mermaid-skirt", {"close": 41.0}),
        ("pencil skirt with a frill at the hem", "mermaid-skirt", {"close": 41.0}),
        ("tight dress with a ruffle at the bottom", "mermaid-dress", {"close": 41.0}),
        ("fitted midi dress with a flared hem", "mermaid-dress", {"skirt_length": 80.0}),
        ("50s dress, wide straps, full skirt, cherries", "strappy-dress", {"skirt_fraction": 1.0}),
        ("mini skirt with ruffle at the bottom", "circle-skirt", {}),
        ("a skirt that spins when I twirl around", "circle-skirt", {"fraction": 1.0}),
        ("dress with a skirt that sticks right out", "skater-dress", {"skirt_fraction": 1.5}),
        ("dress tight under the bust and loose to the floor", "empire-dress", {"skirt_flare": 60.0}),
        ("strapless dress, tight on top and full in the skirt", "strapless-dress", {"skirt_fraction": 1.0}),
        ("flapper dress", "drop-waist-dress", {"fullness": 1.0}),
        ("sundress with thick straps and a sweetheart neck", "skater-dress", {"neckline": "sweetheart"}),
        ("cheongsam", "shift-dress", {"collar": "mandarin"}),
    ],
)
def test_words_begin_from_such_drafts(reader, text, name, options):
    first = hear_description(text, reader).drafts[0]
    assert first.name == name and dict(first.options).items() >= options.items()
    draft(first.name, **dict(first.options))


@pytest.mark.parametrize(
    ("text", "claim"),
    [
        ("A-line skirt to just under the knee", "skirt_length_cm"),
        ("dress, hem just below the knee", "length_cm"),
    ],
)
def test_just_under_the_knee_is_no_calf_length(reader, text, claim):
    heard = hear_description(text, reader)
    told = [w.change.claim for w in heard.sure]
    assert any(each.name == claim for each in told) and Claim("skirt_hem", "below the knee") in told
    assert not any("knee" in word for word in heard.unread)

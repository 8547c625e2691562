"""Necklines as they are asked for: close to the neck, round, a V that is seen for one, or plunging."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.necks_as_asked import neck_as_asked
from swifttailor.wishes.reader import WishReader

ROUND, CREW, V = Claim("neckline", "round"), Claim("neckline", "crew"), Claim("neckline", "v")
HIGH, PLUNGING = Claim("neck_depth", "high"), Claim("neck_depth", "plunging")
SQUARE, TEN = Claim("neckline", "square"), Claim("neck_depth_cm", 10.0)
LOW = Claim("neck_depth", "low")
OPEN_BACK, EIGHT, TWENTY = (
    Claim("back_depth", "open"),
    Claim("neck_depth_cm", 8.0),
    Claim("neck_depth_cm", 20.0),
)


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


@pytest.mark.parametrize(
    ("named", "claims", "begun"),
    [
        ("t-shirt", [CREW], "t-shirt(neck_widening=-1.2;neck_depth=9.5;back_neck_depth=2.5)"),
        ("sweatshirt", [ROUND, HIGH], "sweatshirt(neck_widening=-1.2;neck_depth=9.5)"),
        ("empire-dress", [CREW], "empire-dress(neck_depth=9.5)"),
        ("fitted-dress", [CREW, OPEN_BACK], "fitted-dress(neck_widening=-1.2;neck_depth=9.5)"),
        ("fitted-dress", [ROUND], "fitted-dress(neck_widening=0;neck_depth=11)"),
        ("fitted-dress", [ROUND, EIGHT], "fitted-dress(neck_widening=0)"),
        ("fitted-dress", [ROUND, TWENTY], "fitted-dress"),
        ("fitted-dress", [ROUND, Claim("neckline", "scoop")], "fitted-dress"),
        ("sweatshirt(neck_widening=3)", [ROUND], "sweatshirt(neck_widening=3)"),
        ("skater-dress", [V], "skater-dress(neckline=v;neck_widening=0;neck_depth=18)"),
        ("jumpsuit", [V, TWENTY], "jumpsuit(neckline=v;neck_depth=25)"),
        ("skater-dress", [SQUARE, TEN], "skater-dress(neckline=square;neck_depth=15)"),
        ("skater-dress", [SQUARE, TWENTY], "skater-dress"),
        ("skater-dress", [TEN], "skater-dress(neck_depth=15)"),
        ("tank-top", [SQUARE, TEN], "tank-top"),
        ("jumpsuit", [V, LOW], "jumpsuit(neckline=v;neck_widening=0.5;neck_depth=22)"),
        ("skater-dress", [HIGH], "skater-dress(neck_widening=-1.2;neck_depth=9.5;back_neck_depth=2.5)"),
        ("jumpsuit", [V, PLUNGING], "jumpsuit(neckline=v;neck_widening=1;neck_depth=31)"),
        ("fitted-dress", [ROUND, PLUNGING], "fitted-dress"),
        ("fitted-dress(collar=standing)", [CREW], "fitted-dress(collar=standing)"),
        ("t-shirt", [CREW, Claim("hood", "hood")], "t-shirt"),
        ("trousers", [CREW], "trousers"),
    ],
)
def test_a_neck_is_cut_as_it_is_asked_for(named, claims, begun):
    got, expected = neck_as_asked(NamedDraft.parse(named), claims), NamedDraft.parse(begun)
    assert (got.name, dict(got.options)) == (expected.name, dict(expected.options))


@pytest.mark.parametrize(
    ("text", "names", "options"),
    [
        ("robe col rond assez haut", ("skater-dress",), {"neck_widening": -1.2}),
        ("top with a close round neck", ("t-shirt",), {"neck_widening": -1.2}),
        ("crewneck", ("sweatshirt",), {}),
        ("crew neck t-shirt", ("t-shirt",), {"neck_widening": -1.2}),
        ("t-shirt with a really low back", ("t-shirt",), {"back_neck_depth": 31.0}),
        ("dress with a super low back", ("skater-dress",), {"back_neck_depth": 38.0}),
        (
            "dress with a huge stand-up collar",
            ("shirt-dress",),
            {"collar": "mandarin", "collar_height": 11.0},
        ),
        ("gown with a vampire collar", ("shirt-dress",), {"collar": "mandarin", "collar_height": 11.0}),
        ("gown with a high standing collar", ("shirt-dress",), {"collar": "standing", "collar_height": 7.5}),
        ("cape with a huge standing collar", ("cape",), {"collar": "standing", "collar_height": 11.0}),
        ("sweater with rol neck", ("sweatshirt",), {"collar": "rolled"}),
        ("a shell top, bateau neckline, sleeveless, darted", ("fitted-top",), {"neck_widening": 6.0}),
        ("jumpsuit with a neckline down to there", ("jumpsuit",), {"neckline": "v", "neck_depth": 31.0}),
    ],
)
def test_it_is_heard(reader, text, names, options):
    first = hear_description(text, reader).drafts[0]
    assert first.name in names and dict(first.options).items() >= options.items()
    draft(first.name, **dict(first.options))


def test_broad_straps_do_not_narrow_a_square_or_heart_shaped_neck():
    for shape in ("square", "sweetheart"):
        assert ("straps", "wide") in NamedDraft("skater-dress", (("neckline", shape),)).is_to_the_eye
    assert ("straps", "wide") not in NamedDraft("skater-dress").is_to_the_eye


def test_a_depth_of_so_many_centimetres_is_no_size_of_the_neck(reader):
    told = [w.change.claim for w in hear_description("v neck 15 cm deep, sleeveless top", reader).sure]
    assert Claim("neck_depth_cm", 15.0) in told


def test_told_depths_are_as_they_are_seen_on_a_body():
    cut = neck_as_asked(NamedDraft("skater-dress"), [SQUARE, TEN])
    assert ("neck_depth_cm", 10.0) in cut.is_to_the_eye
    assert not any(name == "neck_depth_cm" for name, _ in NamedDraft("skater-dress").is_to_the_eye)

"""Named drafts with the collar, the shoulders and the slits that a text asks for."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_kinds import DRAFT_NAMES
from swifttailor.pattern.drafts.draft_names import BARE_SHOULDERED, NamedDraft
from swifttailor.wishes.drafts.drafts_as_asked import draft_as_asked

_SLEEVED_SKATER = (
    "skater-dress(skirt_length=98;skirt_fraction=0.5;sleeves=true;sleeve_length=60.0;sleeve_end=24.0)"
)
OPEN_BACK = Claim("back_depth", "open")
BARE = Claim("shoulders", "strapless")
STAND = Claim("collar", "stand")
THIN, CUFFED = Claim("straps", "narrow"), Claim("leg_cuffs", "band")
GATHERED_LEGS, LAPEL = Claim("leg_cuffs", "gathered"), Claim("collar", "lapel")
FLOUNCE = Claim("skirt", "fitted base")
GATHERED, PUFFED = Claim("skirt", "gathered"), Claim("sleeve_shape", "puffed")
BELLS = "swing-dress(sleeve_shape=bell;sleeve_length=60;sleeves=true)"
LOOSE = Claim("fit", "loose")
WIDE_LEGS = Claim("legs", "wide")
SLEEVELESS = "tank-top(strap_width=8;neck_widening=1;neck_depth=11;back_neck_depth=3;length=6)"
TENT_DRESS = "swing-dress(length=50;neck_widening=1;sleeves=false)"
LOOSE_DRESS = "shift-dress(length=50;neck_widening=1;chest_ease=13;flare=24;sleeves=false)"
SLITS = [Claim("slit", "left"), Claim("slit", "right")]


@pytest.mark.parametrize(
    ("named", "claims", "begun"),
    [
        ("shirt", [], "shirt"),
        ("t-shirt(chest_ease=8)", [OPEN_BACK], "fitted-top(back_neck_depth=38;neck_widening=4)"),
        (
            "t-shirt(chest_ease=8)",
            [OPEN_BACK, Claim("sleeves", "short")],
            "t-shirt(chest_ease=8;back_neck_depth=31)",
        ),
        ("shirt", [STAND], "shirt(collar=standing)"),
        (
            "denim-jacket(length=12)",
            [Claim("top_hem", "cropped")],
            "denim-jacket(length=3.5;chest_ease=11;hem_band_ease=1)",
        ),
        ("polo-shirt", [STAND], "polo-shirt(collar=standing)"),
        ("shirt", [Claim("fit", "close")], "shirt(waist_shaping=2.5;chest_ease=4)"),
        ("polo-shirt", [Claim("fit", "close")], "polo-shirt(waist_shaping=2.5;chest_ease=4)"),
        ("blazer(waist_shaping=3)", [Claim("fit", "close")], "blazer(waist_shaping=3;chest_ease=4)"),
        ("camisole", [Claim("fit", "close")], "camisole(chest_ease=3;flare=0;waist_shaping=2)"),
        ("shirt", [Claim("sleeves", "short")], "shirt(sleeve_length=22;sleeve_end=34;cuffs=false)"),
        ("sweatshirt(length=20)", [LAPEL], "polo-shirt(length=20;sleeve_length=58;sleeve_end=23)"),
        ("swing-dress", [LAPEL], "swing-dress(collar=folded)"),
        (
            "robe",
            [LAPEL],
            "coat(lapels=shawl;chest_ease=18;neck_depth=28;opening=-14;closed_to=4;crossing=7;arm_ease=13;sleeve_end=38;length=70)",
        ),
        (
            "coat(length=80)",
            [Claim("skirt", "flared")],
            "shirt-dress(collar=revers;neck_depth=18;sleeve_length=60;sleeve_end=28;cuffs=false;"
            "skirt_fraction=0.5;skirt_length=80;bust_ease=9;waist_ease=7)",
        ),
        ("cape(length=60)", [LAPEL], "cape(length=60;hood=false;collar=shirt;collar_width=7)"),
        ("coat", [Claim("sleeve_shape", "puffed")], "coat(sleeve_shape=puffed)"),
        ("coat", [Claim("sleeves", "three-quarter")], "coat(sleeve_length=44;sleeve_end=28)"),
        ("swing-dress", [Claim("hood", "hood")], "swing-dress(collar=hood)"),
        ("poncho", [Claim("hood", "hood")], "poncho(hood=true)"),
        (
            "skater-dress(skirt_length=50)",
            [Claim("hood", "hood")],
            "shirt-dress(skirt_length=50;collar=hood;cuffs=false;sleeves=false)",
        ),
        (
            "skater-dress(skirt_length=50)",
            [STAND],
            "shirt-dress(sleeves=false;cuffs=false;skirt_length=50;collar=standing)",
        ),
        ("shirt", [Claim("neckline", "v")], None),
        ("bustier", [Claim("shoulders", "both"), Claim("sleeves", "none")], "fitted-top"),
        (
            "strappy-dress(skirt_length=98)",
            [THIN],
            "strappy-dress(skirt_length=98;strap_width=3;bust_ease=1;waist_ease=0)",
        ),
        ("strappy-dress(skirt_length=98;fitted=true)", [], "strappy-dress(skirt_length=98;fitted=true)"),
        ("shirt-dress(collar=folded;cuffs=false)", [STAND], "shirt-dress(cuffs=false;collar=standing)"),
        ("fitted-dress(collar=standing)", [Claim("neckline", "square")], None),
        ("fitted-dress(neck_depth=13)", [BARE], "strapless-dress(skirt_length=60;fitted=true)"),
        ("jeans", [Claim("rise", "low")], "jeans(below_waist=14)"),
        ("circle-skirt(length=60)", [GATHERED], "gathered-skirt(length=60)"),
        ("t-shirt", [Claim("neckline", "v")], "t-shirt(neckline=v;neck_widening=0;neck_depth=18)"),
        ("jumpsuit(leg_ease=2)", [Claim("legs", "slim")], "jumpsuit(leg_ease=2)"),
        ("sweatshirt", [BARE], None),
        ("off-shoulder-top", [BARE], "off-shoulder-top"),
        ("off-shoulder-dress", [BARE], "off-shoulder-dress(waist_seam=true)"),
        ("off-shoulder-dress", [BARE, LOOSE], "off-shoulder-dress"),
        (
            "strapless-dress",
            [Claim("back_depth", "open"), Claim("skirt_hem", "floor"), Claim("slit", "left")],
            "halter-dress(back_fall=18;length=100;skirt_fraction=0.35)",
        ),
        (
            "off-shoulder-dress",
            [BARE, Claim("skirt_hem", "floor")],
            "off-shoulder-dress(length=100;waist_seam=true;skirt_fraction=0.7)",
        ),
        (
            "off-shoulder-dress(length=44)",
            [Claim("skirt", "circle"), Claim("skirt_hem", "midi")],
            "off-shoulder-dress(length=44;waist_seam=true;skirt_fraction=1)",
        ),
        ("sweatshirt(arm_ease=16)", [Claim("hood", "hood")], "hoodie(arm_ease=16)"),
        ("swimsuit", [Claim("neckline", "v")], "swimsuit"),
        (
            "swimsuit",
            [Claim("back_depth", "low")],
            "bodysuit(stretch=14;sleeves=false;armhole_drop=2;back_neck_depth=30;neck_widening=4.5;neck_depth=15)",
        ),
        ("swimsuit", [Claim("back_depth", "low"), THIN], "swimsuit"),
        (
            "leggings",
            [Claim("legs", "flared")],
            "flares(stretch=8;leg_ease=8;hip_ease=2;flare=28;length=103;band_height=7;crotch_drop=0)",
        ),
        ("leggings", [Claim("waistband", "wide")], "leggings(band_height=10.5)"),
        ("leggings(length=58)", [Claim("leg_hem", "mid-thigh")], "leggings(length=47)"),
        ("leggings(length=58)", [Claim("leg_hem", "very short")], "leggings(length=43)"),
        ("briefs(below_waist=10)", [Claim("rise", "high")], "briefs(below_waist=2)"),
        ("pull-on-trousers(leg_ease=20)", [Claim("legs", "wide")], "pull-on-trousers(leg_ease=42;flare=10)"),
        (
            "swimsuit",
            [Claim("neckline", "square")],
            "bodysuit(stretch=14;sleeves=false;armhole_drop=2;back_neck_depth=14;neckline=square;neck_widening=5;neck_depth=15)",
        ),
        (
            "off-shoulder-top(length=20)",
            [Claim("sleeves", "long")],
            "off-shoulder-top(length=20;sleeve_length=60;sleeve_end=24)",
        ),
        (
            "blazer(length=20)",
            [Claim("collar", "none")],
            "cardigan(length=19;chest_ease=10;neck_depth=13;opening=0;sleeve_end=27;closed_to=8)",
        ),
        (
            "skater-dress",
            [Claim("neckline", "round"), Claim("neck_depth", "high")],
            "skater-dress(neck_widening=-1.2;neck_depth=9.5;back_neck_depth=2.5)",
        ),
        (
            "skater-dress",
            [Claim("neckline", "round"), Claim("neck_depth", "high"), Claim("back_depth", "open")],
            "skater-dress(neck_widening=-1.2;neck_depth=9.5;back_neck_depth=38)",
        ),
        ("fitted-dress", [OPEN_BACK], "fitted-dress(back_neck_depth=38;neck_widening=4)"),
        ("fitted-dress", [OPEN_BACK, Claim("back_depth_cm", 30.0)], "fitted-dress"),
        ("halter-dress", [OPEN_BACK], "halter-dress(back_fall=18)"),
        ("strappy-dress(strap_width=3)", [THIN], "strappy-dress(strap_width=1.2)"),
        (
            "strappy-dress(skirt_length=98)",
            [THIN, Claim("skirt", "flared")],
            "strappy-dress(skirt_length=98;skirt_fraction=0.5;strap_width=3;bust_ease=1;waist_ease=0)",
        ),
        (
            "drop-waist-dress(skirt_length=60)",
            [Claim("skirt", "straight")],
            "drop-waist-dress(skirt_length=60;fullness=1;skirt_flare=0)",
        ),
        ("t-shirt", [Claim("fit", "close"), Claim("bodice", "darted")], "fitted-top"),
        ("trousers(leg_ease=21)", [Claim("legs", "wide")], "trousers(leg_ease=42;flare=10)"),
        ("trousers(leg_ease=36;flare=6)", [Claim("legs", "wide")], "trousers(leg_ease=36;flare=6)"),
        ("trousers(length=50;leg_ease=18)", [WIDE_LEGS], "trousers(length=50;leg_ease=60;flare=2)"),
        (
            "trousers(length=50;leg_ease=18)",
            [WIDE_LEGS, Claim("hips", "loose")],
            "trousers(length=50;leg_ease=60;flare=6;hip_ease=12)",
        ),
        ("trousers(length=100)", [Claim("leg_cuff_cm", 12.0)], "trousers(length=91)"),
        ("trousers", [Claim("leg_cuffs", "band")], "trousers(length=95)"),
        ("jumpsuit(length=48)", [Claim("legs", "straight")], "jumpsuit(length=48;leg_ease=22;flare=0)"),
        ("skater-dress", [SLITS[0], Claim("skirt_hem", "maxi")], "fitted-dress(skirt_length=103)"),
        ("strapless-dress", [Claim("sleeves", "long")], _SLEEVED_SKATER),
        ("strapless-dress", [Claim("sleeves", "none")], "strapless-dress"),
        ("strapless-dress", [FLOUNCE], "strapless-dress(flounce=true;close=54;skirt_fraction=0.8)"),
        (
            "mermaid-dress(close=50)",
            [BARE],
            "strapless-dress(close=50;skirt_length=100;flounce=true;skirt_fraction=0.8)",
        ),
        ("mermaid-dress(close=50)", [Claim("skirt", "flared")], "mermaid-dress(close=50;fraction=0.8)"),
        ("skater-dress(skirt_length=62)", [THIN], "strappy-dress(skirt_length=62;skirt_fraction=0.5)"),
        ("skater-dress(skirt_fraction=1)", [Claim("skirt", "flared")], "skater-dress(skirt_fraction=1)"),
        ("skater-dress", [Claim("skirt", "pencil")], "fitted-dress(skirt_length=50)"),
        ("slip-dress(length=44)", [THIN], "slip-dress(length=44)"),
        (
            "slip-dress",
            [Claim("skirt", "circle")],
            "strappy-dress(skirt_length=56;skirt_fraction=1;strap_width=2.5;bust_ease=1;waist_ease=0)",
        ),
        ("jumpsuit(neck_depth=18;leg_ease=30)", [THIN], "strappy-jumpsuit(leg_ease=30)"),
        (
            "strapless-jumpsuit(length=96)",
            [Claim("sleeves", "short")],
            "jumpsuit(length=96;sleeves=true;sleeve_length=22.0;sleeve_end=33.0)",
        ),
        (
            "wrap-top",
            [Claim("sleeves", "short")],
            "wrap-top(sleeves=true;sleeve_length=22.0;sleeve_end=33.0)",
        ),
        ("drop-waist-dress", [Claim("sleeves", "none")], "drop-waist-dress"),
        ("shift-dress", [Claim("collar", "stand")], "shift-dress(collar=standing)"),
        ("coat", [Claim("collar", "stand")], "coat(standing=true;collar_height=4.0)"),
        ("hoodie", [Claim("top_hem", "cropped")], "hoodie(length=6.0;chest_ease=11.0;hem_band_ease=1.0)"),
        ("fitted-top", [Claim("fit", "loose")], "tank-top(length=-2.0;chest_ease=12.0)"),
        ("shirt-dress", [Claim("skirt", "gathered")], "shirt-dress(gathers=2.0)"),
        ("trousers(length=102;leg_ease=20)", [CUFFED], "trousers(length=97;leg_ease=20)"),
        ("trousers(length=102;leg_ease=20)", [GATHERED_LEGS], "joggers(length=98;leg_ease=20)"),
        ("trousers(length=42)", [GATHERED_LEGS], "trousers(length=42)"),
        (
            "joggers",
            [Claim("leg_cuffs", "none")],
            "pull-on-trousers(length=99;hip_ease=10;leg_ease=24;flare=-8)",
        ),
        ("joggers(crotch_drop=9)", [Claim("leg_cuffs", "none")], None),
        ("t-shirt(length=6)", [Claim("fit", "close")], "t-shirt(length=6;chest_ease=3;waist_shaping=3)"),
        ("t-shirt(length=6)", [Claim("sleeves", "none")], SLEEVELESS),
        ("t-shirt(length=30)", [LAPEL], "shirt(length=30)"),
        ("tank-top", [LAPEL, Claim("sleeves", "none")], "shirt(sleeves=false)"),
        ("t-shirt", [Claim("bodice", "flared")], "t-shirt(flare=28)"),
        ("skater-dress", [Claim("bodice", "flared")], TENT_DRESS),
        ("circle-skirt", SLITS[:1], "fitted-skirt(flare=4)"),
        ("halter-dress", SLITS[:1], "halter-dress(skirt_fraction=0.3;length=72)"),
        ("skater-dress", [LOOSE], LOOSE_DRESS),
        ("skater-dress(neck_depth=9)", [GATHERED], "skater-dress(neck_depth=9;gathers=2)"),
        ("fitted-dress", [GATHERED, BARE], "strapless-dress(gathers=2;skirt_length=60)"),
        ("t-shirt", [PUFFED], "t-shirt(sleeve_shape=puffed;sleeve_length=22;sleeve_end=21)"),
        ("t-shirt", [PUFFED, Claim("sleeves", "none")], SLEEVELESS.replace(";length=6", "")),
        ("swing-dress", [Claim("sleeve_shape", "bell"), Claim("sleeves", "long")], BELLS),
        ("shirt", [Claim("sleeve_shape", "balloon")], "shirt(sleeve_shape=balloon;sleeve_length=60)"),
        ("hoodie", [Claim("sleeve_shape", "balloon")], "hoodie(sleeve_shape=balloon)"),
        ("skater-dress", [LOOSE, Claim("waist_seam", "natural")], "skater-dress"),
        ("joggers(hip_ease=24)", [Claim("hips", "loose")], "joggers(hip_ease=24)"),
        ("t-shirt(length=38)", SLITS, "t-shirt(length=38;side_slits=14)"),
        ("t-shirt(length=38)", [*SLITS, Claim("slit_cm", 20.0)], "t-shirt(length=38;side_slits=20)"),
        ("t-shirt(length=38)", [*SLITS, Claim("slit_cm", 70.0)], "t-shirt(length=38;side_slits=14)"),
        ("t-shirt(length=38)", SLITS[:1], "t-shirt(length=38)"),
        ("skater-dress", SLITS[:1], "fitted-dress(skirt_length=72)"),
        ("tank-top(length=-3)", [Claim("straps", "narrow")], None),
        ("jumpsuit", [Claim("legs", "wide")], "jumpsuit(leg_ease=42;flare=10)"),
        ("trousers", [Claim("legs", "wide")], "trousers"),
        ("trousers(hip_ease=7)", [Claim("hips", "loose")], "trousers(hip_ease=12)"),
        ("t-shirt(length=38;neck_widening=1)", [STAND], "turtleneck(length=38;collar_height=4;rolled=false)"),
        ("tiered-skirt", [Claim("tiers", 4.0)], "tiered-skirt(tiers=4)"),
        ("tiered-skirt", [Claim("tiers", 9.0)], "tiered-skirt"),
        ("coat(length=80;flare=0)", [Claim("hood", "hood")], "hooded-coat(length=80;chest_ease=20)"),
        ("hooded-coat(length=42)", [Claim("hood", "none")], "coat(length=42)"),
        ("hooded-coat(length=42)", [Claim("collar", "lapel")], "coat(length=42)"),
    ],
)  # fmt: skip
def test_a_draft_is_begun_as_it_is_asked_for(named, claims, begun):
    found = draft_as_asked(NamedDraft.parse(named), claims)
    assert found == (None if begun is None else NamedDraft.parse(begun))


VALUES = [Claim(name, word) for name, kind in CLAIM_TYPES.items() for word in kind.words]


@given(st.sampled_from(DRAFT_NAMES), st.lists(st.sampled_from([BARE, STAND, *SLITS, *VALUES]), max_size=4))
def test_what_is_begun_can_be_drafted_and_has_the_shoulders_asked_for(name, claims):
    found = draft_as_asked(NamedDraft(name), claims)
    if found is None:
        return
    assert draft(found.name, **dict(found.options)).panels
    assert BARE not in claims or found.name in BARE_SHOULDERED


def test_what_is_darted_to_the_waist_stays_as_long_and_as_wide_as_it_is():
    darted = NamedDraft.parse("turtleneck(rolled=false;chest_ease=5;length=6;waist_shaping=3)")
    asked = [Claim("top_hem", "waist"), Claim("fit", "close")]
    assert draft_as_asked(darted, asked) == darted
    assert dict(draft_as_asked(NamedDraft("turtleneck"), asked).options)["length"] == 4.0


def test_long_legs_are_cut_as_long_as_their_inseam_is_told():
    draft = draft_as_asked(NamedDraft("trousers"), [Claim("inseam_cm", 81.3)])
    assert draft is not None and 113.0 < dict(draft.options)["length"] < 116.0
    assert draft_as_asked(NamedDraft("trousers"), [Claim("inseam_cm", 20.0)]) == NamedDraft("trousers")

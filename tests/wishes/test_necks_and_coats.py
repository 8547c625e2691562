"""Collars and coats by words: which block they are cut from, how high and wide the collar is."""

from __future__ import annotations

import pytest

from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.descriptions.sayings_of_wishes import without_asides
from swifttailor.wishes.reader import WishReader
from swifttailor.wishes.trims.trims_wanted import trims_wanted


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "name", "options"),
    [
        ("a warm polo neck jumper", "sweatshirt", {"collar": "rolled", "collar_height": 8.5}),
        ("red dress with a roll neck", "shirt-dress", {"collar": "rolled", "collar_height": 8.0}),
        ("ribbed turtleneck dress", "shift-dress", {"collar": "rolled", "collar_height": 8.0}),
        ("funnel neck sweatshirt, grey", "sweatshirt", {"collar": "standing", "collar_height": 7.5}),
        ("mock neck top", "sweatshirt", {"collar": "standing", "collar_height": 4.5}),
        ("tuxedo jacket with shawl lapels", "blazer", {"lapels": "shawl"}),
        ("a grey coat with huge lapels", "coat", {"lapel_width": 14.0}),
        ("double breasted winter coat with a large collar", "coat", {"collar_width": 12.0}),
        ("a jacket with an oversized collar", "blazer", {"collar_width": 10.0}),
        ("coat with a shirt collar", "coat", {"collar": "shirt"}),
        ("langer Mantel mit breitem Revers, schmal geschnitten", "coat", {"lapel_width": 14.0}),
        ("fitted shirt, collar stand 3 cm", "shirt", {"waist_shaping": 2.5}),
        ("dressing gown", "coat", {"lapels": "shawl"}),
        ("denim shirt dress", "shirt-dress", {"collar": "shirt"}),
        ("tie front blouse", "shirt", {"length": 4.0}),
        ("cropped white shirt", "shirt", {"waist_shaping": 1.5}),
        ("jacket with a round neck", "cardigan", {"neck_depth": 13.0}),
        ("oversized blazer", "blazer", {"chest_ease": 22.0, "waist_shaping": 0.0}),
        ("navy coat with a Peter Pan collar", "coat", {"collar": "flat"}),
        ("pirate shirt with a wide floppy collar", "shirt", {"collar": "folded", "collar_width": 10.0}),
        ("a shirt with a big Peter Pan collar", "shirt", {"collar": "flat", "collar_width": 7.0}),
        ("fitted dress coat with a flared skirt", "shirt-dress", {"collar": "revers"}),
        ("blue housecoat", "coat", {"collar": "shirt", "opening": -3.0}),
        ("cape coat in red wool", "cape", {"collar": "shirt", "closed": 90.0}),
        ("ringmaster tailcoat", "coat", {}),
        ("jacket with a Peter Pan collar", "blazer", {"collar": "flat"}),
        ("jacket with a shirt collar", "blazer", {"collar": "shirt"}),
        ("jacket with a standing collar", "blazer", {"collar": "standing"}),
        ("blazer with a mandarin collar", "blazer", {"collar": "mandarin"}),
        ("collarless coat", "coat", {"collar": "none"}),
        ("coat, edge to edge", "coat", {"collar": "none", "closed_to": -30.0, "opening": 8.0}),
        ("tweed jacket, no collar, edge to edge", "cardigan", {"closed_to": -30.0, "opening": 4.0}),
        ("coat with a shawl collar, no fastening", "coat", {"lapels": "shawl", "closed_to": -30.0}),
        ("princess line coat, eight panels", "coat", {"waist_shaping": 4.0, "flare": 50.0}),
        ("bathrobe", "coat", {"crossing": 7.0}),
        ("silk kimono robe", "robe", {"crossing": 7.0}),
        ("nightshirt, buttons down the front", "shift-dress", {"collar": "shirt", "cuffs": True}),
        ("button-down shirt, oxford, light blue", "shirt", {"hem_rise": 5.0}),
        ("office blouse, neck closed", "shirt", {"collar": "standing"}),
    ],
)
def test_a_collar_and_the_block_that_it_is_cut_on(reader, text, name, options):
    first = hear_description(text, reader).drafts[0]
    assert first.name == name
    assert options.items() <= dict(first.options).items()


@pytest.mark.parametrize(
    ("text", "draft", "trim", "is_put_on"),
    [
        ("an Oxford shirt", "shirt", "collar buttons", True),
        ("a shirt with a button-down collar", "shirt", "collar buttons", True),
        ("a white shirt", "shirt", "collar buttons", False),
        ("a blouse with a back yoke", "shirt", "back yoke", True),
        ("a nightshirt with buttons down the front", "shift-dress", "button placket", True),
        ("a coat, edge to edge", "coat", "buttons", False),
        ("a coat", "coat", "buttons", True),
        ("a parka", "hooded-coat", "drawstring", True),
        ("a wrap skirt with a tie at the side", "wrap-skirt", "hip knot", True),
        ("a satin wrap skirt, tie at waist", "wrap-skirt", "hip knot", True),
        ("a shirt with a tie", "shirt", "hip knot", False),
    ],
)
def test_what_shirts_coats_and_wraps_are_closed_and_known_by(reader, text, draft, trim, is_put_on):
    first = [wish.choices[0] for wish in trims_wanted(hear_description(text, reader), draft)]
    assert any(trim in names for names in first) == is_put_on


@pytest.mark.parametrize(
    ("text", "draft", "trims"),
    [
        ("white nightie with lace around the neckline", "shift-dress", {"neck lace"}),
        ("ruffle blouse in ivory", "shirt", {"neck frill", "front frills"}),
        ("victorian blouse", "shirt", {"neck frill", "yoke frill"}),
        ("a cape coat", "cape", {"arm slits", "buttons"}),
        ("housecoat, buttoned up the front", "coat", {"buttons"}),
        ("blouse with a bow tie", "shirt", {"neck bow"}),
    ],
)
def test_what_is_put_on_at_the_neck_and_down_the_front(reader, text, draft, trims):
    wishes = trims_wanted(hear_description(text, reader), draft)
    assert trims <= {name for wish in wishes for name in wish.choices[0]}


@pytest.mark.parametrize("word", ["I can turn up", "turned up", "that turns up"])
def test_a_collar_that_is_turned_up_turns_up_no_legs(reader, word):
    heard = hear_description(f"a camel coat with a big collar {word}", reader)
    assert not any(lack.what == "turn_ups" for lack in heard.lacks)


def test_trousers_have_turn_ups(reader):
    heard = hear_description("grey trousers with turn ups", reader)
    assert any("turn-ups" in wish.choices[0] for wish in trims_wanted(heard, "trousers"))


def test_lace_at_the_neck_is_not_the_cloth_of_the_whole(reader):
    assert not hear_description("cotton nightie, lace at the neck", reader).with_looks().looks.looks


@pytest.mark.parametrize(
    "text",
    ["coat with no closure showing", "a camel coat with a concealed fastening", "coat, no visible buttons"],
)
def test_what_is_not_to_show_is_refused(text):
    assert "no buttons" in without_asides(text)


@pytest.mark.parametrize(
    ("text", "band"),
    [("a blouse with short sleeves", False), ("a shirt", True)],
)
def test_short_sleeves_have_no_cuffs_of_their_own(reader, text, band):
    heard = hear_description(text, reader)
    claims = [str(w) for w in (*heard.sure, *heard.likely)]
    assert any("cuffs" in claim for claim in claims) is band


def test_sleeves_with_room_for_a_jacket_are_no_wide_ones(reader):
    heard = hear_description("a coat, long sleeves wide enough for a jacket underneath", reader)
    assert not any("wide" in str(change) for change in heard.sure)
    assert not heard.cannot

"""Tops, jackets and coats that a name or a detail tells: smocks, wraps, big buttons, rolled sleeves."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.cropped_drafts import cropped_as_asked
from swifttailor.wishes.drafts.heard_drafts import drafts_of
from swifttailor.wishes.drafts.said_details import with_details
from swifttailor.wishes.drafts.sleeved_drafts import sleeves_as_asked
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.reader import Wish
from swifttailor.wishes.trims.big_buttons import asks_for_big_buttons
from swifttailor.wishes.trims.trims_wanted import trims_wanted
from swifttailor.wording.lexicon import read_words


def heard(text: str, *claims: Claim) -> Heard:
    words = read_words(text)
    sure = tuple([Wish(Gain(claim), 1.0) for claim in claims])
    return Heard(text, sure=sure, lacks=tuple(words.lacks), words=words)


@pytest.mark.parametrize(
    ("text", "draft", "option", "value"),
    [
        ("an artist's smock", "shirt", "length", 34.0),
        ("a work smock with buttons down the front", "shirt", "collar", "flat"),
        ("a barber's smock", "turtleneck", "opening", 1.0),
        ("a kimono sleeve wrap top", "wrap-top", "armhole", "cut-in-one"),
        ("a ballet wrap cardigan", "wrap-top", "waist_shaping", 3.0),
        ("a shirt with the sleeves rolled up", "shirt", "cuffs", False),
        ("a 1950s blouse", "shirt", "sleeve_shape", "puffed"),
        ("top with straps that tie", "camisole", "strap_width", 2.0),
        ("sweetheart neck top with tie straps", "bustier", "straps", True),
    ],
)
def test_begins_from(text, draft, option, value):
    first = drafts_of(heard(text, Claim("kind", "top")))[0]
    assert first.name == draft and dict(first.options)[option] == value


@pytest.mark.parametrize(
    ("text", "kind", "draft", "trims"),
    [
        ("a cardigan with big buttons", "top", "cardigan", {"big buttons"}),
        ("a coat with big brown buttons", "dress", "coat", {"big buttons"}),
        ("Strickjacke mit großen Knöpfen", "top", "cardigan", {"big buttons"}),
        ("cardigan aux gros boutons", "top", "cardigan", {"big buttons"}),
        ("a wrap top", "top", "wrap-top", {"side tie"}),
        ("a wrap blouse that ties at the side", "top", "wrap-top", {"side tie"}),
        ("a blouse with a bow at the nape", "top", "shirt", {"nape bow"}),
        ("a Norfolk jacket", "top", "blazer", {"box pleats", "buckle belt"}),
        ("a linen jacket", "top", "blazer", {"buttons"}),
        ("veste aux manches retroussées", "top", "blazer", {"sleeve turn-ups"}),
    ],
)
def test_has_put_on(text, kind, draft, trims):
    wanted = trims_wanted(heard(text), draft, kind)
    assert trims <= {name for wish in wanted for name in wish.choices[0]}


@pytest.mark.parametrize(
    ("text", "big"),
    [
        ("a coat, big brass buttons", True),
        ("Mantel mit großen braunen Knöpfen", True),
        ("abrigo con botones", False),
        ("big pockets and buttons", False),
        ("a large shirt with buttons", False),
    ],
)
def test_size_of_buttons(text, big):
    assert asks_for_big_buttons(text) is big


def test_jackets_are_drawn_in_where_a_waist_is_told():
    jacket = NamedDraft.parse("blazer(waist_shaping=1)")
    waist = Claim("waist_seam", "natural")
    assert dict(with_details(jacket, (), (waist,)).options)["waist_shaping"] == 3.5
    assert with_details(jacket, (), (waist, Claim("fit", "loose"))) == jacket


def test_short_wide_sleeves_of_shirts_have_no_cuffs():
    wide = (Claim("sleeve_shape", "wide"), Claim("sleeves", "short"))
    assert dict(sleeves_as_asked(NamedDraft("shirt"), wide).options)["cuffs"] is False


@pytest.mark.parametrize(
    ("draft", "least"),
    [
        ("turtleneck(rolled=false;chest_ease=20)", 11.0),
        ("turtleneck(rolled=false;chest_ease=10)", 6.0),
        ("shirt", 4.0),
    ],
)
def test_what_ends_at_the_waist_covers_it(draft, least):
    short = cropped_as_asked(NamedDraft.parse(draft), (Claim("top_hem", "waist"),))
    assert dict(short.options)["length"] >= least


class Silent:
    """A network that reads nothing."""

    def read(self, text, *, instruction=False):
        return ()

    def whole(self, text, *, instruction=True):
        return {}


@pytest.mark.parametrize("text", ["coat with big brown buttons", "Mantel mit großen braunen Knöpfen"])
def test_a_size_that_is_told_of_buttons_is_understood(text):
    assert hear_description(text, Silent()).unread == ()

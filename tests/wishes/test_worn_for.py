"""What is made for an occasion, a mood or a class of clothes where no garment is named."""

from __future__ import annotations

import pytest

from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.descriptions.worn_for import worn_for
from swifttailor.wishes.reader import WishReader
from swifttailor.wording.lexicon import read_words
from swifttailor.wording.lexicon.vocabulary import all_entries


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "garment", "kind"),
    [
        ("something for the beach", "sundress", "dress"),
        ("what can I wear to a job interview", "blazer", "top"),
        ("something cosy for winter evenings", "jumper", "top"),
        ("an outfit for yoga", "leggings", "trousers"),
        ("gym wear", "leggings", "trousers"),
        ("something elegant", "sheath dress", "dress"),
        ("a tuxedo", "dinner jacket", "top"),
        ("something cute for a first date", "wrap dress", "dress"),
        ("I want to look like Gandalf, grey", "wizard robe", "dress"),
        ("Mary Poppins, navy", "Mary Poppins dress", "dress"),
        ("carnival pirate lady, ruffled sleeves, short skirt", "pirate dress", "dress"),
        ("Elizabethan lady, square neckline, big skirt", "Elizabethan gown", "dress"),
        ("a Victorian schoolmistress: high neck, long skirt", "Victorian dress", "dress"),
        ("Henry VIII", "doublet", "top"),
        ("Viking woman", "Viking apron dress", "dress"),
        ("Hermione Granger", "wizard robe", "dress"),
        ("something cottagecore for a picnic", "cottagecore dress", "dress"),
        ("coquette", "coquette dress", "dress"),
        ("clubbing", "black mini dress", "dress"),
        ("running in winter", "leggings", "trousers"),
        ("chilly evenings", "jumper", "top"),
        ("drop waist", "dress", "dress"),
        ("empire line", "dress", "dress"),
        ("Hose für den Sport", "joggers", "trousers"),
        ("jupe pour danser", "circle skirt", "skirt"),
        ("robe de sorcière", "witch dress", "dress"),
        ("something to wear for our ruby wedding", "ruby wrap dress", "dress"),
        ("burns night", "kilt", "skirt"),
        ("Clueless skirt", "plaid skirt", "skirt"),
        ("something for a Gatsby party", "flapper dress", "dress"),
        ("smart but not stuffy, for casual friday", "shirt", "top"),
        ("something for a ball", "evening gown", "dress"),
        ("Old Hollywood", "old Hollywood gown", "dress"),
        ("something comfy for a long train journey", "jersey dress", "dress"),
        ("something I can get out of on a sleeper train", "nightshirt", "dress"),
        ("cool for Delhi, covered for temples", "modest maxi dress", "dress"),
        ("something I can cycle to work in", "tapered trousers", "trousers"),
        ("something to dance salsa in", "dance dress", "dress"),
        ("green velvet, christmas", "party dress", "dress"),
        ("for cooking class, something that opens at the front", "shirt", "top"),
        ("Marilyn but not white", "Marilyn dress", "dress"),
        ("school run, then straight to the office", "blazer", "top"),
        ("librarian", "cardigan", "top"),
        ("mother of the bride, not frumpy", "mother of the bride dress", "dress"),
        ("for a first communion, white", "communion dress", "dress"),
        ("for walking the dog in all weathers", "anorak", "top"),
        ("something floaty over my tummy", "tunic", "tunic"),
        ("I've got a wedding in June, nothing sleeveless", "tea dress", "dress"),
        ("I am a hairdresser and stand all day", "salon tunic", "top"),
        ("clothes for a hospital stay", "nightshirt", "dress"),
        ("tea at the Ritz", "tea dress", "dress"),
        ("something for my 70th birthday", "emerald wrap dress", "dress"),
        ("work christmas do", "wine velvet party dress", "dress"),
        ("christmas party in green satin", "party dress", "dress"),
        ("for my birthday, pink but not green", "satin party dress", "dress"),
        ("something for my hen do, but I am not wearing a bodycon", "emerald satin party dress", "dress"),
        ("camping", "hiking trousers", "trousers"),
        ("knee length, navy", "dress", "dress"),
        ("something green, not too short", "dress", "dress"),
        ("something linen", "shirt", "top"),
        ("denim", "jeans", "trousers"),
        ("wool, to the knee", "dress", "dress"),
        ("dark academia, long sleeves", "dark brown tweed blazer", "top"),
        ("I can feed in it, loose", "nursing top", "top"),
        ("anything but a dress, it's for a wedding", "navy satin wide-leg jumpsuit", "jumpsuit"),
    ],
)
def test_a_garment_is_guessed_from_what_it_is_for(reader, text, garment, kind):
    heard = hear_description(text, reader)
    assert (heard.guess, heard.kind) == (garment, kind)


@pytest.mark.parametrize(
    "text", ["a skirt for the beach", "elegant trousers", "a hoodie for yoga", "a dress for a wedding"]
)
def test_nothing_is_guessed_where_a_garment_is_named(reader, text):
    heard = hear_description(text, reader)
    assert heard.guess == "" and worn_for(heard) is None


@pytest.mark.parametrize(
    ("text", "garment"),
    [
        ("New Year's Eve top", "party top"),
        ("dark academia skirt", "brown tartan pleated skirt"),
        ("old money dress", "navy shirt dress"),
        ("a warm dress", "long sleeved dress"),
        ("skirt, summery", "floral skirt"),
        ("cottagecore top", "milkmaid top"),
        ("top for the theatre", "wrap top"),
        ("comfy trousers", "lounge trousers"),
        ("comfy trousers for a long flight", "lounge trousers"),
        ("a dress for a wedding", ""),
        ("comfy jeans", ""),
        ("comfy trousers for work", ""),
    ],
)
def test_a_mere_kind_is_made_as_the_mood_has_it(reader, text, garment):
    assert hear_description(text, reader).guess == garment


def test_what_contradicts_a_detail_is_not_suggested(reader):
    assert hear_description("a party outfit with wide legs", reader).kind == "trousers"


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("no skirts please, something for a wedding", "jumpsuit"),
        ("anything but a dress, for a ball", "jumpsuit"),
        ("anything but trousers. for a job interview", "top"),
    ],
)
def test_what_is_refused_is_not_suggested(reader, text, kind):
    assert hear_description(text, reader).kind == kind


def test_a_picture_shows_which_garment_is_meant(reader):
    assert hear_description("something for the beach", reader, alone=False).guess == ""


def test_what_is_worn_is_a_garment_of_one_kind():
    worn = {name for entry in all_entries() for name in (entry.worn, *entry.worn_as) if name}
    assert len(worn) > 20
    for name in worn:
        kinds = {i.claim.value for i in read_words(name).implications if i.claim.name == "kind"}
        assert len(kinds) == 1, name


def test_what_is_guessed_has_no_print_where_a_colour_is_asked_for(reader):
    assert hear_description("my best friend's wedding, something green", reader).print is None
    assert hear_description("my best friend's wedding", reader).print is not None
    assert hear_description("my best friend's wedding, red spots", reader).print is not None

"""Wishes for garments that are worn together, beside or over each other, and for one that sounds like two."""

import pytest

from swifttailor.errors import InputError
from swifttailor.tailor import Order
from swifttailor.tailor.color_of_set import color_of_set
from swifttailor.wishes.outfits.two_garments import two_garments
from swifttailor.wording.lexicon import read_words
from swifttailor.wording.lexicon.outfits import _outfits

TWO = [
    ("a white blouse and a black pencil skirt", "a white blouse", "a black pencil skirt"),
    ("blouse and skirt", "blouse", "skirt"),
    ("halter top n long straight skirt", "halter top", "long straight skirt"),
    ("two-piece: crop top and maxi skirt", "crop top", "maxi skirt"),
    ("a navy two-piece: crop top and maxi skirt", "navy crop top", "navy maxi skirt"),
    ("navy trouser suit", "navy blazer", "navy tailored trousers"),
    ("a striped pyjamas", "a striped long sleeved pyjama top", "striped pyjama bottoms"),
    ("scrubs", "scrub top", "scrub trousers"),
    ("lounge set", "jumper", "lounge trousers"),
    ("pyjama en satin", "long sleeved pyjama top satin", "pyjama bottoms en satin"),
    ("waitress", "white blouse", "black pencil skirt"),
    ("red bikini", "red bikini top", "red bikini bottoms"),
    ("red bikini top with high waisted bottoms", "red bikini top", "high waisted red bikini bottoms"),
    ("tankini with skirt", "tankini top", "swim skirt"),
    ("pajamas with short sleeves and shorts", "pyjama top with short sleeves", "pyjama shorts"),
    ("pyjamas with a collar", "long sleeved pyjama top with a collar", "pyjama bottoms"),
    ("PJs with shorts and a strappy top", "a strappy pyjama top", "pyjama shorts"),
    ("pyjamas, short sleeves and trousers", "pyjama top, short sleeves", "pyjama trousers"),
    ("chef uniform", "chef jacket", "chef trousers"),
    ("girls school uniform", "school shirt", "school skirt"),
    ("sweatshirt and joggers set in lilac", "lilac sweatshirt", "joggers in lilac"),
    ("my dad needs a tracksuit", "my dad needs a tracksuit jacket", "my dad needs tracksuit bottoms"),
    ("salwar kameez in turquoise cotton", "kameez in turquoise cotton", "salwar in turquoise cotton"),
    ("white kurta pajama", "white kurta", "white churidar"),
    ("yellow kurti and jeans", "yellow kurti", "jeans"),
    ("red ao dai", "red ao dai tunic", "red ao dai trousers"),
    ("short-sleeved pyjamas with long legs", "short-sleeved pyjama top", "pyjama bottoms with long legs"),
    ("suit with a pencil skirt", "blazer", "a pencil skirt"),
    ("a grey suit with a waistcoat", "a grey blazer", "grey tailored trousers"),
    ("suit: jacket, waistcoat and trousers", "jacket", "trousers"),
    ("pyjama set of camisole and shorts", "camisole", "pyjama shorts"),
    ("crop top and matching skirt, tropical print", "tropical print crop top", "skirt, tropical print"),
    ("sweatpants and sweatshirt, sage", "sweatshirt, sage", "sweatpants, sage"),
    ("cropped hoodie and joggers set, lilac", "cropped hoodie, lilac", "joggers, lilac"),
    ("scrub top and bottoms, teal, v neck", "scrub top, teal, v neck", "scrub bottoms, teal"),
    (
        "silk pyjama set with piping, navy shirt and trousers",
        "navy silk long sleeved pyjama shirt with piping",
        "silk navy pyjama trousers with piping",
    ),
    (
        "trousers with a yoke, coral, and a matching camisole",
        "a coral camisole",
        "trousers with a yoke, coral",
    ),
    (
        "track suit, navy, stripes down the sleeves and legs",
        "tracksuit jacket, navy, stripes down the sleeves",
        "tracksuit bottoms, navy, stripes down the legs",
    ),
    (
        "tunic, knee length, with a belt, over brown breeches",
        "tunic, knee length, with a belt",
        "brown breeches",
    ),
    ("red skirt and a top, white", "a top, white", "red skirt"),
    ("a jumper and jeans, red", "a jumper", "jeans, red"),
    ("white karate suit", "white gi top", "white gi trousers"),
    ("red lehenga choli", "red choli", "red lehenga"),
    ("white shirt black trousers", "white shirt", "black trousers"),
    ("red crop top denim shorts", "red crop top", "denim shorts"),
    ("chemise blanche pantalon noir", "chemise blanche", "pantalon noir"),
    ("weißes Hemd schwarze Hose", "weißes Hemd", "schwarze Hose"),
    ("a tunic over leggings", "a tunic", "leggings"),
    (
        "green tunic, knee length, with a belt, over brown breeches",
        "green tunic, knee length, with a belt",
        "brown breeches",
    ),
    ("a shirt, hip length, over a long skirt", "a shirt, hip length", "a long skirt"),
    ("a long coat over wide trousers", "a long coat", "wide trousers"),
    ("velvet bodysuit and flared trousers", "velvet bodysuit", "velvet flared trousers"),
    ("a linen shirt with matching trousers", "a linen shirt", "linen trousers"),
    (
        "a black and white striped top and matching shorts",
        "a black and white striped top",
        "black and white striped shorts",
    ),
    ("a blouse and a black and white skirt", "a blouse", "a black and white skirt"),
    ("a blouse in navy and a skirt in red", "a blouse in navy", "a skirt in red"),
    ("a white blouse and skirt", "a white blouse", "white skirt"),
    ("a navy top and shorts", "a navy top", "shorts"),
    ("white t-shirt and jeans", "white t-shirt", "jeans"),
    ("top and shorts in navy linen", "navy linen top", "shorts in navy linen"),
    ("a blouse and a skirt, both in navy", "a blouse, in navy", "a skirt, in navy"),
    ("a shirt & trousers in the same fabric", "a shirt", "trousers"),
    ("a matching set of a cropped tee and shorts", "a cropped tee", "shorts"),
    (
        "a loose shirt with puff sleeves and a V neck, and long flowing trousers with a high waist",
        "a loose shirt with puff sleeves and a V neck",
        "long flowing trousers with a high waist",
    ),
    ("a long, pleated skirt with a short boxy jacket", "a short boxy jacket", "a long, pleated skirt"),
    ("blouse with a bow + mini skirt", "blouse with a bow", "mini skirt"),
    ("I'd like a jumper and a skirt, size 14, please", "I'd like a jumper, please", "a skirt, please"),
    (
        "for my holiday: a loose shirt, and olive shorts",
        "for my holiday a loose shirt",
        "for my holiday olive shorts",
    ),
    ("white blose and navy skrit", "white blouse", "navy skirt"),
    ("eine weiße Bluse und ein schwarzer Rock", "eine weiße Bluse", "ein schwarzer Rock"),
    ("dunkelblauer Hosenanzug", "dunkelblauer blazer", "dunkelblauer tailored trousers"),
    ("une chemise blanche et une jupe noire", "une chemise blanche", "une jupe noire"),
    ("una camisa blanca y una falda negra", "una camisa blanca", "una falda negra"),
    ("dark academia", "dark brown tweed blazer", "dark brown tailored trousers"),
    ("old money, green", "cable knit jumper, green", "tailored trousers, green"),
    ("first day at the new job", "navy blazer", "navy tailored trousers"),
    ("country house weekend", "tweed blazer", "brown corduroy trousers"),
]
ONE = [
    "old money dress",
    "dark academia skirt",
    "preppy, long sleeves",
    "job interview, nothing black",
    "casual Christmas party",
    "minimalist wedding guest",
    "barn dance at the weekend",
    "shirt dress",
    "a dress with a pleated skirt",
    "a top with a skirt part",
    "a top with a peplum skirt",
    "blouse trousers",
    "jumpsuit with wide trousers",
    "a jumpsuit with a shirt collar and trousers with pleats",
    "dress with a fitted bodice and a full skirt",
    "a fitted bodice and a full skirt",
    "skirt with braces",
    "jeans with a shirt collar",
    "a shirt to wear with trousers",
    "a top that goes with my jeans",
    "a tunic long enough to wear over leggings",
    "a top to throw over a skirt",
    "a blouse to go under a suit",
    "a blouse for under my suit",
    "a skirt instead of trousers",
    "not a skirt but a blouse",
    "a skirt or trousers",
    "a dress with shorts",
    "dungarees with a t-shirt top",
    "a trouser suit jacket",
    "a suit jacket with a nipped waist",
    "a bikini top",
    "pyjama bottoms",
    "shorts with a top pocket",
    "trousers with a jacket pocket",
    "a wrap skirt with a top band",
    "a skirt with shorts underneath",
    "a skirt with a blouse collar",
    "a skirt with a top layer of tulle",
    "trousers that look good with a blouse",
    "something that looks like a top and skirt but is one piece",
    "a top and skirt, sewn together",
    "I have a grey jacket and need trousers to match",
    "a white shirt with black collar and cuffs",
    "a coat dress with a flared skirt",
    "a cardigan to wear over a top",
    "a coat that looks like a cape",
    "a cross between a coat and a cape",
    "a jacket or a cardigan",
    "dress with a bolero style top",
    "dress with a jacket collar",
    "denim jacket with sheepskin collar",
    "a dress to wear under my coat",
    "a jumpsuit and a dress in one",
    "a two tier skirt, and then if you can also do a matching bandeau, but the skirt please",
]

LAYERS = [
    ("a cardigan over a top", "a cardigan", "a top"),
    ("pale blue twinset", "pale blue twinset cardigan", "pale blue short sleeved knit top"),
    ("a dress and a jacket", "a jacket", "a dress"),
    ("floral dress with a denim jacket over it", "a denim jacket", "floral dress"),
    ("jumper over shirt", "jumper", "a shirt"),
    ("white t-shirt under denim dungarees", "denim dungarees", "white t-shirt"),
    ("dungarees with a striped t-shirt underneath", "dungarees", "a striped t-shirt"),
    ("black slip dress layered over a white tee", "black slip dress", "a white tee"),
    ("black turtleneck under a pinafore dress", "a pinafore dress", "black turtleneck top"),
    ("evening dress with matching coat", "coat", "evening dress"),
    ("satin nightdress and dressing gown set", "satin dressing gown", "satin nightdress"),
    ("red dress, black jacket", "black jacket", "red dress"),
    ("blue evening dress with a cape", "a blue cape", "blue evening dress"),
    ("an evening dress, blue, with a cape", "a blue cape", "an evening dress, blue"),
    ("blue evening dress with a white bolero", "a white bolero", "blue evening dress"),
    ("tank top with an open shirt over it", "an open shirt", "tank top"),
    ("pinafore with white blouse", "pinafore", "white blouse"),
    ("dress over jeans", "dress", "jeans"),
    (
        "a red coat with a hood over a white dress with long sleeves",
        "a red coat with a hood",
        "a white dress with long sleeves",
    ),
    (
        "a midi dress in pink with long sleeves and a matching coat in the same colour to wear over it",
        "a pink coat",
        "a midi dress in pink with long sleeves",
    ),
    ("schwarze Jacke über einem roten Kleid", "schwarze Jacke", "einem roten Kleid"),
    ("robe rouge avec une veste noire", "une veste noire", "robe rouge"),
    ("vestido rojo con chaqueta negra", "chaqueta negra", "vestido rojo"),
]
"""With what is on top before what is beneath it."""


def test_what_a_mood_is_taken_for_is_a_guess_and_no_set():
    moods, names = two_garments("preppy"), two_garments("navy trouser suit")
    assert moods is not None and names is not None
    assert (moods.guessed, moods.alike) == (True, False)
    assert (names.guessed, names.alike) == (False, True)


@pytest.mark.parametrize(("text", "over", "beneath"), LAYERS)
def test_one_garment_over_another_is_both(text, over, beneath):
    found = two_garments(text)
    assert found is not None and found.layered
    assert (found.upper, found.lower) == (over, beneath)


@pytest.mark.parametrize(("text", "upper", "lower"), TWO)
def test_two_garments_are_told_apart_each_with_its_words(text, upper, lower):
    found = two_garments(text)
    assert found is not None
    assert (found.upper, found.lower) == (upper, lower)


@pytest.mark.parametrize(
    ("text", "third", "alike"),
    [
        ("suit: jacket, waistcoat and trousers", "waistcoat", True),
        ("three piece suit", "waistcoat", True),
        ("three piece suit in grey tweed", "grey tweed waistcoat", True),
        ("a navy three-piece suit with a paisley waistcoat", "paisley waistcoat", False),
        ("jacket, shirt and jeans", "shirt", False),
        ("a velvet suit with a white shirt", "white shirt", False),
        ("camel coat over a black turtleneck and jeans", "black turtleneck top", False),
        ("white shirt, grey jumper and a black coat", "black coat", False),
        ("a blazer with matching trousers and a silk blouse to wear underneath", "silk blouse", False),
        ("white blouse and black skirt", "", False),
    ],
)
def test_a_third_garment_is_worn_with_both(text, third, alike):
    found = two_garments(text)
    assert (found.third, found.third_alike, found.besides) == (third, alike, ())


@pytest.mark.parametrize(
    ("text", "besides"),
    [
        ("three piece suit with a white shirt", ("shirt",)),
        ("a blouse and a skirt like a kilt", ("kilt",)),
    ],
)
def test_what_is_named_besides_and_not_made_is_told(text, besides):
    assert two_garments(text).besides == besides


def test_an_order_for_a_third_garment_is_about_its_words():
    assert Order("navy suit with a white shirt", part="beside").words == "white shirt"
    with pytest.raises(InputError, match="no third"):
        Order("a navy suit", part="beside")


@pytest.mark.parametrize("text", ONE)
def test_one_garment_is_never_parted(text):
    assert two_garments(text) is None


def test_every_outfit_of_the_table_is_made_of_garments_of_both_halves():
    for name, outfit in _outfits().items():
        assert two_garments(name) is not None, name
        for garment in (outfit.upper, outfit.lower):
            assert not read_words(garment).unknown, garment


def test_an_order_for_a_part_is_about_its_words_and_keeps_the_wish():
    order = Order("a white blouse and a black skirt", part="lower")
    assert order.words == order.title == "a black skirt"
    assert order.to_json()["text"] == "a white blouse and a black skirt"
    assert Order("a white blouse and a black skirt").words == "a white blouse and a black skirt"


@pytest.mark.parametrize(
    ("text", "shared"),
    [
        ("power suit with a pencil skirt", True),
        ("crop top and skirt set", True),
        ("navy suit", False),  # says its own
        ("a blouse and a skirt", False),
    ],
)
def test_a_set_without_a_colour_is_all_in_one(text, shared):
    assert (color_of_set(two_garments(text)) is not None) == shared

"""Who wears a garment, as texts say it."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.wishes.wearers.wearer_words import hear_wearer


@pytest.mark.parametrize(
    ("text", "rest", "size", "measures", "figure"),
    [
        ("a dress in size 12", "a dress", "women UK 12", None, None),
        ("a red EU 40 skirt", "a red skirt", "women EU 40", None, None),
        ("a men's T-shirt in size L", "a men's T-shirt", "men L", None, None),
        ("hoodie XL", "hoodie", "women XL", None, None),
        ("US 8 dress", "dress", "women US 8", None, None),
        ("five foot two, wrap dress", "wrap dress", None, {"height": 157.0}, None),
        ("a tunic for my wife who is nearly six foot", "a tunic", None, {"height": 183.0}, "women"),
        ("shirt for my dad, he has a big stomach", "shirt, he", "men EU 58", None, None),
        ("my arms: I have short arms, blouse", "my arms: I have, blouse", None, {"arm_length": 49.0}, None),
        ("wide pants for short legs", "wide pants", None, {"height": 157.0}, "women"),
        ("a dress for a woman of 160 cm", "a dress", None, {"height": 160.0}, "women"),
        ("trousers for a man who is 1.9 m tall", "trousers", None, {"height": 190.0}, "men"),
        (
            "dress, bust 52 inches, waist 46, hips 58",
            "dress",
            None,
            {"bust": 52 * 2.54, "waist": 46 * 2.54, "hips": 58 * 2.54},
            None,
        ),
        (
            "sundress, bust 31, waist 25, hips 34",
            "sundress",
            None,
            {"bust": 31 * 2.54, "waist": 25 * 2.54, "hips": 34 * 2.54},
            None,
        ),
        ("trousers, waist 34", "trousers", None, {"waist": 34 * 2.54}, None),
        (
            "schmale Hose, Brust 98, Taille 86, Hüfte 106",
            "schmale Hose",
            None,
            {"bust": 98, "waist": 86, "hips": 106},
            None,
        ),
        (
            "camisa, pecho 128 cintura 124 y mido 1.70",
            "camisa, y",
            None,
            {"bust": 128, "waist": 124, "height": 170},
            None,
        ),
        (
            "a black robe, I have 92-74-101",
            "a black robe, I have",
            None,
            {"bust": 92, "waist": 74, "hips": 101},
            None,
        ),
        ("plus size, 24, tunic with elbow sleeves", "tunic with elbow sleeves", "women UK 24", None, None),
        ("plus size 26 wide leg trousers", "wide leg trousers", "women UK 26", None, None),
        ("plus size top with 12 buttons", "top with 12 buttons", "women EU 50", None, None),
        ("a petite midi dress", "a midi dress", None, {"height": 157.0}, "women"),
        ("I'm 6ft, a maxi dress", "I'm, a maxi dress", None, {"height": 183.0}, None),
        ("for a 5'10\" woman, a jumpsuit", "for a woman, a jumpsuit", None, {"height": 178.0}, "women"),
        ("5 foot 4 tall, trousers", "trousers", None, {"height": 163.0}, None),
        ("for someone 1.80 m, a coat", "for someone, a coat", None, {"height": 180.0}, None),
        ("a plus-size jumpsuit", "a jumpsuit", "women EU 50", None, None),
        ("a dress for a girl", "a dress", "children EU 128", None, None),
        ('fitted top, 36" bust', "fitted top", None, {"bust": 36 * 2.54}, None),
        ("a 46 inch bust dress", "dress", None, {"bust": 46 * 2.54}, None),
        ("jeans, waist 28 inches", "jeans", None, {"waist": 28 * 2.54}, None),
        ("a T-shirt for an 8-year-old", "a T-shirt", "children UK 8", None, None),
        (
            "a skirt, bust 92, waist 74 cm, hips 98",
            "a skirt",
            None,
            {"bust": 92, "waist": 74, "hips": 98},
            None,
        ),
    ],
)
def test_the_wearer_is_taken_out_of_a_text(text, rest, size, measures, figure):
    heard = hear_wearer(text)
    assert heard.rest == rest
    assert heard.wearer is not None
    assert (heard.wearer.size, heard.wearer.measures, heard.wearer.figure) == (size, measures, figure)


@pytest.mark.parametrize(
    "text",
    [
        "a knee-length dress",
        "a women's blouse",
        "boyfriend jeans",
        "an oversized shirt with a large collar",
        "a dress 10 cm longer at the waist",
        "make it 5 cm wider around the chest",
        "a medium length skirt",
        "",
    ],
)
def test_other_texts_stay_as_they_are(text):
    heard = hear_wearer(text)
    assert heard.wearer is None and heard.rest == text


@pytest.mark.parametrize(
    ("text", "rest"),
    [
        ("flower girl dress", "flower girl dress"),
        ("a Flower-Girl dress for a girl", "a Flower-Girl dress"),
        ("a dress for my daughter", "a dress"),
        ("a girl's red dress", "red dress"),
    ],
)
def test_children_in_names_of_garments_stay(text, rest):
    heard = hear_wearer(text)
    assert heard.rest == rest
    assert heard.wearer is not None and heard.wearer.size == "children EU 128"


def test_girths_of_an_instruction_are_the_garments():
    assert hear_wearer("make the waist 70 cm", instruction=True).wearer is None
    assert hear_wearer("make it size 46", instruction=True).wearer is not None


@given(st.text(max_size=200))
def test_any_text_is_read(text):
    heard = hear_wearer(text)
    assert len(heard.rest) <= len(text) or heard.wearer is None


@pytest.mark.parametrize("text", ["farm girl dress", "a soft girl top", "a dress with a 10 inch waistband"])
def test_looks_and_inches_of_garments_are_no_wearers(text):
    assert hear_wearer(text).wearer is None


@pytest.mark.parametrize(
    "text",
    [
        "My daughter is nineteen: a dress",
        "a skirt 6 ft wide at the hem",
        'a hem 4" above the knee',
        "land girl breeches",
        "une petite veste",
    ],
)
def test_other_feet_and_other_small_things_are_nobodys_height(text):
    heard = hear_wearer(text)
    assert heard.wearer is None and heard.rest == text


def test_a_lone_french_size_is_no_waist():
    wearer = hear_wearer("jupe taille 42").wearer
    assert wearer is not None and wearer.size == "women EU 40" and wearer.measures is None


@pytest.mark.parametrize(
    ("text", "measures"),
    [
        ("trousers, inseam 32 inches, waist 34", {"inseam": 88.3, "waist": 86.4}),
        ('black trousers, 31" inseam', {"inseam": 85.7}),
        ("chinos, inside leg 80 cm", {"inseam": 87.0}),
    ],
)
def test_who_asks_for_long_legs_has_them(text, measures):
    heard = hear_wearer(text)
    assert heard.wearer is not None
    assert {name: round(value, 1) for name, value in heard.wearer.measures.items()} == measures
    assert "ins" in heard.rest  # it is the length of the trousers as well


@pytest.mark.parametrize(
    "text", ["shorts with a 5 inch inseam", "trousers, inseam 26 inches", "jeans, 34 inseam, that drag"]
)
def test_shorter_legs_are_the_garments_alone(text):
    assert hear_wearer(text).wearer is None


def test_who_wears_it_is_heard_once_however_often_it_is_asked():
    text = "a linen dress for a woman of 171 cm"
    assert hear_wearer(text) is hear_wearer(text)
    assert hear_wearer(text, instruction=True) is not hear_wearer(text)

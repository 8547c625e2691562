"""What sounds like the wearer of a garment and is not."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.wishes.wearers.not_the_wearer import hide_others, with_finished_chest
from swifttailor.wishes.wearers.wearer_words import hear_wearer


@pytest.mark.parametrize(
    "text",
    [
        "a dress for my daughter's wedding",
        "mother of the groom, my son gets married in June",
        "girls night out top",
        "dresses for the girls in our tearoom",
        "boy shorts",
        "a magical girl outfit",
        "flapper girl dress",
        "the gown that the girl in the film wears",
        "a petite floral print dress",
        "a skirt with a curvy hem",
        "hoodie with an XL hood",
        "give us 2 pockets",
        "a shirt with size 18 buttons",
        "My daughter says polka dots, a swing dress",
        "a tunic for our principal boy",
        "smart, but I crawl on the floor with toddlers",
        "ribbed dresses, XS to XL",
        "a jacket in S, M, L and XL",
    ],
)
def test_others_and_other_things_have_no_size_of_the_wearer(text):
    heard = hear_wearer(text)
    assert heard.wearer is None and heard.rest == text


@pytest.mark.parametrize(
    "text",
    [
        "a dress for my daughter",
        "boys shirt",
        "a dress for the girls, aged 8",
        "a shirt for my husband who is rather large round the middle",
        "a shirt for a man with a bit of a paunch",
        "my son wants a hoodie",
        "petite dress",
        "a top in XL",
        "US 8 dress",
    ],
)
def test_wearers_are_still_heard(text):
    assert hear_wearer(text).wearer is not None


@pytest.mark.parametrize(
    ("text", "rest"),
    [
        ("finished chest 108, length 70", "finished chest 108 cm, length 70"),
        ("tunic, bust 110 finished, no collar", "tunic, finished chest 110 cm, no collar"),
        ("top, chest 100, length 60", "top, finished chest 100 cm, length 60"),
        ("Chest: 104 cm. Sleeves: 22 cm.", "finished chest 104 cm. Sleeves: 22 cm."),
    ],
)
def test_among_measures_of_the_garment_a_chest_is_its_own(text, rest):
    heard = hear_wearer(text)
    assert heard.wearer is None and heard.rest == rest


@pytest.mark.parametrize(
    "text",
    [
        "bust 104, waist 86, hips 110, sleeve 60",
        "I am bust 104, dress length 100",
        "shirt for a man, chest 104, length 70",
        "a knee length dress, bust 104",
    ],
)
def test_a_girth_of_a_body_stays_one(text):
    wearer = hear_wearer(text).wearer
    assert wearer is not None and wearer.measures is not None and wearer.measures["bust"] == 104.0


def test_in_instructions_no_chest_is_renamed():
    assert hear_wearer("chest 104, length 70", instruction=True).rest == "chest 104, length 70"


@given(st.text(alphabet=st.characters(exclude_categories=["Co", "Cs"]), max_size=80))
def test_hidden_words_come_back(text):
    hidden = hide_others(text)
    assert hidden.shown(hidden.text) == text


@given(st.text(max_size=60))
def test_texts_without_a_chest_stay(text):
    if "chest" not in text.lower() and "bust" not in text.lower():
        assert with_finished_chest(text) == text

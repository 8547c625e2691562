"""How high slits go, by places of the body; and where close skirts begin to flare, which is no hem."""

from __future__ import annotations

import pytest

from swifttailor.wishes.text.slit_levels import slit_levels
from swifttailor.wording.lexicon import read_words


@pytest.mark.parametrize(
    ("text", "height"),
    [
        ("strappy maxi dress with slit to the knee", 41.0),
        ("a floor length gown, a slit up to mid-thigh", 61.0),
        ("column dress and a slit but only up to the knee", 37.0),
        ("midi skirt with a slit to the knee", 19.0),
        ("knee length skirt with a slit to the knee", None),
        ("a gown with a slit, sleeves to the elbow", None),
        ("maxi skirt to the ankle", None),
    ],
)
def test_a_slit_ends_where_the_body_says(text, height):
    heard = slit_levels(text, read_words(text), ())
    assert [claim.value for claim in heard.claims] == ([] if height is None else [height])
    assert len(heard.spans) == len(heard.claims)


@pytest.mark.parametrize(
    "text",
    [
        "Tango skirt, tight to the knee then fishtail",
        "an evening skirt, tight to the knee then a godet flare",
        "flamenco dress, three flounces starting at the knee",
        "dress fitted to the knee and flared below",
        "skirt close to the knee, flaring out below",
    ],
)
def test_where_a_skirt_turns_is_no_hem(text):
    said = {i.claim.name for i in read_words(text).implications if i.said}
    assert "skirt_hem" not in said


@pytest.mark.parametrize(
    "text", ["a tight skirt to the knee", "skirt, straight to the knee", "slim, to the knee"]
)
def test_others_still_end_there(text):
    words = read_words(f"{text} skirt" if "skirt" not in text else text)
    assert "skirt_hem" in {i.claim.name for i in words.implications if i.said}

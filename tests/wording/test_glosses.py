"""Wishes in languages without tables, word for word in English."""

from __future__ import annotations

import pytest

from swifttailor.wording.lexicon import glossed, read_words


@pytest.mark.parametrize(
    ("text", "english"),
    [
        ("mormors blommiga klänning med krage", "floral dress with collar"),
        ("袖なしの黒いワンピース、膝丈", "no sleeves black dress, knee length"),
        ("czerwona spódnica z koła do kolan", "red skirt circle knee length"),
        ("spodnie dzwony", "flared trousers"),
        ("sort kjole med lange ærmer", "black dress with long sleeves"),
        ("uzun kollu beyaz gömlek", "long sleeves white shirt"),
        ("синее платье в горошек до колен", "blue dress polka dots knee length"),
        ("검은색 롱 원피스", "black maxi dress"),
        ("mörkblå byxor med hög midja", "dark blue trousers with high waist"),
        ("ciemnozielony płaszcz z kapturem", "dark green coat with hood"),
        ("en florbig klänning", "florbig dress"),
        ("синее платье-футляр с рукавом три четверти", "blue sheath dress with three-quarter sleeves"),
        ("платье-мешок", "dress мешок"),
    ],
)
def test_foreign_wishes_are_put_into_english(text: str, english: str) -> None:
    assert glossed(text) == english
    assert any(i.claim.name == "kind" for i in read_words(english).implications)


@pytest.mark.parametrize(
    "text",
    [
        "a denim jacket but as a dress",
        "a maxi dress with sleeves",
        "top lila",
        "rotes Kleid mit langen Ärmeln",
        "zwarte jurk met lange mouwen",
        "robe noire courte à manches longues",
        "vestido rosa corto",
        "pantaloni larghi di lino",
        "toaster",
        "",
    ],
)
def test_what_is_read_anyway_stays(text: str) -> None:
    assert glossed(text) == text

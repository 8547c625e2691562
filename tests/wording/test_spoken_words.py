"""Words as people speak and type them in other languages: names, diminutives, what is refused first."""

from __future__ import annotations

import pytest

from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wording.lexicon import read_words
from swifttailor.wording.lexicon.inflection import base_forms


def said(text: str) -> set[str]:
    reading = read_words(text)
    assert not reading.unknown, reading.unknown
    return {f"{each.claim.name}={each.claim.value}" for each in reading.implications}


@pytest.mark.parametrize(
    ("text", "language", "claims"),
    [
        ("Strampler", "de", {"kind=jumpsuit", "sleeves=long"}),
        ("Schlaghosn", "de", {"kind=trousers", "legs=flared"}),
        ("Bluse, dreiviertel Arm, weis", "de", {"kind=top", "sleeves=three-quarter"}),
        ("Sommerfähnchen mit Flatterärmeln", "de", {"kind=dress", "sleeves=short"}),
        ("Tweedrock, vorne ein Schlitz", "de", {"kind=skirt", "slit=front"}),
        ("robe bustier", "fr", {"kind=dress", "shoulders=strapless"}),
        ("salopette courte", "fr", {"kind=playsuit", "sleeves=none"}),
        ("pat d'eph", "fr", {"kind=trousers", "legs=flared"}),
        ("robe de grossesse, taille sous la poitrine", "fr", {"kind=dress", "waist_seam=empire"}),
        ("rebequita", "es", {"kind=top", "sleeves=long"}),
        ("una chamarra con gorro para el frío", "es", {"kind=top", "hood=hood"}),
        ("blusa campesina con los hombros al aire", "es", {"kind=top", "shoulders=strapless"}),
        ("enterito corto para el verano, che", "es", {"kind=playsuit"}),
        ("saia de roda inteira", "pt", {"kind=skirt", "skirt=circle"}),
        ("macaquinho jeans sem manga", "pt", {"kind=playsuit", "sleeves=none"}),
        ("moletom com touca", "pt", {"kind=top", "hood=hood"}),
        ("felpa col capuccio smanicata per palestra", "it", {"kind=top", "hood=hood", "sleeves=none"}),
        ("mutandoni della nonna", "it", {"kind=shorts", "leg_hem=calf"}),
        ("hansop voor volwassenen met muts eraan", "nl", {"kind=jumpsuit", "hood=hood"}),
        ("boerenkiel", "nl", {"kind=top", "sleeves=long"}),
    ],
)
def test_what_people_call_it_is_known(text, language, claims):
    assert read_words(text).language == language
    assert claims <= said(text)


@pytest.mark.parametrize("text", ["robe", "satin robe", "hooded robe", "short robe"])
def test_an_english_robe_stays_one(text):
    assert read_words(text).language == "en"


@pytest.mark.parametrize(
    ("text", "kind", "refused"),
    [
        ("no quiero minifalda, quiero un shorcito bien cortito", "shorts", "skirt"),
        ("bitte keinen Rock, sondern eine Schlaghose", "trousers", "skirt"),
        ("no mini skirt, I want shorts", "shorts", "skirt"),
        ("Skihose hab ich schon, brauch ein Skiunterhemd", "top", "trousers"),
    ],
)
def test_the_garment_that_is_not_refused_is_asked_for(text, kind, refused):
    assert f"kind={kind}" in said(text)
    assert refused in {str(claim.value) for claim in read_words(text).never if claim.name == "kind"}


@pytest.mark.parametrize(
    ("language", "forms"),
    [
        ("es", {"faldita": "falda", "chaquetitas": "chaqueta", "manguita": "manga", "cortito": "corto"}),
        ("it", {"magliettina": "maglietta", "giacchina": "giacca", "corpini": "corpo"}),
        ("pt", {"blusinha": "blusa", "casaquinho": "casaco", "justinhas": "justo", "calçãozinho": "calção"}),
    ],
)
def test_what_is_little_is_the_same_garment(language, forms):
    for form, word in forms.items():
        assert word in [base for base, _ in base_forms(form, language)], form


@pytest.mark.parametrize(
    ("text", "cm"),
    [
        ("60 Zentimeter", 60.0),
        ("60 centimètres", 60.0),
        ("60 centímetros", 60.0),
        ("60 centimetri", 60.0),
        ("13 pouces", 33.02),
        ("10 pulgadas", 25.4),
        ("10 polegadas", 25.4),
        ("10 Zoll", 25.4),
    ],
)
def test_units_are_known_in_other_languages(text, cm):
    (mention,) = find_mentions(text)
    assert mention.is_length
    assert mention.value == pytest.approx(cm)

"""Words of everyday in other languages: persons and costumes, what clothes are to be like, cloth, folds."""

from __future__ import annotations

import pytest

from swifttailor.wording.lexicon import read_words


def entries_of(text: str) -> set[str]:
    """The English names of the entries of its words; all of them are known."""
    reading = read_words(text)
    assert not reading.unknown, reading.unknown
    return {entry.english for mark in reading.marks for entry in mark.entries if entry.english}


@pytest.mark.parametrize(
    ("text", "language", "entry"),
    [
        ("Hexenkostüm", "de", "witch"),
        ("costume de pirate", "fr", "pirate"),
        ("disfraz de bruja", "es", "witch"),
        ("costume da strega", "it", "witch"),
        ("heksenjurk", "nl", "witch"),
        ("fantasia de bruxa", "pt", "witch"),
        ("schlichtes Kleid, blickdicht", "de", "opaque"),
        ("Hose zum Tanzen", "de", "dancing"),
        ("Damenhose schwarz mit Bügelfalte", "de", "creases"),
        ("robe qui cache le ventre", "fr", "hides my tummy"),
        ("pantalon cargo kaki", "fr", "olive"),
        ("jupe, taille élastique", "fr", "elastic waist"),
        ("robe à paillettes", "fr", "sequin dress"),
        ("chándal", "es", "tracksuit"),
        ("jeans de campana", "es", "flared jeans"),
        ("vestido con volantes en las mangas", "es", "ruffle sleeves"),
        ("blusa de topos", "es", "polka dots"),
        ("pantaloni con le pinces", "it", "pleated trousers"),
        ("vestito stretto in vita", "it", "nipped waist"),
        ("lange trui met kabels", "nl", "cable knit"),
        ("saia travada", "pt", "pencil skirt"),
    ],
)
def test_everyday_words_are_known(text, language, entry):
    assert read_words(text).language == language
    assert entry in entries_of(text)


@pytest.mark.parametrize(
    ("text", "claim"),
    [
        ("un vestido sin escote", "neck_depth=high"),
        ("robe sans décolleté", "neck_depth=high"),
        ("Kleid ohne Ausschnitt", "neck_depth=high"),
        ("vestito senza scollatura", "neck_depth=high"),
        ("jurk zonder decolleté", "neck_depth=high"),
        ("vestido sem decote", "neck_depth=high"),
        ("Jumpsuit kurz", "kind=playsuit"),
    ],
)
def test_what_is_refused_of_a_neckline_leaves_a_high_one(text, claim):
    assert claim in {f"{i.claim.name}={i.claim.value}" for i in read_words(text).implications}


@pytest.mark.parametrize(
    ("text", "language"), [("Rock", "de"), ("Rock mini", "de"), ("rock chick", "en"), ("punk rock", "en")]
)
def test_a_skirt_is_german_where_all_of_the_text_is(text, language):
    assert read_words(text).language == language


@pytest.mark.parametrize(
    ("text", "own"),
    [
        ("polo shirt short sleeve navy 3 button", True),
        ("navy polo shirt 3 button", True),
        ("white polo shirt with navy buttons", False),
        ("shirt linen navy short sleeve mens", True),
        ("cardigan long navy pockets", True),
        ("Bluse dunkelblau Rüschenkragen", True),
        ("Kleid dunkelblau weißer Kragen", True),
        ("weiße Bluse, dunkelblauer Rüschenkragen", False),
    ],
)
def test_a_color_before_a_count_is_the_garments(text, own):
    assert ("1f2a44" in {color.rgb for color in read_words(text).colors}) is own

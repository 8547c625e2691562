"""Tables of the lexicon: every row says something that the product knows, once, and in few words."""

from __future__ import annotations

import dataclasses
import re
from collections import Counter
from pathlib import Path

import pytest

from swifttailor.describing import CLAIM_TYPES, Claim
from swifttailor.draping.known_fabrics import FABRICS
from swifttailor.errors import InputError
from swifttailor.render import prints
from swifttailor.wording.lexicon.conflicts import SCALES, beyond, exclude
from swifttailor.wording.lexicon.entries import MOTIFS, PRINTS
from swifttailor.wording.lexicon.inflection import LANGUAGES, NAMES, base_forms
from swifttailor.wording.lexicon.vocabulary import (
    TABLES,
    WORDS,
    all_entries,
    cannot_texts,
    entries_in,
    vocabulary,
    vocabulary_of,
)
from swifttailor.wording.word_tables import parse_table

SILENT = ("function", "polite", "degrees", "comparisons", "numbers", "negations")
OTHERS = LANGUAGES[1:]


def lexicon(table: str):
    return vocabulary_of(parse_table(table, "table.txt"))


def words_in(*categories: str, language="en") -> set[str]:
    return {word for category in categories for e in entries_in(category, language) for word in e.words}


@pytest.mark.parametrize("language", TABLES)
def test_every_table_can_be_read_and_every_file_is_one(language):
    assert len(all_entries(language)) > 250
    read = {name for names in TABLES.values() for name in names}
    read |= {"cannot.txt", "usual_colors.txt", "outfits.txt"}
    assert read == {path.name for path in WORDS.iterdir()}


def test_there_are_words_for_most_of_what_people_ask_for():
    assert len(words_in("garments")) >= 2000
    assert len(words_in("styles")) >= 1000
    assert len(words_in("occasions")) >= 300
    assert len(words_in("fits", "lengths")) >= 300
    assert len(entries_in("garments")) >= 500
    assert len(entries_in("styles")) >= 150
    assert len(entries_in("colors")) >= 148 + 80


@pytest.mark.parametrize("language", OTHERS)
@pytest.mark.parametrize(
    ("categories", "least"), [(("garments",), 100), (("styles",), 60), (("lengths",), 30), (("colors",), 25)]
)
def test_other_languages_have_words_too(language, categories, least):
    assert len(words_in(*categories, language=language)) >= least


@pytest.mark.parametrize("language", OTHERS)
def test_words_of_other_languages_stand_for_english_entries(language):
    for entry in all_entries(language):
        senses = vocabulary("en").find((entry.english or "").lower().split())
        assert entry.gloss in {sense.entry.gloss for sense in senses}, entry.words


def test_every_entry_has_a_gloss_of_its_own_words():
    for entry in all_entries():
        assert 3 <= len(entry.gloss) <= 120, entry.name
        assert entry.gloss.strip() == entry.gloss and not entry.gloss.endswith("."), entry.name
        assert entry.gloss.lower() != entry.name.lower(), entry.name


def test_no_entry_contradicts_itself():
    for entry in all_entries():
        claims = entry.claims()
        assert len(set(claims)) == len(claims), entry.name
        assert not set(claims) & set(entry.against), entry.name
        assert not any(exclude(a, b) for a in claims for b in claims), entry.name


def test_words_that_hold_texts_together_imply_nothing():
    for category in SILENT:
        for entry in entries_in(category):
            assert not entry.implied and not entry.cannot and entry.color is None, entry.name


def test_garments_have_one_kind_by_definition():
    for entry in entries_in("garments"):
        kinds = [claim.value for claim in entry.claims("certain") if claim.name == "kind"]
        assert len(kinds) == 1 or not kinds, entry.name
        assert entry.kinds, entry.name


def test_all_that_cannot_be_made_is_used_and_said_in_words():
    used = {what for entry in all_entries() for what in entry.cannot}
    assert used == set(cannot_texts())
    for text in cannot_texts().values():
        assert re.fullmatch(r"[a-z][^.\n]{2,80}", text)


def test_cloths_and_prints_are_those_of_the_product():
    assert {entry.cloth for entry in all_entries()} - {None} == set(FABRICS)
    fields = {
        kind: {field.name for field in dataclasses.fields(getattr(prints, kind.capitalize()))}
        for kind in PRINTS
    }
    for kind, sizes in PRINTS.items():
        assert set(sizes) <= fields[kind], kind
    drawn = [entry.print for entry in all_entries() if entry.print is not None]
    assert {named.kind for named in drawn} == set(PRINTS)
    assert {named.motif for named in drawn if named.kind == "motif"} == set(MOTIFS)


def test_colors_are_those_of_cloth():
    known = {word.lower(): e.color for e in entries_in("colors") for word in e.words}
    for name, rgb in {"rebecca purple": "663399", "green": "40724f", "forest green": "2c4533"}.items():
        assert known[name] == rgb
    assert Counter(len(rgb) for rgb in known.values() if rgb is not None).keys() == {6}


def test_scales_name_all_values_that_have_an_order():
    for name, scale in SCALES.items():
        values = {value for step in scale for value in step}
        assert values <= set(CLAIM_TYPES[name].words), name
        unordered = {"none", "left only", "right only", "unequal"} if name == "sleeves" else set()
        assert set(CLAIM_TYPES[name].words) - values == unordered, name


def test_exclusion_goes_both_ways_and_never_between_equals():
    claims = [
        claim
        for name, claim_type in CLAIM_TYPES.items()
        for claim in [Claim(name, value) for value in claim_type.words]
    ]
    for a in claims:
        assert not exclude(a, a)
        assert a in beyond(a)
        for b in claims:
            assert exclude(a, b) == exclude(b, a), (a, b)


@pytest.mark.parametrize(
    ("language", "forms"),
    [
        (
            "it",
            {
                "bianche": "bianco",
                "larghi": "largo",
                "gonne": "gonna",
                "verdi": "verde",
                "camicie": "camicia",
            },
        ),
        ("it", {"grigie": "grigio", "lisci": "liscio", "nera": "nero", "maniche": "manica"}),
        (
            "nl",
            {
                "witte": "wit",
                "rode": "rood",
                "kragen": "kraag",
                "rokken": "rok",
                "losse": "los",
                "grijze": "grijs",
            },
        ),
        (
            "nl",
            {"jurkjes": "jurk", "mouwtjes": "mouw", "truien": "trui", "donkere": "donker", "brede": "breed"},
        ),
        (
            "pt",
            {"azuis": "azul", "pretas": "preto", "calções": "calção", "botões": "botão", "marrons": "marrom"},
        ),
    ],
)
def test_forms_lead_to_their_words(language, forms):
    for form, word in forms.items():
        assert word in [base for base, _ in base_forms(form, language)], form


def test_a_vowel_that_would_be_short_is_no_form_in_dutch():
    assert "los" not in [base for base, _ in base_forms("lose", "nl")]


def test_every_language_has_a_name_and_tables():
    assert set(NAMES) == set(LANGUAGES) == set(TABLES)


GLOSS = '"what it means"'


@pytest.mark.parametrize(
    ("table", "problem"),
    [
        (f"[garments]\nkind=gown : gown | {GLOSS}", "gown"),
        (f"[garment]\nkind=dress : dress | {GLOSS}", "there is no section 'garment'"),
        ("[garments]\nkind=dress : dress", "quotation marks"),
        (f'[garments]\nkind=dress : dress | "{"x" * 121}"', "121 characters"),
        (f"[styles]\ncannot:wings : winged | {GLOSS}", "cannot:wings"),
        (f"[styles]\nneckline=v of:hat : V | {GLOSS}", "of:hat"),
        (f"[colors]\nrgb:12345 : odd | {GLOSS}", "six digits"),
        (f"[prints]\nprint:stripes radius:2 : striped | {GLOSS}", "stripes have no radius"),
        (f"[styles]\ncannot:zip trim:zipper : zip | {GLOSS}", "trim:zipper is none of"),
        (f"[styles]\ncannot:zip trim:back_zip,zap : zip | {GLOSS}", "trim:zap is none of"),
        (f"[prints]\nprint:motif : flowery | {GLOSS}", "motif:"),
        (f"[garments]\nkind=dress look:a8202c : gown | {GLOSS}", "look:a8202c"),
        (f"[garments]\nkind=dress look:a8202(edging) : gown | {GLOSS}", "look:a8202 is none of"),
        (f"[styles]\nnever:x : y | {GLOSS}", "never"),
        (f"[styles]\nsometimes : y | {GLOSS}", "is no mark"),
        (f"[negations]\nnegates:around : no | {GLOSS}", "negates:around"),
        (f"[styles]\nneckline=v : V neck | v-neck | {GLOSS}", "are one word"),
        (
            f"[styles]\nneckline=v : vee | {GLOSS}\nneckline=boat : Vee | {GLOSS}",
            "stands in table.txt, line 2",
        ),
    ],
)
def test_mistakes_are_named_with_their_line(table, problem):
    with pytest.raises(InputError, match=r"table\.txt, line") as caught:
        lexicon(table)
    assert problem in str(caught.value)


def test_meanings_may_share_a_word_where_something_tells_them_apart():
    known = lexicon(
        f"[fits]\nfit=loose of:top : wide | {GLOSS}\n[styles]\nlegs=wide of:trousers : wide | {GLOSS}\n"
        f"[garments]\nkind=top : jersey | {GLOSS}\n[fabrics]\ncloth:jersey : jersey | {GLOSS}"
    )
    assert len(known.find(["wide"])) == 2
    assert len(known.find(["jerseys"])) == 2


def test_the_rows_of_the_guide_can_be_added():
    guide = (Path(__file__).parents[2] / "docs" / "lexicon.md").read_text()
    english, german = re.findall(r"```text\n(.*?)```", guide.partition("## A word of your own")[2], re.DOTALL)
    known = lexicon(f"[garments] kind=dress\n{english}")
    assert known.find(["karosses"]) and not vocabulary("en").find(["kaross"])
    (row,) = parse_table(f"[words]\n{german}", "german.txt")
    assert row.options == {"is": ("kaross",)} and row.texts == ("Fellumhang",)


def test_spellings_and_plurals_are_found_and_nothing_near_them():
    known = lexicon(f"[garments]\nkind=top : T shirt | tea dress | scarf | knife | berry @uk | {GLOSS}")
    for parts in ("t shirt", "tshirt", "tshirts", "t shirts", "scarves", "knives", "berries", "teadress"):
        assert known.find(parts.split()), parts
    for parts in ("shirt", "t shirtt", "tshrt", "scarfe", "berrie", "tea dres"):
        assert not known.find(parts.split()), parts


def test_names_of_garments_and_cloths_lose_no_colour():
    """A "white shirt" that is one name of a garment would come in any colour."""
    colors = {word.lower() for entry in entries_in("colors") for word in entry.words}
    alike = {
        "flax",
        "mulberry",
        "sable",
        "elephant",
        "snow",
        "pumpkin",
        "buff",
        "linen",
        "khaki",
        "metallic",
        "natural",
        "camel",
        "stone",
    }
    for category in ("garments", "fabrics"):
        names = {word.lower() for entry in entries_in(category) for word in entry.words}
        for entry in (e for e in entries_in(category) if e.color is None):
            for word in map(str.lower, entry.words):
                first, _, rest = word.partition(" ")
                lost = first in colors - alike and rest in names
                assert not lost, f"{entry.place}: {word}"

"""Reading by the lexicon alone: what words imply, what is denied, what cannot be made, what nobody knows."""

from __future__ import annotations

import subprocess
import sys

import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from swifttailor.describing import Claim
from swifttailor.wording.lexicon import read_words
from swifttailor.wording.lexicon.marking import find_words
from swifttailor.wording.lexicon.tokens import tokens_of, words_of
from swifttailor.wording.lexicon.vocabulary import all_entries, entries_in, vocabulary

NOUNS = [e for e in entries_in("garments") if not e.ambiguous]
NAMES = sorted({w.partition(" @")[0] for e in NOUNS for w in e.words if "@" not in w and w.isascii()})
DETAILS = sorted({w for e in entries_in("styles") if not e.of for w in e.words if w.isascii()})
WORDS = sorted({w for e in all_entries() for w in e.words if "#" not in w})
UNSEEN = ["wuzzle", "florp", "zibbet", "asdfghjkl", "quorl"]
texts_of_words = st.lists(
    st.sampled_from([*WORDS, *UNSEEN, ",", ".", "and", "with", "no", "not too", "12", "3 cm"]), max_size=9
).map(" ".join)


def said(text, **options):
    """Claims that follow, as ``name=value``."""
    return {f"{i.claim.name}={i.claim.value}" for i in read_words(text, **options).implications}


def cannot(text):
    return {lack.what for lack in read_words(text).lacks}


@given(st.one_of(st.text(max_size=120), texts_of_words))
@example('DRESS"CROP"TROUSER')
@example("L'été, d'une robe: \u2019s 3/4 5'2\" 62cm 👗 -> _ ' - --")
def test_every_word_is_in_exactly_one_mark(text):
    reading = read_words(text)
    ends = [0]
    for number, mark in enumerate(reading.marks):
        # A length within a name is told first, and the name lies around it: "dress crop trousers".
        around = number and mark.start <= reading.marks[number - 1].start and mark.end > ends[-1]
        assert (mark.start >= ends[-1] or around) and mark.end > mark.start
        assert text[mark.start : mark.end] == mark.word
        ends.append(mark.end)
    for token in tokens_of(text, reading.language):
        held = [m for m in reading.marks if m.start < token.end and token.start < m.end]
        assert held or not token.word.replace("'", "").isalnum()
        assert len(held) <= 2  # two halves of a German compound
    assert reading.unknown == tuple(m.word for m in reading.marks if not m.entries)


@given(texts_of_words)
def test_what_follows_is_consistent(text):
    reading = read_words(text)
    claims = [i.claim for i in reading.implications]
    assert len(set(claims)) == len(claims)
    assert not set(claims) & set(reading.never)
    assert sum(claim.name == "kind" for claim in claims) <= 1
    assert read_words(text) == reading
    for mark in reading.marks:
        if mark.denied:
            assert not any(lack.mark == mark for lack in reading.lacks)


@given(texts_of_words)
def test_capitals_change_nothing(text):
    assume(text.upper().lower() == text.lower())
    lower, upper = read_words(text), read_words(text.upper())
    assert [m.entries for m in lower.marks] == [m.entries for m in upper.marks]
    assert said(text) == said(text.upper())


def several(name):
    if name.endswith(("ch", "sh", "x")):
        return f"{name}es"
    return f"{name[:-1]}ies" if name[-1] == "y" and name[-2] not in "aeo" else f"{name}s"


KNOWN = {**vocabulary("en").senses, **vocabulary("en").closed}
ONES = [
    name
    for name in NAMES
    if len(name) > 2
    and name.isalpha()
    and name[-1] not in "sz"
    and not {several(name).lower(), several(name).lower()[:-1]} & KNOWN.keys() - {name.lower()}
]


@given(st.sampled_from(ONES))
def test_one_and_several_are_the_same(name):
    assert said(several(name), language="en") == said(name, language="en")


@given(st.sampled_from([name for name in NAMES if 2 <= len(name.replace("-", " ").split()) <= 3]))
def test_hyphens_blanks_and_neither_are_the_same(name):
    parts = words_of(name, "en")
    expected = said(name, language="en")
    assert said(name.replace(" ", "-"), language="en") == expected
    if "".join(parts).isalpha():
        assert said("".join(parts), language="en") == expected


@given(st.sampled_from(DETAILS))
def test_denial_turns_a_detail_round(word):
    assume(not {"no", "without", "not", "free", "off"} & set(words_of(word, "en")))
    plain, denied = read_words(f"a dress, {word}"), read_words(f"a dress, not {word}")
    mark = next((m for m in denied.marks if m.denied), None)
    assume(mark is not None and len(plain.marks) == len(denied.marks) - 1)
    wanted = {claim for entry in mark.entries for claim in entry.without}
    for entry in mark.entries:
        for claim in entry.claims("certain"):
            assert plain.certainty(claim) is not None or any(claim.name == c.name for c in plain.never)
            assert denied.certainty(claim) is None or claim in wanted
            assert claim in denied.never or claim in wanted
        assert set(entry.cannot) <= {lack.what for lack in plain.lacks}
        assert not set(entry.cannot) & {lack.what for lack in denied.lacks if lack.mark == mark}


@given(st.sampled_from(NAMES))
def test_what_is_said_wins_over_names(name):
    reading = read_words(f"sleeveless {name}")
    garment = next((m for m in reading.marks if m.role == "garment"), None)
    assume(garment is not None and len(reading.marks) == 2 and reading.marks[0].word == "sleeveless")
    certain = {c for entry in garment.entries for c in entry.claims("certain")}
    assume(not any(c.name in ("sleeves", "sleeve_shape", "cuffs") for c in certain))
    claims = {i.claim for i in reading.implications}
    assert Claim("sleeves", "none") in claims
    assert not any(c.name in ("sleeve_shape", "cuffs") and c.value != "none" for c in claims)


@given(st.sampled_from([name for name in NAMES if name.isalpha() and len(name) > 4]), st.data())
def test_a_word_with_another_letter_is_another_word(name, data):
    place = data.draw(st.integers(0, len(name) - 1))
    letter = data.draw(st.sampled_from("qxzj"))
    changed = name[:place] + letter + name[place + 1 :]
    known = vocabulary("en")
    assume(changed.lower() != name.lower() and not known.find([changed.lower()]))
    assert changed in read_words(changed, language="en").unknown


@settings(max_examples=5, deadline=None)
@given(st.sampled_from(["not ", "wide ", "no a ", "dress ", "x", "- ", "'", "l'", "long, wide "]))
def test_long_texts_are_cut(piece):
    reading = read_words(piece * 20_000)
    assert not reading.marks or reading.marks[-1].end <= 20_000


@pytest.mark.parametrize(
    ("text", "claims"),
    [
        ("short black dress", {"kind=dress", "skirt_hem=mini"}),
        ("a dress with short sleeves", {"kind=dress", "sleeves=short"}),
        ("long, wide sleeves", {"sleeves=long", "sleeve_shape=wide"}),
        ("sleeves long and slim on a blouse", {"kind=top", "sleeves=long", "sleeve_shape=slim"}),
        ("knee-length shorts", {"kind=shorts", "leg_hem=knee"}),
        ("wideleg pants", {"kind=trousers", "legs=wide"}),
        ("trousers, wide", {"legs=wide"}),
        ("sleeveless shirt dress", {"kind=dress", "sleeves=none", "collar=lapel"}),
        ("jersey dress", {"kind=dress"}),
        ("a jersey", {"kind=top", "sleeves=long"}),
        ("neither mini nor maxi, a dress", {"kind=dress"}),
        ("Skirt with a dropped waist and puff sleeves", {"kind=dress", "sleeve_shape=puffed"}),
        ("puff sleeves, v neck", {"kind=top", "sleeve_shape=puffed", "neckline=v"}),
        ("ein langes rotes Sommerkleid ohne Ärmel", {"kind=dress", "skirt_hem=maxi", "sleeves=none"}),
        ("Baumwollrock, knielang", {"kind=skirt", "skirt_hem=knee"}),
        ("une jupe plissée longue", {"kind=skirt", "skirt_hem=maxi"}),
        ("una falda larga con volantes", {"kind=skirt", "skirt_hem=maxi"}),
        ("👗", {"kind=dress"}),
        ("a skirt to go with my blouse, short", {"kind=skirt", "skirt_hem=mini"}),
    ],
)
def test_what_follows(text, claims):
    assert claims <= said(text)


@pytest.mark.parametrize(
    ("text", "claims", "never"),
    [
        ("dress without a collar or a hood", {"collar=none", "hood=none"}, set()),
        ("a skirt, not too short", set(), {"skirt_hem=mini", "skirt_hem=micro"}),
        ("neither mini nor maxi, a dress", set(), {"skirt_hem=mini", "skirt_hem=maxi", "skirt_hem=floor"}),
        ("trousers that aren't skinny", set(), {"legs=slim"}),
        ("I hate ruffles, tiers and gathers. Long skirt.", {"skirt_hem=maxi"}, {"skirt=tiered"}),
        ("Not V, not square: a dress with another neckline", set(), {"neckline=v", "neckline=square"}),
        ("a hoodie with no sleeves", {"hood=hood", "sleeves=none"}, set()),
        ("fit: oversized -> fitted", set(), {"fit=oversized"}),
        ("Der Kragen darf auch weg", {"collar=none"}, set()),
        ("une robe sans manches", {"sleeves=none"}, set()),
        ("no wide straps, a top", set(), {"straps=wide"}),
        ("a skirt that is not see through, elastic waist, short", {"skirt_hem=mini"}, set()),
    ],
)
def test_what_is_refused(text, claims, never):
    reading = read_words(text)
    assert claims <= said(text)
    assert never <= {f"{claim.name}={claim.value}" for claim in reading.never}


@pytest.mark.parametrize(
    ("text", "claims"),
    [
        ("pencil skirt, just below the knee", {"skirt_hem=knee"}),
        ("a jacket to wear over my dress", {"kind=dress"}),
        ("spencer dress", {"top_hem=cropped", "kind=top"}),
        ("palazzos that look like a skirt", {"kind=skirt"}),
        ("wide legs that look like a skirt", {"kind=skirt"}),
        ("a dress with a v neck, no collar", {"collar=stand"}),
    ],
)
def test_what_does_not_follow(text, claims):
    assert not claims & said(text)
    assert "separate_pieces" not in cannot(text)


def test_a_denied_detail_is_not_missing():
    assert "pockets" in cannot("trousers with pockets")
    assert "pockets" not in {lack.what for lack in read_words("a skirt, no pockets").lacks}
    zip_said = {lack.what: lack.said for lack in read_words("a dress with a zip").lacks}
    assert zip_said == {"zip": True}
    assert all(not lack.said for lack in read_words("cardigan").lacks)
    assert "open_front" in cannot("cardigan")
    assert "separate_pieces" in cannot("a skirt and a matching bandeau")
    assert "separate_pieces" not in cannot("a dress with a wide skirt")


@pytest.mark.parametrize(
    ("text", "pair"),
    [
        ("short maxi dress", ("short", "maxi dress")),
        ("skin-tight oversized t-shirt", ("skin-tight", "oversized t-shirt")),
        ("wide skinny jeans", ("wide", "skinny jeans")),
        ("a backless top with a high closed back", ("backless", "closed back")),
        ("sleeveless dress with long sleeves", ("sleeveless", "long sleeves")),
        ("collarless blouse with a big lapel collar", ("collarless", "big lapel collar")),
    ],
)
def test_contradictions_are_named(text, pair):
    named = read_words(text).contradictions
    assert pair in [(found.first.word, found.second.word) for found in named]


@pytest.mark.parametrize(
    "text",
    [
        "long dress with short sleeves",
        "midi dress below the knee",
        "sleeveless hoodie",
        "no mini, maxi dress",
        "a hoodie, long enough that my belly button does not show",
    ],
)
def test_what_fits_together_is_no_contradiction(text):
    assert read_words(text).contradictions == ()


def test_cloth_is_found():
    reading = read_words("dusty pink linen blouse with navy polka dots and 2 cm stripes")
    assert [color.words for color in reading.colors] == ["dusty pink", "navy"]
    assert reading.cloths == ("linen",)
    assert [named.kind for named in reading.prints] == ["dots", "stripes"]
    assert read_words("dress size 12").sizes == ("size 12",)
    assert read_words("Size EU 40, blouse").sizes == ("Size EU 40",)
    dark, plain, light = (read_words(f"{shade}plum dress").colors[0].rgb for shade in ("dark ", "", "light "))
    assert sum(bytes.fromhex(dark)) < sum(bytes.fromhex(plain)) < sum(bytes.fromhex(light))


def test_words_of_both_sides_of_the_atlantic():
    assert "sleeves=none" in said("a vest") and "sleeves=none" in said("a jumper", dialect="us")
    assert "kind=dress" in said("a jumper", dialect="us")
    assert {"kind=top", "sleeves=long"} <= said("a jumper", dialect="uk")
    assert "kind=trousers" in said("pants", dialect="us") and "kind=shorts" in said("pants", dialect="uk")
    assert said("pyjamas") == said("pajamas") and said("grey dress") == said("gray dress")


def test_an_instruction_is_about_the_garment_that_it_is_given_for():
    assert "leg_hem=calf" in said("cropped", kind="trousers")
    assert "top_hem=cropped" in said("cropped", kind="top")
    assert "skirt_hem=mini" in said("make it short", kind="skirt")
    assert not any(claim.startswith("kind=") for claim in said("add puff sleeves", kind="dress"))


@pytest.mark.parametrize(
    ("text", "language"),
    [
        ("a red dress", "en"),
        ("rotes Kleid", "de"),
        ("une robe rouge", "fr"),
        ("falda corta", "es"),
        ("", "en"),
        ("xqzv", "en"),
    ],
)
def test_languages_are_told_apart(text, language):
    assert read_words(text).language == language


def test_reading_needs_no_network_and_loads_late():
    code = (
        "import sys; import swifttailor.wording.lexicon as lexicon;"
        "assert 'swifttailor.wording.lexicon.vocabulary' not in sys.modules;"
        "lexicon.read_words('a dress');"
        "heavy = {'onnxruntime', 'numba', 'torch', 'PIL'} & set(sys.modules); assert not heavy, heavy"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize(
    ("text", "collar"),
    [
        ("a shirt with a collar", "lapel"),
        ("a dress with a collar", "lapel"),
        ("a coat with a collar", "lapel"),
        ("a shirt with a high collar", "stand"),
        ("a shirt with a mandarin collar", "stand"),
        ("a bomber jacket with a ribbed collar", "stand"),
        ("a grandad shirt with a white collar", "stand"),
    ],
)
def test_a_plain_collar_is_the_one_that_a_garment_wears(text, collar):
    found = [i.claim.value for i in read_words(text).implications if i.claim.name == "collar"]
    assert found == [collar]


def test_what_is_not_allowed_is_refused() -> None:
    reading = read_words("My boss says sleeveless is not ok. A plain dress with elbow sleeves.")
    assert [mark.word for mark in reading.marks if mark.denied] == ["sleeveless"]
    assert not reading.contradictions


def test_a_comma_ends_what_is_denied() -> None:
    reading = read_words("We have no budget, so it's a long brown skirt")
    assert not reading.never
    assert reading.colors


def test_the_jacket_of_a_dress_is_another_garment() -> None:
    reading = read_words("a knee length dress with a matching jacket")
    assert not [i for i in reading.implications if i.claim.name == "sleeves"]
    assert [lack.what for lack in reading.lacks if lack.said] == ["separate_pieces"]


@pytest.mark.parametrize(
    ("text", "color"),
    [
        ("robe longue bleu nuit", "midnight blue"),
        ("Kleid in Tannengrün", "fir green"),
        ("falda rosa palo", "dusty pink"),
        ("gonna color sabbia", "sand"),
        ("rok in okergeel met zakken in kersenrood", "cherry red"),
        ("saia verde musgo", "moss green"),
    ],
)
def test_colors_of_other_languages(text: str, color: str) -> None:
    meant = read_words(color).colors[0].rgb
    assert meant in [each.rgb for each in read_words(text).colors] + [
        look.color.rgb for look in read_words(text).looks if look.color is not None
    ]


def test_what_contradicts_two_others_is_left_out() -> None:
    reading = read_words("strapless turtleneck with long sleeves")
    assert reading.contradictions
    claims = {f"{i.claim.name}={i.claim.value}" for i in reading.implications}
    assert {"collar=turtleneck", "sleeves=long"} <= claims
    assert "shoulders=strapless" not in claims


def test_a_prom_dress_that_is_not_low_cut_has_shoulders() -> None:
    claims = {f"{i.claim.name}={i.claim.value}" for i in read_words("prom dress, not low cut").implications}
    assert "shoulders=both" in claims
    assert "shoulders=strapless" not in claims


def test_the_words_of_a_text_are_found_once_however_often_it_is_read():
    text = "ein Kleid mit langen Ärmeln"
    assert find_words(text) is find_words(text)


@pytest.mark.parametrize(
    ("text", "color", "together"),
    [
        ("cropped white jeans", "white", {"leg_hem=calf", "legs=straight"}),
        ("a wrap dark green dress", "dark green", {"neckline=v"}),
        ("vestido rojo de flamenca", "rojo", {"skirt=fitted base"}),
        ("falda negra de tubo", "negra", {"skirt=pencil"}),
        ("robe rouge de mariée", "rouge", {"skirt_hem=floor"}),
        ("abito nero da sera", "nero", {"skirt_hem=floor"}),
    ],
)
def test_a_colour_within_a_name_leaves_it_whole(text, color, together):
    assert together <= said(text)
    assert [each.words for each in read_words(text).colors] == [color]


def test_a_colour_behind_a_pause_joins_no_name():
    assert [mark.word for mark in read_words("cropped, white jeans").marks] == ["cropped", "white", "jeans"]
    assert "skirt=fitted base" not in said("vestido rojo con flamenca")


@pytest.mark.parametrize(
    ("text", "claims"),
    [
        ("a tunic, slit at both sides", {"slit=left", "slit=right"}),
        ("a y2k mini skirt", {"rise=low", "skirt_hem=mini"}),
        ("pj shorts", {"kind=shorts", "leg_hem=thigh"}),
        ("a housecoat", {"collar=lapel", "skirt_hem=midi"}),
        ("capri shorts", {"leg_hem=calf", "legs=slim"}),
        ("a healer robe", {"hood=hood", "skirt_hem=floor", "sleeve_shape=wide"}),
        ("a dress, tight on top", {"fit=close", "waist_seam=natural"}),
        ("a skatery dress", {"skirt=flared"}),
    ],
)
def test_words_of_wishes(text, claims):
    assert claims <= said(text)


def test_a_straight_neckline_says_nothing_of_the_skirt():
    assert not {"skirt=straight", "fit=easy"} & said("mermaid gown, straight neckline")


@pytest.mark.parametrize(
    ("text", "never"),
    [
        ("a coat fitted to the waist, very wide turned-down collar", "fit=oversized"),
        ("a shirt with big turned-back cuffs", "fit=oversized"),
        ("a jacket with a huge yoke", "fit=oversized"),
        ("a long skirt with tiny buttons", "sleeves=cap"),
        ("a floor length robe, split up the front to the knee", "skirt_hem=knee"),
        ("a floor length coat with a zip to the waist", "top_hem=waist"),
        ("a dress buttoned down to the waist", "top_hem=waist"),
    ],
)
def test_the_size_of_a_detail_is_none_of_the_garment(text, never):
    assert never not in said(text)
    assert not read_words(text).contradictions


@pytest.mark.parametrize(
    ("text", "sizes"),
    [
        ("a skirt with a small train", ()),
        ("a smock with a small stand-up neck", ()),
        ("a dress with a small slit", ()),
        ("a small zipped jacket", ("small",)),
        ("a small dress with a big bow", ("small",)),
    ],
)
def test_a_small_detail_is_no_size_of_clothes(text, sizes):
    assert read_words(text).sizes == sizes
    assert ("sizes" in {lack.what for lack in read_words(text).lacks}) == bool(sizes)


@pytest.mark.parametrize(
    ("text", "draft", "claims"),
    [
        ("surplice", "shift-dress", {"sleeve_shape=wide", "skirt_hem=knee"}),
        ("surplice top", "wrap-top", {"neckline=v"}),
        ("bib shorts for cycling", "dungarees", {"fit=close", "legs=slim"}),
        ("houppelande", "shift-dress", {"collar=stand", "sleeve_shape=bell"}),
        ("chiton", "shift-dress", {"shoulders=both", "fit=loose"}),
        ("Sailor Moon style school uniform", "shirt-dress", {"collar=lapel", "skirt_hem=mini"}),
        ("gambeson", "turtleneck", {"collar=stand", "top_hem=long"}),
        ("tabard", "shift-dress", {"slit=left", "slit=right", "sleeves=none"}),
        ("baby doll nightdress", "empire-dress", {"waist_seam=empire"}),
        ("tennis dress", "skater-dress", {"skirt=flared"}),
        ("drop-waist tennis dress", "drop-waist-dress", {"skirt_hem=knee"}),
        ("salwar kameez", "shift-dress", {"skirt_hem=knee", "slit=left"}),
        ("yukata", "robe", {"sleeves=long", "sleeve_shape=wide"}),
        ("Wickelhose", "pull-on-trousers", {"legs=wide"}),
        ("suspender skirt", "pinafore", {"kind=skirt"}),
        ("bistro apron", "apron", {"kind=skirt"}),
        ("lederhosen", "dungarees", {"kind=shorts", "leg_hem=knee"}),
        ("skort", "leggings", {"kind=shorts", "leg_hem=thigh"}),
        ("boho skirt", "tiered-skirt", {"skirt=tiered", "skirt_hem=maxi"}),
        ("thigh slit skirt", "fitted-skirt", {"slit=left", "slit_size=high"}),
        ("front slit skirt", "fitted-skirt", {"slit=front"}),
        ("high waisted jeans", "trousers", {"rise=high"}),
        ("riding breeches", "jeans", {"legs=slim"}),
        ("jorts", "trousers", {"leg_hem=knee", "hips=loose"}),
    ],
)
def test_names_begin_from_what_they_look_like(text, draft, claims):
    reading = read_words(text)
    assert draft in {each.name for mark in reading.marks for e in mark.entries for each in e.drafts}
    assert claims <= {f"{i.claim.name}={i.claim.value}" for i in reading.implications}


@pytest.mark.parametrize(
    "text",
    [
        "a dress, very short, long sleeves",
        "a short, long-sleeved dress",
        "a sweetheart bodice with wide straps",
        "a skirt for dance, big circle",
        "trousers down to the floor",
        "a robe, hooded, down to the ground",
        "no slits: a plain skirt to the knee",
    ],
)
def test_what_is_said_of_two_things_is_no_contradiction(text):
    reading = read_words(text)
    assert not reading.contradictions and "astray" not in {mark.role for mark in reading.marks}


def test_shorts_to_the_floor_contradict_themselves():
    (pair,) = read_words("Short trousers with long legs down to the floor").contradictions
    assert (pair.first.word, pair.second.word) == ("Short trousers", "down to the floor")


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("a slip dress over a white t-shirt", True),
        ("a pinafore over a striped tee", True),
        ("a jacket to wear over my dress", False),
        ("a cardigan that goes over any dress", False),
    ],
)
def test_another_garment_beneath_is_told(text, told):
    assert ("separate_pieces" in {lack.what for lack in read_words(text).lacks}) == told


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("a jacket with two tails", "tails"),
        ("a coat with toggles", "toggles"),
        ("a jacket with huge shoulders", "huge_shoulders"),
        ("trousers with zip-off legs", "zip_off"),
        ("a knit in all colourways", "colorways"),
    ],
)
def test_what_was_dropped_silently_is_told(text, what):
    assert what in {lack.what for lack in read_words(text).lacks if lack.said}


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        ("leggings in nylon spandex", {"trousers"}),
        ("shorts in lycra", {"shorts"}),
        ("long sleeves and wide legs", {"jumpsuit"}),
    ],
)
def test_close_cloth_makes_no_jumpsuit_of_leggings(text, kinds):
    found = read_words(text).implications
    assert {i.claim.value for i in found if i.claim.name == "kind"} == kinds


@pytest.mark.parametrize(
    ("text", "shape"),
    [
        ("long dress, puffed sleeves to the elbow, gathered skirt", "puffed"),
        ("wide sleeves to the elbow, pencil skirt", "wide"),
        ("puffed sleeves below the elbow, full skirt", "puffed"),
    ],
)
def test_what_stands_before_sleeves_is_said_of_them_wherever_they_end(text, shape):
    assert f"sleeve_shape={shape}" in said(text)
    assert "puffball" not in cannot(text)


@pytest.mark.parametrize(
    ("text", "sides"),
    [
        ("a shirt with a slit at the side", {"left", "right"}),
        ("tunic, side slit", {"left", "right"}),
        ("top with a slit on the left", {"left"}),
        ("skirt with a side slit", {"left"}),
        ("dress, slit at the side", {"left"}),
    ],
)
def test_a_slit_at_the_side_of_a_top_is_one_at_either(text, sides):
    assert {claim for claim in said(text) if claim.startswith("slit=")} == {f"slit={side}" for side in sides}

"""Which trims a text means, and which it refuses: of its words alone."""

from __future__ import annotations

from dataclasses import replace

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.pattern.trims import TRIMS
from swifttailor.wishes.corrections.closed_behind import without_opposites
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.reader import Wish
from swifttailor.wishes.trims.three_stripes import THREE
from swifttailor.wishes.trims.trims_spoken_of import refused_trims, speaks_of_trims_alone
from swifttailor.wishes.trims.trims_wanted import TRIMS_OF, trims_wanted
from swifttailor.wording import cannot_texts, read_words
from swifttailor.wording.lexicon import all_entries

POCKETS = {name for name in TRIMS if "pocket" in name}
ZIPS = {"zip", "half zip", "back zip", "side zip", "fly", "asymmetric zip"}


def heard(text: str) -> Heard:
    words = read_words(text)
    return Heard(text, lacks=tuple(words.lacks), words=words)


@pytest.mark.parametrize(
    ("text", "kind", "first"),
    [
        ("trousers with cargo pockets", "trousers", ("cargo pockets",)),
        ("a top with a kangaroo pocket", "top", ("kangaroo pocket",)),
        ("a coat with two rows of buttons", "top", ("double-breasted buttons",)),
        ("a dress with a back zip", "dress", ("back zip",)),
        ("a dress with an invisible zip", "dress", ("side zip",)),
        ("a zip up top", "top", ("zip",)),
        ("trousers with a zip", "trousers", ("fly",)),
        ("trousers with buttons", "trousers", ("fly",)),
        ("trousers with a belt", "trousers", ("buckle belt",)),
        ("a dress with a belt", "dress", ("tie belt",)),
        ("trousers with a drawstring", "trousers", ("drawstring",)),
        ("a dress with pockets", "dress", ("slant pockets",)),
        ("a top with buttons", "top", ("button placket",)),
        ("eine Hose mit Reißverschluss", "trousers", ("fly",)),
        ("ripped jeans", "trousers", ("rips",)),
        ("a dress with buttons down the back", "dress", ("back buttons",)),
        ("a pinafore that ties at the back", "dress", ("back ties",)),
        ("a top with a lace-up back", "top", ("back lacing",)),
        ("a dress with a bow at the back", "dress", ("back bow",)),
        ("a dress with a sash at the back", "dress", ("back bow",)),
        ("joggers with a white stripe down the side", "trousers", ("side stripes",)),
        ("distressed jeans", "trousers", ("rips", "frayed hem")),
        ("ripped jeans with a hole in the right knee", "trousers", ("right knee rip",)),
        ("a hole in the left knee and a hole in the right knee", "trousers", ("knee rips",)),
        ("jeans déchirés aux genoux", "trousers", ("knee rips",)),
        ("a smocked top", "top", ("smocking",)),
        ("a long dress with a shirred bodice", "dress", ("smocking",)),
        ("a smocked skirt", "skirt", ("elastic waist",)),
        ("a ruched top", "top", ("ruching",)),
        ("a draped evening gown", "dress", ("draped folds",)),
        ("a blouse with pintucks", "top", ("tucks",)),
        ("a navy dress with princess seams", "dress", ("princess seams",)),
        ("a black dress with cut outs at the waist", "dress", ("waist cut-outs",)),
        ("a top with a scalloped hem", "top", ("scalloped edge",)),
        ("a skirt with a front yoke", "skirt", ("yoke",)),
    ],
)
def test_what_is_wanted_first(text, kind, first):
    said = [wish for wish in trims_wanted(heard(text), kind=kind) if wish.said]
    assert [wish.choices[0] for wish in said] == [first]


@pytest.mark.parametrize(
    ("text", "trims"),
    [
        ("dirndl dress", {"apron", "lacing", "blouse front"}),
        ("a waitress uniform", {"button placket"}),
        ("a dress with an apron", {"apron"}),
        ("formal trousers", {"side pockets", "fly", "creases"}),
        ("a cheongsam", {"diagonal closing"}),
        ("a sari", {"edging", "shoulder drape"}),
        ("corset top", {"lacing", "boning"}),
        ("tuxedo trousers", {"satin stripes", "fly", "side pockets"}),
        ("henley", {"polo placket"}),
        ("half zip running top", {"half zip"}),
        ("cargo skirt", {"cargo pockets", "patch pockets"}),
        ("hakama", {"pleat lines", "waist bow"}),
        ("national costume", {"apron", "lacing", "edging"}),
        ("house dress", {"buttons", "patch pockets"}),
        ("forties dress", {"buttons", "buckle belt"}),
        ("frilly dress", {"neck frill", "sleeve frills", "hem frill"}),
        ("pirate dress", {"lacing", "hem frill"}),
        ("peasant dress", {"neck cord", "neck gathers"}),
        ("busuti", {"tie belt"}),
        ("smocked dress", {"smocking"}),
        ("ruched dress", {"ruching"}),
        ("hoodie dress", {"kangaroo pocket"}),
        ("a strappy dress with a shirred bodice", {"smocking"}),
        ("cardigan dress", {"buttons", "patch pockets"}),
        ("duffle coat", {"toggles", "patch pockets"}),
        ("biker jacket", {"asymmetric zip", "buckle belt"}),
        ("peplum jacket", {"buttons"}),
        ("cheer dress", set()),
        ("cheerleader dress", {"bands"}),
        ("milkmaid dress", {"smocking"}),
        ("cut out dress", {"waist cut-outs"}),
        ("paper bag skirt", {"waist frill", "tie belt"}),
        ("smock dress", set()),  # which is wide, whatever its name says
        ("wedding dress", set()),  # which may have lace, but need not
    ],
)
def test_names_of_dresses_mean_what_they_are_known_by(text, trims):
    assert {name for wish in trims_wanted(heard(text), kind="dress") for name in wish.choices[0]} == trims


@pytest.mark.parametrize(
    ("text", "trim"),
    [
        ("a keyhole neck top", "keyhole"),
        ("a dress with a keyhole back", "back keyhole"),
        ("a police shirt with epaulettes", "epaulettes"),
        ("a cold shoulder top", "shoulder cut-outs"),
        ("a blouse with cut outs on the shoulders", "shoulder cut-outs"),
        ("a dress with cut outs at the waist", "waist cut-outs"),
        ("a cut out dress", "waist cut-outs"),
        ("a dress with a cut out back", "back cut-out"),
        ("a dress with a cut out neckline", "keyhole"),
        ("a satin cowl neck top", "cowl folds"),
        ("a slip dress with a cowl neck", "cowl folds"),
        ("a jumper with elbow patches", "elbow patches"),
        ("a jumper with a Henley neckline", "polo placket"),
        ("a jumper with a zip neck", "half zip"),
        ("a tie front blouse", "waist bow"),
        ("a dress with a tie front", "waist bow"),
        ("a coat with fur trim", "fur trim"),
    ],
)
def test_openings_at_the_neck_and_tabs_on_shoulders_are_put_on(text, trim):
    assert any(trim in wish.choices[0] for wish in trims_wanted(heard(text)))


@pytest.mark.parametrize(
    ("text", "draft", "buttoned"),
    [
        ("a silk blouse", "shirt", True),
        ("a blouse with buttons down the front and a bow at the back", "shirt", True),
        ("a blouse with a zip down the back", "shirt", False),
        ("a blouse that ties at the back", "shirt", False),
        ("a blouse with a keyhole neck", "t-shirt", False),
        ("a blouse with a cowl neck", "t-shirt", False),
        ("a strapless blouse", "bandeau", False),
        ("a blouse with buttons and no straps", "bandeau", True),
    ],
)
def test_what_closes_behind_or_is_pulled_on_has_no_buttons_in_front(text, draft, buttoned):
    assert any(wish.what == "buttons" for wish in trims_wanted(heard(text), draft)) is buttoned


@pytest.mark.parametrize("text", ["a draped skirt", "a club dress", "a shirt with perforated sleeves"])
def test_folds_and_cut_outs_are_put_on_where_they_are_asked_for_alone(text):
    names = {name for wish in trims_wanted(heard(text)) for choice in wish.choices for name in choice}
    assert names.isdisjoint({"cowl folds", "waist cut-outs", "back cut-out", "shoulder cut-outs"})


@pytest.mark.parametrize(
    ("text", "pleated"),
    [
        ("pleat front bermudas", True),
        ("pleated trousers", True),
        ("pantalon large à pinces", True),
        ("pantalón de pinzas", True),
        ("paperbag trousers", False),
        ("plain trousers", False),
    ],
)
def test_pleats_of_trousers_lie_below_the_waistband(text, pleated):
    wanted = trims_wanted(heard(text), "trousers", "trousers")
    assert ("front pleats" in {name for wish in wanted for name in wish.choices[0]}) is pleated


@pytest.mark.parametrize(
    ("text", "refused"),
    [
        ("jeans without pockets", POCKETS),
        ("a dress, no pockets", POCKETS),
        ("jeans without back pockets", {"back pockets"}),
        ("a shirt without a chest pocket", {"chest pocket"}),
        ("a dress without a zip", ZIPS),
        ("a dress without pockets and without a back zip", POCKETS | {"back zip"}),
        ("a coat without a belt", {"tie belt", "buckle belt", "sash"}),
        ("trousers, not jeans", set()),
        ("jeans with pockets", set()),
        ("ein Kleid ohne Taschen", POCKETS),
        ("une robe sans poches", POCKETS),
        ("un vestido sin bolsillos", POCKETS),
    ],
)
def test_what_is_refused(text, refused):
    assert refused_trims(heard(text)) == refused


@pytest.mark.parametrize(
    ("text", "alone"),
    [
        ("remove the kangaroo pocket", True),
        ("add pockets and a belt", True),
        ("swap the buttons for a zip", True),
        ("take the belt off", True),
        ("Taschen weg", True),
        ("remove the hood", False),
        ("remove the pockets and the sleeves", False),
        ("a longer dress with pockets", False),
        ("add a bow", False),
        ("add wuzzle pockets", False),
        ("please", False),
        ("", False),
    ],
)
def test_whether_a_text_speaks_of_nothing_else(text, alone):
    assert speaks_of_trims_alone(read_words(text)) == alone


def test_keys_and_names_exist():
    assert set(TRIMS_OF) <= set(cannot_texts())
    assert {name for names in TRIMS_OF.values() for name in names} == set(TRIMS)


def test_trims_of_entries_stand_for_what_they_cannot_have():
    """Else no text would ever put them on."""
    marked = [entry for entry in all_entries() if entry.trims]
    assert len(marked) > 20
    for entry in marked:
        for name in entry.trims:
            assert any(name in TRIMS_OF.get(what, ()) for what in entry.cannot), f"{entry.name}: {name}"
    assert {name for entry in marked for name in entry.trims} >= set(TRIMS) - {
        "buckle belt",
        "drawstring",
        *THREE,
    }


def test_edging_is_put_on_unasked_where_the_tables_give_it_to_a_name():
    (edged,) = [wish for wish in trims_wanted(heard("a folk waistcoat"), kind="top") if wish.what == "braid"]
    assert edged.choices[0] == ("edging",) and not edged.said
    assert "braid" not in {wish.what for wish in trims_wanted(heard("uniform trousers"), kind="trousers")}
    wanted = trims_wanted(heard("tuxedo trousers"), kind="trousers")
    (striped,) = [wish for wish in wanted if wish.what == "side_stripes"]
    assert striped.choices[0] == ("satin stripes",)


@pytest.mark.parametrize(
    ("text", "trim"),
    [
        ("track pants with white stripes down the legs", "side stripes"),
        ("a dress with side stripes", "side stripes"),
        ("a hoodie, red stripe down each sleeve", "sleeve stripes"),
    ],
)
def test_stripes_down_seams_are_put_on_and_no_print(text, trim):
    asked = heard(text)
    (striped,) = [wish for wish in trims_wanted(asked) if wish.what == "side_stripes"]
    assert striped.choices[0] == (trim,) and asked.print is None


@pytest.mark.parametrize(
    ("text", "what", "trims"),
    [
        ("pants with huge pockets on the thigh", "pockets", ("cargo pockets",)),
        ("ragged trousers, string at the waist", "drawstring", ("drawstring",)),
        ("paper bag waist shorts", "belt", ("tie belt",)),
        ("a top with a massive ruff", "frills", ("neck frill",)),
        ("a Pierrot top", "frills", ("neck frill",)),
        ("a smock with pompoms down the front", "buttons", ("buttons",)),
        ("the trouser of a sailor", "buttons", ("double-breasted buttons",)),
        ("a tunic with a tie belt", "belt", ("tie belt",)),
        ("a linen shirt with rolled sleeves", "rolled_sleeves", ("sleeve turn-ups",)),
        ("a dress shirt, French cuffs", "french_cuffs", ("sleeve turn-ups",)),
        ("fleece jacket that zips up to the chin", "zip", ("zip",)),
    ],
)
def test_details_are_put_on_where_other_words_tell_them(text, what, trims):
    (wish,) = [wish for wish in trims_wanted(heard(text)) if wish.what == what]
    assert wish.choices[0] == trims


def test_epaulettes_are_told_and_no_edging_is_put_on():
    asked = heard("a black coat with epaulettes")
    assert "epaulettes" in {lack.what for lack in asked.lacks}
    assert not [wish for wish in trims_wanted(asked) if ("edging",) in wish.choices]


def test_bows_of_straps_are_none_at_the_waist():
    tied = trims_wanted(heard("a summer dress with wide straps tied in bows"))
    assert ("waist bow",) not in [wish.choices[0] for wish in tied]


def test_a_jacket_whose_collar_stands_is_buttoned():
    jacket = trims_wanted(heard("a jacket with a mandarin collar"), draft="turtleneck")
    assert "buttons" in {wish.what for wish in jacket}
    assert not trims_wanted(heard("a jumper with a mandarin collar"), draft="turtleneck")


def test_frills_are_put_where_they_are_told_and_on_a_hem_at_last():
    wishes = trims_wanted(heard("a nightgown with a frill at the neck"), kind="dress")
    wish = next(wish for wish in wishes if wish.what == "frills")
    assert wish.choices[0] == ("neck frill",)
    (wish,) = trims_wanted(heard("a ruffle crop top"), kind="top")
    assert wish.choices[-1] == ("hem frill",)


def test_frills_of_the_sleeves_are_put_there_alone():
    told = (Wish(Gain(Claim("cuffs", "flounce")), 1.0),)
    blouse = replace(heard("a blouse with ruffles on the sleeves"), sure=told)
    (wish,) = [wish for wish in trims_wanted(blouse) if wish.what == "frills"]
    assert wish.choices == (("sleeve frills",),)


def test_of_what_closes_it_behind_nothing_hangs_lower_there():
    """Unless another word says so."""
    lower = Wish(Gain(Claim("hem_shape", "high-low")), 0.9)
    assert without_opposites([lower], read_words("a dress with a zip down the back")) == ()
    kept = without_opposites([lower], read_words("a high-low dress with a zip down the back"))
    assert kept == (lower,) == without_opposites([lower], read_words("a dress with a side zip"))


@pytest.mark.parametrize("text", ["open cardigan", "an open long cardigan", "a long open cardigan"])
def test_cardigans_are_open_in_front(text):
    words = read_words(text)
    bare = Wish(Gain(Claim("back_depth", "open")), 0.9)
    assert without_opposites([bare], words) == ()
    drafts = [draft for mark in words.marks for entry in mark.entries for draft in entry.drafts]
    assert all(dict(draft.options)["closed_to"] == -30.0 for draft in drafts) and drafts
    asked = read_words("a cardigan with an open back")
    assert without_opposites([bare], asked) == (bare,)


@pytest.mark.parametrize(
    ("text", "buttoned"),
    [
        ("a jacket without a collar", True),
        ("a jacket without a collar, with a zip", False),
        ("an edge to edge jacket", False),
        ("a cardigan", False),
    ],
)
def test_a_jacket_without_a_collar_is_buttoned_and_has_pockets(text, buttoned):
    wanted = trims_wanted(heard(text), draft="cardigan")
    assert (("buttons", "welt pockets") in [wish.choices[0] for wish in wanted]) == buttoned

"""From words to trims, and edits of them."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from own_library import library_of
from scripted_maker import scripted_maker

from swifttailor.pattern import to_specification
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.trims import LIKE_EACH_OTHER, TRIMS, trims_that_fit
from swifttailor.tailor import Order, Tailor
from swifttailor.tailor.trimming import trimmed
from swifttailor.wishes.trims.trims_of import TRIMS_OF
from swifttailor.wording import cannot_texts

KNOWN = {"skirt": draft("fitted-skirt"), "shirt": draft("t-shirt"), "trousers": draft("trousers")}
DENIM = {"topstitching", "belt loops"}
JEANS = {"fly", "slant pockets", "back pockets", *DENIM}
JACKET = {"buttons", "chest pockets", "topstitching", "denim seams"}
COAT = {"buttons", "side pockets"}
ASKED = {
    # English
    "jeans": JEANS,
    "jeans without pockets": {"fly", *DENIM},
    "jeans without back pockets": {"fly", "slant pockets", *DENIM},
    "jeans without pockets and without a fly": DENIM,
    "jeans with cargo pockets": {"fly", "cargo pockets", *DENIM},
    "a shirt": {"button placket"},
    "a shirt without buttons": set(),
    "a shirt, no pockets, no buttons": set(),
    "a shirt with a chest pocket": {"button placket", "chest pocket"},
    "a shirt with buttons and a zip": {"button placket", "side zip"},
    "a polo shirt": {"polo placket"},
    "a hoodie": {"kangaroo pocket", "neck cord"},
    "a hoodie without a pocket": {"neck cord"},
    "a hoodie with a zip": {"kangaroo pocket", "zip", "neck cord"},
    "a denim jacket": JACKET,
    "a double-breasted coat": {"double-breasted buttons", "welt pockets"},
    "a trench coat": {"double-breasted buttons", "side pockets", "tie belt", "epaulettes", "storm flap"},
    "a coat with a belt": {*COAT, "tie belt"},
    "a double breasted blazer": {"double-breasted buttons", "welt pockets"},
    "cargo trousers": {"cargo pockets", "slant pockets", "back pockets", "fly", "belt loops"},
    "joggers with a drawstring": {"drawstring", "elastic waist", "slant pockets", "back pockets"},
    "a skirt with an elastic waist": {"elastic waist"},
    "trousers with a belt": {"buckle belt", "fly", "slant pockets", "belt loops"},
    "a skirt with a side zip": {"side zip"},
    "a dress with a back zip": {"back zip"},
    "a dress without a zip": set(),
    "a dress with pockets and without a back zip": {"slant pockets"},
    "a shirt dress with a belt": {"button placket", "tie belt"},
    "a bathrobe": {"tie belt", "patch pockets"},
    "dungarees": {"bib pocket", "slant pockets", "back pockets", "strap buckles", "topstitching"},
    "a skirt with patch pockets": {"patch pockets"},
    "a t-shirt with a breast pocket": {"chest pocket", "neck rib"},
    "a plain t-shirt": {"neck rib"},
    "a tank top": {"neck rib", "armhole ribs"},
    "a pussy bow blouse": {"neck bow"},
    "a sundress that ties at the shoulders": {"shoulder bows"},
    "a skirt with a ruffled hem": {"hem frill"},
    "a cardigan with buttons": {"buttons", "knit bands", "patch pockets"},
    # German
    "eine Jeans ohne Taschen": {"fly", *DENIM},
    "ein Hemd mit Knöpfen": {"button placket"},
    "ein Rock mit Reißverschluss": {"side zip"},
    "ein Kleid mit Taschen und Gürtel": {"slant pockets", "tie belt"},
    "ein Mantel mit Gürtel": {*COAT, "tie belt"},
    # French
    "un jean sans poches": {"fly", *DENIM},
    "une robe avec des poches": {"slant pockets"},
    "une chemise avec des boutons": {"button placket"},
    "un manteau avec une ceinture": {*COAT, "tie belt"},
    # Spanish
    "unos vaqueros sin bolsillos": {"fly", *DENIM},
    "un vestido con bolsillos": {"slant pockets"},
    "una camisa con botones": {"button placket"},
    "un abrigo con cinturón": {*COAT, "tie belt"},
}
EDITS = [
    ("jeans", "add pockets", JEANS),
    ("jeans", "remove the pockets", {"fly", *DENIM}),
    ("jeans", "the pockets can go", {"fly", *DENIM}),
    ("jeans", "take off the back pockets", {"fly", "slant pockets", *DENIM}),
    ("jeans", "add a belt", {*JEANS, "buckle belt"}),
    (
        "cargo trousers",
        "remove the cargo pockets",
        {"slant pockets", "back pockets", "fly", "belt loops"},
    ),
    ("a skirt", "add pockets", {"patch pockets"}),
    ("a shirt", "remove the buttons", set()),
    ("a shirt", "remove the placket", set()),
    ("a shirt", "swap the buttons for a zip", {"zip"}),
    ("a shirt", "replace the buttons with a zip", {"zip"}),
    ("a shirt", "change the buttons to a zip", {"zip"}),
    ("a shirt", "add a chest pocket", {"button placket", "chest pocket"}),
    ("a denim jacket", "add buttons", JACKET),
    ("a coat with a belt", "remove the belt", COAT),
    ("a coat with a belt", "make it double-breasted",
     {"double-breasted buttons", "side pockets", "tie belt"}),
    ("a polo shirt", "remove the placket", set()),
    ("a hoodie", "remove the kangaroo pocket", {"neck cord"}),
    ("joggers with a drawstring", "replace the drawstring with a buckle belt",
     {"buckle belt", "elastic waist", "slant pockets", "back pockets"}),
    ("jeans", "ohne Taschen", {"fly", *DENIM}),
    ("ein Kleid", "mit Taschen", {"slant pockets"}),
    ("une robe", "ajoute des poches", {"slant pockets"}),
    ("una falda", "añade bolsillos", {"patch pockets"}),
]  # fmt: skip


@pytest.fixture(scope="module")
def tailor(tmp_path_factory, sewer):
    library = library_of(KNOWN, tmp_path_factory.mktemp("library"))
    return Tailor(scripted_maker([draft("fitted-dress")]), sewer, pattern_library=library)


@pytest.fixture(scope="module")
def answers(tailor):
    """Of texts, each answered once."""
    found = {}

    def of(text: str):
        if text not in found:
            (found[text],) = tailor.write([Order(text)])
        return found[text]

    return of


def panels(pattern) -> dict:
    """All of a pattern but its name and what is put on it."""
    written = to_specification(pattern)
    return {key: written[key] for key in written if key == "pattern"}


@pytest.mark.parametrize("text", ASKED)
def test_words_choose_trims(answers, text):
    answer = answers(text)
    assert set(answer.pattern.trims) == ASKED[text]
    assert set(answer.put_on) == ASKED[text] and answer.taken_off == ()
    assert trims_that_fit(answer.pattern, answer.pattern.trims) == answer.pattern.trims
    heard = answer.wanted.heard
    told = {*heard.cannot, *heard.left_out}
    for name in answer.pattern.trims:
        what = next(key for key, names in TRIMS_OF.items() if name in names)
        assert cannot_texts()[what] not in told, "put on, and still told as impossible"


@pytest.mark.parametrize(
    ("text", "missing"),
    [
        ("a pleated skirt with pockets", "pockets"),
        ("a T-shirt with sequins", "sequins sewn on (they are drawn)"),
        ("a wrap dress with pockets", "pockets"),
    ],
)
def test_what_found_no_place_is_still_told(answers, text, missing):
    assert any(missing in said for said in answers(text).wanted.heard.cannot)


@pytest.mark.parametrize(("text", "instruction", "trims"), EDITS)
def test_edits_of_trims_leave_the_panels_alone(tailor, answers, text, instruction, trims):
    base = answers(text).pattern
    (answer,) = tailor.write([Order(instruction, edit=base)])
    assert set(answer.pattern.trims) == trims
    assert panels(answer.pattern) == panels(base)
    assert answer.of_edit and answer.cuts == ()
    assert set(answer.put_on) == trims - set(base.trims)
    assert set(answer.taken_off) == set(base.trims) - trims
    assert answer.is_given == (set(base.trims) == trims)


@pytest.mark.parametrize(
    ("text", "instruction", "trims"),
    [
        ("jeans", "make it longer", JEANS),
        ("a shirt", "remove the sleeves", {"button placket"}),
        ("a hoodie", "drop the hood", {"kangaroo pocket", "neck cord"}),
        ("jeans", "make them wider and add a belt", {*JEANS, "buckle belt"}),
        ("a shirt", "remove the collar and add a chest pocket", {"button placket", "chest pocket"}),
    ],
)
def test_cuts_keep_what_is_put_on(tailor, answers, text, instruction, trims):
    base = answers(text).pattern
    (answer,) = tailor.write([Order(instruction, edit=base)])
    assert set(answer.pattern.trims) == trims
    assert panels(answer.pattern) != panels(base) and answer.cuts


def test_reports_and_notes_say_it(tailor):
    made = tailor.generate("a shirt with a chest pocket")
    assert made.report["trims"] == list(made.pattern.trims) == ["chest pocket", "button placket"]
    (note,) = (note for note in made.notes if note.startswith("Put on"))
    assert "a pocket on the left breast; a front band with buttons" in note
    edited = tailor.edit(made.pattern, "remove the pocket")
    assert "Taken off: a pocket on the left breast." in edited.notes
    assert edited.report["trims"] == ["button placket"]


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("tailored waistcoat with four buttons", 4),
        ("waistcoat", 5),
        ("navy blazer, single button", 1),
        ("a blazer", 2),
        ("a double-breasted coat with six buttons", 6),
        ("a shirt with nine buttons", 9),
        ("a shirt", 0),
        ("jeans", 0),
    ],
)
def test_the_number_of_buttons_is_obeyed_or_usual(answers, text, count):
    assert answers(text).pattern.button_count == count


def test_an_instruction_changes_the_number_of_buttons_alone(tailor, answers):
    base = answers("waistcoat").pattern
    (answer,) = tailor.write([Order("make it four buttons", edit=base)])
    assert answer.pattern.button_count == 4 and answer.pattern.trims == base.trims
    assert panels(answer.pattern) == panels(base) and answer.put_on == ("buttons",)
    (longer,) = tailor.write([Order("make it longer", edit=answer.pattern)])
    assert longer.pattern.button_count == 4
    (bare,) = tailor.write([Order("remove the buttons", edit=answer.pattern)])
    assert bare.pattern.button_count == 0


def test_notes_say_the_number_of_buttons(tailor):
    made = tailor.generate("tailored waistcoat with four buttons")
    assert any("4 buttons down the front" in note for note in made.notes)
    assert made.report["button_count"] == 4


def test_done_twice_is_done_once(answers):
    for text in ("jeans", "a shirt without buttons", "a trench coat"):
        answer = answers(text)
        again = trimmed(answer)
        assert again.pattern.trims == answer.pattern.trims and again.put_on == answer.put_on


WORDS = sorted({
    "buttons", "a zip", "a button placket", "double breasted buttons", "a half zip", "a polo placket",
    "a belt", "a buckle belt", "a drawstring", "a tie belt", "pockets", "a fly",
})  # fmt: skip


@settings(max_examples=15, deadline=None, derandomize=True)
@given(
    st.sampled_from(["a shirt", "a coat", "trousers", "a shirt dress", "a hoodie"]),
    st.lists(st.sampled_from(WORDS), min_size=2, max_size=4, unique=True),
    st.lists(st.sampled_from(list(TRIMS)), max_size=3, unique=True),
)
def test_two_that_are_like_each_other_are_never_both_taken(tailor, answers, garment, words, had):
    (made,) = tailor.write([Order(f"{garment} with {', '.join(words)}")])
    assert_apart(made.pattern.trims)
    own = tuple([name for name in had if not any(like(name, other) for other in had if other != name)])
    base = replace(answers(garment).pattern, trims=own)
    (edited,) = tailor.write([Order(f"add {' and '.join(words)}", edit=base)])
    assert_apart(edited.pattern.trims)


def like(one: str, other: str) -> bool:
    return any(one in group and other in group for group in LIKE_EACH_OTHER)


def assert_apart(trims: tuple[str, ...]) -> None:
    assert len(set(trims)) == len(trims) and set(trims) <= set(TRIMS)
    for group in LIKE_EACH_OTHER:
        assert len(set(group).intersection(trims)) <= 1, trims

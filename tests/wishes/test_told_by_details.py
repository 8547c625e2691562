"""What a name is known by is put on unasked: stitches on denim, loops, sashes, aprons, hoods of outfits."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.sayings_of_wishes import without_asides
from swifttailor.wishes.drafts.drafts_as_asked import draft_as_asked
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.looks.heard_print import heard_print
from swifttailor.wishes.outfits.aprons import with_apron_put_on
from swifttailor.wishes.outfits.hooded_outfits import with_hooded_top
from swifttailor.wishes.outfits.two_garments import two_garments
from swifttailor.wishes.trims.loops_and_stitches import loops_and_stitches
from swifttailor.wishes.trims.trims_wanted import trims_wanted
from swifttailor.wording.lexicon import read_words


def first_trims(text: str, kind: str, draft: str) -> set[str]:
    words = read_words(text)
    heard = Heard(text, lacks=tuple(words.lacks), words=words)
    return {name for wish in trims_wanted(heard, draft, kind) for name in wish.choices[0]}


@pytest.mark.parametrize(
    ("text", "kind", "draft", "trims"),
    [
        ("blue jeans", "trousers", "trousers", {"belt loops", "topstitching"}),
        ("skinny jeans", "trousers", "jeans", {"belt loops", "topstitching"}),
        ("chinos", "trousers", "trousers", {"belt loops"}),
        ("a denim skirt", "skirt", "circle-skirt", {"belt loops", "topstitching"}),
        ("a denim jacket", "top", "denim-jacket", {"topstitching", "denim seams"}),
        ("dungarees", "jumpsuit", "dungarees", {"strap buckles", "topstitching"}),
        ("a trench coat", "dress", "coat", {"epaulettes", "storm flap"}),
        ("a kilt", "skirt", "pleated-skirt", {"kilt edge"}),
        ("a lehenga", "skirt", "circle-skirt", {"hem border"}),
        ("a dirndl", "dress", "skater-dress", {"blouse front", "apron", "lacing"}),
        ("a sarong", "skirt", "sarong", {"hip knot"}),
        ("leggings with a foldover waistband", "trousers", "leggings", {"folded band"}),
        ("a jumper with thumb holes", "top", "sweatshirt", {"thumb holes"}),
        ("a maternity top", "top", "t-shirt", {"bust gathers"}),
        ("a flower girl dress", "dress", "skater-dress", {"sash"}),
        ("a blue dress with a sash", "dress", "skater-dress", {"sash"}),
        ("a skirt with pockets", "skirt", "circle-skirt", {"patch pockets"}),
        ("an evening gown", "dress", "skater-dress", {"draped folds"}),
    ],
)
def test_is_put_on(text, kind, draft, trims):
    assert trims <= first_trims(text, kind, draft)


@pytest.mark.parametrize(
    ("text", "kind", "draft", "trims"),
    [
        ("joggers", "trousers", "joggers", {"belt loops", "topstitching"}),
        ("a kimono robe with a sash", "dress", "robe", {"sash"}),
        ("a wrap skirt", "skirt", "wrap-skirt", {"kilt edge", "tie belt"}),
        ("a dress with pockets", "dress", "skater-dress", {"patch pockets"}),
        ("a cotton shirt", "top", "shirt", {"topstitching", "denim seams"}),
    ],
)
def test_is_not_put_on_others(text, kind, draft, trims):
    assert trims.isdisjoint(first_trims(text, kind, draft))


def test_what_is_held_by_elastic_has_no_loops():
    own = ("fly", "elastic waist")
    assert not list(loops_and_stitches("trousers", "trousers", cloth=None, own=own))
    assert list(loops_and_stitches("trousers", "trousers", cloth=None, own=("fly",)))


@pytest.mark.parametrize(
    ("text", "upper", "lower"),
    [
        ("leather outfit: tight trousers, hooded", "leather hooded top", "leather tight trousers"),
        ("a blouse, a skirt and an apron", "a blouse", "a skirt with an apron front"),
        ("tailleur grigio", None, None),
        ("grunge outfit", "flannel shirt", "ripped jeans"),
    ],
)
def test_outfits_have_both_halves(text, upper, lower):
    found = two_garments(text)
    assert found is not None
    assert upper is None or (found.upper, found.lower) == (upper, lower)


def test_other_texts_stay_as_they_are():
    for text in ("a hooded jacket and trousers", "an outfit for the gym", "an apron and a skirt for it"):
        assert with_hooded_top(text) == text and with_apron_put_on(text) == text


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("crewneck", "crew neck sweatshirt"),
        ("trouser short of sport", "gym shorts"),
        ("a business casual top", "a blouse"),
        ("a skirt with a gold border", "a skirt with a gold hem border"),
        ("a tee with a crew neck", "a tee with a crew neck"),
        ("a sari with a gold border", "a sari with a gold border"),
    ],
)
def test_is_put_plainly(text, plain):
    assert without_asides(text) == plain


def test_a_gown_with_a_slit_is_close_and_keeps_its_neck():
    gown = NamedDraft.parse("skater-dress(skirt_length=99;skirt_fraction=0.45;neckline=v;neck_depth=17)")
    found = draft_as_asked(gown, [Claim("slit", "left")])
    assert found is not None and found.name == "fitted-dress"
    options = dict(found.options)
    assert options["neckline"] == "v" and options["skirt_length"] > 90.0


def test_the_second_of_two_colours_is_that_of_a_border():
    text = "a lehenga in red and gold"
    assert heard_print(text, read_words(text), kind="skirt") is None

"""What lexicon and network understand together, and what is said of the rest."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import swifttailor
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.descriptions.no_garment import asks_for_none
from swifttailor.wishes.heard import HEARD_NOTHING
from swifttailor.wishes.instructions.hearing_changes import hear_instruction
from swifttailor.wishes.reader import SURE, Wish, WishReader
from swifttailor.wording.lexicon import exclude, read_words


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


class Saying:
    """A network that reads the same in every text."""

    def __init__(self, *wishes: Wish) -> None:
        self.wishes, self.texts = wishes, []

    def read(self, text, *, instruction=False):
        self.texts.append(text)
        return self.wishes

    def whole(self, text, *, instruction=True):
        return {}


def claims(wishes):
    return {w.change.claim for w in wishes if isinstance(w.change, Gain)}


@pytest.mark.parametrize(
    ("text", "kind", "sure"),
    [
        ("bathrobe", "dress", set()),
        ("a vest", "top", {Claim("sleeves", "none")}),
        ("skinny jeans", "trousers", set()),
        ("one shoulder top", "top", set()),
        ("polo shirt", "top", set()),
        ("a pinny with an A-line skirt", "dress", {Claim("skirt", "a-line")}),
        ("ein knielanger Rock mit Schlitz", "skirt", {Claim("skirt_hem", "knee")}),
        ("une robe longue sans manches", "dress", {Claim("sleeves", "none")}),
    ],
)
def test_names_in_people_s_own_words_are_understood(reader, text, kind, sure):
    heard = hear_description(text, reader)
    assert heard.kind == kind and heard.unread == ()
    assert sure <= claims(heard.sure) | claims(heard.likely)


def test_every_word_ends_in_a_list(reader):
    heard = hear_description("a knee-length navy denim skirt with pockets and a wuzzle", reader)
    assert Claim("skirt_hem", "knee") in claims(heard.sure)
    assert (heard.color, heard.cloth) == ("#1f2a44", "denim")
    assert heard.cannot == ("pockets",) and heard.unread == ("wuzzle",)
    dotted = hear_description("a polka dot dress", reader)
    assert dotted.cannot == () and dotted.print is not None and dotted.print.kind == "dots"
    assert hear_description("a cardigan", reader).left_out
    assert hear_description("a plain white shirt", reader).color == "#ffffff"
    assert hear_description("a plain white shirt", reader).cannot == ()
    assert hear_description("little black dress", reader).color == "#000000"


def test_what_details_say_outranks_the_network_and_that_outranks_names():
    wide = Wish(Gain(Claim("sleeves", "long")), 0.99)
    heard = hear_description("a sleeveless dress for the office", Saying(wide))
    assert Claim("sleeves", "none") in claims(heard.sure) and Claim("sleeves", "long") not in claims(
        heard.sure
    )
    usual = claims(hear_description("a shirt", Saying()).likely)
    (said,) = [claim for claim in usual if claim.name == "sleeves"]
    network = Saying(
        Wish(Gain(other := Claim("sleeves", "short" if said.value != "short" else "long")), 0.95)
    )
    heard = hear_description("a shirt with nice sleeves", network)
    assert other in claims(heard.sure) and said not in claims(heard.likely)


def test_what_is_short_itself_has_no_short_sleeves():
    network = Saying(Wish(Gain(short := Claim("sleeves", "short")), 0.95))
    assert short not in claims(hear_description("a robe, short, with lace sleeves", network).sure)
    assert short in claims(hear_description("a robe with short sleeves", network).sure)


def test_what_is_tied_over_loose_cloth_has_no_waist_seam():
    network = Saying(Wish(Gain(seam := Claim("waist_seam", "natural")), 0.95))
    loose = hear_description("an old fashioned dressing gown tied at the waist", network)
    assert seam not in claims((*loose.sure, *loose.likely))
    dress = hear_description("an old fashioned dress tied at the waist", network)
    assert seam in claims((*dress.sure, *dress.likely))


def test_the_network_is_not_believed_in_what_no_word_is_about():
    network = Saying(Wish(Gain(Claim("sleeves", "none")), 0.99), Wish(Gain(Claim("skirt", "peplum")), 0.99))
    heard = hear_description("no v necks! a tee with a high round neck", network)
    assert claims(heard.sure) == {
        Claim("kind", "top"),
        Claim("neckline", "round"),
        Claim("neck_depth", "high"),
    }
    assert Claim("sleeves", "short") in claims(heard.likely), "as tees have"
    assert Claim("skirt", "peplum") not in claims(hear_description("a column gown", network).sure)
    strange = hear_description("a tee, wuzzled", network)
    assert Claim("sleeves", "none") in claims(strange.sure), "a word that nobody knows may be about sleeves"


@pytest.mark.parametrize(
    ("text", "unread"),
    [
        ("a shirt whose collar is wider than the sleeves", ("wider",)),
        ("a shirt, warmer than mine", ()),
        ("a shirt that is longer behind than in front", ()),
        ("a skirt not longer than the knee", ()),
    ],
)
def test_comparisons_that_nothing_came_of_are_named(text, unread):
    heard = hear_description(text, Saying())
    assert tuple(word for word in heard.unread if word.endswith("er")) == unread


@pytest.mark.parametrize(
    ("text", "claim"),
    [
        ("a shirt whose back is longer than the front", Claim("hem_shape", "high-low")),
        ("a shirt, shorter in front than behind", Claim("hem_shape", "high-low")),
        ("a skirt, the hem longer on the left than on the right", Claim("hem_shape", "lower left")),
        ("a skirt no longer than the knee", Claim("skirt_hem", "knee")),
        ("a dress that is longer than the knee", Claim("skirt_hem", "below the knee")),
        ("a dress with sleeves no longer than the elbow", Claim("sleeves", "elbow")),
        ("a blouse not longer than the hip bone", Claim("top_hem", "high hip")),
        ("a top cropped at the natural waist", Claim("top_hem", "waist")),
        ("ein Kleid übers Knie, hinten geschlitzt", Claim("skirt_hem", "below the knee")),
        ("ein Kleid übers Knie, hinten geschlitzt", Claim("slit", "back")),
    ],
)
def test_lengths_that_are_compared_are_heard(text, claim):
    heard = hear_description(text, Saying())
    assert claim in claims(heard.sure) and claim not in heard.never
    assert heard.unread == ()


@pytest.mark.parametrize("text", ["a dress for my nan", "trousers for my gf", "a body with sleeves"])
def test_people_and_bodies_are_no_clothes(text):
    heard = hear_description(text, Saying())
    assert heard.unread == () and heard.cannot == ()


def test_who_asks_for_box_pleats_is_told_that_the_cloth_decides():
    lacks = [hear_description(f"a {sort}pleated skirt", Saying()).lacks for sort in ("box ", "knife ", "")]
    assert [any(lack.what == "pleat_folds" for lack in each) for each in lacks] == [True, False, False]


@pytest.mark.parametrize(
    ("text", "draft"),
    [
        ("halter top", "halter-top"),
        ("a halter dress", "halter-dress"),
        ("off the shoulder top", "off-shoulder-top"),
        ("a bardot dress", "off-shoulder-dress(waist_seam=true)"),
    ],
)
def test_bare_shoulders_begin_from_drafts_and_lack_nothing_then(text, draft):
    heard = hear_description(text, Saying())
    assert heard.drafts == (NamedDraft.parse(draft),)
    assert {lack.what for lack in heard.made_as(NamedDraft.parse(draft)).lacks} <= {"ties"}


@pytest.mark.parametrize(
    ("text", "draft"),
    [
        ("a wrap dress", "wrap-dress"),
        ("a knee length dress with a surplice neckline", "wrap-dress"),
        ("ein Wickelkleid", "wrap-dress"),
        ("a faux wrap top", "wrap-top"),
        ("a wrap blouse", "wrap-top(length=18;waist_shaping=2)"),
        ("a polo shirt", "polo-shirt"),
        ("a long-sleeved polo", "polo-shirt"),
        ("a double breasted blazer", "blazer"),
        ("a dinner jacket", "blazer(neck_depth=33)"),
        ("a wrap skirt", "wrap-skirt"),
        ("a pareo", "sarong(band_height=2.5)"),
    ],
)
def test_what_overlaps_or_is_folded_begins_from_drafts(text, draft):
    assert hear_description(text, Saying()).drafts[0] == NamedDraft.parse(draft)


@pytest.mark.parametrize(
    "text",
    [
        *("a wrap jumpsuit", "a dress with a matching wrap", "a polo dress"),
        *(
            "a blazer dress",
            "a dress with a cowl neck",
            "a dress, not a wrap dress",
        ),
    ],
)
def test_what_only_sounds_like_them_does_not(text):
    named = {draft.name for draft in hear_description(text, Saying()).drafts}
    assert not named & {"wrap-dress", "wrap-top", "wrap-skirt", "polo-shirt", "blazer", "sarong"}


def test_a_name_sets_options_of_its_draft():
    (flares,), (bootcut,) = (hear_description(text, Saying()).drafts for text in ("flares", "bootcut jeans"))
    assert flares == NamedDraft("flares") and bootcut.name == "flares"
    assert 0 < dict(bootcut.options)["flare"] < 20


def test_names_of_legs_and_skirts_have_drafts_of_their_own():
    drafts = {
        "thong": "briefs",
        "harem jumpsuit": "jumpsuit",
        "salopettes": "dungarees",
        "lungi": "gathered-skirt",
        "high waisted skirt": "circle-skirt",
        "sharara": "flares",
        "H line dress": "shift-dress",
        "knee breeches": "joggers",
    }
    heard = {text: hear_description(text, Saying()).drafts[0] for text in drafts}
    assert {text: draft.name for text, draft in heard.items()} == drafts
    assert dict(heard["harem jumpsuit"].options)["leg_cuff"] > 0
    assert dict(heard["thong"].options)["leg_height"] > 8


def test_a_polo_neck_is_a_turtleneck():
    (draft,) = hear_description("a polo neck", Saying()).drafts
    assert draft.name == "turtleneck"


@pytest.mark.parametrize(
    ("text", "draft", "lacking"),
    [
        ("a polo shirt", "polo-shirt", {"buttons", "open_front"}),
        ("a blazer", "blazer", {"buttons", "pockets", "second_layer"}),
        ("a wrap dress", "wrap-dress", {"ties"}),
        ("a sarong", "sarong", {"draped_cloth", "ties"}),
    ],
)
def test_what_these_drafts_cannot_show_is_still_said(text, draft, lacking):
    assert {
        lack.what for lack in hear_description(text, Saying()).made_as(NamedDraft(draft)).lacks
    } == lacking


def test_a_name_that_means_a_length_outweighs_what_a_detail_goes_with():
    heard = hear_description("a mini dress with a straight skirt", Saying())
    hems = claims((*heard.sure, *heard.likely))
    assert Claim("skirt_hem", "mini") in hems and Claim("skirt_hem", "knee") not in hems


def test_a_detail_that_becomes_its_opposite_is_named():
    mini = Saying(Wish(Gain(Claim("skirt_hem", "mini")), 0.7))
    heard = hear_description("long skirt, not floor length though", mini)
    assert heard.never == (Claim("skirt_hem", "floor"),)
    assert Claim("skirt_hem", "maxi") in claims((*heard.sure, *heard.likely))


def test_where_the_network_leaves_no_word_out_it_comes_first(reader):
    text = "a top with a neckline that is square on the left and round on the right"
    found = claims(hear_description(text, reader).sure)
    assert {Claim("left_neckline", "square"), Claim("right_neckline", "round")} <= found
    assert not any(claim.name == "neckline" for claim in found), "the words alone say so of all of it"
    square, kind = Wish(Gain(Claim("neckline", "square")), 0.99), Wish(Gain(Claim("kind", "top")), 0.99)
    heard = hear_description("a round neckline top, no collar", Saying(square, kind))
    assert Claim("neckline", "round") in claims(heard.sure), "nothing of the collar, so it has not understood"
    heard = hear_description("a top, not a square neckline", Saying(square, kind))
    assert Claim("neckline", "square") not in claims(heard.sure), "refused"


def test_numbers_of_a_skirt_fit_a_skirt(reader):
    heard = hear_description("an asymmetric-hem mid-calf skirt with four godets set into the hem", reader)
    assert Claim("godets", 4.0) in claims(heard.sure)


def test_what_a_kind_cannot_have_is_not_taken_from_the_network():
    legs = Wish(Gain(Claim("legs", "wide")), 0.97)
    assert Claim("legs", "wide") not in claims(hear_description("a bathrobe", Saying(legs)).sure)
    assert Claim("legs", "wide") in claims(hear_description("trousers, comfortable legs", Saying(legs)).sure)


def test_refusals_are_kept_apart(reader):
    heard = hear_description("a dress, not too short", reader)
    assert Claim("skirt_hem", "mini") in heard.never
    assert not set(heard.never) & (claims(heard.sure) | claims(heard.likely))


def test_a_garment_that_nobody_knows_has_no_kind_and_near_names(reader):
    heard = hear_description("a bxthrzbe", Saying())
    assert heard.kind is None and not heard.guess
    heard = hear_description("a grey cardigam", Saying())
    assert heard.kind == "top" and heard.guess == "cardigan", "a guess, and said to be one"
    assert "cardigam" in heard.unread
    assert hear_description("short maxi dress", reader).contradictions == (("short", "maxi dress"),)


def test_typing_errors_are_put_right_in_words_that_nobody_knows_alone():
    network = Saying()
    dress = measure_facts(swifttailor.draft("fitted-dress"))
    heard = hear_description("a sleevless dres and a rock", network)
    assert network.texts == [heard.text] and "rock" in heard.text, "a first letter is right"
    assert "dress" in heard.text
    assert hear_instruction("rock it, sleevless", network, dress).text == "rock it, sleeveless"


def test_in_an_instruction_words_count_and_the_network_where_they_leave_some_over():
    top = measure_facts(swifttailor.draft("t-shirt"))
    hood = Wish(Gain(Claim("hood", "hood")), 0.97)
    assert hood in hear_instruction("give it whatever a monk wears", Saying(hood), top).sure
    assert hood not in hear_instruction("a V neck instead, please", Saying(hood), top).sure
    heard = hear_instruction("a V neck instead, please", Saying(), top)
    assert Claim("neckline", "v") in claims(heard.sure)


@pytest.mark.parametrize("text", ["make it red and of denim", "make it of denim", "make it red, in silk"])
def test_fabrics_of_an_instruction_are_understood(text, reader):
    heard = hear_instruction(text, reader, measure_facts(swifttailor.draft("fitted-dress")))
    assert heard.cloth in ("denim", "silk") and heard.unread == ()


def test_lengths_that_were_read_are_no_sizes(reader):
    dress = measure_facts(swifttailor.draft("fitted-dress"))
    assert hear_instruction("make it 6 cm longer", reader, dress).cannot == ()
    assert any("sizes" in text for text in hear_description("a dress in size 12", reader).cannot)


def test_long_behind_a_length_is_no_claim(reader):
    heard = hear_description("a skirt 60 cm long with a 5 cm waistband", reader)
    found = claims(heard.sure) | claims(heard.likely)
    assert {Claim("skirt_length_cm", 60.0), Claim("waistband_cm", 5.0), Claim("kind", "skirt")} <= found
    assert all(claim.name != "skirt_hem" for claim in found)
    assert Claim("skirt_hem", "maxi") in claims(hear_description("a long skirt", reader).sure)


def test_no_text_asks_for_nothing(reader):
    assert hear_description(" \n", reader) is HEARD_NOTHING


WORDS = "no not too short long maxi mini dress skirt top shirt sleeveless hood collar V neck wide denim with"


@settings(max_examples=60, deadline=None)
@given(st.text(max_size=60) | st.lists(st.sampled_from(WORDS.split()), max_size=9).map(" ".join))
def test_wishes_never_exclude_each_other_and_the_surest_come_first(text):
    heard = hear_description(text, Saying(Wish(Gain(Claim("sleeves", "long")), 0.8)))
    wishes = (*heard.sure, *heard.likely)
    assert all(w.certainty >= SURE for w in heard.sure) and all(w.certainty < SURE for w in heard.likely)
    found = [w.change.claim for w in wishes]
    assert len(set(found)) == len(found) and not set(found) & set(heard.never)
    network = [claim for claim in found if claim == Claim("sleeves", "long")]
    assert not any(exclude(a, b) for a in network for b in found if a != b)


@pytest.mark.parametrize(
    ("text", "color"),
    [("a denim skirt", "#3b5578"), ("skinny jeans", "#3b5578"), ("a white denim skirt", "#ffffff")],
)
def test_denim_is_blue_unless_another_colour_is_named(reader, text, color):
    assert hear_description(text, reader).color == color


def test_what_is_denied_in_so_many_words_stands(reader):
    heard = hear_description("a dress with the right shoulder bare and no sleeve on either side", reader)
    said = {wish.change.claim for wish in heard.sure if isinstance(wish.change, Gain)}
    assert {Claim("sleeves", "none"), Claim("shoulders", "bare right")} <= said
    assert not [c for c in said if c.name in ("right_sleeve", "left_sleeve")]


def test_a_name_that_is_misspelt_comes_before_what_may_be_meant(reader):
    heard = hear_description("grey cardigam", reader)
    assert (heard.guess, heard.kind) == ("cardigan", "top")


def test_a_figure_outranks_a_word_for_the_size(reader):
    heard = hear_description("a blouse with long sleeves gathered to an 8 cm cuff", reader)
    claims = {wish.change.claim for wish in (*heard.sure, *heard.likely)}
    assert Claim("cuff_cm", 8.0) in claims
    assert Claim("cuffs", "deep") not in claims


def test_a_list_does_not_go_on_over_words_that_are_not_said_of_what_follows():
    words = read_words("a robe, long flowing, bell sleeves")
    assert Claim("skirt_hem", "maxi") in [i.claim for i in words.implications]
    words = read_words("a dress with long, wide sleeves")
    assert Claim("skirt_hem", "maxi") not in [i.claim for i in words.implications]
    assert Claim("sleeves", "long") in [i.claim for i in words.implications]


@pytest.mark.parametrize(
    ("text", "gone"),
    [
        ("shirt. collar: none. cuffs: none", {("collar", "none"), ("cuffs", "none")}),
        ("dress; sleeves = none; hood: no", {("sleeves", "none")}),
    ],
)
def test_what_a_list_has_none_of_is_refused(reader, text, gone):
    heard = hear_description(text, reader)
    asked = {(c.name, c.value) for c in claims(heard.sure)}
    assert gone <= asked
    assert not any(name in {n for n, _ in gone} and value != "none" for name, value in asked)


@pytest.mark.parametrize("text", ["long loose coat, straight cut", "loose straight dress"])
def test_what_is_loose_is_not_made_easy(reader, text):
    asked = claims(hear_description(text, reader).sure)
    assert Claim("fit", "loose") in asked and Claim("fit", "easy") not in asked


@pytest.mark.parametrize(
    "text", ["something flowing, maybe ankle length", "straight and loose, mid calf, short sleeves"]
)
def test_what_is_long_and_has_no_name_is_guessed_to_be_a_dress(reader, text):
    heard = hear_description(text, reader)
    assert heard.kind == "dress" and heard.text == text
    assert heard.guess == "dress"
    assert hear_description(text, reader, alone=False).guess == "", "a picture tells what it is"


@pytest.mark.parametrize(
    "text", ["ankle length, with a wide waistband", "an ankle-length skirt", "floor length trousers"]
)
def test_what_has_a_waistband_or_a_name_is_no_dress(reader, text):
    assert hear_description(text, reader).kind != "dress"


def test_a_figure_for_sleeves_leaves_no_word_for_their_length(reader):
    heard = hear_description("top with sleeves, sleeve 60 cm", reader)
    assert Claim("sleeve_cm", 60.0) in claims(heard.sure)
    assert not {Claim("sleeves", "short"), Claim("sleeves", "cap")} & claims((*heard.sure, *heard.likely))


@pytest.mark.parametrize(("text", "unread"), [("a skirt with 2 slits", ()), ("a skirt with 3 slits", ("3",))])
def test_slits_that_are_counted_are_no_gores(reader, text, unread):
    heard = hear_description(text, reader)
    claims = {w.change.claim.name for w in (*heard.sure, *heard.likely) if isinstance(w.change, Gain)}
    assert "slit" in claims and "gores" not in claims
    assert heard.unread == unread


@pytest.mark.parametrize(
    ("text", "first"),
    [
        ("trousers that are flared from the knee", "flares"),
        ("jeans that are flared", "flares"),
        ("slim chinos", "jeans"),
        ("a wrap dress with an A-line skirt", "wrap-dress"),
        ("an A-line shirt dress", "shirt-dress"),
        ("a wool dress with an A-line skirt", "skater-dress"),
        ("a pleated skirt", "pleated-skirt"),
        ("a plain skirt", "circle-skirt"),
    ],
)
def test_what_says_more_of_a_garment_gives_the_draft(text, first):
    assert hear_description(text, Saying()).drafts[0].name == first


def test_shorts_begin_from_a_draft_of_their_length():
    (draft, *_) = hear_description("wide shorts", Saying()).drafts
    assert dict(draft.options)["length"] < 60.0


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("bolero to wear over my wedding dress", "top"),
        ("waist to hem 48 cm, eight gores, flat across the hip", "skirt"),
        ("trumpet sleeves, boat neckline, 60 cm long", "top"),
        ("nothing on top, long dress, slinky", "dress"),
        ("what would you wear to a ceilidh? it needs to twirl", "dress"),
        ("harem pants for yoga", "trousers"),
    ],
)
def test_the_kind_is_that_of_what_is_asked_for(reader, text, kind):
    assert hear_description(text, reader).kind == kind


def test_the_band_of_a_jackets_hem_may_be_called_a_waistband(reader):
    heard = claims(hear_description("bomber jacket with ribbed cuffs and waistband", reader).sure)
    assert Claim("waistband", "hem") in heard and Claim("waistband", "waist") not in heard


@pytest.mark.parametrize(
    ("text", "draft"),
    [
        ("prom dress, mermaid, strapless", "strapless-dress(flounce=true)"),
        ("playsuit with cami straps", "strappy-jumpsuit(length=48;leg_ease=24;flare=4)"),
        ("joggers", "joggers"),
        ("square neck dress with puff sleeves", None),
    ],
)
def test_drafts_are_held_and_sleeved_as_asked(reader, text, draft):
    drafts = hear_description(text, reader).drafts
    assert drafts
    if draft is not None:
        assert drafts[0].name == NamedDraft.parse(draft).name
        assert dict(NamedDraft.parse(draft).options).get("flounce") == dict(drafts[0].options).get("flounce")
    else:
        assert dict(drafts[0].options)["sleeve_shape"] == "puffed"


def test_what_one_word_tells_of_sleeves_counts_once(reader):
    heard = hear_description("a dress with bishop sleeves and a waist seam", reader)
    assert {"sleeves", "sleeve_shape", "cuffs", "waist_seam"} <= {c.name for c in claims(heard.sure)}
    assert dict(heard.drafts[0].options)["sleeve_shape"] == "balloon"


@pytest.mark.parametrize(
    ("text", "kind", "draft"),
    [
        ("long sleeves, boat neck, knee-length pencil skirt", "dress", "fitted-dress"),
        ("puff sleeves and a full skirt to the knee", "dress", "skater-dress"),
        ("a pleated skirt with pockets", "skirt", "pleated-skirt"),
        ("a skirt with a boat neck top", "skirt", "circle-skirt"),
    ],
)
def test_a_skirt_with_sleeves_is_that_of_a_dress(text, kind, draft):
    heard = hear_description(text, Saying())
    assert heard.kind == kind and heard.drafts[0].name == draft


def test_what_is_refused_sets_the_draft():
    (blazer,) = hear_description("a blazer that isn't boxy", Saying()).drafts
    assert blazer.name == "blazer" and dict(blazer.options)["chest_ease"] == 4.0
    (dress,) = hear_description("strapless prom dress but not poofy", Saying()).drafts
    assert dress.name == "strapless-dress" and dict(dress.options)["fitted"] is True


def test_a_blouse_without_its_collar_begins_from_a_plain_top():
    (draft,) = hear_description("a blouse without a collar", Saying()).drafts
    assert draft.name == "t-shirt"


def test_long_texts_begin_from_a_draft_that_has_all_they_ask_for():
    text = (
        "a dress, close in the bodice, long sleeves, a high round neck without a collar, a gathered skirt "
        "from the natural waist, to the ankles"
    )
    heard = hear_description(text, Saying())
    assert len(heard.sure) > 7 and heard.drafts[0].name == "skater-dress"
    assert not hear_description(text + ", three tiers and godets", Saying()).drafts, "no draft has these"


def test_numbers_of_buttons_are_understood():
    assert hear_description("a polo shirt, 3 button placket", Saying()).unread == ()
    assert hear_description("a polo shirt, 3 wuzzles", Saying()).unread


def test_slippers_alone_ask_for_no_garment(reader: WishReader) -> None:
    heard = hear_description("just some slippers for my dad he's always cold", reader)
    assert asks_for_none(heard, heard.text)


def test_a_greeting_asks_for_no_garment(reader: WishReader) -> None:
    for text in ("hello", "hi there, please"):
        assert asks_for_none(hear_description(text, reader), text)
    assert not asks_for_none(hear_description("hello, a dress please", reader), "hello, a dress please")


def test_of_a_high_neck_that_plunges_one_is_begun_from_and_both_are_named(reader: WishReader) -> None:
    heard = hear_description("a high neck plunging blouse", reader)
    assert heard.contradictions == (("high neck", "plunging"),)
    assert not any(draft.name == "turtleneck" for draft in heard.drafts)


def test_a_collar_stands_on_a_gown_that_its_name_makes_strapless(reader: WishReader) -> None:
    first = hear_description("high neck bridal gown with cap sleeves and a full skirt", reader).drafts[0]
    assert first.name == "shirt-dress" and dict(first.options)["collar"] == "standing"
    assert dict(first.options)["skirt_fraction"] == 1.0


def test_cables_are_named_as_what_is_not_knitted(reader: WishReader) -> None:
    for text in ("a chunky cable knit jumper", "a dress in cable knit"):
        assert "cables" in {lack.what for lack in hear_description(text, reader).lacks}
    assert "cables" not in {lack.what for lack in hear_description("a ribbed jumper", reader).lacks}


def test_the_one_dress_that_is_named_stays_one(reader: WishReader) -> None:
    heard = hear_description(
        "lolita jsk, bow at the waist, skirt as poofy as it gets, pink w strawberries", reader
    )
    assert heard.kind == "dress"


@pytest.mark.parametrize(
    ("text", "slits"),
    [
        ("flowy sundress with a bow at the back", set()),
        ("prom dress with a corset back", set()),
        ("skirt with two cuts on the side", {"left", "right"}),
        ("a straight skirt with a slit at the back", {"back"}),
    ],
)
def test_no_slit_is_guessed_where_no_word_can_mean_one(text, slits, reader: WishReader) -> None:
    heard = hear_description(text, reader)
    changes = [wish.change for wish in (*heard.sure, *heard.likely)]
    claims = [change.claim for change in changes if isinstance(change, Gain)]
    assert {claim.value for claim in claims if claim.name == "slit"} == slits


def test_curtains_are_none_however_they_are_described(reader: WishReader) -> None:
    heard = hear_description("curtains for the spare room, 2m drop, lined", reader)
    assert asks_for_none(heard, heard.text)
    heard = hear_description("a dress made of an old curtain", reader)
    assert not asks_for_none(heard, heard.text)


def test_a_laced_front_is_no_slit(reader):
    heard = hear_description("a high waisted velvet gown in dark red, laced front, floor length", reader)
    assert not any(w.change.claim.name == "slit" for w in heard.sure if hasattr(w.change, "claim"))

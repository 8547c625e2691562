"""Sayings put plainly, and what instructions ask for by them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor import draft
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.measuring import measure_facts
from swifttailor.wishes.instructions.girth_targets import with_targets
from swifttailor.wishes.instructions.sayings import plainly
from swifttailor.wishes.instructions.spoken_changes import spoken_changes
from swifttailor.wording.lexicon import read_words


def heard(text, kind, *so):
    plain = plainly(text, kind)
    words = read_words(plain, kind=kind)
    return set(spoken_changes(plain, words, kind, lambda c: f"{c.name}={c.value}" in so).changes)


def gain(name, value):
    return Gain(Claim(name, value))


SLITS = {gain("slit", "left"), gain("slit", "right")}
GRIP = {Step("waistband width", -1, 3.0)}


@pytest.mark.parametrize(
    ("text", "kind", "changes"),
    [
        # As people say it
        ("flouncy cuffs", "dress", {gain("cuffs", "flounce")}),
        ("let out side seams by 1 cm each", "top", {Step("chest", 1, 2.0)}),
        (
            "Let out the side seams a centimetre either side of each, 4 cm round the chest in all.",
            "top",
            {Step("chest", 1, 4.0)},
        ),
        ("the wavy bit along the bottom, make that straight", "skirt", {gain("hem_shape", "level")}),
        ("make the zigzag hem straight", "skirt", {gain("hem_shape", "level")}),
        ("Hem in points, hood up", "dress", {gain("hem_shape", "pointed"), gain("hood", "hood")}),
        ("make pant shorter 3 cm", "trousers", {Step("leg length", -1, 3.0)}),
        ("baggier, like it's my dad's", "top", {Step("chest", 1)}),
        ("cut the front a good bit longer", "dress", {Step("dip", -1)}),
        ("drop the hem 4 cm at the back", "skirt", {Step("dip", 1, 4.0)}),
        ("front 5 cm shorter", "dress", {Step("dip", 1, 5.0)}),
        ("the back should be longer", "dress", {gain("hem_shape", "high-low")}),
        ("shorter at the front", "skirt", {gain("hem_shape", "high-low")}),
        ("the waistband a good 3 cm taller", "skirt", {Step("waistband height", 1, 3.0)}),
        ("the neck closed up with a little standing collar", "dress", {gain("collar", "stand")}),
        (
            "sleeve length + 2cm / body length - 3cm",
            "top",
            {Step("sleeve length", 1, 2.0), Step("length", -1, 3.0)},
        ),
        ("cover bum", "top", {gain("top_hem", "long")}),
        ("show less cleavage", "dress", {Step("neck depth", -1)}),
        ("show no cleavage", "dress", {gain("neck_depth", "high")}),
        # One shoulder, one sleeve
        ("off one shoulder, nothing on the left side at all", "dress", {gain("shoulders", "bare left")}),
        ("one-shoulder, bare on the right", "dress", {gain("shoulders", "bare right")}),
        ("drop it off my left shoulder", "dress", {gain("shoulders", "bare left")}),
        ("one shouldered please, keep the right strap", "dress", {gain("shoulders", "bare left")}),
        # Where the waist is
        ("raise it to just under the bust", "dress", {gain("waist_seam", "empire")}),
        ("start the skirt right under the bust", "dress", {gain("waist_seam", "empire")}),
        ("I want a normal waist", "dress", {gain("waist_seam", "natural")}),
        (
            "a proper waistline in the ordinary place rather than under the bust",
            "dress",
            {gain("waist_seam", "natural")},
        ),
        (
            "the seam should sit where my waist actually is",
            "dress",
            {gain("waist_seam", "natural")},
        ),
        ("Taille bitte direkt unter der Brust", "dress", {gain("waist_seam", "empire")}),
        ("la couture sous la poitrine", "dress", {gain("waist_seam", "empire")}),
        # What goes
        ("the shirt can lose its collar", "top", {gain("collar", "none")}),
        ("chop the sleeves off completely", "dress", {gain("sleeves", "none")}),
        ("lop those sleeves off", "top", {gain("sleeves", "none")}),
        ("could the high neck go", "top", {gain("collar", "none")}),
        ("the hood has to go", "top", {gain("hood", "none")}),
        (
            "It's the collar thing, the rolled one that goes up, can it just not be there.",
            "top",
            {gain("collar", "none")},
        ),
        ("sew up the slit", "dress", {gain("slit", "none")}),
        # What is cut off somewhere is shortened
        ("saw the sleeves off at the elbow", "dress", {gain("sleeves", "elbow")}),
        # Hems and slits
        ("make the hem come to a point in front", "dress", {gain("hem_shape", "pointed")}),
        ("Saum vorne spitz zulaufend", "dress", {gain("hem_shape", "pointed")}),
        ("cut both sides open to the top of the thigh", "skirt", {*SLITS, gain("slit_size", "high")}),
        ("slash both sides up to the hip", "dress", {*SLITS, gain("slit_size", "high")}),
        ("split it up the back", "skirt", {gain("slit", "back")}),
        # Cuffs
        (
            "gather them into a cuff at the ankle",
            "trousers",
            {gain("leg_cuffs", "gathered"), gain("leg_hem", "ankle")},
        ),
        ("nip the legs in at the ankles with a band", "jumpsuit", {gain("leg_cuffs", "gathered")}),
        # What is felt
        ("I have to keep hitching these up", "trousers", GRIP),
        ("they slide off my waist", "trousers", GRIP),
        ("der Rock rutscht", "skirt", GRIP),
        ("it won't stay up", "dress", {Step("chest", -1)}),
        ("I keep treading on it", "trousers", {Step("leg length", -1)}),
        ("my hands disappear in the sleeves", "top", {Step("sleeve length", -1)}),
        ("my collarbones mustn't show", "top", {Step("neck depth", -1)}),
        ("it is so narrow that I cannot walk", "dress", {Step("skirt hem", 1)}),
        ("my bra shows at the back", "dress", {Step("back depth", -1)}),
        # How much
        ("a bit tight round the guts, give us another 5 cm there", "dress", {Step("chest", 1, 5.0)}),
        ("too snug at the bust, I need two inches more", "dress", {Step("chest", 1, 5.08)}),
        ("two more inches in the waist please", "skirt", {Step("waistband width", 1, 5.08)}),
        ("neck too broad", "top", {Step("neck width", -1)}),
        ("everything 5 cm longer", "dress", {Step("length", 1, 5.0), Step("sleeve length", 1, 5.0)}),
        ("me queda grande", "top", {Step("chest", -1)}),
        ("las mangas me quedan largas", "top", {Step("sleeve length", -1)}),
        ("la robe me serre à la taille", "dress", {Step("chest", 1)}),
    ],
)
def test_a_saying_asks_for_what_it_means(text, kind, changes):
    found = heard(text, kind)
    assert {c for c in found if c not in (gain("hips", "close"), gain("sides", "different"))} == changes


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("make it a bit tighter round the waist", "dress"),
        ("shorten the sleeves by 4 cm", "top"),
        ("drop the waist to the hip", "dress"),
        ("tight on the bottom", "skirt"),
        ("remove the left sleeve", "top"),
        ("take the sleeves up 3 cm", "top"),
    ],
)
def test_what_is_plain_stays_as_it_is(text, kind):
    assert plainly(text, kind) == text


def test_what_makes_somebody_look_like_something_is_no_wish():
    text = "a dropped waist makes me look like a toddler; raise it to just under the bust."
    assert heard(text, "dress", "waist_seam=dropped") == {gain("waist_seam", "empire")}


def test_what_is_asked_to_be_so_is_not_too_much():
    assert Step("sleeve width", 1) not in heard("make the sleeves a bit tight", "top")
    assert Step("chest", 1, 6.0) in heard("it's a bit tight", "top")


def test_a_shape_that_is_there_makes_way_for_another():
    found = heard("swap the circle skirt for tiers, a circle is too easy", "dress", "skirt=circle")
    assert gain("skirt", "circle") not in found and gain("skirt", "tiered") in found


def test_only_lower_garments_hold_at_the_waist():
    assert "waist" in plainly("it slips down over my hips", "skirt")
    assert "waist" not in plainly("it keeps slipping down", "dress")


@given(st.text(max_size=80), st.sampled_from(["dress", "top", "skirt", "trousers", "jumpsuit"]))
def test_any_text_can_be_put_plainly(text, kind):
    assert isinstance(plainly(text, kind), str)


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("strap width down to half an inch", "narrow straps"),
        ("thinner straps, about 1 cm", "narrow straps"),
        ("straps 2 cm narrower", "straps 2 cm narrower"),
        ("make the hem 60 cm", "make the hem 60 cm"),
    ],
)
def test_straps_end_at_a_number(text, plain):
    facts = measure_facts(draft("tank-top"))
    assert " ".join(with_targets(text, "top", facts).split()).removesuffix(" wide") == plain


def test_a_girth_that_ends_at_a_number_changes_by_the_difference():
    facts = measure_facts(draft("trousers"))
    now = facts.waistband.upper
    plain = with_targets(f"waist down to {now - 4:.1f} cm", "trousers", facts)
    assert plain == "waist narrower by 4.0 cm"


@pytest.mark.parametrize(
    ("text", "kind", "changes"),
    [
        ("pencil skirt out, circle skirt in", "dress", {gain("skirt", "circle")}),
        ("sleeves: long -> short", "top", {gain("sleeves", "short")}),
        ("the sleeves from long to short", "dress", {gain("sleeves", "short")}),
        ("i keep rolling up the sleeves", "top", {Step("sleeve length", -1)}),
        ("sleeves are way past my fingertips", "top", {Step("sleeve length", -1)}),
        ("too much bust on show", "dress", {Step("neck depth", -1)}),
        ("i'm choking", "top", {Step("neck depth", 1)}),
        ("delete collar, remove hood mesh", "top", {gain("collar", "none"), gain("hood", "none")}),
        ("crop it just under the bust", "top", {gain("top_hem", "bra")}),
        ("let it end at the waist", "top", {gain("top_hem", "waist")}),
        ("she has to run in it, open it up below the knee", "skirt", {Step("skirt hem", 1)}),
        ("one sleeve only, on the left", "top", {gain("sleeves", "left only"), gain("sides", "different")}),
        ("Ausschnitt bitte rund statt eckig", "dress", {gain("neckline", "round")}),
    ],
)
def test_what_one_writer_said_of_sixty_garments(text, kind, changes):
    assert heard(text, kind) == changes


def test_a_hem_measured_from_the_waist_is_no_girth():
    assert plainly("hem at 60 cm from the waist", "dress") == "skirt length 60 cm"
    assert plainly("hem at 60 cm", "dress") == "hem at 60 cm"


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("a good inch shorter", "1 inch shorter"),
        ("take it up by 2 or 3 cm", "take it up by 3 cm"),
        ("couple inches off the hem", "2 inches off the hem"),
        ("two fingers longer", "4 cm longer"),
        ("a hand's breadth longer, please", "10 cm longer, please"),
        ("sleeves down to my fingers", "sleeves down to my fingers"),
        ("two fingers of cloth", "two fingers of cloth"),
    ],
)
def test_amounts_by_hand_are_in_centimetres(said, plain):
    assert plainly(said, "dress") == plain

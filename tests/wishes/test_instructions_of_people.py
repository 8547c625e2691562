"""What people say of a garment that is there, and what becomes of it."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step, subject_of
from swifttailor.describing.measuring import measure_facts
from swifttailor.recutting.alter import alter
from swifttailor.wishes.instructions.hearing_changes import hear_instruction
from swifttailor.wishes.instructions.parts_of_shapes import part_of_shape
from swifttailor.wishes.instructions.sayings import plainly
from swifttailor.wishes.instructions.spoken_changes import spoken_changes
from swifttailor.wishes.reader import WishReader
from swifttailor.wording.lexicon import read_words


def gain(name, value):
    return Gain(Claim(name, value))


def heard(text, kind, *so):
    plain = plainly(text, kind)
    words = read_words(plain, kind=kind)
    return set(spoken_changes(plain, words, kind, lambda c: f"{c.name}={c.value}" in so).changes)


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "kind", "so", "changes"),
    [
        ("con mangas largas", "dress", ("sleeves=none",), {gain("sleeves", "long")}),
        ("add sleeves", "dress", ("sleeves=none",), {gain("sleeves", "short")}),
        ("why does it have a collar? I didn't ask for one", "dress", (), {gain("collar", "none")}),
        ("why the slit?", "dress", (), {gain("slit", "none")}),
        (
            "no slit please, and a bit longer",
            "skirt",
            ("slit=back",),
            {gain("slit", "none"), Step("length", 1)},
        ),
        ("crop torso 10cm", "top", (), {Step("length", -1, 10.0)}),
        ("down to the ankle", "trousers", (), {gain("leg_hem", "ankle")}),
        ("the trousers bag at the knee", "trousers", (), {Step("leg end", -1)}),
        ("the sleeves should not flap about at the end", "top", (), {Step("sleeve end", -1)}),
        ("less puffy", "top", ("sleeve_shape=puffed",), {Step("sleeve width", -1)}),
        ("less flared", "top", ("sleeve_shape=bell",), {Step("sleeve end", -1)}),
        ("the waist pinches, let it out", "skirt", (), {Step("waistband width", 1, 3.0)}),
        ("the waist pinches, let it out 2 cm", "skirt", (), {Step("waistband width", 1, 2.0)}),
        ("too big at the waist, maybe 2 cm", "skirt", (), {Step("waistband width", -1, 2.0)}),
        (
            "lengthen the body by 4 cm, the sleeves by 5 cm",
            "top",
            (),
            {Step("length", 1, 4.0), Step("sleeve length", 1, 5.0)},
        ),
        ("a dress, not a top", "top", (), {gain("kind", "dress")}),
        ("this is a sack", "top", (), {Step("chest", -1, 6.0)}),
        (
            "turn hood into high collar",
            "top",
            ("hood=hood",),
            {gain("hood", "none"), gain("collar", "stand")},
        ),
        ("Bodice: perfect. Sleeves: an inch shorter.", "dress", (), {Step("sleeve length", -1, 2.54)}),
        ("a hood to keep the rain off", "dress", ("hood=none",), {gain("hood", "hood")}),
        ("I'd wear it if it had straps", "dress", ("shoulders=strapless",), {gain("shoulders", "both")}),
        ("it must not show my knees", "dress", (), {gain("skirt_hem", "below the knee")}),
        ("Just hem it. Three centimetres.", "dress", (), {Step("length", -1, 3.0)}),
        ("reduce hood size", "top", (), {Step("hood depth", -1)}),
        ("make the neckline more covered", "dress", (), {Step("neck depth", -1)}),
        ("the same without sleeve", "dress", (), {gain("sleeves", "none")}),
        ("make the slit smaller", "skirt", ("slit=left",), {Step("left slit", -1)}),
        ("the band at the waist is too wide", "skirt", (), {Step("waistband height", -1)}),
        ("no bare arms", "dress", ("sleeves=none",), {gain("sleeves", "long")}),
        ("fitted waist", "skirt", (), {Step("waistband width", -1, 3.0)}),
        ("the hem is two inches off the floor", "dress", (), {Step("length", 1, 6.0)}),
        ("cintura más baja", "trousers", ("rise=high",), {gain("rise", "mid")}),
        ("the sleeves must be huge", "top", (), {Step("sleeve width", 1)}),
    ],
)
def test_words_say(text, kind, so, changes):
    assert heard(text, kind, *so) == changes


def test_a_slit_that_goes_and_grows_is_a_contradiction():
    words = read_words("remove the slit and make it higher", kind="skirt")
    spoken = spoken_changes(
        "remove the slit and make it higher", words, "skirt", lambda c: str(c.value) == "left"
    )
    assert spoken.clashes


@pytest.mark.parametrize(
    ("word", "so", "part"),
    [
        ("less puffy", ("sleeve_shape=puffed",), "sleeves"),
        ("less puffy", ("sleeve_shape=puffed", "skirt=gathered"), None),
        ("less puffy", ("sleeves=none",), None),
        ("less flared", (), None),
        ("shorter", ("sleeve_shape=puffed",), None),
    ],
)
def test_a_shape_names_the_part_that_has_it(word, so, part):
    assert part_of_shape(word, "dress", lambda c: f"{c.name}={c.value}" in so) == part


def test_a_skirt_of_trousers_ends_as_a_skirt(reader):
    facts = measure_facts(swifttailor.draft("trousers"))
    asked = [
        w.change
        for w in hear_instruction("trade the trousers for a full skirt to the ankle", reader, facts).sure
    ]
    assert gain("kind", "skirt") in asked
    assert gain("skirt_hem", "ankle") in asked


def test_what_is_far_too_low_is_not_so_afterwards(reader):
    plunging = alter(
        swifttailor.draft("shirt-dress"), ["collar=none", "neckline=v", "neck_depth=plunging"]
    ).facts
    assert Claim("neck_depth", "plunging").holds(plunging)
    asked = [
        w.change for w in hear_instruction("the neckline is far too low, bring it up", reader, plunging).sure
    ]
    (step,) = [c for c in asked if subject_of(c) == "neck depth"]
    assert isinstance(step, Step) and step.direction < 0
    assert plunging.front_neck.depth - step.amount < 23.5


def test_a_slit_to_the_thigh_moves_no_hem(reader):
    facts = measure_facts(swifttailor.draft("shirt-dress"))
    asked = [w.change for w in hear_instruction("mid thigh slit please on the left", reader, facts).sure]
    assert gain("slit", "left") in asked
    assert not {"skirt_hem", "leg_hem", "length"} & {subject_of(c) for c in asked}

"""What is said of an edit is so: what was understood, what was changed, what stayed."""

from __future__ import annotations

from dataclasses import replace

import pytest
from scripted_maker import scripted_maker

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Step
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import InputError, NothingAskedError
from swifttailor.garment.cloth_color import PALETTE, cloth_color
from swifttailor.garment.garment import Garment
from swifttailor.garment.part_looks import PartLook
from swifttailor.garment.triangle_mesh import mesh_of_garment
from swifttailor.pattern import write_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.tailor import Order, Tailor
from swifttailor.tailor.changes_seen import changes_seen
from swifttailor.tailor.reporting import AS_IT_WAS

DRESS, SHIRT = draft("fitted-dress"), draft("t-shirt")


@pytest.fixture
def tailor(sewer) -> Tailor:
    """Whose network would write a T-shirt, whatever is asked for."""
    return Tailor.load(scripted_maker([SHIRT]), sewer)


@pytest.mark.parametrize("text", ["asdf qwer", "长裙", "make it prettier"])
def test_an_edit_of_which_nothing_is_understood_gives_back_the_pattern(tailor, text, tmp_path):
    before = DRESS.canonical()
    made = tailor.edit(before, text)
    assert made.pattern == before and made.pattern.name == before.name
    write_pattern(before, tmp_path / "before.json")
    write_pattern(made.pattern, tmp_path / "after.json")
    assert (tmp_path / "before.json").read_bytes() == (tmp_path / "after.json").read_bytes()
    assert tailor.pattern_maker.model.runtime.asked == [], "nobody was asked to write another"
    assert made.needs_a_look and made.notes[0] == AS_IT_WAS
    assert made.report["not_understood"]
    assert any(made.report["not_understood"][0] in note for note in made.notes[1:])
    assert made.report["alterations"] == {"of_the_pattern_to_edit": True, "cuts": [], "changes": []}


def test_samples_of_it_are_all_the_same(tailor):
    made = tailor.make(Order("make it prettier", edit=DRESS, samples=3))
    assert [one.pattern for one in made] == [DRESS.canonical()] * 3
    assert [one.report["order"]["seed"] for one in made] == [0, 1, 2]


def test_both_of_two_wishes_are_cut(tailor):
    made = tailor.edit(DRESS, "give it a V neck and make it 12 cm longer")
    was, now = measure_facts(DRESS), measure_facts(made.pattern)
    assert now.length - was.length == pytest.approx(12, abs=1)
    assert made.report["not_understood"] == [] and len(made.report["wishes"]) == 2
    assert all(wish["holds"] for wish in made.report["wishes"]) and not made.needs_a_look


def test_what_is_said_in_known_words_is_done_though_the_network_is_not_sure(tailor):
    made = tailor.edit(DRESS, "v-neck, knee length")
    assert [wish["holds"] for wish in made.report["wishes"]] == [True, True]
    assert made.notes[-1].startswith("Changed: ") and not made.needs_a_look


def test_what_was_not_understood_is_named_beside_what_was_done(tailor):
    made = tailor.edit(DRESS, "make it glorped and 12 cm longer with sequins")
    assert (
        'Not understood: "glorped".' in made.notes
        and "Cannot be made: sequins sewn on (they are drawn)." in made.notes
    )
    assert made.needs_a_look, "12 cm longer, but without sequins, and who knows what glorped is"
    assert made.report["heard"]["cannot"] == ["sequins sewn on (they are drawn)"]
    assert made.report["not_understood"] == ["glorped"]


@pytest.mark.parametrize("lost", ["glorp it", "make it 20 cm glorpier", "sew on sequins"])
@pytest.mark.parametrize("order", ["{lost} and make it 12 cm longer", "make it 12 cm longer and {lost}"])
def test_of_two_wishes_the_one_that_is_lost_is_said(tailor, lost, order):
    """Whichever comes first; and the other one is done."""
    made = tailor.edit(DRESS, order.format(lost=lost))
    assert measure_facts(made.pattern).length - measure_facts(DRESS).length == pytest.approx(12, abs=1)
    said = [note for note in made.notes if note.startswith(("Not understood: ", "Cannot be made: "))]
    assert said and any(word in said[0] for word in ("glorp", "20 cm", "sequins"))
    assert made.needs_a_look


def test_a_colour_alone_changes_the_colour_alone(tailor):
    made = tailor.edit(DRESS.canonical(), "make it red and of denim")
    assert made.pattern == DRESS.canonical()
    assert made.garment.color == made.report["color"] == "#ab252e"
    assert tailor.pattern_maker.model.runtime.asked == [], "nobody was asked to write another"
    assert any(n.startswith("Colour: red") for n in made.notes) and "denim" in made.warnings[0]


def test_what_is_understood_and_does_not_hold_is_to_be_looked_at(tailor):
    made = tailor.edit(DRESS, "make it 300 cm longer")
    assert made.needs_a_look and made.pattern == DRESS.canonical()
    assert made.notes[-2:] == (
        "Nothing was changed.",
        "Requested but not met: from top to hem, garments without legs: more by 300 cm.",
    )


def test_what_is_so_already_changes_nothing(tailor):
    made = tailor.edit(SHIRT, "give it short sleeves")
    assert made.pattern == SHIRT.canonical() and not made.needs_a_look
    assert made.notes == ("Nothing was changed: it was so already.",)


def test_changes_are_told_from_the_patterns(tailor):
    assert changes_seen(DRESS, DRESS) == changes_seen(DRESS, replace(DRESS, name="other")) == ()
    made = tailor.edit(DRESS, "make it 12 cm longer")
    assert made.answer.seen == changes_seen(DRESS, made.pattern)
    (step,) = (c for c in made.answer.seen if isinstance(c, Step) and c.quantity == "length")
    was, now = measure_facts(DRESS), measure_facts(made.pattern)
    assert step.direction == 1 and step.amount == pytest.approx(now.length - was.length, abs=0.051)
    assert changes_seen(DRESS, replace(DRESS, panels=(), stitches=())) is None


def test_what_the_network_wrote_is_told_as_such(sewer):
    made = Tailor.load(scripted_maker([DRESS]), sewer).edit(SHIRT, "turn it into a dress")
    assert any("Written anew" in note for note in made.notes)
    assert any(note.startswith("Changed: ") and "dress" in note for note in made.notes)


def test_a_garment_keeps_its_colour(tailor, tmp_path):
    text = "give it a V neck and make it 12 cm longer"
    made = tailor.edit(DRESS, text)
    assert mesh_of_garment(made.garment).color == made.report["color"] == cloth_color(DRESS)
    given = next(color for color in PALETTE if color != cloth_color(DRESS))
    again = tailor.edit(DRESS, text, color=given)
    again.save(tmp_path, preview=False, images=False)
    assert Garment.load(tmp_path).color == again.garment.color == given
    assert "color" not in tailor.sew(DRESS).report


def test_a_text_without_words_is_refused(tailor):
    with pytest.raises(InputError, match="an instruction is needed"):
        tailor.edit(SHIRT, "\u200b")


def test_a_description_of_which_nothing_is_understood_is_to_be_looked_at(tailor):
    made = tailor.generate("asdf qwer", attempts=1, source="writer")
    assert made.needs_a_look and 'Not understood: "asdf", "qwer".' in made.notes
    assert any("this one is a guess" in note for note in made.notes)
    assert not tailor.generate("a T-shirt", attempts=1).needs_a_look


def test_a_cloth_alone_tells_no_garment(tailor):
    assert any("this one is a guess" in note for note in tailor.generate("sackcloth", attempts=1).notes)


@pytest.mark.parametrize("text", ["asdf qwer", "გრძელი ქვედაბოლო", "???", "sofa cover"])
def test_of_what_nobody_understands_nothing_is_made(tailor, text):
    with pytest.raises(NothingAskedError, match="no word of it is known") as refused:
        tailor.generate(text)
    assert text in str(refused.value) and refused.value.exit_code == 1
    assert tailor.pattern_maker.model.runtime.asked == [], "nobody was asked to write one"


@pytest.mark.parametrize("text", ["size 14", "XL", "188 cm 95 kg"])
def test_of_a_wearer_alone_nothing_is_made(tailor, text):
    asked, other = tailor.write([Order(text), Order("a T-shirt")])
    assert isinstance(asked, NothingAskedError) and "Nothing but who wears it" in str(asked)
    assert not isinstance(other, NothingAskedError)


@pytest.mark.parametrize(
    "text",
    [
        "hat",
        "a paisley scarf",
        "shoes for running",
        "blue curtains",
        "Can you fix the zip on my boots?",
        "please mend my jacket",
    ],
)
def test_what_is_no_garment_is_not_made(tailor, text):
    with pytest.raises(NothingAskedError, match="What can be made are tops, dresses"):
        tailor.generate(text)


@pytest.mark.parametrize(
    "text", ["something to go with my hat", "a red one", "a dress and a scarf", "a suit"]
)
def test_what_may_be_a_garment_is_made(tailor, text):
    assert tailor.generate(text, attempts=1).pattern.panels


def test_a_print_alone_changes_the_print_alone_and_is_kept(tailor, tmp_path):
    striped = tailor.edit(DRESS, "with navy and white stripes")
    assert striped.pattern == DRESS.canonical() and striped.garment.print is not None
    assert striped.report["print"]["colors"] == ["#1f2a44", "#ffffff"]
    striped.save(tmp_path, preview=False, images=False)
    assert Garment.load(tmp_path).print == striped.garment.print
    shorter = tailor.edit(DRESS, "make it 5 cm shorter", print=striped.garment.print)
    assert shorter.garment.print == striped.garment.print
    assert tailor.edit(DRESS, "in plain red", print=striped.garment.print).garment.print is None


def test_looks_of_parts_alone_cut_nothing_and_are_kept(tailor, tmp_path):
    red = PartLook("skirt", "#ab252e")
    made = tailor.edit(DRESS, "make the skirt red")
    assert made.pattern == DRESS.canonical() and made.garment.looks == (red,) and not made.needs_a_look
    assert made.report["looks"] == [{"part": "skirt", "color": "#ab252e"}]
    assert "Parts in a look of their own: skirt in red (#ab252e)." in made.notes
    sheer = tailor.edit(DRESS, "make the skirt sheer", looks=made.garment.looks)
    assert sheer.garment.looks == (PartLook("skirt", "#ab252e", "sheer"),)
    sheer.save(tmp_path, preview=False, images=False)
    assert Garment.load(tmp_path).looks == sheer.garment.looks
    longer = tailor.edit(DRESS, "make it 5 cm longer", looks=sheer.garment.looks)
    assert longer.garment.looks == sheer.garment.looks and longer.pattern != DRESS.canonical()
    assert tailor.edit(DRESS, "make it opaque", looks=sheer.garment.looks).garment.looks == (red,)
    assert "looks" not in tailor.edit(DRESS, "make it 5 cm longer").report


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("orange shoulders", "another colour of the shoulders"),
        ("make the buttons gold", "another colour of the buttons"),
    ],
)
def test_looks_of_what_is_no_part_of_a_garment_are_said_to_be_impossible(tailor, text, said):
    made = tailor.edit(DRESS, text)
    assert made.needs_a_look and made.garment.looks == () and made.pattern == DRESS.canonical()
    assert f"Cannot be made: {said}." in made.notes


@pytest.mark.parametrize(
    ("text", "fabric"),
    [
        ("make it of denim", "denim"),
        ("make it 5 cm longer, in silk", "silk"),
        ("make it red and of satin", "silk"),
    ],
)
def test_a_fabric_that_only_physics_obeys_is_not_said_to_be_met(tailor, text, fabric):
    made = tailor.edit(SHIRT, text)
    assert made.needs_a_look and made.report["heard"]["cloth_unmet"]
    (warning,) = made.report["warnings"]
    assert made.warnings == (warning,) and fabric in warning and "--finish" in warning
    assert AS_IT_WAS not in made.notes, "it was understood"


def test_a_fabric_is_met_where_the_garment_is_finished_with_it(tailor):
    made = tailor.edit(SHIRT, "make it of denim", finish=True, edge_length=6.0)
    assert made.report["fabric"] == "denim" and made.warnings == ()
    assert not made.report["heard"]["cloth_unmet"]


def test_cotton_is_what_garments_hang_like_anyway(tailor):
    made = tailor.edit(SHIRT, "make it of cotton and 5 cm longer")
    assert made.warnings == () and not made.needs_a_look
    assert any(note.startswith("Fabric: cotton") for note in made.notes)


@pytest.mark.parametrize(
    ("text", "unmet"), [("a denim skirt", True), ("a satin skirt", True), ("jeans", False)]
)
def test_what_only_the_name_of_a_garment_implies_was_not_asked_for(tailor, text, unmet):
    made = tailor.generate(text)
    assert made.report["heard"]["cloth"] and made.report["heard"]["cloth_unmet"] == unmet
    assert any("The fabric, " in warning for warning in made.warnings) == unmet


def test_what_is_named_late_in_a_long_text_is_made(tailor):
    text = (
        "I'm building a wardrobe for a stylised farming game and need simple dungarees, full length, "
        "straight leg, no sleeves obviously, denim."
    )
    wished = tailor.read(Order(text)).wishes
    assert any(wish.change.claim == Claim("kind", "jumpsuit") for wish in wished)

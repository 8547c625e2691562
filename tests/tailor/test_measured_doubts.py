"""What a finished pattern measures against what its text says."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step, subject_of
from swifttailor.tailor import Order
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.reading import Wanted, facts_of
from swifttailor.tailor.reporting import order_notes
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import read_words

SHIRT = swifttailor.draft("t-shirt")
LONG = Gain(Claim("sleeves", "long"))


def answer_to(text, pattern, *, edit=None, changes=(), kept=frozenset(), unread=()):
    wishes = tuple(Wish(change, 0.97) for change in changes)
    heard = Heard(text, wishes, words=read_words(text), kept=kept, unread=tuple(unread))
    wanted = Wanted(Order(text, edit=edit), text, wishes=wishes, heard=heard)
    return Answer(pattern, wanted=wanted, cuts=("something",), of_edit=edit is not None)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("a top with long sleeves", {"long"}),
        ("a top with a hood and short sleeves", {"hood"}),
        ("a top without sleeves", {"sleeves"}),
        ("a top with short sleeves", set()),
        ("a top without a hood", set()),
        ("a blue cotton top", set()),
    ],
)
def test_words_that_are_not_so_are_told(text, words):
    told = {word for each, _ in answer_to(text, SHIRT).not_so for word in each.split()}
    assert words <= told and bool(told) == bool(words)
    assert answer_to(text, SHIRT).is_other_than_wanted or not words


def test_what_is_told_anyhow_is_not_told_twice():
    assert answer_to("a top with long sleeves", SHIRT).not_so
    assert not answer_to("a top with long sleeves", SHIRT, unread=["long", "long sleeves"]).not_so
    assert not answer_to("shorter, long sleeves before", SHIRT, edit=SHIRT).not_so, "of edits it describes"


def test_what_an_edit_changed_unasked_is_told():
    longer = swifttailor.alter(SHIRT, ["sleeves=long"]).pattern
    assert not answer_to("long sleeves", longer, edit=SHIRT, changes=[LONG]).unasked
    other = answer_to("deeper neck", longer, edit=SHIRT, changes=[Step("neck depth", 1)])
    assert any(subject_of(change) in ("sleeves", "sleeve length") for change in other.unasked)
    assert other.is_other_than_wanted
    assert not answer_to("deeper neck", SHIRT, edit=SHIRT, changes=[Step("neck depth", 1)]).unasked


def test_a_waist_that_is_to_stay_and_does_not_is_told():
    dress = swifttailor.draft("shirt-dress")
    step = Step("chest", -1, 6.0)
    closer = swifttailor.alter(dress, [step]).pattern
    before, after = facts_of(dress), facts_of(closer)
    assert before is not None and after is not None
    waist = frozenset({"waist_seam"})
    kept = answer_to("closer, leave the waist", closer, edit=dress, changes=[step], kept=waist)
    free = answer_to("closer", closer, edit=dress, changes=[step])
    assert free.moved_waist is None
    moved = after.torso.waist - before.torso.waist
    assert moved < -5.0 and kept.moved_waist == pytest.approx(moved) and kept.is_other_than_wanted
    assert any(f"is {-moved:.1f} cm narrower" in note for note in order_notes(kept, kept.wanted))
    untouched = answer_to("closer, leave the waist", dress, edit=dress, changes=[step], kept=waist)
    assert untouched.moved_waist is None


def test_figures_of_an_instruction_that_are_missed_are_told():
    length = facts_of(SHIRT).length
    asked = Gain(Claim("length_cm", round(length + 2.5, 1)))
    text = f"make it {asked.claim.value} cm long"
    assert [c for _, c in answer_to(text, SHIRT, edit=SHIRT, changes=[asked]).not_so] == [asked]
    near = Gain(Claim("length_cm", round(length + 0.5, 1)))
    assert not answer_to(f"make it {near.claim.value} cm long", SHIRT, edit=SHIRT, changes=[near]).not_so

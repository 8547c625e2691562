"""Sleeves that are cut in one with the body are drafted for each body, not refitted with the trunk."""

from __future__ import annotations

from dataclasses import replace

import pytest

from swifttailor.body import Body
from swifttailor.body.wearer import Wearer
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.pattern.drafts.measurements import DraftMeasurements
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.drafted import DraftCandidate
from swifttailor.tailor.refitted import refitted


@pytest.fixture(scope="module")
def wearer():
    body = Body.default()
    return replace(body, measurements=replace(body.measurements, bust=112.0, arm_length=60.0), name="other")


def answer(armhole, **more):
    begun = DraftCandidate(
        NamedDraft("t-shirt", (("armhole", armhole), ("sleeve_length", 50.0))), 0, plain=True
    )
    return Answer(replace(begun.take().pattern, trims=("tie belt",)), draft=begun.name, drafted=begun, **more)


def test_wings_are_drafted_for_the_body_and_keep_what_is_put_on(wearer):
    made = refitted(answer("cut-in-one"), wearer)
    wanted = draft("t-shirt", measurements=wearer.measurements, armhole="cut-in-one", sleeve_length=50.0)
    assert made.pattern.panels == wanted.panels and made.pattern.trims == ("tie belt",)
    assert made.fitted_to == "other"


@pytest.mark.parametrize(
    ("name", "sleeve", "size", "anew"),
    [
        ("t-shirt", 22.0, "women EU 60", True),
        ("t-shirt", 60.0, "women EU 60", True),
        ("t-shirt", 60.0, "women EU 44", False),
        ("coat", 60.0, "women EU 60", False),
    ],
)
def test_tops_and_short_sleeves_of_large_bodies_are_drafted_for_them(monkeypatch, name, sleeve, size, anew):
    monkeypatch.setattr(
        "swifttailor.refitting.refitted.fit", lambda pattern, body: replace(pattern, name="fit")
    )
    body = Wearer(size=size).body()
    begun = DraftCandidate(NamedDraft(name, (("sleeve_length", sleeve),)), 0, plain=True)
    made = refitted(Answer(begun.take().pattern, draft=begun.name, drafted=begun), body).pattern
    assert (made.name == "fit") is not anew
    if anew:
        wider = 34.0 * body.measurements.armscye_depth / DraftMeasurements().armscye_depth
        wanted = draft("t-shirt", measurements=body.measurements, sleeve_length=sleeve, sleeve_end=wider)
        assert made.panels == wanted.panels and made.drafted_for == body.made_for


@pytest.mark.parametrize(("armhole", "cuts"), [("raglan", ()), ("cut-in-one", ("hem 4.0 cm shorter",))])
def test_others_are_refitted(monkeypatch, wearer, armhole, cuts):
    monkeypatch.setattr(
        "swifttailor.refitting.refitted.fit", lambda pattern, body: replace(pattern, name="fit")
    )
    assert refitted(answer(armhole, cuts=cuts), wearer).pattern.name == "fit"


@pytest.mark.parametrize(
    ("cuts", "length"),
    [(("bodice 4.0 cm shorter",), 18.0), (("hem 9.0 cm longer", "sleeves 2.0 cm longer"), 31.0)],
)
def test_a_top_of_a_large_body_is_drafted_as_long_as_it_was_cut(cuts, length):
    body = Wearer(size="women EU 60").body()
    begun = DraftCandidate(NamedDraft("sweatshirt", (("length", 22.0),)), 0, plain=True)
    made = refitted(Answer(begun.take().pattern, draft=begun.name, drafted=begun, cuts=cuts), body).pattern
    more = {} if len(cuts) == 1 else {"sleeve_length": 60.0}
    candidate = DraftCandidate(
        NamedDraft("sweatshirt", tuple({"length": length, **more}.items())), 0, plain=True
    )
    assert made.panels == candidate.made_for(body.measurements).panels

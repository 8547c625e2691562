"""Sleeves that are cut in one with the body are drafted for each body, not refitted with the trunk."""

from __future__ import annotations

from dataclasses import replace

import pytest

from swifttailor.body import Body
from swifttailor.body.wearer import Wearer
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
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


@pytest.mark.parametrize(("sleeve", "anew"), [(22.0, True), (60.0, False)])
def test_short_sleeves_of_very_large_bodies_are_drafted_for_them(monkeypatch, sleeve, anew):
    monkeypatch.setattr(
        "swifttailor.refitting.refitted.fit", lambda pattern, body: replace(pattern, name="fit")
    )
    body = Wearer(size="women EU 60").body()
    begun = DraftCandidate(NamedDraft("t-shirt", (("sleeve_length", sleeve),)), 0, plain=True)
    made = refitted(Answer(begun.take().pattern, draft=begun.name, drafted=begun), body).pattern
    assert (made.name == "fit") is not anew
    if anew:
        wanted = begun.made_for(body.measurements)
        assert made.panels == wanted.panels and made.drafted_for == body.made_for


@pytest.mark.parametrize(("armhole", "cuts"), [("raglan", ()), ("cut-in-one", ("hem 4.0 cm shorter",))])
def test_others_are_refitted(monkeypatch, wearer, armhole, cuts):
    monkeypatch.setattr(
        "swifttailor.refitting.refitted.fit", lambda pattern, body: replace(pattern, name="fit")
    )
    assert refitted(answer(armhole, cuts=cuts), wearer).pattern.name == "fit"


@pytest.mark.parametrize(
    ("size", "flare", "cuts", "anew"),
    [(26, -16.0, (), True), (26, -8.0, (), False), (26, -16.0, ("a",), False), (14, -16.0, (), False)],
)
def test_tapered_legs_of_large_bodies_are_drafted_for_them(monkeypatch, size, flare, cuts, anew):
    monkeypatch.setattr(
        "swifttailor.refitting.refitted.fit", lambda pattern, body: replace(pattern, name="fit")
    )
    body = Wearer(size=f"women UK {size}").body()
    begun = DraftCandidate(NamedDraft("trousers", (("leg_ease", 17.0), ("flare", flare))), 0, plain=True)
    pattern = begun.take().pattern
    made = refitted(Answer(pattern, draft=begun.name, drafted=begun, cuts=cuts), body).pattern
    assert (made.name == "fit") is not anew
    if anew:  # as high above the floor in proportion, and wider at the hem
        usual, large = (measure_facts(one) for one in (pattern, made))
        taller = body.measurements.waist_level / Body.default().measurements.waist_level
        assert large.hem.level == pytest.approx(taller * usual.hem.level, abs=1.0)
        assert large.trousers.hem > usual.trousers.hem + 5.0

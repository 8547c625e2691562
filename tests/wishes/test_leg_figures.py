"""Rises and widths at knee and hem that are told, in figures, of trousers."""

from __future__ import annotations

import pytest

from swifttailor.describing import measure_facts
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.measured_legs import legs_as_measured
from swifttailor.wishes.reader import WishReader
from swifttailor.wishes.text.leg_figures import below_waist_cm, knee_cm, told_rises

TROUSERS = NamedDraft.parse("trousers(length=100;leg_ease=22;flare=-8)")


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "below", "knee"),
    [
        ("Trousers: rise 28, inside leg 74, knee 48, hem 40.", 7.0, 48.0),
        ("trousers with a 24 cm rise", 11.0, None),
        ("trousers, rise of 11 inches", 7.1, None),
        ("front rise: 33", 2.0, None),
        ("46 cm at the knee", None, 46.0),
        ("Kniewweite 44", None, 44.0),
        ("a skirt 10 cm below the knee", None, None),
        ("knee 5 cm above", None, None),
        ("high rise trousers, 76 inside leg", None, None),
    ],
)
def test_figures_of_legs(text, below, knee):
    assert below_waist_cm(text) == (None if below is None else pytest.approx(below, abs=0.1))
    assert knee_cm(text) == knee


@pytest.mark.parametrize(("text", "rise"), [("rise 34", "high"), ("rise 28", "mid"), ("rise 22", "low")])
def test_a_rise_in_words(text, rise):
    assert told_rises(text, "trousers") == [Claim("rise", rise)]
    assert not told_rises(text, "skirt")


@pytest.mark.parametrize(
    ("text", "hem", "knee"),
    [
        ("trousers, knee 48, hem 40", 40.0, 48.0),
        ("trousers, hem 44", 44.0, 52.0),
        ("trousers, knee 46", None, 46.0),
    ],
)
def test_legs_are_as_wide_as_told(text, hem, knee):
    claims = [] if hem is None else [Claim("leg_width_cm", hem)]
    options = dict(legs_as_measured(TROUSERS, text, claims).options)
    assert float(options["leg_ease"]) + 36.7 == pytest.approx(knee)
    if hem is not None:
        legs = measure_facts(draft("trousers", **options)).trousers
        assert legs is not None and legs.hem == pytest.approx(hem, abs=1.0)


def test_all_of_such_figures_is_understood(reader):
    heard = hear_description("Straight-leg trousers, rise 28 cm, inside leg 76, knee 48, hem 40.", reader)
    wishes = {w.change for w in heard.sure}
    assert not heard.unread
    assert {Gain(Claim("rise", "mid")), Gain(Claim("leg_width_cm", 40.0))} <= wishes
    assert Gain(Claim("legs", "straight")) not in wishes, "the figures say it"
    assert Gain(Claim("leg_hem", "knee")) not in wishes
    assert dict(heard.drafts[0].options)["below_waist"] == 7.0


@pytest.mark.parametrize("text", ["straight boyfriend jeans, cropped", "chinos, cropped"])
def test_cropped_legs_are_not_full(text, reader):
    wishes = {w.change for w in hear_description(text, reader).sure}
    assert Gain(Claim("leg_hem", "calf")) in wishes and Gain(Claim("leg_hem", "full")) not in wishes


def test_slightly_cropped_legs_end_at_the_ankle(reader):
    heard = hear_description("trousers not tight on the calves. Slightly cropped is fine", reader)
    ends = [w.change.claim for w in heard.sure if isinstance(w.change, Gain)]
    assert [claim.value for claim in ends if claim.name == "leg_hem"] == ["ankle"]
    assert dict(heard.drafts[0].options)["length"] == 91.0


@pytest.mark.parametrize(
    "name", ["chinos", "jeans", "straight leg jeans", "cargo pants", "tailored trousers"]
)
def test_usual_legs_are_straight_and_no_wider_at_the_hem_than_at_the_thigh(name, reader):
    heard = hear_description(name, reader)
    first = heard.drafts[0]
    facts = measure_facts(draft(first.name, **dict(first.options)))
    assert Claim("legs", "straight").holds(facts)
    assert facts.trousers is not None and facts.trousers.hem < 0.82 * facts.trousers.thigh
    assert all(w.change != Gain(Claim("legs", "wide")) for w in (*heard.sure, *heard.likely))

"""Altering what a pattern maker writes."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import pytest

import swifttailor
from swifttailor.describing import Claim, measure_facts
from swifttailor.describing.differences import Gain, Step
from swifttailor.pattern import Pattern, check_pattern
from swifttailor.pattern_maker.maker import Request
from swifttailor.recutting import alter as alter_it
from swifttailor.tailor.fitted import FittingMaker, fit, sure_wishes
from swifttailor.wishes.reader import Wish

MIDI, NO_HOOD = Gain(Claim("skirt_hem", "midi")), Gain(Claim("hood", "none"))
LONGER = Step("length", 1, 10.0)


def written(pattern: Pattern, likelihood: float = -1.0) -> SimpleNamespace:
    """What is used of `Generated`."""
    return SimpleNamespace(
        pattern=pattern,
        findings=tuple(check_pattern(pattern)),
        changes=("mended",),
        log_likelihood=likelihood,
        sequence=(1, 2),
        unsewn=0,
        confidence=None,
        seconds={"writing": 0.1},
    )


@pytest.fixture(scope="module")
def dress() -> Pattern:
    return swifttailor.draft("shirt-dress")


@pytest.fixture(scope="module")
def shirt() -> Pattern:
    return swifttailor.draft("t-shirt")


def test_without_wishes_nothing_is_altered(dress):
    fitted = fit(written(dress), ())
    assert fitted.pattern is dress
    assert (fitted.cuts, fitted.open, fitted.recut) == ((), (), False)
    assert fitted.changes == ("mended",)


def test_what_was_written_is_altered_to_the_text(dress):
    assert not MIDI.claim.holds(measure_facts(dress))
    fitted = fit(written(dress), [Wish(MIDI, 0.9), Wish(NO_HOOD, 0.9)])
    assert MIDI.claim.holds(measure_facts(fitted.pattern))
    assert fitted.open == ()
    assert len(fitted.cuts) == 1
    assert not fitted.recut
    assert fitted.findings == tuple(check_pattern(fitted.pattern))


def test_an_edit_alters_the_pattern_that_was_given(dress, shirt):
    fitted = fit(written(shirt), [Wish(LONGER, 0.9)], dress)
    assert fitted.recut
    before, after = measure_facts(dress), measure_facts(fitted.pattern)
    assert after.length - before.length == pytest.approx(10.0, abs=0.5)
    assert {p.name for p in fitted.pattern.panels} == {p.name for p in dress.panels}
    assert fitted.changes == ()  # what was mended in what the network wrote is not in it


def test_what_cannot_be_cut_is_left_to_the_network(shirt):
    darted = swifttailor.draft("fitted-dress")
    wish = Gain(Claim("bodice", "darted"))
    fitted = fit(written(darted), [Wish(wish, 0.9)], shirt)
    assert not fitted.recut
    assert fitted.pattern is darted
    assert fitted.open == ()


def test_another_kind_of_garment_is_the_networks(dress, shirt):
    wish = Gain(Claim("kind", "dress"))
    fitted = fit(written(dress), [Wish(wish, 0.9)], shirt)
    assert not fitted.recut
    assert fitted.pattern is dress
    less = fit(written(shirt), [Wish(Gain(Claim("kind", "skirt")), 0.9)], swifttailor.draft("fitted-dress"))
    assert less.recut  # taking the upper part off leaves the skirt as it was
    assert less.open == ()


def test_what_holds_of_neither_stays_open(dress, shirt):
    wish = Gain(Claim("godets", 5.0))
    fitted = fit(written(shirt), [Wish(wish, 0.9)], dress)
    assert fitted.open == (wish,)
    assert fitted.pattern is shirt
    assert fitted.rank[:2] == (0, 1)


def test_patterns_that_cannot_be_measured_are_left_alone(dress):
    empty = replace(dress, panels=(), stitches=())
    fitted = fit(written(empty), [Wish(MIDI, 0.9)])
    assert fitted.pattern is empty
    assert fitted.open == (MIDI,)


class Scripted:
    """Writes one pattern after the other."""

    def __init__(self, *patterns: Pattern) -> None:
        self.patterns, self.asked = patterns, []

    def generate_all(self, requests, *, seed, temperature, first_attempt):
        self.asked.append((len(requests), first_attempt))
        return [written(self.patterns[first_attempt]) for _ in requests]


class Reading:
    """Reads what it was told to."""

    def __init__(self, *wishes: Wish) -> None:
        self.wishes = wishes

    def read(self, text, *, instruction):
        return self.wishes


def test_attempts_end_when_everything_holds(dress, shirt):
    darted = swifttailor.draft("fitted-dress")
    maker = Scripted(shirt, darted, shirt)
    fitting = FittingMaker(maker, Reading(Wish(Gain(Claim("bodice", "darted")), 0.9)))
    (fitted,) = fitting.generate_all([Request("a darted one")], attempts=3, temperature=0.5)
    assert fitted.pattern is darted
    assert maker.asked == [(1, 0), (1, 1)]


def test_a_pattern_to_edit_is_altered_once_for_all_attempts(shirt, monkeypatch):
    altered = []

    def counted(pattern, wishes, **options):
        altered.append(pattern)
        return alter_it(pattern, wishes, **options)

    monkeypatch.setattr("swifttailor.tailor.fitted.alter", counted)
    wish, maker = Wish(Gain(Claim("bodice", "darted")), 0.9), Scripted(shirt, shirt, shirt)
    request = Request("with darts", edit=shirt)
    (fitted,) = FittingMaker(maker, Reading(wish)).generate_all([request], attempts=3, temperature=0.5)
    assert fitted.open == (wish.change,) and len(maker.asked) == 3
    assert len(altered) == 4  # once the pattern to edit, and what was written each time


def test_who_reads_both_none_and_some_has_misunderstood():
    none, short = Wish(Gain(Claim("sleeves", "none")), 0.99), Wish(Gain(Claim("sleeves", "short")), 0.6)
    dress = Wish(Gain(Claim("kind", "dress")), 0.95)
    assert sure_wishes([none, dress, short]) == (dress,)
    assert sure_wishes([none, dress]) == (none, dress)
    assert sure_wishes([dress, short]) == (dress,)


def test_what_is_read_without_certainty_is_no_wish(dress):
    fitting = FittingMaker(Scripted(dress), Reading(Wish(MIDI, 0.4)))
    (fitted,) = fitting.generate_all([Request("a midi dress, perhaps", image="dress.png")])
    assert fitted.wishes == ()
    assert fitted.pattern is dress
    (plain,) = FittingMaker(Scripted(dress), None).generate_all([Request("a midi dress")])
    assert plain.pattern is dress


def test_one_leg_is_a_fault_unless_it_was_asked_for():
    trousers = swifttailor.draft("trousers")
    gone = {"pant_f_l", "pant_b_l"}
    kept = tuple(s for s in trousers.stitches if not gone & {side.panel for side in s.sides})
    one_leg = replace(trousers, panels=tuple(p for p in trousers.panels if p.name not in gone), stitches=kept)
    fitted = fit(written(one_leg), ())
    assert set(fitted.one_sided) == {"pant_f_r", "pant_b_r"}
    assert fitted.rank > fit(written(trousers), ()).rank
    asked = Wish(Gain(Claim("sides", "different")), 0.95)
    assert fit(written(one_leg), [asked]).one_sided == ()
    assert fit(written(one_leg), (), one_leg).one_sided == ()
    assert fit(written(trousers), ()).one_sided == ()

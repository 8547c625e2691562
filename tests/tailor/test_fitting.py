"""Altering what a pattern maker writes, in one loop of attempts with one verdict."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import swifttailor
from swifttailor.clock import Clock
from swifttailor.describing import Claim, measure_facts
from swifttailor.describing.differences import Gain, Step
from swifttailor.errors import InputError
from swifttailor.pattern import Pattern, check_pattern
from swifttailor.pattern.check import Change
from swifttailor.pattern_maker.maker import WrittenPattern
from swifttailor.recutting import alter as alter_it
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.fitting import fit
from swifttailor.tailor.order import Order
from swifttailor.tailor.orders_read import read_order
from swifttailor.tailor.reading import Wanted
from swifttailor.tailor.writing import WARMER, write_patterns
from swifttailor.wishes.corrections.sureness import sure_wishes
from swifttailor.wishes.reader import Wish

MIDI, NO_HOOD = Gain(Claim("skirt_hem", "midi")), Gain(Claim("hood", "none"))
LONGER = Step("length", 1, 10.0)
MENDED = Change("tiny-edge", "left out")


def written(pattern: Pattern, likelihood: float = -1.0) -> WrittenPattern:
    """What a pattern maker says of a pattern."""
    findings = tuple(check_pattern(pattern))
    return WrittenPattern(pattern, log_likelihood=likelihood, findings=findings, changes=(MENDED,))


def wanted(wishes=(), edit: Pattern | None = None, likely=(), *, unsaid: bool = False) -> Wanted:
    """An order as it was read; of a picture, or to leave alone, unless nothing goes without saying."""
    order = Order("words", edit=edit, alter=unsaid)
    return Wanted(order, "words", wishes=tuple(wishes), likely=tuple(likely))


@pytest.fixture(scope="module")
def dress() -> Pattern:
    return swifttailor.draft("shirt-dress")


@pytest.fixture(scope="module")
def shirt() -> Pattern:
    return swifttailor.draft("t-shirt")


@pytest.fixture(scope="module")
def picture():
    return np.full((8, 8, 3), 200, np.uint8)


def test_without_wishes_nothing_is_altered(dress):
    fitted = fit(written(dress), wanted())
    assert fitted.pattern is dress
    assert (fitted.cuts, fitted.verdict.open, fitted.of_edit) == ((), (), False)
    assert fitted.changes == (MENDED,)


def test_what_was_written_is_altered_to_the_text(dress):
    assert not MIDI.claim.holds(measure_facts(dress))
    fitted = fit(written(dress), wanted([Wish(MIDI, 0.9), Wish(NO_HOOD, 0.9)]))
    assert MIDI.claim.holds(measure_facts(fitted.pattern))
    assert fitted.verdict.open == ()
    assert len(fitted.cuts) == 1
    assert not fitted.of_edit
    assert fitted.verdict.findings == tuple(check_pattern(fitted.pattern))


def test_an_edit_alters_the_pattern_that_was_given(dress, shirt):
    fitted = fit(written(shirt), wanted([Wish(LONGER, 0.9)], dress))
    assert fitted.of_edit
    before, after = measure_facts(dress), measure_facts(fitted.pattern)
    assert after.length - before.length == pytest.approx(10.0, abs=0.5)
    assert {p.name for p in fitted.pattern.panels} == {p.name for p in dress.panels}
    assert fitted.changes == ()  # what was mended in what the network wrote is not in it


def test_what_is_written_anew_is_left_where_it_changes_what_nobody_spoke_of(shirt):
    darted = swifttailor.draft("fitted-dress")  # without sleeves, and longer
    wish = Gain(Claim("bodice", "darted"))
    fitted = fit(written(darted), wanted([Wish(wish, 0.9)], shirt))
    assert fitted.pattern is shirt and fitted.is_given
    assert fitted.verdict.open == (wish,)


def test_another_kind_of_garment_is_the_networks(dress, shirt):
    wish = Gain(Claim("kind", "dress"))
    fitted = fit(written(dress), wanted([Wish(wish, 0.9)], shirt))
    assert not fitted.of_edit
    assert fitted.pattern is dress
    skirt = Wish(Gain(Claim("kind", "skirt")), 0.9)
    less = fit(written(shirt), wanted([skirt], swifttailor.draft("fitted-dress")))
    assert less.of_edit  # taking the upper part off leaves the skirt as it was
    assert less.verdict.open == ()


def test_what_holds_of_neither_stays_open(dress, shirt):
    wish = Gain(Claim("godets", 5.0))
    fitted = fit(written(shirt), wanted([Wish(wish, 0.9)], dress))
    assert fitted.verdict.open == (wish,)
    assert fitted.pattern is dress and fitted.is_given
    assert fitted.verdict.rank == (0, 1, 0)


def test_patterns_that_cannot_be_measured_are_left_alone(dress):
    empty = replace(dress, panels=(), stitches=())
    fitted = fit(written(empty), wanted([Wish(MIDI, 0.9)]))
    assert fitted.pattern is empty
    assert fitted.verdict.open == (MIDI,)


class Scripted:
    """Writes one pattern after the other."""

    def __init__(self, *patterns: Pattern) -> None:
        self.patterns, self.asked, self.temperatures = patterns, [], []

    def generate_all(self, requests, *, seed, temperature, draw):
        self.asked.append((list(seed), draw))
        self.temperatures.append(temperature)
        return [written(self.patterns[draw]) for _ in requests]


class Listening(Scripted):
    """Notes the words that it is asked in."""

    def generate_all(self, requests, *, seed, temperature, draw):
        made = super().generate_all(requests, seed=seed, temperature=temperature, draw=draw)
        self.asked[-1] = requests[0].text
        return made


class Reading:
    """Reads what it was told to."""

    def __init__(self, *wishes: Wish) -> None:
        self.wishes, self.texts = wishes, []

    def read(self, text, *, instruction):
        self.texts.append(text)
        return self.wishes

    def whole(self, text, *, instruction=True):
        return {}


class Mannequin:
    """Sews nothing: notes what it was to prepare, and refuses some."""

    def __init__(self, *refused: Pattern) -> None:
        self.refused, self.prepared = refused, []

    def prepare(self, pattern, *, edge_length, resolution):
        if any(len(pattern.panels) == len(other.panels) for other in self.refused):
            raise InputError("no room on the mannequin")
        self.prepared.append(pattern)
        return edge_length


def answer(writer, order: Order, reader=None, sewer=None) -> Answer:
    """What comes of the one sample of an order."""
    samples = [(read_order(order, reader), order.seed)]
    (one,) = write_patterns(lambda: writer, sewer or Mannequin(), samples, Clock())
    assert isinstance(one, Answer)
    return one


def test_attempts_end_when_everything_holds(dress, shirt):
    darted = swifttailor.draft("fitted-dress")
    maker, sewer = Scripted(shirt, darted, shirt), Mannequin()
    wish = Wish(Gain(Claim("bodice", "darted")), 0.9)
    fitted = answer(maker, Order("a wuzzle", seed=5, temperature=0.5), Reading(wish), sewer)
    assert [p.name for p in fitted.pattern.panels] == [p.name for p in darted.panels]
    assert maker.asked == [([5], 0), ([5], 1)]
    assert maker.temperatures == [0.5, 0.5 + WARMER]
    assert fitted.attempt == 1 and len(fitted.failures) == 1
    assert fitted.failures[0].startswith("requested but not met: how the upper part is shaped")
    assert fitted.pattern.name == "a wuzzle" and fitted.pattern is sewer.prepared[-1]


def test_what_cannot_be_sewn_is_written_again_and_of_all_the_best_is_taken(shirt):
    trousers = swifttailor.draft("trousers")
    wish = Wish(Gain(Claim("bodice", "darted")), 0.9)
    order = Order("a wuzzle", attempts=2, source="writer")
    fitted = answer(Scripted(trousers, shirt), order, Reading(wish), Mannequin(trousers))
    assert fitted.attempt == 1 and fitted.failures == ("no room on the mannequin",)
    assert [w.claim.value for w in fitted.verdict.open] == ["darted"]
    (refused,) = write_patterns(
        lambda: Scripted(trousers, trousers),
        Mannequin(trousers),
        [(read_order(order, Reading()), 3)],
        Clock(),
    )
    assert "None of the 2 patterns" in str(refused) and "no room on the mannequin" in str(refused)
    assert "seed than 3" in str(refused)


def test_orders_are_written_together_and_each_until_it_is_sound(dress, shirt):
    """The first is sound at once; the other is asked for again, alone, by its own seed."""
    sound, darted = Order("anything", seed=1, alter=False), Order("a wuzzle", seed=8)
    reader = Reading(Wish(Gain(Claim("bodice", "darted")), 0.9))
    maker = Scripted(shirt, shirt, swifttailor.draft("fitted-dress"))
    samples = [(read_order(sound, None), 1), (read_order(darted, reader), 8)]
    first, second = write_patterns(lambda: maker, Mannequin(), samples, Clock())
    assert maker.asked == [([1, 8], 0), ([8], 1), ([8], 2)]
    assert (first.attempt, second.attempt) == (0, 2) and (first.seed, second.seed) == (1, 8)
    cold = Order("anything", temperature=0.0)
    with pytest.raises(InputError, match="one temperature"):
        write_patterns(lambda: maker, Mannequin(), [samples[0], (read_order(cold, None), 0)], Clock())


def test_a_text_is_read_and_a_pattern_to_edit_altered_once_for_all_samples_and_attempts(shirt, monkeypatch):
    altered = []

    def counted(pattern, wishes, **options):
        altered.append(pattern)
        return alter_it(pattern, wishes, **options)

    monkeypatch.setattr("swifttailor.tailor.reading.alter", counted)
    wish, maker = Wish(Gain(Claim("bodice", "darted")), 0.98), Scripted(shirt, shirt, shirt)
    reader = Reading(wish)
    order = Order("as a monk has it", edit=shirt, samples=2, attempts=3)  # words alone cannot tell
    one = read_order(order, reader)
    answers = write_patterns(lambda: maker, Mannequin(), [(one, 0), (one, 1)], Clock())
    assert all(a.verdict.open == (wish.change,) for a in answers) and len(maker.asked) == 3
    assert altered.count(shirt) == len(altered) == 7  # the pattern to edit, and what was written 3 times 2
    assert reader.texts.count("as a monk has it") == 1


def test_who_reads_both_none_and_some_has_misunderstood():
    none, short = Wish(Gain(Claim("sleeves", "none")), 0.99), Wish(Gain(Claim("sleeves", "short")), 0.6)
    dress = Wish(Gain(Claim("kind", "dress")), 0.95)
    assert sure_wishes([none, dress, short]) == (dress,)
    assert sure_wishes([none, dress]) == (none, dress)
    assert sure_wishes([dress, short]) == (dress,)


def test_what_is_read_without_certainty_is_no_wish(dress, picture):
    read = read_order(Order("a wuzzle, perhaps", picture), Reading(Wish(MIDI, 0.6)))
    assert read.wishes == () and [w.change for w in read.likely] == [MIDI]
    assert fit(written(dress), read).pattern is dress
    plain = read_order(Order("a midi dress", alter=False), None)
    assert fit(written(dress), plain).pattern is dress


def test_one_leg_is_a_fault_unless_it_was_asked_for():
    trousers = swifttailor.draft("trousers")
    gone = {"pant_f_l", "pant_b_l"}
    kept = tuple(s for s in trousers.stitches if not gone & {side.panel for side in s.sides})
    one_leg = replace(trousers, panels=tuple(p for p in trousers.panels if p.name not in gone), stitches=kept)
    fitted = fit(written(one_leg), wanted())
    assert set(fitted.verdict.one_sided) == {"pant_f_r", "pant_b_r"}
    assert fitted.rank > fit(written(trousers), wanted()).rank
    assert "no counterpart on the other side" in fitted.verdict.fault
    asked = Wish(Gain(Claim("sides", "different")), 0.95)
    assert fit(written(one_leg), wanted([asked])).verdict.one_sided == ()
    assert fit(written(one_leg), wanted(edit=one_leg)).verdict.one_sided == ()
    assert fit(written(trousers), wanted()).verdict.one_sided == ()


def test_a_hem_that_cutting_makes_uneven_is_made_level_again():
    """A circle skirt that is gathered at its seam: its sides get longer than its middle."""
    gathered = Gain(Claim("skirt", "gathered"))
    draft = swifttailor.draft("strapless-dress")
    alone = alter_it(draft, [gathered]).facts.hem
    fitted = fit(written(draft), wanted([Wish(gathered, 0.97)], unsaid=True), drafted=True)
    after = measure_facts(fitted.pattern)
    assert alone.dip > 8.0 and abs(after.hem.dip) < 4.0
    assert after.skirt.gather > 1.25 and any("level" in cut for cut in fitted.cuts)
    pointed = Wish(Gain(Claim("hem_shape", "pointed")), 0.97)
    asked = fit(written(draft), wanted([Wish(gathered, 0.97), pointed], unsaid=True), drafted=True)
    assert measure_facts(asked.pattern).hem.dip > 8.0


def test_what_can_be_had_of_what_goes_without_saying_is_done(shirt):
    """One thing that spoils what is asked for does not keep the others from being cut."""
    asked = Wish(Gain(Claim("top_hem", "hip")), 0.97)
    likely = [Wish(Gain(Claim("kind", "dress")), 0.85), Wish(Gain(Claim("sleeves", "long")), 0.85)]
    fitted = fit(written(shirt), wanted([asked], likely=likely, unsaid=True))
    facts = measure_facts(fitted.pattern)
    assert facts.kind == "top" and Claim("top_hem", "hip").holds(facts)
    assert Claim("sleeves", "long").holds(facts)

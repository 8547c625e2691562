"""What is asked of a garment becomes a change of what it has: its slit, its cuffs, its gathers."""

from __future__ import annotations

import pytest

from swifttailor import draft
from swifttailor.describing import measure_facts
from swifttailor.describing.change_text import read_change
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Step
from swifttailor.recutting import alter
from swifttailor.wishes.instructions.changes_of_garment import made_where_lacking, with_slits_that_are
from swifttailor.wishes.instructions.refusals import without_gathers
from swifttailor.wishes.instructions.sayings import plainly

GATHERED = measure_facts(draft("gathered-skirt"))


@pytest.mark.parametrize("said", ["skirt=straight", "skirt=a-line", "skirt gathers -"])
def test_gathers_that_are_refused_all_go(said):
    (*_, smooth) = without_gathers([read_change(said)], [Claim("skirt", "gathered")], GATHERED)
    assert isinstance(smooth, Step) and (smooth.quantity, smooth.direction) == ("skirt gathers", -1)
    assert smooth.amount >= GATHERED.skirt.gather - 1.0


@pytest.mark.parametrize("said", ["skirt gathers -", "skirt=tiered", "length +5"])
def test_less_gathers_are_less(said):
    assert without_gathers([read_change(said)], [], GATHERED) == [read_change(said)]


def test_a_slit_that_is_there_is_made_as_high_as_said():
    slit = alter(draft("fitted-skirt"), ["slit=left"]).facts
    told = with_slits_that_are([read_change("slit=left"), read_change("slit_cm=40")], slit)
    assert [c.quantity for c in told if isinstance(c, Step)] == ["left slit"]
    assert with_slits_that_are([read_change("slit_cm=40")], slit) == [read_change("slit_cm=40")]


def test_cuffs_are_what_is_tight_at_the_wrist():
    facts = measure_facts(draft("hoodie"))
    assert made_where_lacking(Step("sleeve end", -1), facts) == Step("cuff opening", -1)


@pytest.mark.parametrize(
    ("kind", "text", "plain"),
    [
        ("dress", "bring the back up to the length of the front", "level hem"),
        ("top", "merge it with pants", "turn it into a jumpsuit"),
    ],
)
def test_said_plainly(kind, text, plain):
    assert plain in plainly(text, kind)

"""A refitted garment is measured, recut and checked on the body that it names."""

from __future__ import annotations

from dataclasses import replace

import pytest

from swifttailor.body import Body, body_for
from swifttailor.describing.claims import Claim, claims_of
from swifttailor.describing.differences import Gain
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import InputError
from swifttailor.pattern import Severity
from swifttailor.pattern.drafted_for import DraftedFor
from swifttailor.pattern.drafts import draft
from swifttailor.recutting.alter import alter
from swifttailor.refitting import fit
from swifttailor.tailor.reading import checked


@pytest.fixture(scope="module")
def child():
    return body_for("children 122")


@pytest.fixture(scope="module")
def shirt(child):
    return fit(draft("t-shirt"), child)


def words(pattern, body=None):
    """What a pattern shows, without numbers."""
    return {c.name: c.value for c in claims_of(measure_facts(pattern, body)) if isinstance(c.value, str)}


def test_a_child_s_shirt_shows_what_the_adult_s_did(shirt):
    adult, same, otherwise = (
        words(draft("t-shirt")),
        words(shirt),
        words(shirt, Body.default().measurements),
    )
    told = ("kind", "top_hem", "sleeves", "neckline", "collar")
    assert {name: same.get(name) for name in told} == {name: adult.get(name) for name in told}
    assert any(otherwise.get(name) != adult.get(name) for name in told)  # on an adult it is another garment


def test_long_sleeves_end_at_the_child_s_wrists(shirt, child):
    recut = alter(shirt, [Gain(Claim("sleeves", "long"))])
    sleeve = measure_facts(recut.pattern, child.measurements).left_sleeve
    assert not recut.open and sleeve is not None
    assert sleeve.length == pytest.approx(child.measurements.arm_length, abs=6.0)
    assert sleeve.length < Body.default().measurements.arm_length - 10.0


def test_sleeves_are_sewn_on_a_child_s_top(child):
    """New panels at a child's height are not misplaced."""
    recut = alter(fit(draft("tank-top"), child), [Gain(Claim("sleeves", "long"))])
    sleeve = measure_facts(recut.pattern, child.measurements).left_sleeve
    assert not recut.open and sleeve is not None
    assert sleeve.length == pytest.approx(child.measurements.arm_length, abs=6.0)


def test_a_check_of_an_edit_knows_who_wears_it(shirt):
    bare = replace(shirt, drafted_for=None)
    assert "misplaced-panel" in {f.code for f in checked(bare, bare)}
    assert not [f for f in checked(bare, shirt) if f.severity is not Severity.INFO]


def test_a_wearer_who_cannot_be_is_said():
    nobody = DraftedFor("nobody", None, (("bust", 60.0), ("waist", 120.0)))
    with pytest.raises(InputError, match="No body has these measures together"):
        measure_facts(replace(draft("t-shirt"), drafted_for=nobody))

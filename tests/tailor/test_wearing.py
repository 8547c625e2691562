"""Garments for the body that a text or the caller names."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.body import Body, body_for
from swifttailor.pattern.drafts import draft
from swifttailor.tailor import Order, Tailor
from swifttailor.tailor.wearing import body_wanted


@pytest.fixture(scope="module")
def tailor():
    return Tailor.load()


def test_a_size_in_the_text_is_worn_and_heard_no_more(tailor):
    made = tailor.generate("a knee-length dress in size 46", edge_length=4.0)
    assert made.body is not None and made.body.name == "women EU 46"
    assert made.pattern.drafted_for == made.body.made_for
    assert made.report["fitted_to"]["measures"]["bust"] == pytest.approx(104, abs=0.5)
    assert any(note.startswith("Refitted to women EU 46") for note in made.notes)
    assert not any("size" in text for text in made.report["heard"]["cannot"])
    plain = tailor.generate("a knee-length dress", edge_length=4.0)
    assert plain.body is None and "fitted_to" not in plain.report
    assert np.ptp(made.garment.vertices[:, 0]) != np.ptp(plain.garment.vertices[:, 0])


def test_who_wears_it_is_said_by_the_order_then_the_text_then_the_pattern_then_the_tailor():
    own, usual = body_for("men 50"), body_for("children 128")
    assert body_wanted(Order("a dress in size 46", body=own), usual) is own
    assert body_wanted(Order("a dress in size 46"), usual).name == "women EU 46"
    assert body_wanted(Order("a dress"), usual) is usual
    assert body_wanted(Order("a dress"), None) is None
    assert body_wanted(Order("a dress in size 46", alter=False), None) is None
    from dataclasses import replace

    fitted = replace(draft("fitted-skirt"), drafted_for=own.made_for)
    assert body_wanted(Order("make it longer", edit=fitted), None).made_for == own.made_for


def test_patterns_for_a_body_are_sewn_on_it_as_they_are(tailor):
    body = body_for("women 46")
    fitting = Tailor(body=body, fit=True)
    once = fitting.sew(draft("fitted-skirt"), edge_length=4.0)
    again = fitting.sew(once.pattern, edge_length=4.0)
    assert "fitted_to" in once.report and "fitted_to" not in again.report
    for a, b in zip(once.pattern.panels, again.pattern.panels, strict=True):
        assert np.array_equal(a.vertices, b.vertices)
    plain = Tailor(body=body).sew(draft("fitted-skirt"), edge_length=4.0)
    assert plain.pattern == draft("fitted-skirt").canonical()


def test_a_workshop_for_another_body_shares_the_networks(tailor):
    other = tailor.worn_by(body_for("children 128"))
    assert other.garment_sewer.model is tailor.garment_sewer.model
    assert other.worn_by(None).garment_sewer.body.measurements == Body.default().measurements
    assert tailor.body is None

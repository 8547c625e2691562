"""What is true of garments, as a picture reader learns it."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.describing import Claim, claims_of, measure_facts
from swifttailor.describing.dimensions import DIMENSIONS
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.labels import PARTS, measure_labels, statement_labels, topics
from swifttailor.picture_reader.truth import FALSE, TRUE, UNCLEAR, Truth


@pytest.fixture
def shirt():
    return draft("t-shirt")


def test_labels_are_those_of_claims_and_dimensions():
    assert len(set(statement_labels())) == len(statement_labels()) > 150
    assert set(measure_labels()) == set(DIMENSIONS)
    assert len(set(topics())) == len(topics())
    assert {claim for claim, _ in statement_labels()} <= set(topics())


def test_statements_are_true_false_or_on_the_border(real_samples):
    from swifttailor.pattern import read_specification

    for sample in real_samples("repository"):
        pattern = read_specification(sample["pattern"]).pattern
        facts = measure_facts(pattern)
        truth = Truth.of(pattern, facts)
        said = {(c.name, c.value) for c in claims_of(facts)}
        for label, value in zip(statement_labels(), truth.statements, strict=True):
            assert (value == TRUE) == (label in said)
            assert (value == FALSE) == (not Claim(*label).holds(facts))
        assert set(np.unique(truth.statements)) <= {FALSE, TRUE, UNCLEAR}
        assert PARTS[truth.part] == ("upper" if facts.torso else "lower")


def test_measures_are_those_of_the_dimensions(shirt):
    facts = measure_facts(shirt)
    truth = Truth.of(shirt, facts)
    for name, value in zip(measure_labels(), truth.measures, strict=True):
        expected = DIMENSIONS[name].stated_measure(facts)
        assert np.isnan(value) if expected is None else value == pytest.approx(expected, rel=1e-5)
    assert np.isnan(truth.measures[measure_labels().index("leg length")])


def test_panels_are_told_by_name_place_and_size(real_samples):
    from swifttailor.pattern import read_specification

    for sample in real_samples("repository"):
        pattern = read_specification(sample["pattern"]).pattern
        truth = Truth.of(pattern, measure_facts(pattern))
        names = {p.name for p in pattern.panels}
        assert {PANEL_NAMES[k] for k in np.flatnonzero(truth.panels)} == names & set(PANEL_NAMES)
        assert not truth.boxes[truth.panels == 0].any()
        for panel in pattern.panels:
            box = truth.boxes[PANEL_NAMES.index(panel.name)]
            low, high = panel.bounding_box()
            np.testing.assert_allclose(box[3:], high - low, rtol=1e-5)
            corners = panel.to_world(np.array([low, high]))
            np.testing.assert_allclose(box[:3], corners.mean(axis=0), atol=1e-3)

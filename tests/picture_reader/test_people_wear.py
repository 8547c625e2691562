"""Hoods over the head are seldom in pictures of people."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.labels import PARTS, measure_labels, statement_labels
from swifttailor.picture_reader.people_wear import DRAWN, WORN, as_people_wear
from swifttailor.programs.read_parameter import ReadParameter


def odds(share):
    return share / (1 - share)


@given(st.floats(-8.0, 8.0))
def test_the_odds_of_hoods_alone_change_and_by_how_often_they_are(logit):
    labels = statement_labels()
    answers = {
        "statements": np.full((len(PARTS), len(labels)), logit),
        "has": np.full((len(PARTS), len(measure_labels())), logit),
        "panels": np.full((len(PARTS), len(PANEL_NAMES)), logit),
        "present": np.full(len(PARTS), logit),
    }
    found = as_people_wear(answers)
    ratio = odds(WORN) / odds(DRAWN)
    hood, none = labels.index(("hood", "hood")), labels.index(("hood", "none"))
    changed = np.exp(found["statements"] - logit)
    assert changed[:, hood] == pytest.approx(ratio) and changed[:, none] == pytest.approx(1 / ratio)
    assert np.delete(changed, [hood, none], axis=1) == pytest.approx(1.0)
    for name, change in zip(PANEL_NAMES, np.exp(found["panels"] - logit).T, strict=True):
        assert change == pytest.approx(ratio if "hood" in name else 1.0), name
    for name, change in zip(measure_labels(), np.exp(found["has"] - logit).T, strict=True):
        assert change == pytest.approx(ratio if name in ("hood depth", "hood height") else 1.0), name
    assert found["present"] is answers["present"]
    collar = ReadParameter("collar.component.style", (None, "Turtle", "Hood2Panels"))
    parameters = (ReadParameter("meta.wb", ("StraightWB", None)), collar)
    answers["designs"] = np.full((len(PARTS), 2, 3), logit)
    changed = np.exp(as_people_wear(answers, parameters)["designs"] - logit)
    assert changed[:, 1, 2] == pytest.approx(ratio) and (np.delete(changed.reshape(2, 6), 5, 1) == 1).all()
    assert (answers["statements"] == logit).all(), "what was given stays as it is"

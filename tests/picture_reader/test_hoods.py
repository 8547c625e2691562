"""What a look at the neck says of hoods counts in everything that is said of them."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.hoods import with_hoods_of_near
from swifttailor.picture_reader.labels import PARTS, measure_labels
from swifttailor.programs.read_parameter import ReadParameter


@given(st.floats(-8.0, 8.0), st.floats(-8.0, 8.0))
def test_what_a_near_look_says_of_hoods_counts_for_their_measures_and_designs(before, after):
    collar = ReadParameter("collar.component.style", (None, "Turtle", "Hood2Panels"))
    hoods = np.array(["hood" in name for name in PANEL_NAMES])
    whole = {
        "has": np.zeros((len(PARTS), len(measure_labels()))),
        "panels": np.where(hoods, before, 0.0) * np.ones((len(PARTS), 1)),
        "designs": np.zeros((len(PARTS), 1, 3)),
    }
    altogether = whole | {"panels": np.where(hoods, after, 0.0) * np.ones((len(PARTS), 1))}
    found = with_hoods_of_near(altogether, whole, 1, (collar,))
    measures = [name in ("hood depth", "hood height") for name in measure_labels()]
    np.testing.assert_allclose(found["has"][1], np.where(measures, after - before, 0.0), atol=1e-12)
    np.testing.assert_allclose(found["designs"][1, 0], [0.0, 0.0, after - before], atol=1e-12)
    assert not found["has"][0].any() and not found["designs"][0].any(), "of the other garment nothing is new"
    assert found["panels"] is altogether["panels"] and not whole["has"].any()
    unread = with_hoods_of_near(altogether, whole, 1)
    assert unread["designs"] is altogether["designs"]

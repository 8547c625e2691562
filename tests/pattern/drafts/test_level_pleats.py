"""Pleats that widen to the hem are as long at the sides as in the middle."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.pattern.drafts import draft


@pytest.mark.parametrize("length", [46.0, 78.0])
def test_all_folds_end_as_far_from_the_waist(length):
    pattern = draft("pleated-skirt", length=length)
    folds = []
    for panel in pattern.panels:
        if panel.name.startswith("skirt_"):
            along = np.array([panel.chord(k)[1] - panel.chord(k)[0] for k in range(len(panel.edges))])
            folds += [float(np.linalg.norm(way)) for way in along if abs(way[1]) > 0.5 * length]
    hidden = 2.0  # hidden edges begin so far below the waist, cm
    assert len(folds) > 20 and np.ptp(folds) < hidden + 0.1

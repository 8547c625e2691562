"""Lab is CIE's."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.render.lab import lab_of_hex, lab_of_linear, linear_of_lab


@pytest.mark.parametrize(
    ("rgb", "lab"),
    [
        ("#ffffff", (100, 0, 0)),
        ("#000000", (0, 0, 0)),
        ("ff0000", (53.24, 80.09, 67.20)),
        ("#0000ff", (32.30, 79.19, -107.86)),
        ("#808080", (53.59, 0, 0)),
    ],
)
def test_known_colours_are_where_cie_has_them(rgb, lab):
    assert np.allclose(lab_of_hex(rgb), lab, atol=0.02)


def test_there_and_back_nothing_changes():
    linear = np.random.default_rng(0).random((5, 7, 3)) ** 3
    assert np.allclose(linear_of_lab(lab_of_linear(linear)), linear, atol=1e-9)

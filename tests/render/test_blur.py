"""The blur is scipy's, to the last bit but for what a processor's rounding may add."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.ndimage import gaussian_filter

from swifttailor.render.blur import gaussian_blur


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@given(
    shape=st.tuples(st.integers(1, 40), st.integers(1, 40)),
    sigma=st.floats(0.1, 12.0),
    truncate=st.sampled_from([2.5, 4.0]),
    reflects=st.booleans(),
    seed=st.integers(0, 2**32 - 1),
)
def test_it_is_scipys(dtype, shape, sigma, truncate, reflects, seed):
    picture = np.random.default_rng(seed).normal(size=shape).astype(dtype)
    mode = "reflect" if reflects else "constant"
    wanted = gaussian_filter(picture, sigma, mode=mode, truncate=truncate)
    blurred = gaussian_blur(picture, sigma, truncate=truncate, reflects=reflects)
    assert blurred.dtype == dtype
    assert np.abs(blurred - wanted).max() <= 4 * np.finfo(dtype).eps * np.abs(picture).max()

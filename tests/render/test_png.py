"""PNG files hold the pixels that they are made from."""

from __future__ import annotations

import io

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from swifttailor.render.png import encode_png


@given(st.integers(1, 40), st.integers(1, 40), st.integers(0, 2**32 - 1))
def test_pillow_reads_the_same_pixels(height, width, seed):
    picture = np.random.default_rng(seed).integers(0, 256, (height, width, 3), np.uint8)
    with Image.open(io.BytesIO(encode_png(picture))) as read:
        read.verify()
    with Image.open(io.BytesIO(encode_png(picture))) as read:
        assert read.format == "PNG" and read.mode == "RGB"
        assert np.array_equal(np.asarray(read), picture)

"""Prompts in rows: all there, in order, none cut."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS
from swifttailor.training.packed_prompts import ROW, pack_prompts

PAD = -7


@given(st.lists(st.integers(1, 200), max_size=30))
def test_every_prompt_is_in_one_row_and_in_order(lengths):
    prompts = [np.arange(n) + 1000 * k for k, n in enumerate(lengths)]
    numbers = [np.full((n, NUMBERS), k + 0.5, np.float32) for k, n in enumerate(lengths)]
    packed = pack_prompts(prompts, numbers, PAD)
    assert packed.tokens.shape == packed.positions.shape
    if not prompts:
        assert packed.tokens.shape[0] == len(packed.ends) == 0
        return
    length = packed.tokens.shape[1]
    assert length == max(ROW, *lengths)
    begins = packed.ends - np.array(lengths) + 1
    assert (begins // length == packed.ends // length).all()
    assert (begins[1:] > packed.ends[:-1]).all()
    kept = np.zeros(packed.tokens.size, bool)
    rows = packed.numbers.reshape(-1, NUMBERS)
    for prompt, own, begin, end in zip(prompts, numbers, begins, packed.ends, strict=True):
        np.testing.assert_array_equal(rows[begin : end + 1], own)
        np.testing.assert_array_equal(packed.tokens.ravel()[begin : end + 1], prompt)
        np.testing.assert_array_equal(packed.positions.ravel()[begin : end + 1], np.arange(len(prompt)))
        kept[begin : end + 1] = True
    assert not rows[~kept].any()
    assert (packed.tokens.ravel()[~kept] == PAD).all() and not packed.positions.ravel()[~kept].any()
    # A row is begun only where the next prompt has no room.
    for k in range(1, len(prompts)):
        if begins[k] % length == 0:
            assert packed.ends[k - 1] % length + lengths[k] >= length

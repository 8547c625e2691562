"""Vectors of words: what they say, and files of them."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.errors import InputError
from swifttailor.wishes.word_vectors import SHIPPED, SIZE, WordVectors, quantized


def likeness(one: str, other: str) -> float:
    first, second = WordVectors.shipped().of([one, other])
    return float(first @ second / np.linalg.norm(first) / np.linalg.norm(second))


@pytest.mark.parametrize(
    ("word", "like", "unlike"),
    [("knee", "ankle", "music"), ("tight", "loose", "river"), ("skirt", "dress", "engine")],
)
def test_words_that_are_used_alike_lie_close_together(word, like, unlike):
    assert likeness(word, like) > likeness(word, unlike) + 0.2


def test_what_is_not_known_says_nothing():
    found = WordVectors.shipped().of(["glorped", "", "skirt"])
    assert found.shape == (3, SIZE) and found.dtype == np.float32
    assert not found[:2].any() and found[2].any()
    assert WordVectors.shipped().of([]).shape == (0, SIZE)


def test_they_are_rounded_to_a_hundredth_or_two_and_come_back_the_same(tmp_path):
    values = np.random.default_rng(0).normal(size=(50, SIZE))
    words = [f"word{chr(97 + k // 26)}{chr(97 + k % 26)}" for k in range(50)]
    made = quantized(words, values)
    made.save(tmp_path / "vectors.npz")
    again = WordVectors.load(tmp_path / "vectors.npz")
    assert again.numbers == made.numbers and np.array_equal(again.rows, made.rows)
    centred = values - values.mean(0)
    centred /= centred.std()
    assert np.abs(again.of(words) - np.clip(centred, -4, 4)).max() <= 0.5 * again.scale + 1e-6


@pytest.mark.parametrize("kept", [0, 100, 100_000, -1])
def test_damaged_files_are_named(tmp_path, kept):
    path = tmp_path / "vectors.npz"
    path.write_bytes(SHIPPED.read_bytes()[:kept])
    with pytest.raises(InputError, match=r"vectors\.npz"):
        WordVectors.load(path)


def test_other_arrays_and_missing_files_are_named(tmp_path):
    with pytest.raises(InputError, match=r"none\.npz"):
        WordVectors.load(tmp_path / "none.npz")
    for name, rows in (("short", np.zeros((1, SIZE), np.int8)), ("wide", np.zeros((2, 3), np.int8))):
        path = tmp_path / f"{name}.npz"
        np.savez(path, words=np.frombuffer(b"one\ntwo", np.uint8), rows=rows, scale=np.float32(0.03))
        with pytest.raises(InputError, match="2 words"):
            WordVectors.load(path)

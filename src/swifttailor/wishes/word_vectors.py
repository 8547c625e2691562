"""What words are like: vectors that lie close together for words that are used alike.

A network that has read thousands of instructions has not read most of the words that people use. Their
vectors tell it that a bosom is like a bust, and a meringue like nothing that is sewn. The vectors are GloVe's
(Pennington et al. 2014), those of the commonest English words and of words for clothes;
``scripts/make_word_vectors.py`` made the file of the package.
"""

from __future__ import annotations

import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from zipfile import BadZipFile

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import InputError

SHIPPED = Path(__file__).with_name("word_vectors.npz")
SIZE = 100
"""Numbers of a vector."""
_MAX_BYTES = 2**26


@dataclass(frozen=True, eq=False)
class WordVectors:
    """Vectors of some words."""

    numbers: dict[str, int]
    """The row of each word."""
    rows: NDArray[np.int8]
    """(words, `SIZE`)."""
    scale: float
    """What 1 in a row stands for."""

    def of(self, words: Sequence[str]) -> NDArray[np.float32]:
        """(n, `SIZE`), zeros for what is not known.

        Args:
            words: In lower case, without spaces.
        """
        found = np.zeros((len(words), SIZE), np.float32)
        for place, word in enumerate(words):
            number = self.numbers.get(word)
            if number is not None:
                found[place] = self.rows[number]
        return found * self.scale

    @staticmethod
    def shipped() -> WordVectors:
        """Those of the package."""
        return _shipped()

    @staticmethod
    def load(path: Path) -> WordVectors:
        """Opens a file that `save` has written.

        Raises:
            InputError: It is missing, damaged, or another file.
        """
        try:
            if path.stat().st_size > _MAX_BYTES:
                raise ValueError("it is too large")
            with np.load(path, allow_pickle=False) as arrays:
                words = bytes(arrays["words"]).decode().split("\n")
                rows, scale = arrays["rows"], float(arrays["scale"])
            if rows.dtype != np.int8 or rows.shape != (len(words), SIZE) or not 0 < scale < 1:
                raise ValueError(f"{len(words)} words, rows of shape {rows.shape}")
        except (OSError, ValueError, KeyError, EOFError, BadZipFile, zlib.error) as error:
            raise InputError(
                f"'{path}' holds no word vectors: {error}. Install swifttailor again, or make the file anew "
                "with scripts/make_word_vectors.py."
            ) from error
        return WordVectors({word: k for k, word in enumerate(words)}, rows, scale)

    def save(self, path: Path) -> None:
        """Writes them."""
        words = np.frombuffer("\n".join(self.numbers).encode(), np.uint8)
        np.savez_compressed(path, words=words, rows=self.rows, scale=np.float32(self.scale))


def quantized(words: Sequence[str], values: NDArray[np.floating]) -> WordVectors:
    """Vectors rounded to 8 bits, their mean taken out and their numbers one on average.

    Args:
        words: In lower case.
        values: (words, `SIZE`).
    """
    values = values - values.mean(0)
    values = values / values.std()
    # Few numbers are beyond four standard deviations.
    scale = 4.0 / 127
    rows = np.clip(np.round(values / scale), -127, 127).astype(np.int8)
    return WordVectors({word: k for k, word in enumerate(words)}, rows, scale)


@cache
def _shipped() -> WordVectors:
    return WordVectors.load(SHIPPED)

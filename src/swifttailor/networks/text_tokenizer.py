"""Text as tokens: byte-level byte pair encoding (Sennrich et al. 2016; Radford et al. 2019).

Any text has tokens, whatever its script, because the 256 bytes are tokens themselves; a word of captions is
one or two. The merges come with the package and are part of trained weights;
``scripts/train_text_tokenizer.py`` made them from captions of the training split.
"""

from __future__ import annotations

import json
import re
import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cache, cached_property
from itertools import pairwise
from pathlib import Path
from typing import Any

from swifttailor.errors import InputError

FORMAT = "swifttailor text tokens 1"
SHIPPED = Path(__file__).with_name("text_tokens.json")
BYTES = 256
LONGEST_TOKEN = 24
"""In bytes. Longer words are cut, so that the time a word takes is bounded."""
MOST_MERGES = 65_536
_REMEMBERED = 20_000
_SPACES = re.compile(r"[^\S\n]+")
_LINES = re.compile(r"\s*\n\s*")
# A word with the space before it; every digit for itself, so that numbers are read by their places.
_WORD = re.compile(r" ?[^\W\d_]+|\d| ?(?:[^\w\s]|_)+|\s")


@dataclass(frozen=True)
class EncodedText:
    """A text as tokens."""

    tokens: tuple[int, ...]
    truncated: bool
    """Whether its end was left out."""


@dataclass(frozen=True)
class TextTokenizer:
    """Merges of pairs of tokens, earliest first: merge k makes token 256 + k."""

    merges: tuple[tuple[int, int], ...]
    _known: dict[bytes, tuple[int, ...]] = field(default_factory=dict, repr=False, compare=False)

    def __post_init__(self) -> None:
        if len(self.merges) > MOST_MERGES:
            raise InputError(f"A text tokenizer has {len(self.merges)} merges; {MOST_MERGES} are accepted.")
        for k, pair in enumerate(self.merges):
            if len(pair) != 2 or not all(isinstance(t, int) and 0 <= t < BYTES + k for t in pair):
                raise InputError(f"Merge {k} of a text tokenizer is {pair}; two earlier tokens are accepted.")

    @property
    def size(self) -> int:
        """Number of tokens."""
        return BYTES + len(self.merges)

    def encode(self, text: str, limit: int) -> EncodedText:
        """The tokens of a text, in lower case and with single spaces.

        Args:
            text: Of any length and script; it takes time in proportion to `limit`, not to its length.
            limit: Tokens that are kept at most, from the beginning.
        """
        # A token is 24 bytes at most; compatibility forms and spaces may shrink a text further.
        shown = text[: 4 * LONGEST_TOKEN * (limit + 1)]
        tokens: list[int] = []
        for word in _words(normalize(shown)):
            tokens += self._word(word)
            if len(tokens) > limit:
                return EncodedText(tuple(tokens[:limit]), True)
        return EncodedText(tuple(tokens), len(shown) < len(text))

    def decode(self, tokens: Iterable[int]) -> str:
        """The normalised text of tokens; bytes that are no text become replacement characters."""
        return b"".join(self._bytes[t] for t in tokens).decode("utf-8", "replace").removeprefix(" ")

    def to_json(self) -> str:
        """As it is written into files."""
        return json.dumps({"format": FORMAT, "merges": self.merges}, separators=(",", ":")) + "\n"

    @staticmethod
    def from_json(text: str | bytes, source: str) -> TextTokenizer:
        """Reads what `to_json` wrote.

        Args:
            text: The file.
            source: Its name, for messages.

        Raises:
            InputError: It is another file, or damaged.
        """
        try:
            value: Any = json.loads(text)
            if value["format"] != FORMAT:
                raise ValueError(f"{value['format']!r} instead of '{FORMAT}'")
            return TextTokenizer(tuple((a, b) for a, b in value["merges"]))
        except (ValueError, KeyError, TypeError, RecursionError) as error:
            raise InputError(f"'{source}' holds no text tokenizer of this version: {error}.") from error

    @staticmethod
    def shipped() -> TextTokenizer:
        """The one that comes with the package."""
        return _shipped()

    @cached_property
    def _ranks(self) -> dict[tuple[int, int], int]:
        return {pair: BYTES + k for k, pair in reversed(list(enumerate(self.merges)))}

    @cached_property
    def _bytes(self) -> list[bytes]:
        spelled = [bytes([k]) for k in range(BYTES)]
        for a, b in self.merges:
            spelled.append(spelled[a] + spelled[b])
        return spelled

    def _word(self, word: bytes) -> tuple[int, ...]:
        if word not in self._known:
            if len(self._known) >= _REMEMBERED:
                self._known.clear()
            self._known[word] = tuple(merge(list(word), self._ranks))
        return self._known[word]


def normalize(text: str) -> str:
    """Lower case, compatibility forms as ordinary letters, single spaces, one line end for several."""
    text = unicodedata.normalize("NFKC", text).lower()
    return _SPACES.sub(" ", _LINES.sub("\n", text)).strip()


def words_of(text: str) -> list[bytes]:
    """The words that are encoded one by one."""
    return list(_words(normalize(text)))


def merge(tokens: list[int], ranks: dict[tuple[int, int], int]) -> list[int]:
    """Joins pairs of tokens, earliest merges first, until none is left.

    Args:
        tokens: Of one word.
        ranks: The token that each pair becomes.
    """
    while len(tokens) > 1:
        best = min(ranks.get(pair, _NEVER) for pair in pairwise(tokens))
        if best == _NEVER:
            break
        joined: list[int] = []
        k = 0
        while k < len(tokens):
            if k + 1 < len(tokens) and ranks.get((tokens[k], tokens[k + 1])) == best:
                joined.append(best)
                k += 2
            else:
                joined.append(tokens[k])
                k += 1
        tokens = joined
    return tokens


_NEVER = BYTES + MOST_MERGES


def _words(text: str) -> Iterable[bytes]:
    if not text:
        return
    for found in _WORD.finditer(" " + text):
        word = found[0].encode("utf-8", "replace")
        for start in range(0, len(word), LONGEST_TOKEN):
            yield word[start : start + LONGEST_TOKEN]


@cache
def _shipped() -> TextTokenizer:
    try:
        return TextTokenizer.from_json(SHIPPED.read_bytes(), str(SHIPPED))
    except OSError as error:
        raise InputError(
            f"Cannot read '{SHIPPED}': {error.strerror or error}. Install swifttailor again."
        ) from error

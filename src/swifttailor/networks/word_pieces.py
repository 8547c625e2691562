"""Text as word pieces, as BERT has them (Wu et al. 2016; Devlin et al. 2019): what its encoders read.

Words are lower case without accents. One that is no piece itself is the longest piece that it begins with,
then the longest that goes on (written ``##ing``), and so on.
"""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path

from swifttailor.errors import InputError
from swifttailor.networks.text_tokenizer import EncodedText

SHIPPED = Path(__file__).with_name("word_pieces.txt")
"""The commonest English pieces of BERT's 30,522; ``scripts/take_sentence_encoder_torch.py`` chose them."""
UNKNOWN = "[UNK]"
"""What has no pieces; the first of the list."""
LONGEST_WORD = 60
"""In characters; a longer one has no pieces."""
_GOES_ON = "##"
_REMEMBERED = 20_000
# BERT's words: runs of letters and digits; every other character stands for itself.
_WORD = re.compile(r"[^\W_]+|[^\w\s]|_")


@dataclass(frozen=True)
class WordPieces:
    """The pieces that are known, each a token by its place in the list."""

    pieces: tuple[str, ...]
    _known: dict[str, tuple[int, ...]] = field(default_factory=dict, repr=False, compare=False)

    def __post_init__(self) -> None:
        if not self.pieces or self.pieces[0] != UNKNOWN or len(set(self.pieces)) < len(self.pieces):
            raise InputError(
                f"A list of word pieces begins with '{self.pieces[0] if self.pieces else ''}' or has a piece "
                f"twice; accepted is one that begins with {UNKNOWN} and has each piece once."
            )

    @property
    def size(self) -> int:
        """Number of tokens."""
        return len(self.pieces)

    def encode(self, text: str, limit: int) -> EncodedText:
        """The tokens of a text.

        Args:
            text: Of any length and script; it takes time in proportion to `limit`, not to its length.
            limit: Tokens that are kept at most, from the beginning.
        """
        shown = text[: (LONGEST_WORD + 1) * (limit + 1)]
        tokens: list[int] = []
        for found in _WORD.finditer(_plain(shown)):
            tokens += self._word(found[0])
            if len(tokens) > limit:
                return EncodedText(tuple(tokens[:limit]), True)
        return EncodedText(tuple(tokens), len(shown) < len(text))

    @staticmethod
    def shipped() -> WordPieces:
        """Those that come with the package.

        Raises:
            InputError: The file is missing or damaged.
        """
        return _shipped()

    @staticmethod
    def load(path: Path) -> WordPieces:
        """Reads a list, a piece a line.

        Raises:
            InputError: It cannot be read, or is no such list.
        """
        try:
            return WordPieces(tuple(path.read_text(encoding="utf-8").split("\n")[:-1]))
        except (OSError, UnicodeDecodeError, InputError) as error:
            raise InputError(f"'{path}' holds no word pieces: {error}. Install swifttailor again.") from error

    @cached_property
    def _tokens(self) -> dict[str, int]:
        return {piece: k for k, piece in enumerate(self.pieces)}

    def _word(self, word: str) -> tuple[int, ...]:
        if word not in self._known:
            if len(self._known) >= _REMEMBERED:
                self._known.clear()
            self._known[word] = self._split(word)
        return self._known[word]

    def _split(self, word: str) -> tuple[int, ...]:
        found, start = [], 0
        while start < len(word) <= LONGEST_WORD:
            before = _GOES_ON if start else ""
            ends = (
                end for end in range(len(word), start, -1) if f"{before}{word[start:end]}" in self._tokens
            )
            end = next(ends, None)
            if end is None:
                return (0,)
            found.append(self._tokens[f"{before}{word[start:end]}"])
            start = end
        return tuple(found) or (0,)


def _plain(text: str) -> str:
    """Lower case, without accents."""
    split = unicodedata.normalize("NFKD", text.lower())
    return "".join(letter for letter in split if not unicodedata.combining(letter))


@cache
def _shipped() -> WordPieces:
    return WordPieces.load(SHIPPED)

"""How well prints are read of photographs of which they are known."""

from __future__ import annotations

import csv
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from swifttailor.data.pictures.photograph_lists import Photograph
from swifttailor.errors import InputError
from swifttailor.picture_reader.print_head import PLAIN, PRINTS
from swifttailor.picture_reader.reader import PictureReader
from swifttailor.picture_reader.seen_print import DOWN, SeenPrint

KnownPrints = Mapping[tuple[str, str], tuple[str, ...]]
"""By the name of a photograph's file, without its ending, and a part of the body: words that may be true."""


def known_prints(table: Path) -> KnownPrints:
    """Reads a list of prints.

    Args:
        table: Comma-separated, with the columns ``image``, ``part`` and ``prints``: one of `PRINTS`, or
            several with spaces between them where any of them may be meant.

    Raises:
        InputError: It cannot be read, or names another print.
    """
    try:
        rows = list(csv.DictReader(table.read_text(encoding="utf-8").splitlines()))
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"The list of prints '{table}' cannot be read: {error}.") from error
    found = {}
    for number, row in enumerate(rows, 2):
        words = tuple((row.get("prints") or "").split())
        if not words or not set(words) <= set(PRINTS):
            raise InputError(f"Line {number} of '{table}' names no print of {', '.join(PRINTS)}.")
        found[row.get("image") or "", row.get("part") or ""] = words
    return found


@dataclass
class PrintScores:
    """What was read of garments, by what they are and by what was said."""

    garments: list[tuple[tuple[str, ...], str]] = field(default_factory=list)
    """Which words may be true of each, and which was read."""

    def said(self, word: str) -> tuple[int, int]:
        """Of how many garments a print was read, and of how many of these rightly."""
        right = [word in known for known, read in self.garments if read == word]
        return len(right), sum(right)

    def there(self, word: str) -> tuple[int, int]:
        """How many garments have a print, and of how many of these it, or what may be meant, was read."""
        right = [read in known for known, read in self.garments if known[0] == word]
        return len(right), sum(right)

    def printed(self) -> tuple[int, int, int]:
        """Of how many garments any print was read, of how many rightly, and how many have one."""
        said = [read in known for known, read in self.garments if read != PLAIN]
        return len(said), sum(said), sum(known[0] != PLAIN for known, _ in self.garments)


def word_of(seen: SeenPrint | None) -> str:
    """What was read, as one of `PRINTS`."""
    if seen is None:
        return PLAIN
    if seen.kind == "stripes":
        return "down" if seen.angle == DOWN else "across"
    return seen.kind


def read_prints(
    reader: PictureReader,
    photographs: Sequence[Photograph],
    known: KnownPrints,
    done: Callable[[int], None] | None = None,
) -> PrintScores:
    """Reads photographs as pictures of users are read; a garment that is not seen is read as plain."""
    scores = PrintScores()
    for one in photographs:
        parts = {part: words for (name, part), words in known.items() if name == one.path.stem}
        if parts:
            read = {part.part: part.print for part in reader.read(one.pixels()).parts}
            scores.garments += [(words, word_of(read.get(part))) for part, words in parts.items()]
        if done is not None:
            done(1)
    return scores

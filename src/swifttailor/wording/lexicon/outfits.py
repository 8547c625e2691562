"""Names of two garments that are worn together, and the two: a suit is a blazer and trousers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from swifttailor.wording.lexicon.entries import Entry
from swifttailor.wording.lexicon.tokens import words_of
from swifttailor.wording.lexicon.vocabulary import WORDS, vocabulary
from swifttailor.wording.word_tables import read_table

TABLE = "outfits.txt"
_MARKS = ("upper", "lower", "beside")


@dataclass(frozen=True, slots=True)
class NamedOutfit:
    """What is worn where, by names of the English tables."""

    upper: str
    lower: str
    beside: tuple[str, ...] = ()
    """What may be named with it and takes no garment's place: the waistcoat of a suit."""


def named_outfit(word: str, entries: Sequence[Entry]) -> NamedOutfit | None:
    """The outfit that a word of a text names; None where it names none.

    Args:
        word: As the text has it.
        entries: That it belongs to; one of another language names what it stands for.
    """
    names = [entry.english for entry in entries if entry.english] or [word.lower()]
    for name in names:
        parts = words_of(name, "en")
        keys = [" ".join(parts)]
        keys += [" ".join(words_of(sense.word, "en")) for sense in vocabulary("en").find(parts)]
        for key in keys:
            if (found := _outfits().get(key)) is not None:
                return found
    return None


@cache
def _outfits() -> Mapping[str, NamedOutfit]:
    """The outfits of the table, by the words of the English tables."""
    found: dict[str, NamedOutfit] = {}
    for row in read_table(WORDS / TABLE):
        row.check_options(*_MARKS)
        halves = [row.options.get(half, ()) for half in ("upper", "lower")]
        if any(len(half) != 1 for half in halves) or row.claims or row.words or row.numbers:
            row.wrong("one garment for each half stands on the left, as in upper:blazer lower:trousers.")
        upper, lower = (half[0].replace("_", " ") for half in halves)
        beside = tuple([name.replace("_", " ") for name in row.options.get("beside", ())])
        for text in row.texts:
            key = " ".join(words_of(text, "en"))
            if key in found:
                row.wrong(f"'{text}' stands here twice.")
            if key not in vocabulary("en").senses:
                row.wrong(f"'{text}' is no word of the English tables.")
            found[key] = NamedOutfit(upper, lower, beside)
    return found

"""Reading wishes from texts, with onnxruntime."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.describing.differences import Change, Step, subject_of
from swifttailor.networks.model_file import GRAPH, ModelKind, open_model
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.networks.word_pieces import WordPieces
from swifttailor.wishes.labels import change_of, label_of
from swifttailor.wishes.text.clauses import clauses
from swifttailor.wishes.text.mentions import Mention, find_mentions
from swifttailor.wishes.text.phrase_book import find_phrases
from swifttailor.wishes.text.text_tokens import EXTRA_TOKENS, LONGEST_TEXT, ReadyText, Tokenizer, text_tokens
from swifttailor.wishes.text.whole_sides import is_of_one_side, speaks_of_sides

SHIPPED, SHIPPED_SPOKEN = (
    Path(__file__).with_name(name) for name in ("wish_reader.onnx", "spoken_reader.onnx")
)
INPUTS, OUTPUTS = ("tokens",), ("statements", "numbers")
_MAX_BYTES = 2**28
KIND = ModelKind("wish reader", "swifttailor wish-reader 1", _MAX_BYTES, ({GRAPH: (INPUTS, OUTPUTS)},))
SPOKEN_KIND = ModelKind(
    "reader of people's own words",
    "swifttailor spoken-reader 2",
    _MAX_BYTES,
    ({GRAPH: (INPUTS, OUTPUTS)},),
)
LEAST_CERTAINTY = 0.5
SURE = 0.9
"""What is read with less certainty is as likely a misunderstanding."""
MOST_CLAUSES = 16
"""That are read alone; nobody asks for more, and time is bounded."""
KNOWN_CERTAINTY = 0.99
"""Of a phrase that stands in the text as it is known."""


@dataclass(frozen=True)
class Wish:
    """Something that a text asks for."""

    change: Change
    """A description asks for what is to be true (`Gain`), an instruction for what is to become so as well."""
    certainty: float
    """How sure the reader is, 0 to 1."""


@dataclass(frozen=True, eq=False)
class WishReader:
    """Reads what texts ask for."""

    session: Any
    """Of onnxruntime."""
    statements: tuple[str, ...]
    """Labels of what a text says."""
    numbers: tuple[str, ...]
    """Labels of what a number is."""
    tokenizer: Tokenizer
    card: dict[str, Any]
    """What it was trained on and how good it is."""
    own_words: Path | None = None
    """The file of the network that has learnt from people's own words (`whole`); None for none."""

    @staticmethod
    def load(weights: Path | str | None = None, *, threads: int = 1) -> WishReader:
        """Opens a model file; what is said in people's own words is read by the package's network for them.

        Args:
            weights: File; the one that comes with the package when None.
            threads: CPU cores for the network.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        return _opened(SHIPPED if weights is None else weights, KIND, threads, SHIPPED_SPOKEN)

    @staticmethod
    def load_spoken(weights: Path | str = SHIPPED_SPOKEN, *, threads: int = 1) -> WishReader:
        """Opens the model file of a network that has learnt from people's own words.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        return _opened(weights, SPOKEN_KIND, threads, None)

    @cached_property
    def spoken(self) -> WishReader | None:
        """The network that has learnt from people's own words, opened when it is first needed.

        Raises:
            InputError: Its file is damaged.
        """
        return None if self.own_words is None else WishReader.load_spoken(self.own_words)

    @cached_property
    def said(self) -> tuple[tuple[Change, bool], ...]:
        """What a text may say by `statements`, and whether it makes the sides of a garment differ."""
        changes = [change_of(label) for label in self.statements]
        return tuple([(change, is_of_one_side(change)) for change in changes])

    def read(self, text: str, *, instruction: bool = False) -> tuple[Wish, ...]:
        """What a text asks for, surest first.

        An instruction of several clauses is read as a whole, and what is sure is kept. What else it asks for,
        its clauses say more reliably when they are read alone.

        Args:
            text: In any script; what is not understood says nothing.
            instruction: Whether it says how to change a garment, and not what garment it is.
        """
        whole = self._read(text, instruction)
        parts = clauses(text[:LONGEST_TEXT])[:MOST_CLAUSES] if instruction else []
        if len(parts) < 2:
            return whole
        sure = [wish for wish in whole if wish.certainty >= SURE]
        spoken = {subject_of(wish.change) for wish in sure if not _lacks_amount(wish.change)}
        found = {wish.change: wish for wish in sure}
        for wish in (wish for start, end in parts for wish in self._read(text[start:end], instruction)):
            before = found.get(wish.change)
            if subject_of(wish.change) not in spoken and (
                before is None or before.certainty < wish.certainty
            ):
                found[wish.change] = wish
        for change in [c for c in found if isinstance(c, Step) and c.amount is not None]:
            found.pop(change_of(label_of(change)), None)
        return tuple(sorted(found.values(), key=lambda wish: -wish.certainty))

    def whole(self, text: str, *, instruction: bool = True) -> dict[Change, float]:
        """How likely it is of every wish that a text, read as one, asks for it; with its amount.

        Args:
            text: In English.
            instruction: Whether it says how to change a garment, and not what garment it is.

        Returns:
            By wish. That sides differ is among them only where the text speaks of sides; nothing is where
            there is no network for people's own words.
        """
        reader = self.spoken
        if reader is None:
            return {}
        ready = text_tokens(text, reader.tokenizer, instruction=instruction)
        if len(ready.tokens) < 2:
            return {}
        said, numbers = reader._run(ready)
        certain = (1 / (1 + np.exp(-said[0].astype(float)))).tolist()
        sides = speaks_of_sides(text)
        found = {c: p for (c, of_one), p in zip(reader.said, certain, strict=True) if sides or not of_one}
        for _, change, certainty in _measured(ready, numbers[0], reader.numbers):
            if not sides and is_of_one_side(change):
                continue
            bare = change_of(label_of(change)) if isinstance(change, Step) else None
            if bare in found:  # once: another number for the same measure is another matter
                found[change] = max(found.pop(bare), certainty)
        return found

    def _run(self, ready: ReadyText) -> Any:
        return self.session.run(None, {"tokens": ready.tokens[None]})

    def _read(self, text: str, instruction: bool) -> tuple[Wish, ...]:
        ready = text_tokens(text, self.tokenizer, instruction=instruction)
        if len(ready.tokens) < 2:
            return ()
        said, numbers = self._run(ready)
        phrases = find_phrases(text[:LONGEST_TEXT], find_mentions(text[:LONGEST_TEXT])) if instruction else []
        found = dict(_stated(said[0], self.statements))
        for mention, change, certainty in _measured(ready, numbers[0], self.numbers):
            if any(p.start <= mention.start < p.end for p in phrases):
                continue
            if isinstance(change, Step):
                found.pop(change_of(label_of(change)), None)
            found[change] = certainty
        for change in (change for phrase in phrases for change in phrase.changes):
            if isinstance(change, Step) and change.amount is not None:
                found.pop(change_of(label_of(change)), None)
            found[change] = KNOWN_CERTAINTY
        kept = [Wish(c, p) for c, p in found.items() if instruction or not isinstance(c, Step)]
        return tuple(sorted(kept, key=lambda wish: -wish.certainty))


def _opened(path: Path | str, kind: ModelKind, threads: int, own_words: Path | None) -> WishReader:
    model = open_model(path, kind, threads=threads)
    tokenizer = WordPieces.shipped() if kind is SPOKEN_KIND else TextTokenizer.shipped()
    with model.says("what it reads"):
        statements, numbers = tuple(model.about["statements"]), tuple(model.about["numbers"])
        for label in statements:
            change_of(label)
        for label in numbers:
            change_of(label, 1.0)
    model.require({"the tokens that it reads": (model.about.get("tokens"), tokenizer.size + EXTRA_TOKENS)})
    return WishReader(
        model.sessions[GRAPH], statements, numbers, tokenizer, model.about.get("card", {}), own_words
    )


def _lacks_amount(change: Change) -> bool:
    return isinstance(change, Step) and change.amount is None


def _stated(logits: Any, labels: tuple[str, ...]) -> list[tuple[Change, float]]:
    certain = 1 / (1 + np.exp(-logits.astype(float)))
    return [(change_of(labels[k]), float(certain[k])) for k in np.flatnonzero(certain >= LEAST_CERTAINTY)]


def _measured(ready: ReadyText, logits: Any, labels: tuple[str, ...]) -> list[tuple[Mention, Change, float]]:
    found = []
    for mention, place in zip(ready.mentions, ready.places, strict=True):
        odds = np.exp(logits[place] - logits[place].max())
        best = int(odds.argmax())
        if best and mention.value > 0:
            change = change_of(labels[best - 1], round(mention.value, 2))
            found.append((mention, change, float(odds[best] / odds.sum())))
    return found

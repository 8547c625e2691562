"""Texts and what they ask for, written freshly for every sample of the wish reader's training."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.training.maker_bank import PatternBank, Version
from swifttailor.training.misspelling import misspell
from swifttailor.training.spoken_texts import SpokenText
from swifttailor.training.wish_words import FILLERS, say_nothing, say_otherwise
from swifttailor.wishes.labels import label_of, number_labels, statement_labels
from swifttailor.wishes.text.mentions import Mention
from swifttailor.wishes.text.text_tokens import ReadyText, Tokenizer, text_tokens
from swifttailor.wording.captions import write_caption
from swifttailor.wording.instructions.writer import write_instruction

UNKNOWN = -1
"""What a number is that could be several things."""
_SAME_CM = 0.03
_NOTHING, _INSTRUCTIONS, _OF_STRANGERS, _BARE, _WITH_FILLERS, _OTHERWISE = 0.05, 0.5, 0.4, 0.2, 0.25, 0.4
_STRANGERS = 8
_LARGEST_SEED = 2**31
_TWO_SPOKEN, _SHORTENED, _LEFT_OUT = 0.25, 0.3, 0.1
"""Shares of the texts in people's own words: two instructions said in one breath, and those in which words
are missing; and of their words those that are."""
_FEW_WORDS = 4
"""Of which none can be missing."""
_BETWEEN = (". ", ", ", " and ", ", and ", "; ", " also ", ". oh and ", " plus ", "\n")
_GAP = re.compile(r"(?<=[a-z,]) (?=[a-z])")


@dataclass(frozen=True, eq=False)
class WishSample:
    """A text, and what is to be read of it."""

    ready: ReadyText
    said: NDArray[np.int64]
    """Numbers of the labels of what it says."""
    counts: tuple[int, ...]
    """Of each mention: 0 for nothing, 1 + the number of its label, `UNKNOWN`."""
    text: str
    changes: tuple[Change, ...]
    instruction: bool


class WishSamples:
    """Samples of the patterns of a bank, each determined by its number."""

    def __init__(
        self,
        bank: PatternBank,
        tokenizer: Tokenizer,
        *,
        seed: int,
        typos: float,
        spoken: Sequence[SpokenText] = (),
        own_words: float = 0.6,
    ) -> None:
        """Prepares to write.

        Args:
            bank: Patterns and edited versions of them, with their facts.
            tokenizer: Of the texts.
            seed: Of all samples.
            typos: Share of the words with a typing error.
            spoken: Texts in people's own words, to show among those that are written of the patterns.
            own_words: Their share.
        """
        self.bank, self.tokenizer, self.seed, self.typos = bank, tokenizer, seed, typos
        self.spoken, self.own_words = tuple(spoken), own_words
        self._of_kind: dict[str | None, list[SpokenText]] = {}
        for one in self.spoken:
            self._of_kind.setdefault(one.kind, []).append(one)
        described = self._of_kind.get(None, [])
        self._spoken_of = {False: described, True: [one for one in self.spoken if one.kind is not None]}
        self._said = {label: k for k, label in enumerate(statement_labels())}
        self._counts = {label: k for k, label in enumerate(number_labels())}

    def make(self, number: int) -> WishSample:
        """Sample `number` of an endless training."""
        chance = np.random.default_rng([self.seed, number])
        while True:
            instruction = bool(chance.random() < _INSTRUCTIONS)
            if chance.random() < _NOTHING:
                return self.sample(say_nothing(chance), (), instruction=instruction)
            if self._spoken_of[instruction] and chance.random() < self.own_words:
                written = self._spoken(chance, instruction=instruction)
            else:
                written = self._instruction(chance) if instruction else self._caption(chance)
            if written is not None:
                return self.sample(*written, instruction=instruction, chance=chance)

    def sample(
        self,
        text: str,
        changes: Sequence[Change],
        *,
        instruction: bool,
        chance: np.random.Generator | None = None,
    ) -> WishSample:
        """The sample of a text.

        Args:
            text: As it was written.
            changes: What it asks for.
            instruction: Whether it says how to change a garment.
            chance: Decides typing errors and words that say nothing; without any when None.
        """
        if chance is not None:
            if instruction and chance.random() < _OTHERWISE:
                text = say_otherwise(text, chance)
            text = _as_people_write(text, chance, self.typos)
        ready = text_tokens(text, self.tokenizer, instruction=instruction)
        said = sorted({self._said[name] for c in changes if (name := label_of(c)) in self._said})
        counts = tuple(self._count(m, changes) for m in ready.mentions)
        return WishSample(ready, np.array(said, np.int64), counts, text, tuple(changes), instruction)

    def _count(self, mention: Mention, changes: Sequence[Change]) -> int:
        numbered = {label_of(c): n for c in changes if (n := _number(c)) is not None}
        fitting = [label for label, n in numbered.items() if abs(n - mention.value) < _SAME_CM]
        if len(fitting) > 1:
            return UNKNOWN
        return 1 + self._counts[fitting[0]] if fitting else 0

    def _caption(self, chance: np.random.Generator) -> tuple[str, tuple[Change, ...]]:
        caption = write_caption(self._version(chance).facts, int(chance.integers(_LARGEST_SEED)))
        return caption.text, tuple(Gain(c) for c in caption.claims)

    def _spoken(self, chance: np.random.Generator, *, instruction: bool) -> tuple[str, tuple[Change, ...]]:
        some = self._spoken_of[instruction]
        first = some[int(chance.integers(len(some)))]
        if not instruction or chance.random() >= _TWO_SPOKEN:
            words = first.text.split(" ")
            if chance.random() < _SHORTENED and len(words) > _FEW_WORDS:
                words = [word for word in words if chance.random() >= _LEFT_OUT]
            return " ".join(words), first.changes
        others = self._of_kind[first.kind]
        second = others[int(chance.integers(len(others)))]
        between = _BETWEEN[int(chance.integers(len(_BETWEEN)))]
        changes = tuple(dict.fromkeys([*first.changes, *second.changes]))
        return f"{first.text.rstrip('.!? ')}{between}{second.text}", changes

    def _instruction(self, chance: np.random.Generator) -> tuple[str, tuple[Change, ...]] | None:
        garment = self.bank.garments[int(chance.integers(len(self.bank)))]
        versions = [garment.pattern, *garment.edits]
        if len(versions) < 2 or chance.random() < _OF_STRANGERS:
            first = self._version(chance)
            others = [self._version(chance) for _ in range(_STRANGERS)]
            second = next((v for v in others if v.facts.kind == first.facts.kind), others[0])
        else:
            first, second = (versions[k] for k in chance.permutation(len(versions))[:2])
        written = write_instruction(first.facts, second.facts, int(chance.integers(_LARGEST_SEED)))
        return None if written is None else (written.text, written.changes)

    def _version(self, chance: np.random.Generator) -> Version:
        garment = self.bank.garments[int(chance.integers(len(self.bank)))]
        versions = (garment.pattern, *garment.edits)
        return versions[int(chance.integers(len(versions)))]


def _number(change: Change) -> float | None:
    if isinstance(change, Step):
        return change.amount
    return None if isinstance(change.claim.value, str) else change.claim.value


def _as_people_write(text: str, chance: np.random.Generator, typos: float) -> str:
    """Now and then without hyphens and punctuation, with words between that say nothing of the cut."""
    if chance.random() < _BARE:
        text = text.replace("-", " ").rstrip(".?!")
    if chance.random() < _WITH_FILLERS:
        gaps = [found.start() for found in _GAP.finditer(text)]
        for place in sorted(chance.permutation(gaps)[: int(chance.integers(1, 4))], reverse=True):
            text = f"{text[:place]} {FILLERS[int(chance.integers(len(FILLERS)))]}{text[place:]}"
    return misspell(text, chance, typos)

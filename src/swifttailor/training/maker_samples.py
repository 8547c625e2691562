"""What a PatternMaker is asked and should answer: one sample of any task, written freshly every time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from swifttailor.data.renders.files import SplitRenders
from swifttailor.pattern_maker.asking.pictures import picture_for_network
from swifttailor.pattern_maker.asking.prompt import make_prompt, pattern_part
from swifttailor.pattern_maker.tokens.name_text import NameText, SpelledPattern
from swifttailor.pattern_maker.tokens.token_sequence import NUMBER_MASK, TokenSequence, padded_mask
from swifttailor.pattern_maker.tokens.vocabulary import STITCH_TAGS, STITCH_TOKENS
from swifttailor.training.maker_bank import PatternBank, Version
from swifttailor.training.maker_config import MakerConfig
from swifttailor.training.misspelling import misspell
from swifttailor.training.picture_variation import vary_picture
from swifttailor.wording.captions import write_caption
from swifttailor.wording.instructions.writer import write_instruction

TaskName = Literal["text", "image", "text_image", "edit"]
TASKS: tuple[TaskName, ...] = ("text", "image", "text_image", "edit")
TextTokens = Callable[[str], tuple[int, ...]]
_TYPICAL_TEXT = 20
_BRIEF = 0.35
"""Tokens of the outlines of a pattern, of all of them."""
_LARGEST_SEED = 2**31


@dataclass(frozen=True, eq=False)
class Plan:
    """What a sample will be; its parts are made from it."""

    task: TaskName
    garment: int
    version: Version
    """What is to be written."""
    before: Version | None
    """What is to be edited."""
    seed: tuple[int, ...]
    length: int
    """About how many tokens it has."""


@dataclass(frozen=True, eq=False)
class MakerSample:
    """A prompt and its answer."""

    task: TaskName
    tokens: NDArray[np.int64]
    """(n,) ids of the whole vocabulary, the answer at the end."""
    numbers: NDArray[np.float32]
    """(n, 8) as the network reads them."""
    answer: TokenSequence
    """With the numbers that it should write."""
    picture: NDArray[np.float32] | None
    """(3, size, size)."""
    before: TokenSequence | None = None
    """What is edited."""
    spelled: SpelledPattern | None = None
    """The answer, where its names are written as text."""

    @property
    def outputs(self) -> NDArray[np.integer]:
        """(m,) what the network should choose."""
        return self.answer.tokens if self.spelled is None else self.spelled.outputs

    @property
    def output_numbers(self) -> NDArray[np.float32]:
        """(m, 8) and the numbers that it should write."""
        return self.answer.numbers if self.spelled is None else self.spelled.numbers

    @property
    def prompt(self) -> NDArray[np.int64]:
        """The tokens before the answer."""
        return self.tokens[: len(self.tokens) - len(self.outputs)]


class MakerSamples:
    """Samples of the patterns of a bank, each determined by its task, pattern and seed alone."""

    def __init__(
        self,
        bank: PatternBank,
        renders: Sequence[SplitRenders],
        config: MakerConfig,
        text_tokens: TextTokens,
        text_size: int,
        names: NameText | None = None,
    ) -> None:
        """Prepares to make samples.

        Args:
            bank: The patterns.
            renders: Pictures of some of them, found by id; one garment may be in several.
            config: Of the training.
            text_tokens: The tokens of a text, as many as are read.
            text_size: Tokens of text that there are.
            names: Of a network that writes names as text.
        """
        self.bank, self.renders, self.config = bank, renders, config
        self.text_tokens, self.text_size, self.names = text_tokens, text_size, names

    @cached_property
    def _pictured(self) -> dict[str, list[tuple[SplitRenders, int]]]:
        """Where there are pictures of each garment."""
        found: dict[str, list[tuple[SplitRenders, int]]] = {}
        for renders in self.renders:
            for k, id in enumerate(renders.reader.ids):
                found.setdefault(id, []).append((renders, k))
        return found

    def tasks_of(self, garment: int) -> list[TaskName]:
        """The tasks that there are data for."""
        one = self.bank.garments[garment]
        pictured = one.id in self._pictured
        return [t for t in TASKS if t == "text" or (one.edits if t == "edit" else pictured)]

    def plan(self, place: int) -> Plan:
        """Sample number `place` of an endless training: every garment once, then again in another order."""
        epoch, number = divmod(place, len(self.bank))
        garment = int(self._order(epoch)[number])
        chance = np.random.default_rng([self.config.seed, 3, place])
        tasks = self.tasks_of(garment)
        weights = np.array([getattr(self.config.tasks, task) for task in tasks])
        if not weights.sum():
            tasks, weights = list(TASKS[:1]), np.ones(1)
        task = tasks[int(chance.choice(len(tasks), p=weights / weights.sum()))]
        return self.plan_task(garment, task, chance, versions=True)

    def plan_read(self, place: int) -> Plan | None:
        """Prompt number `place` of those that are only read; None where all that can be asked is editing.

        Edits are read where they are told briefly; whole patterns are too long to be read by the dozen.
        """
        chance = np.random.default_rng([self.config.seed, 7, place])
        garment = int(chance.integers(len(self.bank)))
        brief = self.config.network.edits == "outlines"
        tasks = [task for task in self.tasks_of(garment) if brief or task != "edit"]
        weights = np.array([getattr(self.config.tasks, task) for task in tasks])
        if not weights.sum():
            return None
        task = tasks[int(chance.choice(len(tasks), p=weights / weights.sum()))]
        return self.plan_task(garment, task, chance, versions=True)

    def plan_task(
        self, garment: int, task: TaskName, chance: np.random.Generator, *, versions: bool = False
    ) -> Plan:
        """A sample of a garment and a task; its seed is drawn.

        Args:
            garment: Its number in the bank.
            task: One of `tasks_of`.
            chance: Decides what the task leaves open.
            versions: Whether a text may also describe an edited version: a pattern more to read about.
        """
        one = self.bank.garments[garment]
        version, before = one.pattern, None
        if task == "text" and versions:
            version = (version, *one.edits)[int(chance.integers(1 + len(one.edits)))]
        if task == "edit":
            edited = one.edits[int(chance.integers(len(one.edits)))]
            version, before = (edited, one.pattern) if chance.random() < 0.5 else (one.pattern, edited)
        seed = tuple(chance.integers(_LARGEST_SEED, size=2).tolist())
        share = _BRIEF if self.config.network.edits == "outlines" else 1
        told = 0 if before is None else share * len(before.sequence)
        length = len(version.sequence) + int(told) + _TYPICAL_TEXT
        length += self.config.network.image_tokens if "image" in task else 0
        return Plan(task, garment, version, before, seed, length)

    def make(self, plan: Plan, *, clean: bool = False) -> MakerSample:
        """Writes the sample of a plan.

        Args:
            plan: From `plan` or `plan_task`.
            clean: Without typing errors and noise.
        """
        chance = np.random.default_rng(plan.seed)
        version, before = plan.version, plan.before
        text, picture, task = "", None, plan.task
        if before is not None:
            asked = self._instruction(before, version, plan.seed[0])
            if asked is None:  # there are words for the way back only
                version, before = before, version
                asked = self._instruction(before, version, plan.seed[0])
            if asked is None:
                before, task = None, "text"
            else:
                text = asked
        if task in ("text", "text_image"):
            text = write_caption(version.facts, plan.seed[0]).text
        if task in ("image", "text_image"):
            strength = 0.0 if clean else self.config.picture_variation
            picture = self._picture(self.bank.garments[plan.garment].id, chance, strength)
        if not clean:
            text = misspell(text, chance, self.config.typos)
        answer = self._tagged(version.sequence, chance)
        edit = None if before is None else self._tagged(before.sequence, chance)
        prompt = make_prompt(
            self.text_tokens(text),
            self.text_size,
            image_tokens=0 if picture is None else self.config.network.image_tokens,
            edit=edit,
            brief=self.config.network.edits == "outlines",
            names=self.names,
        )
        written = pattern_part(answer, self.text_size, self.names)
        spelled = None if self.names is None else self.names.spell(answer)
        numbers = written.numbers
        if self.config.number_noise and not clean:
            noise = chance.normal(scale=self.config.number_noise, size=numbers.shape)
            mask = NUMBER_MASK[answer.tokens]
            if self.names is not None and spelled is not None:
                mask = padded_mask(self.names.outputs)[spelled.outputs]
            numbers = numbers + noise.astype(np.float32) * mask
        tokens = np.concatenate([prompt.tokens, written.tokens])
        numbers = np.concatenate([prompt.numbers, numbers])
        return MakerSample(task, tokens, numbers, answer, picture, edit, spelled)

    def _order(self, epoch: int) -> NDArray[Any]:
        if getattr(self, "_epoch", None) != epoch:
            self._epoch = epoch
            self._numbers = np.random.default_rng([self.config.seed, 4, epoch]).permutation(len(self.bank))
        return self._numbers

    def _instruction(self, before: Version, after: Version, seed: int) -> str | None:
        instruction = write_instruction(before.facts, after.facts, seed)
        return None if instruction is None else instruction.text

    def _picture(self, id: str, chance: np.random.Generator, variation: float) -> NDArray[np.float32]:
        places = self._pictured[id]
        renders, number = places[int(chance.integers(len(places)))]
        pictures = renders[number]
        chosen = pictures[int(chance.integers(len(pictures)))]
        pixels = vary_picture(chosen.pixels(), chance, variation)
        return picture_for_network(pixels, self.config.network.image_size)

    def _tagged(self, sequence: TokenSequence, chance: np.random.Generator) -> TokenSequence:
        """The sequence with its stitch tags renamed, where tags are to mean nothing."""
        if self.config.tags == "ascending":
            return sequence
        renamed = np.arange(STITCH_TOKENS.stop)
        renamed[STITCH_TOKENS.start :] = STITCH_TOKENS.start + chance.permutation(STITCH_TAGS)
        tokens = sequence.tokens
        of_stitch = (tokens >= STITCH_TOKENS.start) & (tokens < STITCH_TOKENS.stop)
        return TokenSequence(
            np.where(of_stitch, renamed[np.where(of_stitch, tokens, 0)], tokens), sequence.numbers
        )

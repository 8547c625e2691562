"""From samples to the tensors of one optimiser step."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from swifttailor.pattern_maker.counterpart import NONE, counterparts
from swifttailor.pattern_maker.foresight import foresight_of
from swifttailor.pattern_maker.network_torch import PatternMakerNetwork
from swifttailor.pattern_maker.plan import PatternPlan
from swifttailor.pattern_maker.prompt import PAD
from swifttailor.pattern_maker.token_sequence import TokenSequence
from swifttailor.pattern_maker.vocabulary import NUMBERS
from swifttailor.training.compilation_torch import not_compiled
from swifttailor.training.maker_samples import MakerSample, MakerSamples, Plan
from swifttailor.training.packed_prompts import pack_prompts

WINDOW = 24
"""Batches that are planned together: samples of like length go into the same one."""


@dataclass(frozen=True, eq=False)
class Unplanned:
    """An answer whose counterparts hang on what the network foresees."""

    row: int
    prompt: int
    """Tokens before it."""
    answer: TokenSequence


@dataclass(frozen=True, eq=False)
class Batch:
    """What a network is given, and what it should have answered."""

    tokens: Tensor
    """(B, L) ids of the whole vocabulary, padded at the end."""
    numbers: Tensor
    """(B, L, 8)."""
    pictures: Tensor
    """(P, 3, size, size), of the samples that have one."""
    answers: Tensor
    """(n,) places in (B * L) before a token of an answer."""
    next_tokens: Tensor
    """(n,) that token, of a pattern."""
    next_numbers: Tensor
    """(n, 8) its numbers."""
    firsts: Tensor
    """(B,) places in (B * L) of the last token of each prompt."""
    read: Tensor
    """(M, T) ids of R prompts that are only read, several in a row (`PackedPrompts`)."""
    read_positions: Tensor
    """(M, T) of each in its prompt."""
    read_ends: Tensor
    """(R,) places in (M * T) of their last tokens."""
    read_pictures: Tensor
    """(Q, 3, size, size), of these prompts."""
    present: Tensor
    """(B + R, tokens of patterns) 1 for those that the answer has."""
    panel_numbers: Tensor
    """(B + R, panels, numbers of `foresight`)."""
    panels_known: Tensor
    """The same shape: which of them mean something."""
    copied: Tensor
    """(B, L) counterpart of the token after each place; negative where it has none."""
    copied_numbers: Tensor
    """(B, L, 8)."""
    planned: Tensor
    """(B, L) whether it is foreseen and not repeated."""
    unplanned: tuple[Unplanned, ...]
    """Answers that `with_plans` has still to add the counterparts of."""

    @property
    def given(self) -> tuple[Tensor, ...]:
        """What the network is called with."""
        written = (self.tokens, self.numbers, self.pictures, self.answers, self.next_tokens, self.firsts)
        read = (self.read, self.read_positions, self.read_ends, self.read_pictures)
        return (*written, *read, self.copied, self.copied_numbers, self.planned)

    def to(self, device: torch.device) -> Batch:
        """The same on a device."""
        tensors = {k: v.to(device) for k, v in vars(self).items() if isinstance(v, Tensor)}
        return replace(self, **tensors)


class TrainingBatches:
    """The batches of a training, each determined by its number alone: no state to save or restore."""

    def __init__(self, samples: MakerSamples, *, part: int = 0, parts: int = 1) -> None:
        self.samples, self.part, self.parts = samples, part, parts
        self._window = -1
        self._planned: list[list[Plan]] = []

    def __getitem__(self, step: int) -> Batch:
        """This process's share of the batch of an optimiser step, from 0."""
        config = self.samples.config
        plans = self.plans(step)[self.part :: self.parts]
        count = config.batch_size * config.reads
        reads = [
            self.samples.plan_read(k) for k in range(step * count + self.part, (step + 1) * count, self.parts)
        ]
        return assemble(
            [self.samples.make(plan) for plan in plans],
            config.network.image_size,
            [self.samples.make(plan) for plan in reads if plan is not None],
            planning=config.network.planning,
        )

    def plans(self, step: int) -> list[Plan]:
        """The samples of the whole batch."""
        window, number = divmod(step, WINDOW)
        if window != self._window:
            size = self.samples.config.batch_size
            places = range(window * WINDOW * size, (window + 1) * WINDOW * size)
            plans = sorted((self.samples.plan(place) for place in places), key=lambda plan: plan.length)
            order = np.random.default_rng([self.samples.config.seed, 5, window]).permutation(WINDOW)
            self._planned = [plans[k * size : (k + 1) * size] for k in order.tolist()]
            self._window = window
        return self._planned[number]

    def from_step(self, step: int, *, workers: int = 0) -> Iterator[Batch]:
        """The batches from a step on, made ahead by so many processes; 0 makes them when asked."""
        if not workers:
            while True:
                yield self[step]
                step += 1
        yield from torch.utils.data.DataLoader(
            _Steps(self), batch_size=None, sampler=_CountFrom(step), num_workers=workers, prefetch_factor=4
        )


class _Steps(torch.utils.data.Dataset):
    def __init__(self, batches: TrainingBatches) -> None:
        self.batches = batches

    def __getitem__(self, step: int) -> Batch:
        return self.batches[step]


class _CountFrom(torch.utils.data.Sampler):
    def __init__(self, first: int) -> None:
        self.first = first

    def __iter__(self) -> Iterator[int]:
        step = self.first
        while True:
            yield step
            step += 1


def assemble(
    samples: Sequence[MakerSample],
    image_size: int,
    reads: Sequence[MakerSample] = (),
    *,
    planning: bool = False,
) -> Batch:
    """Puts samples side by side, padded to the longest, and the prompts of others in rows.

    Args:
        samples: To write.
        image_size: Pixels along each side of a picture.
        reads: To read the prompts of.
        planning: Whether `with_plans` is to follow.
    """
    length = max(len(s.tokens) for s in samples)
    some: Any = samples[0]
    pad = int(some.tokens[-1]) - int(some.answer.tokens[-1]) + PAD  # text tokens come before
    tokens = np.full((len(samples), length), pad, np.int64)
    numbers = np.zeros((len(samples), length, NUMBERS), np.float32)
    copied = np.full((len(samples), length), NONE, np.int64)
    copied_numbers = np.zeros_like(numbers)
    answers: list[NDArray[np.int64]] = []
    unplanned: list[Unplanned] = []
    for row, sample in enumerate(samples):
        size = len(sample.tokens)
        tokens[row, :size], numbers[row, :size] = sample.tokens, sample.numbers
        # Each token is predicted from the state before it.
        places = np.arange(size - len(sample.answer), size) - 1
        answers.append(row * length + places)
        if planning and sample.before is None:
            unplanned.append(Unplanned(row, size - len(sample.answer), sample.answer))
            continue
        for place, own in zip(places, counterparts(sample.before, sample.answer), strict=True):
            copied[row, place], copied_numbers[row, place] = own.token, own.numbers
    read = pack_prompts([s.prompt for s in reads], pad)
    foresight = [foresight_of(s.answer) for s in (*samples, *reads)]
    return Batch(
        torch.from_numpy(tokens),
        torch.from_numpy(numbers),
        _pictures(samples, image_size),
        torch.from_numpy(np.concatenate(answers)),
        torch.from_numpy(np.concatenate([s.answer.tokens for s in samples]).astype(np.int64)),
        torch.from_numpy(np.concatenate([s.answer.numbers for s in samples])),
        torch.from_numpy(np.array([places[0] for places in answers])),
        torch.from_numpy(read.tokens),
        torch.from_numpy(read.positions),
        torch.from_numpy(read.ends),
        _pictures(reads, image_size),
        torch.from_numpy(np.stack([f.present for f in foresight])),
        torch.from_numpy(np.stack([f.numbers for f in foresight])),
        torch.from_numpy(np.stack([f.known for f in foresight])),
        torch.from_numpy(copied),
        torch.from_numpy(copied_numbers),
        torch.zeros(copied.shape, dtype=torch.bool),
        tuple(unplanned),
    )


@torch.no_grad()
def with_plans(batch: Batch, network: PatternMakerNetwork) -> Batch:
    """The same with the counterparts of answers for which the network, as it is now, foresees something."""
    if not batch.unplanned:
        return batch
    given = batch.tokens.cpu().numpy()
    packed = pack_prompts([given[u.row, : u.prompt] for u in batch.unplanned], network.text_size + PAD)
    device = batch.tokens.device
    places = [torch.from_numpy(a).to(device) for a in (packed.tokens, packed.positions, packed.ends)]
    was_training = network.training
    network.eval()  # as it is when it answers
    with not_compiled():  # a dozen short prompts
        foreseen = network.foresee(*places, batch.pictures).float().cpu().numpy()
    network.train(was_training)
    copied, planned = batch.copied.cpu().numpy().copy(), batch.planned.cpu().numpy().copy()
    numbers = batch.copied_numbers.cpu().numpy().copy()
    for one, row in zip(batch.unplanned, foreseen, strict=True):
        for k, own in enumerate(counterparts(None, one.answer, PatternPlan.from_foresight(row))):
            place = one.row, one.prompt + k - 1  # each token is predicted from the state before it
            copied[place], numbers[place], planned[place] = own.token, own.numbers, own.planned
    arrays = {"copied": copied, "copied_numbers": numbers, "planned": planned}
    made = {name: torch.from_numpy(a).to(device) for name, a in arrays.items()}
    return replace(batch, unplanned=(), **made)


def _pictures(samples: Sequence[MakerSample], image_size: int) -> Tensor:
    found = [s.picture for s in samples if s.picture is not None]
    return torch.from_numpy(
        np.stack(found) if found else np.zeros((0, 3, image_size, image_size), np.float32)
    )

"""From samples to the tensors of one optimiser step."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from swifttailor.pattern_maker.asking.counterpart import NONE, counterparts
from swifttailor.pattern_maker.asking.foresight import PANEL_NUMBERS, foresight_of
from swifttailor.pattern_maker.asking.plan import PatternPlan
from swifttailor.pattern_maker.asking.prompt import PAD
from swifttailor.pattern_maker.network.network_config import NetworkConfig
from swifttailor.pattern_maker.network.network_torch import PatternMakerNetwork
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS, PANEL_TOKENS
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
    before: TokenSequence | None
    """What is edited."""


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
    """(n,) that token, as the outputs of the network are numbered."""
    next_numbers: Tensor
    """(n, 8) its numbers."""
    firsts: Tensor
    """(B,) places in (B * L) of the last token of each prompt."""
    read: Tensor
    """(M, T) ids of R prompts that are only read, several in a row (`PackedPrompts`)."""
    read_numbers: Tensor
    """(M, T, 8) that go with them."""
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
    """(B, L) what is foreseen there; negative where nothing is."""
    planned_numbers: Tensor
    """(B, L, 8)."""
    panels: Tensor
    """(B, L) class id of the panel that a place is in; negative for none, or where nothing is foreseen."""
    plans: Tensor
    """(B, panels, numbers of `foresight`) what is foreseen of each; 0 where nothing is."""
    unplanned: tuple[Unplanned, ...]
    """Answers that `with_plans` has still to add the counterparts of."""

    @property
    def given(self) -> tuple[Tensor, ...]:
        """What the network is called with."""
        written = (self.tokens, self.numbers, self.pictures, self.answers, self.next_tokens, self.firsts)
        read = (self.read, self.read_numbers, self.read_positions, self.read_ends, self.read_pictures)
        told = (self.copied, self.copied_numbers, self.planned, self.planned_numbers, self.panels, self.plans)
        return (*written, *read, *told)

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
            network=config.network,
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

    def __getitem__(self, index: int) -> Batch:
        return self.batches[index]


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
    network: NetworkConfig | None = None,
) -> Batch:
    """Puts samples side by side, padded to the longest, and the prompts of others in rows.

    Args:
        samples: To write.
        image_size: Pixels along each side of a picture.
        reads: To read the prompts of.
        network: Of one that plans, `with_plans` is to follow.
    """
    length = max(len(s.tokens) for s in samples)
    some: Any = samples[0]
    pad = int(some.tokens[-1]) - int(some.outputs[-1]) + PAD  # the last is no text: text tokens come before
    tokens = np.full((len(samples), length), pad, np.int64)
    numbers = np.zeros((len(samples), length, NUMBERS), np.float32)
    told = _Told.like(tokens.shape)
    planning = network is not None and network.planning
    changes = network is not None and network.edits == "outlines"
    answers: list[NDArray[np.int64]] = []
    unplanned: list[Unplanned] = []
    for row, sample in enumerate(samples):
        size = len(sample.tokens)
        tokens[row, :size], numbers[row, :size] = sample.tokens, sample.numbers
        # Each token is predicted from the state before it.
        places = np.arange(size - len(sample.outputs), size) - 1
        answers.append(row * length + places)
        if sample.spelled is not None:
            continue  # counterparts and plans are told in tokens of names
        one = Unplanned(row, size - len(sample.answer), sample.answer, sample.before)
        if planning and (changes or sample.before is None):
            unplanned.append(one)
        else:
            told.add(one)
    read = pack_prompts([s.prompt for s in reads], [s.numbers[: len(s.prompt)] for s in reads], pad)
    foresight = [foresight_of(s.answer, s.before if changes else None) for s in (*samples, *reads)]
    return Batch(
        tokens=torch.from_numpy(tokens),
        numbers=torch.from_numpy(numbers),
        pictures=_pictures(samples, image_size),
        answers=torch.from_numpy(np.concatenate(answers)),
        next_tokens=torch.from_numpy(np.concatenate([s.outputs for s in samples]).astype(np.int64)),
        next_numbers=torch.from_numpy(np.concatenate([s.output_numbers for s in samples])),
        firsts=torch.from_numpy(np.array([places[0] for places in answers])),
        read=torch.from_numpy(read.tokens),
        read_numbers=torch.from_numpy(read.numbers),
        read_positions=torch.from_numpy(read.positions),
        read_ends=torch.from_numpy(read.ends),
        read_pictures=_pictures(reads, image_size),
        present=torch.from_numpy(np.stack([f.present for f in foresight])),
        panel_numbers=torch.from_numpy(np.stack([f.numbers for f in foresight])),
        panels_known=torch.from_numpy(np.stack([f.known for f in foresight])),
        **{name: torch.from_numpy(values) for name, values in vars(told).items()},
        unplanned=tuple(unplanned),
    )


@torch.no_grad()
def with_plans(batch: Batch, network: PatternMakerNetwork) -> Batch:
    """The same with the counterparts of answers for which the network, as it is now, foresees something."""
    if not batch.unplanned:
        return batch
    tokens, numbers = batch.tokens.cpu().numpy(), batch.numbers.cpu().numpy()
    prompts = [(one.row, slice(one.prompt)) for one in batch.unplanned]
    pad = network.text_size + PAD
    packed = pack_prompts([tokens[p] for p in prompts], [numbers[p] for p in prompts], pad)
    device = batch.tokens.device
    rows = (packed.tokens, packed.numbers, packed.positions, packed.ends)
    was_training = network.training
    network.eval()  # as it is when it answers
    with not_compiled():  # a dozen short prompts
        given = [torch.from_numpy(a).to(device) for a in rows]
        foreseen = network.foresee(*given, batch.pictures).float().cpu().numpy()
    network.train(was_training)
    told = _Told.like(batch.tokens.shape)
    for row in set(range(len(tokens))) - {one.row for one in batch.unplanned}:
        for name, array in vars(told).items():
            array[row] = getattr(batch, name)[row].cpu().numpy()
    for one, row in zip(batch.unplanned, foreseen, strict=True):
        told.add(one, PatternPlan.from_foresight(row, one.before))
    made = {name: torch.from_numpy(a).to(device) for name, a in vars(told).items()}
    return replace(batch, unplanned=(), **made)


@torch.no_grad()
def with_own_numbers(batch: Batch, network: PatternMakerNetwork, rows: NDArray[np.bool_]) -> Batch:
    """The same with the numbers that the network would write, given the true ones before, in their place.

    Args:
        batch: With plans.
        network: As it is now.
        rows: (B,) of which samples. What is said to be repeated stays the truth.
    """
    was_training = network.training
    network.eval()  # as it is when it answers
    _, written, _ = network(*replace(batch, **_nothing_read(batch)).given)
    network.train(was_training)
    places = batch.answers + 1  # where the token stands that was predicted
    inside = places % batch.tokens.shape[1] != 0
    chosen = torch.from_numpy(rows).to(places.device)[batch.answers // batch.tokens.shape[1]] & inside
    numbers = batch.numbers.flatten(0, 1).index_copy(0, places[chosen], written[chosen])
    return replace(batch, numbers=numbers.view(batch.numbers.shape))


def _nothing_read(batch: Batch) -> dict[str, Tensor]:
    """The fields of a batch without prompts that are only read."""
    names = ("read", "read_numbers", "read_positions", "read_ends", "read_pictures")
    return {name: getattr(batch, name)[:0] for name in names}


@dataclass(frozen=True, eq=False)
class _Told:
    """What the network is told of the token after each place, as arrays of a batch."""

    copied: NDArray[np.int64]
    copied_numbers: NDArray[np.float32]
    planned: NDArray[np.int64]
    planned_numbers: NDArray[np.float32]
    panels: NDArray[np.int64]
    plans: NDArray[np.float32]

    @staticmethod
    def like(shape: Sequence[int]) -> _Told:
        """Nothing, for (B, L) places."""
        nothing, zeros = np.full(shape, NONE, np.int64), np.zeros((*shape, NUMBERS), np.float32)
        plans = np.zeros((shape[0], len(PANEL_TOKENS), PANEL_NUMBERS), np.float32)
        return _Told(nothing, zeros, nothing.copy(), zeros.copy(), nothing.copy(), plans)

    def add(self, one: Unplanned, plan: PatternPlan | None = None) -> None:
        """Of an answer."""
        for k, own in enumerate(counterparts(one.before, one.answer, plan)):
            place = one.row, one.prompt + k - 1  # each token is predicted from the state before it
            self.copied[place], self.copied_numbers[place] = own.token, own.numbers
            self.planned[place], self.planned_numbers[place] = own.planned, own.planned_numbers
            self.panels[place] = own.panel
        if plan is not None:
            self.plans[one.row] = plan.numbers


def _pictures(samples: Sequence[MakerSample], image_size: int) -> Tensor:
    found = [s.picture for s in samples if s.picture is not None]
    return torch.from_numpy(
        np.stack(found) if found else np.zeros((0, 3, image_size, image_size), np.float32)
    )

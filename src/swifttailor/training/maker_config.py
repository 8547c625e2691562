"""How a PatternMaker is trained: everything that decides what comes out, in one JSON file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from swifttailor.errors import InputError
from swifttailor.pattern_maker.network.network_config import PAPER_NETWORK, NetworkConfig
from swifttailor.training.config_file import read_config_of, require
from swifttailor.training.loop_config import LoopConfig


@dataclass(frozen=True)
class TaskMix:
    """How often a sample is which task, as weights; tasks that a garment has no data for are left out."""

    text: float = 0.3
    """Caption to pattern."""
    image: float = 0.3
    """Picture to pattern."""
    text_image: float = 0.2
    """Both to pattern."""
    edit: float = 0.2
    """Pattern and instruction to pattern."""

    def __post_init__(self) -> None:
        weights = (self.text, self.image, self.text_image, self.edit)
        if min(weights) < 0 or self.text + self.image + self.text_image + self.edit <= 0:
            raise InputError(f"tasks are {weights}; weights of 0 or more are accepted, one above 0.")


@dataclass(frozen=True)
class MakerLosses:
    """Cross entropy of tokens, and what is added to it: each with its weight."""

    numbers: float = 1.0
    """Of the error of the tokens' numbers."""
    foresight: float = 10.0
    """Of the binary cross entropy of which tokens the answer has, foreseen at the end of the prompt. The
    answer itself tells most of each next token, so that a small network is slow to learn what the prompt
    tells."""
    foreseen_numbers: float = 4.0
    """Of the error of where its panels are and how large, foreseen at the same place."""
    penalty: Literal["absolute", "squared"] = "absolute"
    """Of a number, in normalised units; absolute is squared below `number_penalty`'s beta."""
    changed: float = 4.0
    """Weight of a token that is not its counterpart (`counterpart`), and of numbers that are not: most of an
    edit is to be taken over, and what is learnt of it first is to take over everything."""
    by_kind: bool = False
    """Whether the errors of every kind of token that carries numbers are averaged and then added (AIpparel),
    or those of all such tokens are averaged."""

    def __post_init__(self) -> None:
        for name in ("numbers", "foresight", "foreseen_numbers", "changed"):
            require(self, name, getattr(self, name) >= 0, "0 or more")
        require(self, "penalty", self.penalty in ("absolute", "squared"), "absolute or squared")


@dataclass(frozen=True)
class MakerConfig(LoopConfig):
    """Network, tasks, losses, and how they are optimised."""

    network: NetworkConfig = field(default_factory=NetworkConfig)
    tasks: TaskMix = field(default_factory=TaskMix)
    losses: MakerLosses = field(default_factory=MakerLosses)

    batch_size: int = 8
    learning_rate: float = 8e-4
    pretrained_rate: float = 1.0
    """Factor on the learning rate of what is pretrained."""

    shard: bool = False
    """Whether each of several processes keeps only its part of weights, gradients and optimiser state (FSDP),
    for networks that do not fit into one GPU otherwise."""
    tags: Literal["ascending", "random"] = "ascending"
    """Whether stitch tags count up, or mean nothing (AIpparel)."""
    reads: int = 12
    """Prompts beside each sample that are only read, for the losses of foresight: they are short, and what
    they say is what is learnt last. Their tasks are as often as in `tasks`; edits whose prompts tell the
    whole pattern are left out."""
    decoding: Literal["grammar", "free"] = "grammar"
    """How answers are decoded where the network alone is measured: under the grammar, or whatever is
    likeliest (AIpparel). Nothing about the training; `generate` always decodes under the grammar."""
    recuts: int = 1
    """Edits made of each pattern by recutting it, beside those of the file of edits."""
    typos: float = 0.03
    """Share of the words that are misspelt."""
    picture_variation: float = 1.0
    """How different pictures are each time: moved, tilted, in other light; 0 shows them as they are."""
    number_noise: float = 0.01
    """Standard deviation, in normalised units, of what is added to the numbers that the network reads of its
    own answer, since at use these are its own predictions."""

    own_numbers: float = 0.0
    """Share of the samples of which it reads not the true numbers of what comes before, but those that it
    would have written there itself (scheduled sampling, Bengio et al. 2015): else it learns to go by numbers
    that at use are no better than its guess, rather than by what was asked."""

    log_every: int = 20
    validate_every: int = 250
    validation_samples: int = 96
    """Of each task; the same ones every time."""

    def __post_init__(self) -> None:
        super().__post_init__()
        require(self, "validation_samples", self.validation_samples >= 1, "at least 1")
        for name in ("recuts", "reads", "number_noise", "picture_variation"):
            require(self, name, getattr(self, name) >= 0, "0 or more")
        require(self, "pretrained_rate", self.pretrained_rate > 0, "above 0")
        require(self, "typos", 0 <= self.typos <= 1, "0 to 1")
        require(self, "own_numbers", 0 <= self.own_numbers <= 1, "0 to 1")
        if self.network.planning and not self.losses.foresight:
            raise InputError(
                "network.planning is true, and losses.foresight 0: nothing would be foreseen. Set "
                "losses.foresight above 0, or network.planning to false."
            )
        require(self, "decoding", self.decoding in ("grammar", "free"), "grammar or free")
        if self.network.names == "text" and self.losses.changed != 1:
            raise InputError(
                f"losses.changed is {self.losses.changed:g} with network.names=text, where nothing is told "
                "of what is likely to be repeated; 1 is accepted."
            )
        require(self, "tags", self.tags in ("ascending", "random"), "ascending or random")


_AIPPAREL_LOSSES = MakerLosses(
    numbers=0.1, foresight=0.0, foreseen_numbers=0.0, penalty="squared", changed=1.0, by_kind=True
)

CONFIGS: dict[str, MakerConfig] = {
    "small": MakerConfig(network=NetworkConfig(edits="outlines")),
    "aipparel": MakerConfig(
        network=NetworkConfig(command_seen=False, copying=False, planning=False, names="text"),
        losses=_AIPPAREL_LOSSES,
        tags="random",
        decoding="free",
        reads=0,
    ),
    "paper": MakerConfig(
        network=PAPER_NETWORK,
        tasks=TaskMix(text=0.2, image=0.3, text_image=0.4, edit=0.1),
        losses=_AIPPAREL_LOSSES,
        steps=12_750,
        batch_size=80,
        optimizer="adamw",
        learning_rate=1e-4,
        warmup_steps=100,
        weight_decay=0.0,
        tags="random",
        decoding="free",
        reads=0,
        typos=0.0,
        picture_variation=0.0,
        number_noise=0.0,
        validate_every=1000,
    ),
}
"""Named configurations. In `aipparel`, tokens, losses and decoding are AIpparel's; the network's size, the
tasks, the optimiser, and how texts and pictures are varied are those of `small`. In `paper`, what the paper
does not give is AIpparel's (tasks, losses, steps, batch), and the learning rate ours: AIpparel's is for
another language model."""


def read_config(name: str, overrides: Sequence[str] = ()) -> MakerConfig:
    """One of these, or one from a JSON file that says what differs from ``small``: see `read_config_of`."""
    return read_config_of(CONFIGS, name, overrides)

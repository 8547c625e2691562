"""Training the wish reader, and writing it as a model file. It loads torch."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
import torch
from torch.nn import functional as F

from swifttailor.networks.half_storage import round_to_half
from swifttailor.networks.onnx_export_torch import export_graph
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.training.wish_samples import UNKNOWN, WishSample, WishSamples
from swifttailor.wishes.labels import number_labels, statement_labels
from swifttailor.wishes.network_torch import ReaderConfig, WishNetwork
from swifttailor.wishes.reader import FORMAT, INPUTS, NOTE, OUTPUTS
from swifttailor.wishes.text_tokens import EXTRA_TOKENS, PADDING

_POOL = 8
"""Batches whose samples are sorted by length together."""
_EXAMPLE_TOKENS = 7


@dataclass(frozen=True)
class WishTraining:
    """How it is trained."""

    steps: int = 6000
    batch_size: int = 64
    learning_rate: float = 1e-3
    warmup: int = 200
    weight_decay: float = 0.01
    typos: float = 0.04
    seed: int = 0


@dataclass(frozen=True)
class WishScore:
    """How well texts are read, all of their statements and numbers together."""

    precision: float
    recall: float
    whole: float
    """Texts of which all is read and nothing else."""
    numbers: float
    """Numbers that are told what they are."""


def train_wish_reader(
    samples: WishSamples,
    validation: Sequence[WishSample],
    training: WishTraining,
    report: Callable[[str], None] = print,
) -> tuple[WishNetwork, WishScore]:
    """Trains a reader from random weights.

    Args:
        samples: To learn from.
        validation: To judge it by.
        training: How.
        report: Called with lines to show.
    """
    torch.manual_seed(training.seed)
    size = TextTokenizer.shipped().size + EXTRA_TOKENS
    network = WishNetwork(ReaderConfig(size, len(statement_labels()), len(number_labels())))
    optimizer = torch.optim.AdamW(
        network.parameters(), lr=training.learning_rate, weight_decay=training.weight_decay
    )
    chance, pool, began, losses = np.random.default_rng(training.seed), [], time.monotonic(), []
    for step in range(training.steps):
        if not pool:
            first = step * training.batch_size
            made = [samples.make(first + k) for k in range(_POOL * training.batch_size)]
            made.sort(key=lambda sample: len(sample.ready.tokens))
            batches = [made[k : k + training.batch_size] for k in range(0, len(made), training.batch_size)]
            pool = [batches[k] for k in chance.permutation(len(batches))]
        for group in optimizer.param_groups:
            group["lr"] = training.learning_rate * _rate(step, training)
        loss = _loss(network, pool.pop())
        optimizer.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(network.parameters(), 1.0)
        optimizer.step()
        losses.append(loss.item())
        if (step + 1) % 500 == 0:
            score = judge(network, validation)
            report(
                f"step {step + 1}, {time.monotonic() - began:.0f} s: loss {np.mean(losses[-500:]):.3f}, "
                f"precision {score.precision:.3f}, recall {score.recall:.3f}, whole texts {score.whole:.3f}, "
                f"numbers {score.numbers:.3f}"
            )
    round_to_half(network)
    return network, judge(network, validation)


@torch.no_grad()
def judge(network: WishNetwork, samples: Sequence[WishSample], batch_size: int = 128) -> WishScore:
    """How well a network reads some texts."""
    network.eval()
    right = read = said = whole = numbers = known = 0
    for start in range(0, len(samples), batch_size):
        part = samples[start : start + batch_size]
        logits, counts = network(_tokens(part, network.config.tokens - 1))
        for k, sample in enumerate(part):
            found = set(torch.nonzero(logits[k] > 0)[:, 0].tolist())
            meant = set(sample.said.tolist())
            right, read, said = right + len(found & meant), read + len(found), said + len(meant)
            whole += found == meant
            for place, count in zip(sample.ready.places, sample.counts, strict=True):
                if count != UNKNOWN:
                    known += 1
                    numbers += int(counts[k, place].argmax()) == count
    network.train()
    return WishScore(
        right / max(read, 1), right / max(said, 1), whole / len(samples), numbers / max(known, 1)
    )


def reader_file(network: WishNetwork, card: dict[str, Any]) -> bytes:
    """The content of a model file, which `WishReader.load` opens.

    Args:
        network: Trained.
        card: What it was trained on and how good it is.
    """
    about = {
        "format": FORMAT,
        "tokens": network.config.tokens,
        "statements": statement_labels(),
        "numbers": number_labels(),
        "card": card,
    }
    length = torch.export.Dim("length", min=2, max=network.places.num_embeddings)
    return export_graph(
        network.eval(),
        (torch.zeros(1, _EXAMPLE_TOKENS, dtype=torch.long),),
        ({1: length},),
        INPUTS,
        OUTPUTS,
        {NOTE: json.dumps(about, separators=(",", ":"), allow_nan=False)},
    )


def score_values(score: WishScore) -> dict[str, float]:
    """A score for a card."""
    return {name: round(value, 4) for name, value in asdict(score).items()}


def _rate(step: int, training: WishTraining) -> float:
    rising = min(1.0, (step + 1) / training.warmup)
    return rising * 0.5 * (1 + float(np.cos(np.pi * step / training.steps)))


def _loss(network: WishNetwork, samples: Sequence[WishSample]) -> torch.Tensor:
    logits, counts = network(_tokens(samples, network.config.tokens - 1))
    meant = torch.zeros_like(logits)
    for k, sample in enumerate(samples):
        meant[k, torch.from_numpy(sample.said)] = 1.0
    loss = F.binary_cross_entropy_with_logits(logits, meant, reduction="sum") / len(samples)
    places = [
        (k, place, count)
        for k, sample in enumerate(samples)
        for place, count in zip(sample.ready.places, sample.counts, strict=True)
        if count != UNKNOWN
    ]
    if places:
        rows, columns, wanted = torch.tensor(places).T
        loss = loss + F.cross_entropy(counts[rows, columns], wanted, reduction="sum") / len(samples)
    return loss


def _tokens(samples: Sequence[WishSample], padding: int) -> torch.Tensor:
    longest = max(len(s.ready.tokens) for s in samples)
    tokens = np.full((len(samples), longest), padding, np.int64)
    for k, sample in enumerate(samples):
        tokens[k, : len(sample.ready.tokens)] = sample.ready.tokens
    return torch.from_numpy(tokens)


assert PADDING == EXTRA_TOKENS - 1, "padding is the last token"

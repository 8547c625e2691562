"""The training of a wish reader. Import this in the function that needs it: it loads torch."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Unpack

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn import functional as F

from swifttailor.training.loop_torch import Loop, RunOptions, Task
from swifttailor.training.maker_bank import PatternBank, open_bank, sequences_of
from swifttailor.training.master_weights_torch import MasterWeights
from swifttailor.training.processes_torch import Processes
from swifttailor.training.run_record import file_checksums
from swifttailor.training.spoken_texts import read_spoken_texts
from swifttailor.training.start_torch import load_start
from swifttailor.training.wish_config import WishConfig
from swifttailor.training.wish_samples import UNKNOWN, WishSample, WishSamples
from swifttailor.wishes.export_torch import build_network, labels_checksum, tokenizer_of
from swifttailor.wishes.network_torch import WishNetwork
from swifttailor.wishes.spoken_network_torch import SpokenNetwork

_POOL = 8
"""Batches whose samples are sorted by length together."""


def train(
    config: WishConfig,
    patterns: Sequence[Path],
    out: Path,
    *,
    validation: Sequence[Path],
    apart: Sequence[Path] = (),
    edits: Path | None = None,
    spoken: Sequence[Path] = (),
    cache: Path | None = None,
    workers: int = 1,
    **options: Unpack[RunOptions],
) -> dict[str, Any]:
    """Trains a network, or resumes a training that was interrupted.

    Args:
        config: Everything that decides the result.
        patterns: Files or folders of patterns to write texts of.
        out: Folder of the run; holds weights, card, checkpoint and measurements.
        validation: Files or folders of patterns to validate with.
        apart: Files or folders of patterns that must not be learnt from. Patterns and edits equal to these,
            or to one of `validation`, are left out.
        edits: File with edited versions of some of the patterns.
        spoken: Files of texts in people's own words (`read_spoken_texts`). One of ten is validated
            with and not learnt from.
        cache: Where to keep what is measured of the patterns; ``cache`` in `out` when None. PatternMaker's
            training reads and writes the same.
        workers: Processes that measure.
        options: How it is run.

    Returns:
        The card: what was trained on what, and how good it is.

    Raises:
        InputError: A file, the folder or the configuration cannot be used.
        SimulationError: The loss is no number any more.
    """
    loop = Loop.start(config, out, **options)
    processes, report = loop.processes, loop.report

    def open_part(files: Sequence[Path]) -> PatternBank:
        kept = cache or out / "cache"
        return open_bank(files, edits, kept, recuts=config.recuts, workers=workers, report=report)

    with processes.first_goes_ahead():  # it measures, the others read
        banks = {"train": open_part(patterns), "validation": open_part(validation)}
    banks["train"] = banks["train"].without([*banks["validation"].sequences(), *sequences_of(apart)])
    tokenizer = tokenizer_of(config.network.encoder)
    said = read_spoken_texts(spoken)
    learnt = [one for one in said if not one.held_out]
    samples = WishSamples(
        banks["train"],
        tokenizer,
        seed=config.seed,
        typos=config.typos,
        spoken=learnt,
        own_words=config.own_words,
    )
    judged = WishSamples(banks["validation"], tokenizer, seed=config.seed + 1, typos=0.0)
    data = {name: bank.numbers() for name, bank in banks.items()}
    data["files"] = file_checksums([*patterns, *validation, *apart, *([edits] if edits else []), *spoken])
    held = [judged.make(k) for k in range(config.validation_texts)]
    own = [judged.sample(s.text, s.changes, instruction=s.kind is not None) for s in said if s.held_out]
    if said:
        data["spoken"] = {"train": len(learnt), "validation": len(own)}
    task = WishTask(config, samples, held, data, processes, spoken=own)
    report(
        f"{sum(p.numel() for p in task.network.parameters()) / 1e6:.2f} M parameters; "
        f"{len(banks['train'])} patterns with {data['train']['edits']} edits to write texts of, "
        f"{len(held)} texts to validate; {processes.device}, {processes.count} process(es)."
    )
    return loop.run(task)


class WishTask(Task):
    """What texts ask for, from the texts."""

    samples = "texts"

    def __init__(
        self,
        config: WishConfig,
        samples: WishSamples,
        validation: Sequence[WishSample],
        data: dict[str, Any],
        processes: Processes,
        *,
        spoken: Sequence[WishSample] = (),
    ) -> None:
        """Begins with random weights, or those of ``config.start``.

        Args:
            config: Of the training.
            samples: To learn from.
            validation: To judge by.
            data: What both are of, for the card.
            processes: That train.
            spoken: In people's own words, to judge by, too.
        """
        self.spoken = spoken
        torch.manual_seed(config.seed)
        self.network = build_network(asdict(config.network)).to(processes.device)
        if config.start:
            load_start(self.network, Path(config.start))
        self.weights = MasterWeights(self.network)
        self.validation, self.data, self.device = validation, data, processes.device
        self.batches = WishBatches(samples, config, part=processes.rank, parts=processes.count)

    def losses(self, trained: nn.Module, step: int) -> dict[str, Tensor]:
        """Of the statements and numbers of a batch, a text."""
        batch = self.batches[step]
        logits, counts = trained(tokens_of(batch, self.network.config.tokens - 1).to(self.device))
        meant = torch.zeros_like(logits)
        for k, sample in enumerate(batch):
            meant[k, torch.from_numpy(sample.said)] = 1.0
        said = F.binary_cross_entropy_with_logits(logits, meant, reduction="sum") / len(batch)
        places = [
            (k, place, count)
            for k, sample in enumerate(batch)
            for place, count in zip(sample.ready.places, sample.counts, strict=True)
            if count != UNKNOWN
        ]
        rows, columns, wanted = torch.tensor(places, device=self.device).reshape(-1, 3).T.long()
        numbers = F.cross_entropy(counts[rows, columns], wanted, reduction="sum") / len(batch)
        return {"statements": said, "numbers": numbers, "total": said + numbers}

    def validate(self) -> dict[str, Any]:
        """How well the texts to validate with are read."""
        found = _judged(self.network, self.validation)
        return found | ({"spoken": _judged(self.network, self.spoken)} if self.spoken else {})

    def result_text(self, result: dict[str, Any]) -> str:
        """In one line."""
        shown = (
            f"validation precision {result['precision']:.1%}, recall {result['recall']:.1%}, whole texts "
            f"{result['whole']:.1%}, numbers {result['numbers']:.1%}"
        )
        own = result.get("spoken")
        if own is None:
            return shown
        return (
            f"{shown}; own words: precision {own['precision']:.1%}, recall {own['recall']:.1%}, whole texts "
            f"{own['whole']:.1%}"
        )

    def card(self) -> dict[str, Any]:
        """Model, labels and data."""
        model = "SpokenReader" if isinstance(self.network, SpokenNetwork) else "WishReader"
        return {"model": model, "labels_sha256": labels_checksum(), "data": self.data}


def _judged(network: WishNetwork | SpokenNetwork, samples: Sequence[WishSample]) -> dict[str, Any]:
    return {"texts": len(samples)} | {k: round(v, 4) for k, v in asdict(judge(network, samples)).items()}


class WishBatches:
    """Batches of texts of like length, each determined by its number."""

    def __init__(self, samples: WishSamples, config: WishConfig, *, part: int = 0, parts: int = 1) -> None:
        self.samples, self.part, self.parts = samples, part, parts
        self.size, self.seed = config.batch_size, config.seed
        self._number, self._pool = -1, []

    def __getitem__(self, step: int) -> list[WishSample]:
        """The batch of an optimiser step; of several processes, the part of this one."""
        number, place = divmod(step, _POOL)
        if number != self._number:
            first, size = number * _POOL * self.size, self.size
            made = [self.samples.make(first + k) for k in range(_POOL * size)]
            made.sort(key=lambda sample: len(sample.ready.tokens))
            order = np.random.default_rng([self.seed, 1, number]).permutation(_POOL)
            self._pool = [made[k * size : (k + 1) * size] for k in order]
            self._number = number
        return self._pool[place][self.part :: self.parts]


@dataclass(frozen=True)
class WishScore:
    """How well texts are read, all of their statements and numbers together."""

    precision: float
    recall: float
    whole: float
    """Texts of which all is read and nothing else."""
    numbers: float
    """Numbers that are told what they are."""


@torch.no_grad()
def judge(
    network: WishNetwork | SpokenNetwork, samples: Sequence[WishSample], batch_size: int = 128
) -> WishScore:
    """How well a network reads some texts."""
    device = network.embedding.weight.device
    right = read = said = whole = numbers = known = 0
    for start in range(0, len(samples), batch_size):
        part = samples[start : start + batch_size]
        logits, counts = network(tokens_of(part, network.config.tokens - 1).to(device))
        for k, sample in enumerate(part):
            found = set(torch.nonzero(logits[k] > 0)[:, 0].tolist())
            meant = set(sample.said.tolist())
            right, read, said = right + len(found & meant), read + len(found), said + len(meant)
            whole += found == meant
            for place, count in zip(sample.ready.places, sample.counts, strict=True):
                if count != UNKNOWN:
                    known += 1
                    numbers += int(counts[k, place].argmax()) == count
    return WishScore(
        right / max(read, 1), right / max(said, 1), whole / len(samples), numbers / max(known, 1)
    )


def tokens_of(samples: Sequence[WishSample], padding: int) -> Tensor:
    """(B, N) tokens of texts, padded at the end."""
    longest = max(len(s.ready.tokens) for s in samples)
    tokens = np.full((len(samples), longest), padding, np.int64)
    for k, sample in enumerate(samples):
        tokens[k, : len(sample.ready.tokens)] = sample.ready.tokens
    return torch.from_numpy(tokens)

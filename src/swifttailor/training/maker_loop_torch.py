"""The training of a PatternMaker. Import this in the function that needs it: it loads torch."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, Unpack

import numpy as np
import torch
from torch import Tensor, nn

from swifttailor.data.index import split_folders
from swifttailor.data.reader import SplitReader
from swifttailor.data.renders.files import SplitRenders
from swifttailor.errors import InputError
from swifttailor.networks.settled_norms_torch import settle_norms
from swifttailor.pattern_maker.network.building_torch import build_network
from swifttailor.pattern_maker.network.file_weights_torch import file_weights
from swifttailor.pattern_maker.network.network_torch import OPTIONAL, PatternMakerNetwork
from swifttailor.training.compilation_torch import compile_layers
from swifttailor.training.loop_torch import Loop, RunOptions, Task
from swifttailor.training.maker_bank import PatternBank, open_bank, sequences_of
from swifttailor.training.maker_batch_torch import Batch, TrainingBatches, with_own_numbers, with_plans
from swifttailor.training.maker_config import MakerConfig
from swifttailor.training.maker_losses_torch import compute_losses
from swifttailor.training.maker_samples import MakerSamples
from swifttailor.training.maker_text_torch import open_text
from swifttailor.training.maker_validation_torch import Validation
from swifttailor.training.master_weights_torch import MasterWeights, choose_precision
from swifttailor.training.processes_torch import Processes
from swifttailor.training.run_record import file_checksums, split_card
from swifttailor.training.sharding_torch import shard
from swifttailor.training.start_torch import load_start

ARCHIVE = ".zip"
"""The ending of a model file to begin with."""
_SETTLING_BATCHES = 16
"""What tells mean and variance of the features of a network that was read from one."""
HELD_OUT = 50
"""Of so many patterns one is kept for validation where no file is given for that."""


def train(
    config: MakerConfig,
    patterns: Sequence[Path],
    out: Path,
    *,
    validation: Sequence[Path] = (),
    apart: Sequence[Path] = (),
    data: Sequence[Path] = (),
    edits: Path | None = None,
    cache: Path | None = None,
    workers: int = 1,
    loaders: int = 0,
    **options: Unpack[RunOptions],
) -> dict[str, Any]:
    """Trains a network, or resumes a training that was interrupted.

    Args:
        config: Everything that decides the result.
        patterns: Files or folders of patterns.
        out: Folder of the run; holds weights, card, checkpoint and measurements.
        validation: Files or folders of patterns to validate with; without any, one of fifty of `patterns` is
            held out.
        apart: Files or folders of patterns that must not be learnt from. Patterns and edits equal to these,
            or to one of `validation`, are left out.
        data: Folders of data sets with renders of some of the patterns, for tasks with pictures.
        edits: File with edited versions of some of the patterns.
        cache: Where to keep what is measured of the patterns; ``cache`` in `out` when None.
        workers: Processes that measure.
        loaders: Processes that make batches ahead; 0 makes them between steps.
        options: How it is run.

    Returns:
        The card: what was trained on what, and how good it is.

    Raises:
        InputError: A file, the folder or the configuration cannot be used.
        SimulationError: The loss is no number any more.
    """
    if config.compiled and config.shard:
        raise InputError("compiled=true cannot go with shard=true. Choose one of them.")
    if config.network.planning and config.shard:
        raise InputError("network.planning=true cannot go with shard=true. Choose one of them.")
    loop = Loop.start(config, out, **options)
    processes, report = loop.processes, loop.report
    device = processes.device

    def open_part(files: Sequence[Path], keep: Callable[[str], bool] | None = None) -> PatternBank:
        kept = cache or out / "cache"
        return open_bank(files, edits, kept, recuts=config.recuts, workers=workers, keep=keep, report=report)

    with processes.first_goes_ahead():  # it measures, the others read
        if validation:
            banks = {"train": open_part(patterns), "validation": open_part(validation)}
            _require_apart(banks)
        else:
            learnt = open_part(patterns, lambda id: not _held_out(id))
            banks = {"train": learnt, "validation": open_part(patterns, _held_out)}
    banks["train"] = banks["train"].without([*sequences_of(apart), *banks["validation"].sequences()])
    for name, bank in banks.items():
        for id, why in bank.skipped[:5]:
            report(f"{name}: '{id}' is left out: {why}")
    renders = _open_renders(data)

    text = open_text(config.network)
    torch.manual_seed(config.seed)
    network = build_network(config.network, text.size).to(device)
    if device.type == "cpu" and not config.shard:
        # The fused attention's backward pass takes a third of a step on a CPU, plain products a sixth.
        network.vlm.set_attn_implementation("eager")
    if config.compiled:
        compile_layers(network.compilable, device)
    from_file = Path(config.start).suffix == ARCHIVE
    if from_file:
        network.load_state_dict(file_weights(Path(config.start), network))
    elif config.start:
        for name in load_start(network, Path(config.start), tuple(OPTIONAL.values())):
            report(f"'{config.start}' is of another network in '{name}', which begins anew.")

    def samples_of(name: str) -> MakerSamples:
        return MakerSamples(banks[name], renders[name], config, text.encode, text.size, text.names)

    about: dict[str, Any] = {name: bank.numbers() for name, bank in banks.items()}
    about["files"] = file_checksums([*patterns, *validation, *apart, *([edits] if edits else [])])
    about["pictures"] = {name: [split_card(r.reader) for r in each] for name, each in renders.items()}
    batches = TrainingBatches(samples_of("train"), part=processes.rank, parts=processes.count)
    if from_file and not loop.resume:
        _settle(network, batches, device)
    validated = Validation(samples_of("validation"), config, device)
    task = _MakerTask(network, config, batches, validated, processes, loaders, about)
    total, trained = (
        sum(p.numel() for p in network.parameters() if p.requires_grad or not only) for only in (False, True)
    )
    report(
        f"{total / 1e6:.2f} M parameters, {trained / 1e6:.2f} M trained; {len(banks['train'])} patterns with "
        f"{banks['train'].numbers()['edits']} edits to train on, {len(banks['validation'])} to validate; "
        f"{device}, {task.precision}, {processes.count} process(es)."
    )
    return loop.run(task)


class _MakerTask(Task):
    """Patterns from text, pictures and other patterns (paper, Sec. 4.1)."""

    samples = "garments"

    def __init__(
        self,
        network: PatternMakerNetwork,
        config: MakerConfig,
        batches: TrainingBatches,
        validation: Validation,
        processes: Processes,
        loaders: int,
        data: dict[str, Any],
    ) -> None:
        self.network, self.config, self.data, self.batches = network, config, data, batches
        self.validation, self.device, self.loaders = validation, processes.device, loaders
        self.precision = choose_precision(config.precision, self.device)
        lowered = [network.vlm] if self.precision == "bfloat16" else []
        if config.shard:
            lowered = []  # the parts are float32, what is put together of them is not
            shard(network, network.units, network.vlm, processes, self.precision)
        self.weights = MasterWeights(network, lowered)
        self._ahead: Iterator[Batch] | None = None

    def losses(self, trained: nn.Module, step: int) -> dict[str, Tensor]:
        if self._ahead is None:
            self._ahead = self.batches.from_step(step, workers=self.loaders)
        batch = with_plans(next(self._ahead).to(self.device), self.network)
        if self.config.own_numbers:
            chance = np.random.default_rng([self.config.seed, 9, step, self.batches.part])
            batch = with_own_numbers(
                batch, self.network, chance.random(len(batch.tokens)) < self.config.own_numbers
            )
        return compute_losses(*trained(*batch.given), batch, self.config.losses)

    def rate_factor(self, name: str) -> float:
        pretrained = self.config.network.pretrained and name.startswith("vlm.")
        return self.config.pretrained_rate if pretrained else 1.0

    def validate(self) -> dict[str, Any]:
        return self.validation.measure(self.network)

    def result_text(self, result: dict[str, Any]) -> str:
        parts = [
            f"{task}: tokens {r['token_accuracy']:.1%} (loss {r['token_loss']:.3f}), "
            f"corners {r['corner_cm']:.2f} cm, placement {r['placement_cm']:.2f} cm, "
            f"foreseen: panels {r['panels_foreseen']:.0%}, sizes {r['foreseen_cm']:.1f} cm"
            for task, r in result.items()
        ]
        return "validation " + "; ".join(parts)

    def card(self) -> dict[str, Any]:
        return {"model": "PatternMaker", "data": self.data}


def _settle(network: PatternMakerNetwork, batches: TrainingBatches, device: torch.device) -> None:
    """Lets norms that the file has folded see pictures, where there are any to learn from."""
    shown = [batches[step].pictures for step in range(_SETTLING_BATCHES)]
    pictures = torch.cat([some for some in shown if len(some)] or shown[:1])
    if len(pictures):
        settle_norms(network, lambda: network.vlm.get_image_features(pictures.to(device)))


def _held_out(id: str) -> bool:
    return zlib.crc32(id.encode()) % HELD_OUT == 0


def _require_apart(banks: dict[str, PatternBank]) -> None:
    shared = {g.id for g in banks["train"].garments} & {g.id for g in banks["validation"].garments}
    if shared:
        raise InputError(
            f"{len(shared)} patterns are both trained on and validated with, '{min(shared)}' for one. Give "
            "other files with --validation."
        )


def _open_renders(data: Sequence[Path]) -> dict[str, list[SplitRenders]]:
    sets = [split_folders(folder) for folder in data]
    return {
        name: [SplitRenders(SplitReader(folders[name])) for folders in sets if name in folders]
        for name in ("train", "validation")
    }

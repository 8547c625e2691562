"""The training of a GarmentSewer: one loop. Import this in the function that needs it: it loads torch."""

from __future__ import annotations

from functools import cached_property
from pathlib import Path
from typing import Any, Unpack

import torch
from torch import Tensor, nn

from swifttailor.body import Body
from swifttailor.data.builder.settings import NETWORK
from swifttailor.data.index import split_folders
from swifttailor.data.reader import SplitReader
from swifttailor.errors import InputError
from swifttailor.garment_sewer.body_field_torch import BodyField
from swifttailor.garment_sewer.losses_torch import compute_losses
from swifttailor.garment_sewer.network_torch import SewerNetwork, build_network
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.networks.settled_norms_torch import settle_norms
from swifttailor.training.loop_torch import Loop, RunOptions, Task
from swifttailor.training.master_weights_torch import MasterWeights, choose_precision
from swifttailor.training.run_record import split_card
from swifttailor.training.sewer_batch_torch import TrainingBatches
from swifttailor.training.sewer_config import SewerConfig
from swifttailor.training.sewer_samples import SewerSamples
from swifttailor.training.sewer_validation_torch import Validation
from swifttailor.training.start_torch import GRAPH, load_start

_SETTLING_BATCHES = 32
"""What tells mean and variance of the features of a network that was read from a graph."""


def train(
    config: SewerConfig,
    data: Path,
    out: Path,
    *,
    cache: Path | None = None,
    workers: int = 1,
    **options: Unpack[RunOptions],
) -> dict[str, Any]:
    """Trains a network, or resumes a training that was interrupted.

    Args:
        config: Everything that decides the result.
        data: Folder of a data set with the splits ``train`` and ``validation``.
        out: Folder of the run; holds weights, card, checkpoint, measurements and pictures.
        cache: Where to keep what is drawn of the data; ``cache`` in `data` when None.
        workers: Processes that draw.
        options: How it is run.

    Returns:
        The card: what was trained on what, and how good it is.

    Raises:
        InputError: The data, the folder or the configuration cannot be used.
        SimulationError: The loss is no number any more.
    """
    loop = Loop.start(config, out, **options)
    processes, report = loop.processes, loop.report
    device = processes.device
    readers = _open_splits(data)
    samples = {
        name: SewerSamples(
            reader,
            cache or data / "cache",
            config.network.resolution,
            config.conditioning.prior,
            config.layouts if name == "train" else 1,
            kind=config.conditioning.layout,
        )
        for name, reader in readers.items()
    }
    if processes.is_first:
        for name, of_split in samples.items():
            for done, total in of_split.prepare(workers=workers):
                report(f"drawing {name}: {done} of {total} shards")
    processes.wait()

    torch.manual_seed(config.seed)
    network = build_network(config.network, config.conditioning.count).to(device)
    if config.start:
        load_start(network, Path(config.start))
    network = network.to(memory_format=torch.channels_last)
    if device.type == "cpu":
        # The fused attention's backward pass takes a fifth of a step on a CPU, plain products almost nothing.
        network.set_attn_implementation("eager")
    batches = TrainingBatches(
        samples["train"], readers["train"], config, device, part=processes.rank, parts=processes.count
    )
    if config.start.endswith(GRAPH) and not loop.resume:
        settle_norms(network, lambda: _show(network, batches))
    task = _SewerTask(network, config, readers, samples["validation"], batches, out, device)
    report(
        f"{sum(p.numel() for p in network.parameters()) / 1e6:.1f} M parameters; "
        f"{len(readers['train'])} garments to train on, {len(readers['validation'])} to validate; "
        f"{device}, {task.precision}, {processes.count} process(es)."
    )
    return loop.run(task)


class _SewerTask(Task):
    """Positions of pixels from patterns (paper, Sec. 4.3)."""

    samples = "garments"

    def __init__(
        self,
        network: SewerNetwork,
        config: SewerConfig,
        readers: dict[str, SplitReader],
        validated: SewerSamples,
        batches: TrainingBatches,
        out: Path,
        device: torch.device,
    ) -> None:
        self.network, self.config, self.readers, self.batches = network, config, readers, batches
        self.out, self.device = out, device
        self.precision = choose_precision(config.precision, device)
        lowered = network.lowered if self.precision == "bfloat16" else ()
        self.weights = MasterWeights(network, lowered)
        self.validation = Validation(validated, readers["validation"], config, device)

    def losses(self, trained: nn.Module, step: int) -> dict[str, Tensor]:
        batch = self.batches[step]
        given = batch.conditioning.contiguous(memory_format=torch.channels_last)
        with self._autocast():
            predicted = trained(given, batch.truth.occupancy, batch.prior)
        return compute_losses(predicted, batch.truth, self.config.losses, self._body)

    def rate_factor(self, name: str) -> float:
        return self.config.encoder_rate if name.startswith("dpt.") else 1.0

    def validate(self) -> dict[str, Any]:
        with self._autocast():
            return self.validation.measure(self.network)

    def illustrate(self, step: int) -> None:
        if not self.config.pictures:
            return
        with self._autocast():
            self.validation.draw(self.network, self.out / f"validation-{step:07d}.png")

    def result_text(self, result: dict[str, Any]) -> str:
        kinds = ", ".join(f"{kind} {r['mean']:.2f}" for kind, r in result.get("kinds", {}).items())
        return (
            f"validation {result['mean']:.2f} cm (median {result['median']:.2f}; {kinds}), "
            f"seam gap {result['seam_gap']:.2f} cm, inside {result['inside']:.1%}"
        )

    def card(self) -> dict[str, Any]:
        return {"model": "GarmentSewer", "data": {k: split_card(r) for k, r in self.readers.items()}}

    def _autocast(self) -> torch.autocast:
        return torch.autocast(self.device.type, torch.bfloat16, enabled=self.precision == "bfloat16")

    @cached_property
    def _body(self) -> BodyField | None:
        if not self.config.losses.penetration:
            return None
        return BodyField(BodyDistance.of(Body.default()), self.device)


def _show(network: SewerNetwork, batches: TrainingBatches) -> None:
    for step in range(_SETTLING_BATCHES):
        batch = batches[step]
        given = batch.conditioning.contiguous(memory_format=torch.channels_last)
        network(given, batch.truth.occupancy, batch.prior)


def _open_splits(data: Path) -> dict[str, SplitReader]:
    folders = split_folders(data)
    missing = [name for name in ("train", "validation") if name not in folders]
    if missing:
        raise InputError(
            f"'{data}' has no split '{missing[0]}' (it has: {', '.join(folders)}). Build it with: "
            f"swifttailor data build --patterns FILE --out {data} --split {missing[0]}"
        )
    readers = {name: SplitReader(folders[name]) for name in ("train", "validation")}
    empty = [name for name, reader in readers.items() if not len(reader)]
    if empty:
        raise InputError(f"The split '{empty[0]}' in '{data}' holds no garment.")
    for name, reader in readers.items():
        if reader.index.settings.get("engine") == NETWORK:
            raise InputError(
                f"The garments of '{folders[name]}' are those of a GarmentSewer, from which none can learn. "
                "Drape the patterns: swifttailor data build without --engine network."
            )
    return readers

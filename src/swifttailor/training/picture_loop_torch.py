"""The training of a picture reader. Import this in the function that needs it: it loads torch."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any, Unpack

import torch
from torch import Tensor, nn

from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.errors import InputError
from swifttailor.networks.settled_norms_torch import settle_norms
from swifttailor.parameter_reader.placed_designs import PlacedDesigns
from swifttailor.picture_reader.export_torch import build_network
from swifttailor.picture_reader.labels import labels_checksum
from swifttailor.picture_reader.network_torch import Reading
from swifttailor.picture_reader.seen_design import IN_CARD, NEAR_IN_CARD
from swifttailor.training.loop_torch import Loop, RunOptions, Task
from swifttailor.training.master_weights_torch import MasterWeights
from swifttailor.training.photograph_validation_torch import judge_photographs
from swifttailor.training.picture_batch_torch import PictureBatches
from swifttailor.training.picture_config import PictureConfig
from swifttailor.training.picture_losses_torch import reading_losses
from swifttailor.training.picture_validation_torch import ValidationPictures, judge
from swifttailor.training.processes_torch import Processes
from swifttailor.training.start_torch import GRAPH, load_start

_SETTLING_BATCHES = 8
"""What tells mean and variance of the features of a network that was read from a graph."""


def train(
    config: PictureConfig,
    garments: Sequence[Path],
    out: Path,
    *,
    validation: Sequence[Path],
    apart: Sequence[Path] = (),
    designs: Path | None = None,
    photographs: Sequence[Path] = (),
    workers: int = 1,
    **options: Unpack[RunOptions],
) -> dict[str, Any]:
    """Trains a network, or resumes a training that was interrupted.

    Args:
        config: Everything that decides the result.
        garments: Folders of splits of sewn garments to draw.
        out: Folder of the run; holds weights, card, checkpoint and measurements.
        validation: Folders of splits to validate with.
        apart: Folders of splits whose patterns must not be learnt from, nor those of `validation`.
        designs: File of `PlacedDesigns`: the network learns to say design parameters, too.
        photographs: Folders of `Photographs`, to learn and to validate with.
        workers: Processes that draw; 0 draws between the steps.
        options: How it is run.

    Returns:
        The card: what was trained on what, and how good it is.

    Raises:
        InputError: A file, the folder or the configuration cannot be used.
        SimulationError: The loss is no number any more.
    """
    placed = None if designs is None else PlacedDesigns.read(designs)
    config = replace(config, network=replace(config.network, design_values=placed.values if placed else ()))
    loop = Loop.start(config, out, **options)
    processes, report = loop.processes, loop.report
    held = PictureBank(validation)
    with processes.first_goes_ahead():
        held.prepare(workers=max(workers, 1), report=report)
        others = [PictureBank([folder]) for folder in apart]
        for other in others:
            other.prepare(workers=max(workers, 1), report=report)
        bank = PictureBank(garments)
        bank.prepare(workers=max(workers, 1), report=report)
    bank.leave_out(held.digests().union(*(other.digests() for other in others)))
    if config.training_garments:
        bank.keep(config.training_garments)
    if processes.count > 1 and config.batch_size % processes.count:
        raise InputError(f"batch_size is {config.batch_size}; a multiple of the processes is accepted.")
    if bool(photographs) != (config.photograph > 0):
        raise InputError(
            f"The share of photographs is {config.photograph:g} and "
            f"{'a folder of them was' if photographs else 'no folder of them was'} given. "
            "Give both --photographs DIR and --set photograph=SHARE, or neither."
        )
    task = PictureTask(
        config,
        bank,
        held,
        processes,
        designs=placed,
        photographs=photographs,
        workers=workers,
        resumed=loop.resume,
    )
    report(
        f"{sum(p.numel() for p in task.network.parameters()) / 1e6:.2f} M parameters; {len(bank)} garments "
        f"to draw, {len(task.held)} pictures to validate; {processes.device}, {processes.count} process(es)."
    )
    return loop.run(task)


class PictureTask(Task):
    """What pictures show, from the pictures."""

    samples = "pictures"

    def __init__(
        self,
        config: PictureConfig,
        bank: PictureBank,
        validation: PictureBank,
        processes: Processes,
        *,
        designs: PlacedDesigns | None = None,
        photographs: Sequence[Path] = (),
        workers: int,
        resumed: bool = False,
    ) -> None:
        """Begins with random weights, or those of ``config.start``.

        Args:
            config: Of the training.
            bank: To learn from.
            validation: To judge by.
            processes: That train.
            designs: Of the garments, as far as they are known.
            photographs: Folders of `Photographs`, if any.
            workers: Processes that draw.
            resumed: Whether the weights will be those of a checkpoint.
        """
        torch.manual_seed(config.seed)
        self.config, self.device = config, processes.device
        self.network = build_network(asdict(config.network)).to(processes.device)
        self.network = self.network.to(memory_format=torch.channels_last)
        part = processes.rank, processes.count
        taken = Photographs(photographs, "train") if photographs else None
        self.held_photographs = Photographs(photographs, "validation") if photographs else None
        self.batches = PictureBatches(
            bank,
            config,
            workers=workers,
            part=part,
            device=self.device,
            designs=designs,
            photographs=taken,
        )
        self.designs = designs
        if config.start:
            load_start(self.network, Path(config.start), optional=[("design.",)])
            if config.start.endswith(GRAPH) and not resumed:
                settle_norms(self.network, self._show_some)
        if config.frozen_stages:
            self.network.freeze(config.frozen_stages)
        self.weights = MasterWeights(self.network)
        lowered = config.precision == "bfloat16" or (config.precision == "auto" and _has_bfloat16())
        self.precision = "bfloat16" if lowered else "float32"
        self.held = ValidationPictures(validation, config)
        self.data = {
            "train": {"garments": len(bank), "sha256": bank.checksum()} | _known(bank, designs),
            "validation": {"garments": self.held.garments, "sha256": validation.checksum()},
        }
        if taken is not None:
            self.data["photographs"] = {"train": len(taken), "sha256": taken.checksum()}

    def losses(self, trained: nn.Module, step: int) -> dict[str, Tensor]:
        """Of everything that is to be read of a batch, a picture."""
        pictures, guess, truth = self.batches[step]
        pictures = pictures.contiguous(memory_format=torch.channels_last)
        with torch.autocast(self.device.type, torch.bfloat16, enabled=self.precision == "bfloat16"):
            reading = Reading(*trained(pictures, guess))
        return reading_losses(reading, truth, self.config.losses)

    def _show_some(self) -> None:
        for step in range(_SETTLING_BATCHES):
            pictures, guess, _ = self.batches[step]
            self.network(pictures, guess)

    def validate(self) -> dict[str, Any]:
        """How well the pictures to validate with are read."""
        found = judge(self.network, self.held, self.device)
        if self.held_photographs is not None:
            size = self.config.network.image_size
            found["photographs"] = judge_photographs(self.network, self.held_photographs, size, self.device)
        return found

    def result_text(self, result: dict[str, Any]) -> str:
        """In one line."""
        shown = ("kind", "skirt_hem", "neckline", "waistband", "sleeves", "skirt")
        some = ", ".join(f"{name} {_percent(result['claims'].get(name), 0)}" for name in shown)
        looks = ", ".join(f"{name} {_percent(value, 0)}" for name, value in result["by_look"].items())
        near = ", ".join(f"{name} {_percent(value, 0)}" for name, value in result["near"].items())
        photographs = "".join(
            f", {name} {_percent(value)}" for name, value in result.get("photographs", {}).items()
        )
        return (
            f"validation: not false {_percent(result['not_false'])} of all claims ({some}; {looks}); from "
            f"near {_percent(result['near_not_false'])} ({near}); panels all right {result['panels']:.1%}; "
            f"mask {result['mask']:.1%}{photographs and '; photographs' + photographs[1:]}"
        )

    def card(self) -> dict[str, Any]:
        """Model, labels and data."""
        about = {"model": "PictureReader", "labels_sha256": labels_checksum(), "data": self.data}
        if self.designs:
            about[IN_CARD] = [one.to_json() for one in self.designs.parameters]
            about[NEAR_IN_CARD] = self.config.close > 0
        return about


def _known(bank: PictureBank, designs: PlacedDesigns | None) -> dict[str, int]:
    if designs is None:
        return {}
    return {"designs": int(designs.of_ids(bank.ids)[1].any(axis=1).sum())}


def _percent(share: float | None, digits: int = 1) -> str:
    return "-" if share is None else f"{share:.{digits}%}"


def _has_bfloat16() -> bool:
    if torch.cuda.is_available():
        return torch.cuda.is_bf16_supported()
    return bool(getattr(torch.cpu, "_is_avx512_bf16_supported", lambda: False)())

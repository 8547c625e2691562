"""The training of a GarmentSewer: one loop. Import this in the function that needs it: it loads torch."""

from __future__ import annotations

import contextlib
import math
import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import torch

from swifttailor.body import Body
from swifttailor.data.index import split_folders
from swifttailor.data.reader import SplitReader
from swifttailor.errors import InputError, SimulationError
from swifttailor.garment_sewer.body_field_torch import BodyField
from swifttailor.garment_sewer.losses_torch import compute_losses
from swifttailor.garment_sewer.network_torch import GarmentSewerNetwork, build_network
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.training.checkpoint_torch import MovingAverage, read_checkpoint, write_checkpoint
from swifttailor.training.processes_torch import Processes
from swifttailor.training.run_record import WEIGHTS, RunRecord, versions
from swifttailor.training.schedule import Schedule
from swifttailor.training.sewer_batch_torch import TrainingBatches
from swifttailor.training.sewer_config import SewerConfig, config_values
from swifttailor.training.sewer_samples import SewerSamples
from swifttailor.training.sewer_validation_torch import Validation

Report = Callable[[str], None]


def train(
    config: SewerConfig,
    data: Path,
    out: Path,
    *,
    resume: bool = False,
    cache: Path | None = None,
    workers: int = 1,
    max_minutes: float | None = None,
    stop_after: int | None = None,
    threads: int | None = None,
    report: Report | None = None,
) -> dict[str, Any]:
    """Trains a network, or goes on with a training that was interrupted.

    Args:
        config: Everything that decides the result.
        data: Folder of a data set with the splits ``train`` and ``validation``.
        out: Folder of the run; holds weights, card, checkpoint, measurements and pictures.
        resume: Go on from the checkpoint in `out`. On a CPU the result is that of an uninterrupted
            training, bit for bit, unless `max_minutes` is given.
        cache: Where to keep what is drawn of the data; ``cache`` in `data` when None.
        workers: Processes that draw.
        max_minutes: Of training; the schedule is fitted to it. Counts what an interrupted training has used.
        stop_after: Interrupt after this many steps, a checkpoint written.
        threads: Processor cores to train on; torch's choice when None.
        report: Called with lines to show.

    Returns:
        The card: what was trained on what, and how good it is.

    Raises:
        InputError: The data, the folder or the configuration cannot be used.
        SimulationError: The loss is no number any more.
    """
    if threads is not None:
        torch.set_num_threads(threads)
    processes = Processes.start()
    device = processes.device
    report = report if report is not None and processes.is_first else _say_nothing
    record = RunRecord(out)
    if processes.is_first:
        record.start(config_values(config), resume=resume)
    readers = _open_splits(data)
    samples = {
        name: SewerSamples(
            reader,
            cache or data / "cache",
            config.network.resolution,
            config.conditioning.prior,
            config.layouts if name == "train" else 1,
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
    network = network.to(memory_format=torch.channels_last)
    optimizer = torch.optim.AdamW(_parameter_groups(network, config), betas=(0.9, 0.99))
    average = MovingAverage(network, config.ema)
    step, seconds = 0, 0.0
    if resume:
        state = read_checkpoint(out, device)
        network.load_state_dict(state["network"])
        optimizer.load_state_dict(state["optimizer"])
        average.values = state["average"]
        step, seconds = state["step"], state["seconds"]
        if processes.is_first:
            record.forget_after(step)
    trained = processes.share(network)

    batches = TrainingBatches(
        samples["train"], readers["train"], config, device, part=processes.rank, parts=processes.count
    )
    validation = Validation(samples["validation"], readers["validation"], config, device)
    body = BodyField(BodyDistance.of(Body.default()), device) if config.losses.penetration else None
    schedule = Schedule(
        config.steps, config.warmup_steps, config.final_rate, max_minutes and max_minutes * 60
    )
    precision = _precision(config, device)
    parameters = sum(p.numel() for p in network.parameters())
    report(
        f"{parameters / 1e6:.1f} M parameters; {len(readers['train'])} garments to train on, "
        f"{len(readers['validation'])} to validate; {device}, {precision}, {processes.count} process(es)."
    )
    first_step, began, result = step, time.monotonic() - seconds, {}
    trained.train()
    while schedule.progress(step, seconds) < 1 and (stop_after is None or step - first_step < stop_after):
        rate = schedule.rate(step, seconds)
        for group in optimizer.param_groups:
            group["lr"] = config.learning_rate * group["factor"] * rate
        batch = batches[step]
        given = batch.conditioning.contiguous(memory_format=torch.channels_last)
        with _autocast(device, precision):
            predicted = trained(given, batch.truth.occupancy, batch.prior)
        losses = compute_losses(predicted, batch.truth, config.losses, body)
        losses["total"].backward()
        norm = torch.nn.utils.clip_grad_norm_(network.parameters(), config.clip)
        optimizer.step()
        optimizer.zero_grad(set_to_none=True)
        average.update(network, step)
        step += 1
        seconds = processes.agree(time.monotonic() - began)
        ends = schedule.progress(step, seconds) >= 1
        if step % config.log_every == 0 or ends:
            line = {"step": step, "seconds": round(seconds, 1), "rate": config.learning_rate * rate}
            line |= {name: value.item() for name, value in losses.items()} | {"gradient_norm": norm.item()}
            if not math.isfinite(line["total"]):
                raise SimulationError(
                    f"The loss is {line['total']} at step {step}. Resume from the checkpoint with a smaller "
                    "learning_rate, or with precision=float32."
                )
            if processes.is_first:
                record.add(line)
                report(_line_text(line, step * config.batch_size, seconds))
        if step % config.validate_every == 0 or ends or step - first_step == stop_after:
            if processes.is_first:
                result = _validate(validation, network, average, config, device, precision)
                record.add({"step": step, "seconds": round(seconds, 1), "validation": result})
                report(f"step {step}: {_result_text(result)}")
                state = {
                    "network": network.state_dict(),
                    "optimizer": optimizer.state_dict(),
                    "average": average.values,
                    "step": step,
                    "seconds": seconds,
                }
                write_checkpoint(out, state)
                _save_weights(average, out)
                record.write_card(
                    _card(config, readers, parameters, step, seconds, device, precision, processes, result)
                )
                if config.pictures:
                    with _averaged(network, average):
                        validation.draw(network, out / f"validation-{step:07d}.png")
                trained.train()
            processes.wait()
    report(f"{step} steps in {seconds / 60:.1f} minutes. The weights are in '{out / WEIGHTS}'.")
    return _card(config, readers, parameters, step, seconds, device, precision, processes, result)


def _say_nothing(text: str) -> None:
    """For the processes that are not the first."""


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
    return readers


def _parameter_groups(network: GarmentSewerNetwork, config: SewerConfig) -> list[dict[str, Any]]:
    """Weights decay, biases and norms do not; the encoder may have a rate of its own."""
    groups: dict[tuple[bool, bool], list[torch.nn.Parameter]] = {}
    for name, parameter in network.named_parameters():
        if not parameter.requires_grad:
            continue
        groups.setdefault((parameter.ndim > 1, name.startswith("dpt.")), []).append(parameter)
    return [
        {
            "params": parameters,
            "weight_decay": config.weight_decay if decays else 0.0,
            "factor": config.encoder_rate if encoder else 1.0,
        }
        for (decays, encoder), parameters in groups.items()
    ]


def _precision(config: SewerConfig, device: torch.device) -> str:
    if config.precision != "auto":
        return config.precision
    if device.type == "cuda":
        return "bfloat16" if torch.cuda.is_bf16_supported() else "float32"
    # Without instructions of its own for it, a CPU is slower in bfloat16.
    return "bfloat16" if torch.ops.mkldnn._is_mkldnn_bf16_supported() else "float32"


def _autocast(device: torch.device, precision: str) -> contextlib.AbstractContextManager[Any]:
    return torch.autocast(device.type, torch.bfloat16, enabled=precision == "bfloat16")


@contextlib.contextmanager
def _averaged(network: GarmentSewerNetwork, average: MovingAverage) -> Any:
    """The network with the averaged weights, for as long as this lasts."""
    own = {name: value.detach().clone() for name, value in network.state_dict().items()}
    network.load_state_dict(average.values)
    network.eval()
    try:
        yield
    finally:
        network.load_state_dict(own)


def _validate(
    validation: Validation,
    network: GarmentSewerNetwork,
    average: MovingAverage,
    config: SewerConfig,
    device: torch.device,
    precision: str,
) -> dict[str, Any]:
    with _averaged(network, average), _autocast(device, precision):
        return validation.measure(network)


def _save_weights(average: MovingAverage, out: Path) -> None:
    from safetensors.torch import save

    from swifttailor.data.shard_file import write_durably

    write_durably(out / WEIGHTS, save({k: v.contiguous().cpu() for k, v in average.values.items()}))


def _card(
    config: SewerConfig,
    readers: dict[str, SplitReader],
    parameters: int,
    step: int,
    seconds: float,
    device: torch.device,
    precision: str,
    processes: Processes,
    result: dict[str, Any],
) -> dict[str, Any]:
    name = torch.cuda.get_device_name(device) if device.type == "cuda" else f"{os.cpu_count()} cores"
    return {
        "model": "GarmentSewer",
        "parameters": parameters,
        "config": config_values(config),
        "data": {k: _data_card(r) for k, r in readers.items()},
        "training": {
            "steps": step,
            "garments_seen": step * config.batch_size,
            "minutes": round(seconds / 60, 2),
            "device": f"{device.type}, {name}",
            "processes": processes.count,
            "threads": torch.get_num_threads(),
            "precision": precision,
        },
        "validation": result,
        "versions": versions(),
    }


def _data_card(reader: SplitReader) -> dict[str, Any]:
    from hashlib import sha256

    checksums = "".join(shard.sha256 for shard in reader.index.shards)
    return {"garments": len(reader), "shards_sha256": sha256(checksums.encode()).hexdigest()}


def _line_text(line: dict[str, Any], seen: int, seconds: float) -> str:
    parts = [f"{k} {v:.4g}" for k, v in line.items() if k not in ("step", "seconds", "rate")]
    return f"step {line['step']} ({seen / max(seconds, 1e-9):.1f} garments/s): {', '.join(parts)}"


def _result_text(result: dict[str, Any]) -> str:
    kinds = ", ".join(f"{kind} {r['mean']:.2f}" for kind, r in result.get("kinds", {}).items())
    return (
        f"validation {result['mean']:.2f} cm (median {result['median']:.2f}; {kinds}), "
        f"seam gap {result['seam_gap']:.2f} cm, inside {result['inside']:.1%}"
    )

"""The state of a training on the disk: whole or not at all, and read back without running anything in it."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import torch
from torch import Tensor

from swifttailor.atomic_files import write_atomically
from swifttailor.errors import InputError
from swifttailor.training.run_record import CHECKPOINT

_LONGEST_REASON = 200
"""Characters: torch explains at length how one might read a damaged file after all."""


class MovingAverage:
    """Exponential moving average of a network's weights, in float32; counters are the last ones."""

    def __init__(self, weights: dict[str, Tensor], decay: float) -> None:
        self.decay = decay
        self.values = {k: v.detach().clone() for k, v in weights.items()}

    @torch.no_grad()
    def update(self, weights: dict[str, Tensor], step: int) -> None:
        """Takes in the weights after an optimiser step, from 0; the first steps count for more."""
        decay = min(self.decay, (1 + step) / (10 + step))
        for name, value in weights.items():
            kept = self.values[name]
            if kept.is_floating_point():
                kept.lerp_(value.to(kept.dtype), 1 - decay)
            else:
                kept.copy_(value)


def write_checkpoint(folder: Path, state: dict[str, Any]) -> Path:
    """Writes tensors and plain values.

    Raises:
        InputError: The folder cannot be written; the checkpoint before stays.
    """
    return write_atomically(
        folder / CHECKPOINT, lambda temporary: torch.save(state, temporary), overwrite=True
    )


def read_checkpoint(folder: Path, device: torch.device, expected: Collection[str]) -> dict[str, Any]:
    """Reads what `write_checkpoint` wrote.

    Args:
        folder: Of the training.
        device: Where tensors go.
        expected: Names of the values it must hold.

    Raises:
        InputError: It is missing, damaged or of another version.
    """
    path = folder / CHECKPOINT
    if not path.is_file():
        raise InputError(f"'{folder}' has no {CHECKPOINT} to go on from. Start without --resume.")
    try:
        _require_checksums(path)
        state = torch.load(path, map_location=device, weights_only=True)
    except Exception as error:  # torch raises a dozen kinds for a damaged file
        reason = " ".join(str(error).split())[:_LONGEST_REASON]
        raise InputError(
            f"'{path}' is damaged ({type(error).__name__}: {reason}). "
            "Start again without --resume, in another folder."
        ) from error
    missing = sorted(set(expected) - set(state if isinstance(state, dict) else ()))
    if missing:
        raise InputError(
            f"'{path}' was written by another version: it has no {', '.join(missing)}. "
            "Go on with that version, or start again without --resume, in another folder."
        )
    return state


def _require_checksums(path: Path) -> None:
    """Refuses a file that is not as it was written: torch writes checksums, and does not look at them.

    Raises:
        ValueError: A part of it has changed.
        BadZipFile, OSError: It is cut short, or no archive at all.
    """
    with ZipFile(path) as archive:
        if (name := archive.testzip()) is not None:
            raise ValueError(f"the checksum of its part '{name}' is wrong")

"""Panel tensors of the patterns of a latent diffusion, made once and kept."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.errors import InputError, PatternError
from swifttailor.latent_diffusion import tensor_layout as at
from swifttailor.latent_diffusion.panel_tensor import tensor_of
from swifttailor.training.told_patterns import patterns_of, sha256

_KEPT = ("ids", "owner", "slot", "rows")


@dataclass(frozen=True, eq=False)
class TensorBank:
    """The panels that there are; of a panel tensor most is empty."""

    ids: NDArray[np.str_]
    """(N,) of the patterns."""
    owner: NDArray[np.int32]
    """(P,) number of the pattern of each panel, ascending."""
    slot: NDArray[np.int32]
    """(P,) its slot."""
    rows: NDArray[np.float32]
    """(P, `EDGES`, `NUMBERS`)."""

    def __len__(self) -> int:
        return len(self.ids)

    def tensor(self, number: int) -> Floats:
        """The whole panel tensor of a pattern."""
        tensor = np.zeros(at.SHAPE)
        mine = self.owner == number
        tensor[self.slot[mine]] = self.rows[mine]
        return tensor

    def of(self, ids: Sequence[str]) -> TensorBank:
        """The patterns of these ids, in their order; each must be there."""
        place = {str(id): number for number, id in enumerate(self.ids)}
        return self.chosen([place[id] for id in ids])

    def chosen(self, numbers: Sequence[int]) -> TensorBank:
        """Some of the patterns, in the order given."""
        first = np.searchsorted(self.owner, np.arange(len(self) + 1))
        parts = [np.arange(first[k], first[k + 1]) for k in numbers]
        panels = np.concatenate(parts) if parts else np.zeros(0, int)
        owner = np.repeat(np.arange(len(parts), dtype=np.int32), [len(part) for part in parts])
        ids = self.ids[np.asarray(numbers, int)]
        return TensorBank(ids, owner, self.slot[panels], self.rows[panels])

    @staticmethod
    def joined(banks: Sequence[TensorBank]) -> TensorBank:
        """All patterns of several banks."""
        starts = np.cumsum([0, *(len(bank) for bank in banks)])
        return TensorBank(
            np.concatenate([bank.ids for bank in banks]),
            np.concatenate([bank.owner + start for bank, start in zip(banks, starts[:-1], strict=True)]),
            np.concatenate([bank.slot for bank in banks]),
            np.concatenate([bank.rows for bank in banks]),
        )


def bank_of(path: Path, cache: Path | None = None) -> TensorBank:
    """Panel tensors of a file; patterns that do not fit one are left out, and said on stderr.

    Args:
        path: ``.jsonl.gz`` of patterns.
        cache: Folder that keeps them.

    Raises:
        InputError: None of the patterns fits.
    """
    kept = None if cache is None else cache / f"panel-tensors-{sha256(path)[:16]}.npz"
    if kept is not None and kept.is_file():
        with np.load(kept) as found:
            return TensorBank(*(found[name] for name in _KEPT))
    ids: list[str] = []
    owner: list[int] = []
    slots: list[int] = []
    rows: list[Floats] = []
    for id, _, pattern in patterns_of(path):
        try:
            tensor = tensor_of(pattern)
        except PatternError as error:
            sys.stderr.write(f"{id} is left out: {error}\n")
            continue
        there = np.flatnonzero(tensor[:, 0, at.THERE])
        owner += [len(ids)] * len(there)
        slots += there.tolist()
        rows += list(tensor[there].astype(np.float32))
        ids.append(id)
    if not ids:
        raise InputError(f"'{path}' holds no pattern that fits a panel tensor.")
    panels = np.stack(rows).astype(np.float32)
    bank = TensorBank(np.array(ids), np.array(owner, np.int32), np.array(slots, np.int32), panels)
    if kept is not None:
        kept.parent.mkdir(parents=True, exist_ok=True)
        arrays: dict[str, Any] = {name: getattr(bank, name) for name in _KEPT}
        np.savez_compressed(kept, **arrays)
    return bank

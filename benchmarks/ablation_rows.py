"""Small trainings that differ in one thing, each from several seeds; what is done is not trained again."""

from __future__ import annotations

import json
import os
import shutil
import statistics
import subprocess
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

DONE = "done"
"""File in the folder of a training that has ended."""


@dataclass(frozen=True)
class Row:
    """A row of a table of ablations: the same training from several seeds."""

    name: str
    cards: tuple[dict[str, Any], ...]
    """card.json of each seed that is done."""
    folders: tuple[Path, ...]
    """Where each was trained."""

    def mean(self, value: Callable[[dict[str, Any]], float], form: str) -> str:
        """Mean over the seeds of what is found in a card, with half its range where there are several."""
        return with_spread([value(card) for card in self.cards], form)


def with_spread(values: Sequence[float], form: str) -> str:
    """Mean of some values, with half of their range where there are several: ``2.41 ±0.03``."""
    mean = format(statistics.mean(values), form)
    return mean if len(values) == 1 else f"{mean} ±{format((max(values) - min(values)) / 2, form)}"


def train_rows(
    rows: Mapping[str, Sequence[str]],
    names: Iterable[str],
    seeds: Sequence[int],
    out: Path,
    command: Sequence[str | Path],
) -> None:
    """Trains every row from every seed that is not done yet, seed by seed.

    Args:
        rows: By name, values of the configuration that differ (``FIELD=VALUE``).
        names: Of the rows to train.
        seeds: To train each from.
        out: Folder that keeps a folder for each training.
        command: Of the training, without ``--out`` and ending with ``--set`` and values.
    """
    names = list(names)
    surroundings = os.environ | {"OMP_NUM_THREADS": "1"}
    for seed in seeds:
        for name in names:
            folder = folder_of(out, name, seed)
            if (folder / DONE).is_file():
                continue
            resume = ["--resume"] if (folder / "checkpoint.pt").is_file() else []
            if not resume and (folder / "config.json").is_file():
                shutil.rmtree(folder)  # stopped before its first checkpoint
            put = list(command).index("--set")
            given = [*command[:put], "--out", folder, *resume, *command[put:], f"seed={seed}", *rows[name]]
            subprocess.run([sys.executable, "-m", "swifttailor", *given], check=True, env=surroundings)
            (folder / DONE).touch()


def trained_rows(names: Iterable[str], out: Path) -> list[Row]:
    """The rows of which at least one seed is done, in their order."""
    found = []
    for name in names:
        folders = sorted(f for f in out.glob(f"{name}-seed-*") if (f / DONE).is_file())
        folders = [f for f in folders if f.name.rpartition("-seed-")[0] == name]
        if folders:
            cards = tuple(json.loads((f / "card.json").read_text()) for f in folders)
            found.append(Row(name, cards, tuple(folders)))
    return found


def folder_of(out: Path, name: str, seed: int) -> Path:
    """Where a row is trained from a seed."""
    return out / f"{name}-seed-{seed}"


def as_markdown(heads: Sequence[str], lines: Iterable[Sequence[str]]) -> str:
    """A table; the first column is left-aligned, the others right."""
    rule = ["---", *["---:"] * (len(heads) - 1)]
    return "\n".join("| " + " | ".join(line) + " |" for line in (heads, rule, *lines))

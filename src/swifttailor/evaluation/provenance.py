"""What stands above every table: data, choice of samples, code and machine."""

from __future__ import annotations

import os
import platform
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from swifttailor.data.builder.code_version import code_version
from swifttailor.data.reader import SplitReader
from swifttailor.errors import InputError

CPU_LIST = Path("/proc/cpuinfo")


def choose_samples(reader: SplitReader, limit: int | None, seed: int) -> list[int]:
    """Numbers of the samples to evaluate: all, or `limit` of them by lot, in ascending order.

    A larger limit keeps those of a smaller one.

    Raises:
        InputError: The split is empty, or the limit is not a number of samples.
    """
    if not len(reader):
        raise InputError(f"The split in '{reader.folder}' holds no samples yet. Build it first.")
    if limit is not None and limit < 1:
        raise InputError(f"--limit is {limit}; a whole number of at least 1 is accepted.")
    return sorted(int(k) for k in reader.order(seed)[:limit])


def provenance(reader: SplitReader, numbers: Sequence[int], seed: int) -> dict[str, Any]:
    """Where numbers come from, as JSON values; without dates and paths."""
    code = code_version()
    return {
        "data": reader.folder.resolve().parent.name,
        "split": reader.index.split,
        "samples": len(numbers),
        "of": len(reader),
        "split_complete": reader.index.complete,
        "seed": seed,
        "drapes": {k: v for k, v in reader.index.settings.items() if k not in ("version", "shard_size")},
        "version": code["version"],
        "commit": code["commit"],
        "drapes_of_this_code": {b["code"] for b in reader.index.built_with} == {code["code"]},
        "machine": machine(),
    }


def provenance_lines(about: dict[str, Any]) -> str:
    """The same for people."""
    other = "" if about["drapes_of_this_code"] else " (the drapes were made by other code)"
    part = "" if about["split_complete"] else ", which is not built to its end"
    return (
        f"data {about['data']}, split {about['split']}{part}: {about['samples']} of {about['of']} garments, "
        f"seed {about['seed']}\n"
        f"swifttailor {about['version']}, commit {about['commit'] or 'unknown'}{other}\n"
        f"{about['machine']}\n"
    )


def machine() -> str:
    """Processor, cores that may be used, and Python."""
    names = []
    if CPU_LIST.is_file():
        lines = CPU_LIST.read_text(errors="replace").splitlines()
        names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    processor = names[0] if names else platform.processor() or platform.machine()
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return f"{processor}, {cores} cores, Python {platform.python_version()}"

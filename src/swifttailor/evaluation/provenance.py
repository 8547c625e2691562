"""What stands above every table: data, choice of samples, code and machine."""

from __future__ import annotations

import hashlib
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
    return {
        "data": reader.folder.resolve().parent.name,
        "split": reader.index.split,
        "samples": len(numbers),
        "of": len(reader),
        "split_complete": reader.index.complete,
        "seed": seed,
        "drapes": {k: v for k, v in reader.index.settings.items() if k not in ("version", "shard_size")},
        "drapes_of_this_code": {b["code"] for b in reader.index.built_with} == {code_version()["code"]},
    } | code_and_machine()


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


def code_and_machine() -> dict[str, Any]:
    """Version and commit of the code, and what it runs on, as JSON values."""
    code = code_version()
    return {"version": code["version"], "commit": code["commit"], "machine": machine()}


def file_identity(path: Path) -> dict[str, str]:
    """Name and checksum of a file, as JSON values.

    Raises:
        InputError: It cannot be read.
    """
    try:
        with path.open("rb") as stream:
            return {"file": path.name, "sha256": hashlib.file_digest(stream, "sha256").hexdigest()}
    except OSError as error:
        raise InputError(f"Cannot read '{path}': {error.strerror or error}.") from error


def machine() -> str:
    """Processor, cores that may be used, and Python."""
    names = []
    if CPU_LIST.is_file():
        lines = CPU_LIST.read_text(errors="replace").splitlines()
        names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    processor = names[0] if names else platform.processor() or platform.machine()
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return f"{processor}, {cores} cores, Python {platform.python_version()}"

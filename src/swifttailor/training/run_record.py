"""What a training leaves behind beside its weights: configuration, measurements, card."""

from __future__ import annotations

import functools
import hashlib
import importlib.metadata
import json
import os
import platform
import shlex
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from swifttailor.atomic_files import write_text
from swifttailor.data.builder.code_version import code_version
from swifttailor.data.reader import SplitReader
from swifttailor.errors import InputError
from swifttailor.output_folder import FolderLock
from swifttailor.pattern.pattern_list import pattern_files

CONFIG, METRICS, CARD, WEIGHTS = "config.json", "metrics.jsonl", "card.json", "weights.safetensors"
CHECKPOINT = "checkpoint.pt"
PICTURES = "validation-*.png"
_PACKAGES = ("swifttailor", "torch", "transformers", "numpy")


class RunRecord:
    """The folder of a training."""

    def __init__(self, folder: Path | str) -> None:
        self.folder = Path(folder)
        self._lock: FolderLock | None = None

    def start(self, config: dict[str, Any], *, resume: bool) -> None:
        """Notes the configuration, or compares it with that of the run that goes on.

        Raises:
            InputError: There is a training in the folder already, or one with another configuration, or other
                files that it would replace; or another process trains there.
        """
        try:
            self._lock = FolderLock(self.folder, "training")
        except OSError as error:
            raise InputError(
                f"Cannot write to '{self.folder}': {error.strerror or error}. Choose another --out."
            ) from error
        try:
            self._start(config, resume=resume)
        except BaseException:
            self.end()
            raise

    def end(self) -> None:
        """Lets other processes train in the folder."""
        if self._lock is not None:
            self._lock.release()
            self._lock = None

    def _start(self, config: dict[str, Any], *, resume: bool) -> None:
        path = self.folder / CONFIG
        if resume:
            try:
                before = json.loads(path.read_text(encoding="utf-8"))
            except (OSError, ValueError, RecursionError) as error:
                raise InputError(
                    f"There is no training in '{self.folder}' to go on with: {error}."
                ) from error
            if before != config:
                raise InputError(
                    f"'{self.folder}' was started with other values ({_differences(before, config)}). "
                    "Give the same one, or start anew in another folder."
                )
            return
        if path.exists():
            raise InputError(
                f"There is a training in '{self.folder}' already. Add --resume to go on with it, "
                "or choose another --out."
            )
        written = (METRICS, CARD, WEIGHTS, CHECKPOINT)
        theirs = [self.folder / name for name in written if os.path.lexists(self.folder / name)]
        for other in (*theirs, *self.folder.glob(PICTURES)):
            raise InputError(
                f"'{other}' would be replaced in the course of the training. Choose another --out."
            )
        write_text(path, json.dumps(config, indent=1) + "\n")

    def add(self, line: dict[str, Any]) -> None:
        """Appends a measurement to metrics.jsonl."""
        with (self.folder / METRICS).open("a", encoding="utf-8") as stream:
            stream.write(json.dumps(line) + "\n")

    def forget_after(self, step: int) -> None:
        """Drops measurements of steps that an interrupted training will do again."""
        kept = [line for line in self.lines() if line["step"] <= step]
        write_text(self.folder / METRICS, "".join(json.dumps(line) + "\n" for line in kept), overwrite=True)

    def lines(self) -> list[dict[str, Any]]:
        """All measurements, up to the first line that is none: the last may be cut short by a crash."""
        path = self.folder / METRICS
        if not path.is_file():
            return []
        found = []
        for text in path.read_bytes().splitlines():
            try:
                line = json.loads(text)
            except (ValueError, RecursionError):
                break
            if not isinstance(line, dict) or not isinstance(line.get("step"), int):
                break
            found.append(line)
        return found

    def write_card(self, card: dict[str, Any]) -> None:
        """Writes card.json: what the weights are and how they came about."""
        write_text(self.folder / CARD, json.dumps(card, indent=1, allow_nan=False) + "\n", overwrite=True)


@functools.cache
def versions() -> dict[str, str]:
    """Of what the training runs on, as it was when this was first called; with the commit in a checkout."""
    found = {name: importlib.metadata.version(name) for name in _PACKAGES if _is_installed(name)}
    commit = code_version()["commit"]
    return {"python": platform.python_version()} | found | ({"commit": commit} if commit else {})


def command() -> str:
    """The command line of this process, without ``--resume``; empty where swifttailor was not the program."""
    program = Path(sys.argv[0])
    if program.name not in ("swifttailor", "__main__.py"):
        return ""
    return shlex.join(["swifttailor", *(a for a in sys.argv[1:] if a != "--resume")])


def file_checksums(sources: Iterable[Path]) -> dict[str, str]:
    """The sha256 of files, by name; of a folder, that of its .json files' names and checksums.

    Raises:
        InputError: One cannot be read.
    """
    found: dict[str, str] = {}
    for source in sources:
        name = str(source) if source.name in found else source.name
        try:
            if source.is_dir():
                parts = [(p.name, _sha256(p)) for p in pattern_files(source)]
                found[name] = hashlib.sha256(json.dumps(parts).encode()).hexdigest()
            else:
                found[name] = _sha256(source)
        except OSError as error:
            raise InputError(f"Cannot read '{source}': {error.strerror or error}.") from error
    return found


def split_card(reader: SplitReader) -> dict[str, Any]:
    """For the card: how many garments there are in a split, and which."""
    checksums = "".join(shard.sha256 for shard in reader.index.shards)
    return {"garments": len(reader), "shards_sha256": hashlib.sha256(checksums.encode()).hexdigest()}


def _sha256(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _is_installed(name: str) -> bool:
    try:
        importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:  # run from a source tree
        return False
    return True


def _differences(before: Any, now: Any, place: str = "") -> str:
    if isinstance(before, dict) and isinstance(now, dict):
        found = [
            _differences(before.get(k), now.get(k), f"{place}.{k}" if place else k)
            for k in sorted(before.keys() | now.keys())
            if before.get(k) != now.get(k)
        ]
        return "; ".join(found)
    return f"{place}: {before!r} before, {now!r} now"

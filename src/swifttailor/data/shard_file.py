"""Shards: a few hundred samples in one safetensors file.

Two arrays of bytes, `documents` and `positions`, hold the samples one after the other; `document_ends` and
`position_ends` say where each ends.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.atomic_files import write_atomically
from swifttailor.data.sample import StoredSample
from swifttailor.errors import InputError

FORMAT = "swifttailor shard 1"
_PARTS, _ENDS = ("documents", "positions"), ("document_ends", "position_ends")


def write_shard(folder: Path, name: str, samples: Sequence[StoredSample]) -> tuple[Path, str]:
    """Writes a shard whose file name ends with the start of its checksum.

    Args:
        folder: Of the split.
        name: Start of the file's name.
        samples: At least one.

    Returns:
        The file and its sha256.

    Raises:
        InputError: It cannot be written; then there is no such file.
    """
    data = _pack(samples)
    checksum = hashlib.sha256(data).hexdigest()
    path = folder / f"{name}-{checksum[:12]}.safetensors"
    return write_durably(path, data), checksum


def write_durably(path: Path, data: bytes) -> Path:
    """Writes a file, over one that is there, so that it is on the disk and not only on its way there."""

    def write(temporary: Path) -> None:
        with temporary.open("wb") as stream:
            stream.write(data)
            stream.flush()
            os.fsync(stream.fileno())

    return write_atomically(path, write, overwrite=True)


def pack_sample(sample: StoredSample) -> bytes:
    """A shard of one: what a worker hands back."""
    return _pack([sample])


def unpack_sample(path: Path) -> StoredSample:
    """Reads what `pack_sample` gave from a file.

    Raises:
        InputError: It is missing or damaged.
    """
    return ShardFile(path)[0]


def _pack(samples: Sequence[StoredSample]) -> bytes:
    from safetensors.numpy import save

    arrays: dict[str, Any] = {}
    for part, ends, blobs in (
        ("documents", "document_ends", [s.document for s in samples]),
        ("positions", "position_ends", [s.positions for s in samples]),
    ):
        arrays[part] = np.frombuffer(b"".join(blobs), dtype=np.uint8)
        arrays[ends] = np.cumsum([len(b) for b in blobs], dtype=np.int64)
    return save(arrays, metadata={"format": FORMAT})


class ShardFile:
    """Samples of a shard, read when asked for. Can be sent to other processes."""

    def __init__(self, path: Path, checksum: str = "") -> None:
        """Opens a shard.

        Args:
            path: File.
            checksum: Its sha256; not compared when empty.

        Raises:
            InputError: It is missing, damaged, or another file.
        """
        self.path = path
        try:
            if checksum:
                require_checksum(path, checksum)
            elif not path.is_file():
                raise FileNotFoundError(2, "there is no such file")
            self._starts = self._read_starts()
        except OSError as error:
            raise InputError(f"Cannot read the shard '{path}': {error.strerror or error}.") from error

    def __len__(self) -> int:
        return len(self._starts[0]) - 1

    def __getitem__(self, k: int) -> StoredSample:
        if not 0 <= k < len(self):
            raise IndexError(f"'{self.path.name}' holds {len(self)} samples, there is no number {k}.")
        document, positions = (
            self._file.get_slice(part)[int(starts[k]) : int(starts[k + 1])].tobytes()
            for part, starts in zip(_PARTS, self._starts, strict=True)
        )
        return StoredSample(document, positions)

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name != "_file"}

    @cached_property
    def _file(self) -> Any:
        from safetensors import SafetensorError, safe_open

        try:
            opened = safe_open(self.path, framework="numpy")
            if (opened.metadata() or {}).get("format") != FORMAT:
                raise InputError(f"'{self.path}' is no shard of this version ('{FORMAT}').")
            return opened
        except SafetensorError as error:
            raise InputError(
                f"The shard '{self.path}' is damaged: {error}. Build or copy it again."
            ) from error

    def _read_starts(self) -> list[np.ndarray]:
        """Where the samples start and the last one ends, in each part."""
        from safetensors import SafetensorError

        try:
            ends = [self._file.get_tensor(name) for name in _ENDS]
            parts = [self._file.get_slice(part) for part in _PARTS]
            lengths = [part.get_shape()[0] for part in parts if part.get_dtype() == "U8"]
            sound = (
                all(e.ndim == 1 and e.dtype == np.int64 for e in ends)
                and len(ends[0]) == len(ends[1]) >= 1
                and all(
                    e[0] > 0 and (np.diff(e) > 0).all() and e[-1] == length
                    for e, length in zip(ends, lengths, strict=True)
                )
            )
        except (SafetensorError, ValueError, IndexError) as error:
            raise InputError(f"The shard '{self.path}' is damaged: {error}.") from error
        if not sound:
            raise InputError(f"The shard '{self.path}' is damaged: its parts do not fit each other.")
        return [np.concatenate([[0], e]) for e in ends]


def require_checksum(path: Path, checksum: str) -> None:
    """Compares a file's sha256.

    Raises:
        InputError: It differs.
        OSError: The file cannot be read.
    """
    with path.open("rb") as stream:
        found = hashlib.file_digest(stream, "sha256").hexdigest()
    if found != checksum:
        raise InputError(
            f"'{path}' is damaged or another file: its checksum is {found[:12]}..., the index says "
            f"{checksum[:12]}... Copy it again from where it came, or delete it and build again."
        )

"""Arrays computed once for every sample and then read from memory-mapped files."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.data.reader import SplitReader
from swifttailor.data.sample import Sample
from swifttailor.data.shard_file import write_durably
from swifttailor.errors import InputError, SimulationError, SwiftTailorError

Arrays = dict[str, np.ndarray[Any, np.dtype[Any]]]
Compute = Callable[[Sample], Arrays]
ENDS = ".ends"
_TIME_LIMIT = 3600.0


class ArrayCache:
    """What `compute` gives for each sample of a split, kept in one file per shard.

    The files are named after the shard's checksum: other data never get old arrays. `name` must change when
    `compute` does.
    """

    def __init__(self, reader: SplitReader, folder: Path | str, name: str, compute: Compute) -> None:
        """Opens a cache; nothing is computed yet.

        Args:
            reader: The split.
            folder: For the files; made when missing. Several caches may share it.
            name: Of what is computed, for the files' names.
            compute: Importable by name, or a `functools.partial` of such a function. All samples must give
                the same names, types and shapes but for the first axis.
        """
        self.reader = reader
        self.folder = Path(folder)
        self._name = name
        self._compute = compute
        self._open: dict[int, Any] = {}
        self._ends: dict[int, dict[str, np.ndarray]] = {}

    def prepare(self, *, workers: int = 1) -> Iterator[tuple[int, int]]:
        """Computes what is missing; may be stopped and started again.

        Args:
            workers: Processes; 1 computes in this one.

        Yields:
            How many shards are done, and of how many.

        Raises:
            InputError: A sample cannot be read, or a file not written.
            SimulationError: A worker died.
        """
        from swifttailor.workers import run_tasks

        total = len(self.reader.index.shards)
        missing = [k for k in range(total) if self.reader.index.shards[k].file and not self.path(k).is_file()]
        done = total - len(missing)
        tasks = [_Part(self.reader.folder, k, self.path(k), self._compute) for k in missing]
        if not tasks:
            return
        here: Iterable[str] = (_fill(task) for task in tasks)
        if workers > 1:
            here = (
                o.lost or o.result for o in run_tasks(_fill, tasks, workers=workers, time_limit=_TIME_LIMIT)
            )
        for trouble in here:
            if trouble:
                raise (InputError if trouble.startswith("'") else SimulationError)(trouble)
            done += 1
            yield done, total

    def __len__(self) -> int:
        return len(self.reader)

    def __getitem__(self, k: int) -> Arrays:
        """The arrays of sample number k, read-only; computes its whole shard when that was not prepared.

        Raises:
            InputError: A sample cannot be read, or a file not written or read.
        """
        number, place = self.reader.place(k)
        if number not in self._open:
            self._open_file(number)
        arrays = {}
        for name, ends in self._ends[number].items():
            first = int(ends[place - 1]) if place else 0
            arrays[name] = self._open[number].get_slice(name)[first : int(ends[place])]
        return arrays

    def path(self, number: int) -> Path:
        """The file for a shard."""
        checksum = self.reader.index.shards[number].sha256
        return self.folder / f"{self._name}-{checksum[:16]}.safetensors"

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__ | {"_open": {}, "_ends": {}}

    def _open_file(self, number: int) -> None:
        from safetensors import SafetensorError, safe_open

        path = self.path(number)
        if not path.is_file():
            trouble = _fill(_Part(self.reader.folder, number, path, self._compute))
            if trouble:
                raise InputError(trouble)
        try:
            opened = safe_open(path, framework="numpy")
            names = [n for n in opened.keys() if not n.endswith(ENDS)]
            self._ends[number] = {n: np.asarray(opened.get_tensor(n + ENDS)) for n in names}
        except (SafetensorError, OSError) as error:
            raise InputError(f"'{path}' is damaged: {error}. Delete it, it is made again.") from error
        self._open[number] = opened


def name_with_code(name: str, *rooms: str, without: Sequence[str] = ()) -> str:
    """A cache's name with a checksum of the rooms or modules whose code decides what is in it.

    Args:
        name: Of what is in it.
        rooms: Paths in the package.
        without: Rooms or modules in them that have no part in it.
    """
    import swifttailor

    root = Path(swifttailor.__file__).parent
    digest = hashlib.sha256()
    left_out = [root / room for room in without]
    for room in rooms:
        place = root / room
        if not place.exists():
            raise FileNotFoundError(f"{place}: a cache is named after code that is not there.")
        for path in [place] if place.is_file() else sorted(place.rglob("*.py")):
            if any(path.is_relative_to(other) for other in left_out):
                continue
            digest.update(path.name.encode() + b"\0" + path.read_bytes() + b"\0")
    return f"{name}-{digest.hexdigest()[:8]}"


@dataclass(frozen=True)
class _Part:
    split: Path
    number: int
    path: Path
    compute: Compute


def _fill(part: _Part) -> str:
    """Computes the file of a shard; returns what went wrong, or nothing."""
    from safetensors.numpy import save

    try:
        reader = SplitReader(part.split)
        rows = [part.compute(reader[k]) for k in reader.numbers_in(part.number)]
        arrays: Arrays = {}
        for name in rows[0]:
            arrays[name] = np.ascontiguousarray(np.concatenate([row[name] for row in rows]))
            arrays[name + ENDS] = np.cumsum([len(row[name]) for row in rows], dtype=np.int64)
        write_durably(part.path, save(arrays))
    except SwiftTailorError as error:
        return f"'{part.path}' cannot be made: {error}"
    return ""

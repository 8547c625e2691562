"""Reading a split: any sample at random, all in order, or all shuffled by a seed."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from pathlib import Path

import numpy as np

from swifttailor.data.index import SplitIndex, read_index
from swifttailor.data.sample import Sample, StoredSample, load_sample
from swifttailor.data.shard_file import ShardFile
from swifttailor.errors import InputError


class SplitReader:
    """The samples of a split, read when asked for; checksums are compared when a shard is first opened.

    Only the index is kept in memory. Readers can be sent to other processes.
    """

    def __init__(self, folder: Path | str) -> None:
        """Opens a split.

        Args:
            folder: Of the split: DIR/train, not DIR.

        Raises:
            InputError: It is no split, or its index is damaged.
        """
        self.folder = Path(folder)
        self.index: SplitIndex = read_index(self.folder)
        self.ids: tuple[str, ...] = tuple(id for s in self.index.shards for id in s.ids)
        """Of the samples, in order."""
        self._ends = np.cumsum([len(s.ids) for s in self.index.shards], dtype=np.int64)
        self._files: dict[int, ShardFile] = {}

    def __len__(self) -> int:
        return len(self.ids)

    def __getitem__(self, k: int) -> Sample:
        """Sample number k.

        Raises:
            IndexError: There is no such number.
            InputError: Its shard is missing or damaged.
        """
        number, place = self.place(k)
        shard = self.index.shards[number]
        file = self._file(number)
        try:
            sample = load_sample(file[place])
        except InputError as error:
            raise InputError(f"'{file.path}', sample {place}: {error}") from error
        if sample.id != shard.ids[place]:
            raise InputError(
                f"'{file.path}' holds '{sample.id}' where the index says '{shard.ids[place]}'. "
                "Copy both again from where they came."
            )
        return sample

    def stored(self, k: int) -> StoredSample:
        """Sample number k as it lies in its shard."""
        number, place = self.place(k)
        return self._file(number)[place]

    def __iter__(self) -> Iterator[Sample]:
        for k in range(len(self)):
            yield self[k]

    def place(self, k: int) -> tuple[int, int]:
        """The shard of sample number k and its place in it.

        Raises:
            IndexError: There is no such number.
        """
        if not 0 <= k < len(self):
            raise IndexError(
                f"The split '{self.index.split}' has {len(self)} samples, there is no number {k}."
            )
        number = int(np.searchsorted(self._ends, k, side="right"))
        return number, k - self.numbers_in(number).start

    def numbers_in(self, shard: int) -> range:
        """The numbers of the samples in a shard."""
        end = int(self._ends[shard])
        return range(end - len(self.index.shards[shard].ids), end)

    def sample(self, id: str) -> Sample:
        """The sample of that id.

        Raises:
            InputError: There is none.
        """
        if id not in self._places:
            raise InputError(f"The split '{self.index.split}' in '{self.folder}' has no sample '{id}'.")
        return self[self._places[id]]

    def order(self, seed: int, epoch: int = 0) -> np.ndarray:
        """(n,) numbers of all samples, shuffled; every epoch has its own order."""
        return np.random.default_rng([seed, epoch]).permutation(len(self))

    def shuffled(self, seed: int, epoch: int = 0, *, part: int = 0, parts: int = 1) -> Iterator[Sample]:
        """Goes through the samples in the order of `order`.

        Args:
            seed: Of the shuffle.
            epoch: Pass over the data.
            part: Which of `parts` equal shares to go through, for several processes.
            parts: Number of shares; together they give every sample once.
        """
        for k in self.order(seed, epoch)[part::parts]:
            yield self[int(k)]

    @cached_property
    def _places(self) -> dict[str, int]:
        return {id: k for k, id in enumerate(self.ids)}

    def _file(self, number: int) -> ShardFile:
        if number not in self._files:
            shard = self.index.shards[number]
            file = ShardFile(self.folder / shard.file, shard.sha256)
            if len(file) != len(shard.ids):
                raise InputError(
                    f"'{file.path}' holds {len(file)} samples, the index says {len(shard.ids)}. "
                    "Copy both again from where they came."
                )
            self._files[number] = file
        return self._files[number]

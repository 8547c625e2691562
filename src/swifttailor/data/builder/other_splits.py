"""The other splits of a data set, with which a split shares neither ids nor patterns."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from swifttailor.data.index import INDEX, SplitIndex, read_index
from swifttailor.data.sample import load_sample
from swifttailor.data.shard_file import ShardFile
from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.pattern.digest import pattern_digest
from swifttailor.pattern.pattern_list import BatchPattern


@dataclass
class OtherSplits:
    """What they hold."""

    ids: dict[str, str] = field(default_factory=dict)
    """The split of every pattern, rejected ones included, by id."""
    patterns: dict[str, tuple[str, str]] = field(default_factory=dict)
    """Id and split of every accepted pattern, by its checksum."""

    @staticmethod
    def read(dataset: Path, split: str) -> OtherSplits:
        """All splits of a data set but one.

        Raises:
            InputError: A shard cannot be read.
        """
        found = OtherSplits()
        for path in sorted(dataset.glob(f"*/{INDEX}")):
            if path.parent.name != split:
                found._add(path.parent, read_index(path.parent))
        found.ids = {id: name for id, name in found.ids.items() if not id.startswith("#")}
        return found

    def require_new(self, pattern: BatchPattern) -> None:
        """Refuses a pattern whose id is taken.

        Raises:
            InputError: It is.
        """
        if pattern.id in self.ids:
            raise InputError(
                f"The pattern '{pattern.id}' ({pattern.source}) is in the split "
                f"'{self.ids[pattern.id]}' of the same data set already. Splits must not share patterns."
            )

    def twin_of(self, pattern: BatchPattern) -> tuple[str, str] | None:
        """Id and split of the same pattern under another id; None where there is none, or no pattern."""
        if not self.patterns or pattern.error:
            return None
        try:
            return self.patterns.get(pattern_digest(pattern.read().pattern))
        except SwiftTailorError:
            return None  # whoever drapes it says why

    def _add(self, folder: Path, index: SplitIndex) -> None:
        for shard in index.shards:
            self.ids |= dict.fromkeys([*shard.ids, *(r.id for r in shard.rejected)], index.split)
            if shard.file:
                stored = ShardFile(folder / shard.file, shard.sha256)
                for k, id in enumerate(shard.ids):
                    self.patterns[pattern_digest(load_sample(stored[k]).pattern)] = id, index.split

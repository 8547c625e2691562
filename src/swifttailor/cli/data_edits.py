"""``swifttailor data edits``: pairs of patterns with an instruction that leads from one to the other."""

from __future__ import annotations

import gzip
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from swifttailor.cli.postponed_imports import tyro

MAX_COUNT = 46
"""Topics of `recutting.random_cuts`."""


@dataclass(frozen=True, kw_only=True)
class DataEdits:
    """Recut patterns and write how to ask for it, in both directions.

    Every edited pattern is checked, and fulfils its instruction. One JSON object a line: {"id": text, "base":
    id, "source": what was done, "instruction": text, "changes": [...], "pattern": before, "edited": after}.
    """

    source: Annotated[tyro.conf.Positional[Path], tyro.conf.arg(metavar="SOURCE")]
    """A data set, a split of one, a .jsonl or .jsonl.gz file, a folder of .json files, or a pattern."""
    out: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """File to write, .jsonl or .jsonl.gz. Default: a new one in the current folder, named after SOURCE."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace the file where there is one."""
    count: Annotated[int, tyro.conf.arg(metavar="N")] = 2
    """Topics to recut each pattern about."""
    designs: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Edited versions made elsewhere, one {"id": ..., "base": ..., "pattern": ...} a line, whose bases are
    in SOURCE; their pairs are written too."""
    versions: bool = False
    """Write the recut patterns alone, one {"id": ..., "base": ..., "pattern": ...} a line: more patterns to
    drape, to draw and to learn from."""
    seed: int = 0
    """Decides what is recut, amounts and words."""

    def run(self) -> int:
        """Writes the pairs and returns the exit code: 0, or 1 where a pattern could not be read.

        Raises:
            SwiftTailorError: A source cannot be read.
        """
        from swifttailor.atomic_files import require_free, write_atomically
        from swifttailor.cli.option_checks import in_range
        from swifttailor.cli.results import new_place
        from swifttailor.errors import InputError

        in_range("--count", self.count, 0, MAX_COUNT)
        in_range("--seed", self.seed, 0, 2**31)
        if self.versions and self.designs is not None:
            raise InputError("--versions writes recut patterns, and --designs are patterns already.")
        out = self.out or new_place(f"{self.source.name.split('.')[0]}-edits", ".jsonl.gz")
        if not out.name.lower().endswith((".jsonl", ".jsonl.gz")):
            raise InputError(f"--out is '{out}'; a file that ends in .jsonl or .jsonl.gz is written.")
        require_free(out, overwrite=self.overwrite)
        counts = [0, 0]

        def write(path: Path) -> None:
            compressed = out.name.lower().endswith(".gz")
            # Without a time in its header the file depends on its content alone.
            with path.open("wb") as raw, gzip.GzipFile("", "wb", 6, raw, 0) if compressed else raw as stream:
                for line, problem in self._lines():
                    sys.stderr.write(problem)
                    stream.write(line)
                    counts[0] += bool(line)
                    counts[1] += bool(problem)

        write_atomically(out, write, overwrite=self.overwrite)
        sys.stdout.write(f"{counts[0]} {'patterns' if self.versions else 'pairs'} in {out}\n")
        return int(counts[1] > 0)

    def _lines(self) -> Iterator[tuple[bytes, str]]:
        from swifttailor.cli.item_progress import ItemProgress
        from swifttailor.data.edits.edit_file import pair_line, read_edits, version_line
        from swifttailor.data.edits.pairs import geometric_pairs, is_reversed, pairs_of
        from swifttailor.data.pattern_source import count_source, parsed_pattern, patterns_of
        from swifttailor.errors import SwiftTailorError
        from swifttailor.pattern import Pattern

        bases: dict[str, Pattern] = {}
        with ItemProgress(count_source(self.source), "patterns") as progress:
            for number, (id, pattern) in enumerate(patterns_of(self.source)):
                progress.add(1)
                if isinstance(pattern, SwiftTailorError):
                    yield b"", f"{id}: {pattern}\n"
                    continue
                if self.designs is not None:
                    bases[id] = pattern
                last: Pattern | None = None
                for pair in geometric_pairs(pattern, self.seed + number, count=self.count):
                    version = pair.base if is_reversed(pair.source) else pair.edited
                    if not self.versions:
                        yield pair_line(f"{id}/{pair.source}", id, pair), ""
                    elif version is not last:  # a pair and the same the other way are one version
                        name = pair.source.split(",")[0].replace(" ", "-")
                        yield version_line(f"{id}-{name}", id, version), ""
                    last = version
        for number, version in enumerate(read_edits(self.designs) if self.designs else ()):
            id, edited = version.pattern.id, parsed_pattern(version.pattern)
            if isinstance(edited, SwiftTailorError):
                yield b"", f"{id}: {edited}\n"
            elif version.base in bases:
                for pair in pairs_of(bases[version.base], edited, self.seed + number, source="design"):
                    yield pair_line(f"{id}/{pair.source}", version.base, pair), ""

"""``swifttailor data captions``: writes texts about garments from their patterns."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from swifttailor.cli.postponed_imports import tyro

MAX_COUNT = 1000


@dataclass(frozen=True, kw_only=True)
class DataCaptions:
    """Write captions of garments, from two words to a full description, from what their patterns show.

    Each comes with the claims that it makes, all of which hold for the pattern. One JSON object a line:
    {"id": ..., "captions": [{"text": ..., "style": ..., "claims": [...]}]}.
    """

    source: Annotated[tyro.conf.Positional[Path], tyro.conf.arg(metavar="SOURCE")]
    """A data set, a split of one, a .jsonl or .jsonl.gz file, a folder of .json files, or a pattern."""
    out: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """File to write. Default: captions.jsonl in each split of a data set; others are printed."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace the file where there is one."""
    count: Annotated[int, tyro.conf.arg(metavar="N")] = 4
    """Captions of each pattern."""
    seed: int = 0
    """Decides words, order, dialect and units."""
    style: str | None = None
    """terse, phrase, description, tags, command, shop, sheet or hasty. Default: at random."""
    text: bool = False
    """Print the texts alone, one a line."""

    def run(self) -> int:
        """Writes the captions and returns the exit code: 0, or 1 where a pattern could not be read.

        Raises:
            SwiftTailorError: The source cannot be read, or there is no such style.
        """
        from swifttailor.atomic_files import require_free
        from swifttailor.cli.option_checks import in_range
        from swifttailor.data.index import split_folders
        from swifttailor.data.pattern_source import is_data_set

        in_range("--count", self.count, 1, MAX_COUNT)
        in_range("--seed", self.seed, 0, 2**31)
        if self.out is None and not is_data_set(self.source):
            return self._print()
        if self.out is not None:
            places = {self.source: self.out}
        else:
            places = {f: f / "captions.jsonl" for f in split_folders(self.source).values()}
        for out in places.values():
            require_free(out, overwrite=self.overwrite)
        return max(self._write(source, out) for source, out in places.items())

    def _print(self) -> int:
        failed = 0
        for line, problem in self._lines(self.source):
            sys.stderr.write(problem)
            sys.stdout.write(line)
            failed += bool(problem)
        return int(failed > 0)

    def _write(self, source: Path, out: Path) -> int:
        from swifttailor.atomic_files import write_atomically
        from swifttailor.cli.item_progress import ItemProgress
        from swifttailor.data.pattern_source import count_source

        failed = done = 0

        def write(path: Path) -> None:
            nonlocal failed, done
            with (
                path.open("w", encoding="utf-8") as stream,
                ItemProgress(count_source(source), "patterns") as progress,
            ):
                for line, problem in self._lines(source):
                    stream.write(line)
                    sys.stderr.write(problem)
                    failed += bool(problem)
                    done += not problem
                    progress.add(1)

        write_atomically(out, write, overwrite=self.overwrite)
        sys.stdout.write(f"{self.count} captions of each of {done} patterns in {out}\n")
        return int(failed > 0)

    def _lines(self, source: Path) -> Iterator[tuple[str, str]]:
        """What to write for each pattern, and what to complain of."""
        from swifttailor.data.pattern_source import patterns_of
        from swifttailor.describing import measure_facts
        from swifttailor.errors import SwiftTailorError
        from swifttailor.wording.captions import write_caption

        for number, (id, pattern) in enumerate(patterns_of(source)):
            if isinstance(pattern, SwiftTailorError):
                yield "", f"{id}: {pattern}\n"
                continue
            facts = measure_facts(pattern)
            first = self.seed + number * self.count
            captions = [write_caption(facts, first + k, style=self.style) for k in range(self.count)]
            if self.text:
                yield "".join(c.text.replace("\n", " / ") + "\n" for c in captions), ""
                continue
            written = [
                {"text": c.text, "style": c.style, "claims": [claim.to_json() for claim in c.claims]}
                for c in captions
            ]
            yield json.dumps({"id": id, "captions": written}, ensure_ascii=False) + "\n", ""

"""Folders of released systems as lists of patterns: what ``swifttailor convert FOLDER OUT.jsonl.gz`` does."""

from __future__ import annotations

import gzip
import json
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from swifttailor.data.released import Output

_SHOWN = 10
"""Outputs that cannot be used and are named; a system may fail on thousands."""


def write_list(folder: Path, target: Path, layout: str | None, *, overwrite: bool = False) -> int:
    """Writes the patterns of a folder, one ``{"id": ..., "pattern": ...}`` a line, and says what came of it.

    Each line also tells the `layout`, the name of the `input` that is answered, what was `mended`, and under
    `error` what could not be. Outputs without a pattern are counted and named, and have no line.

    Returns:
        The exit code: 0, or 1 where an output cannot be sewn.

    Raises:
        InputError: The folder is of no known system, or the target cannot be written.
    """
    from swifttailor.atomic_files import require_free, write_atomically
    from swifttailor.data.released import read_outputs

    require_free(target, overwrite=overwrite)
    tally = _Tally()
    outputs = tally.count(read_outputs(folder, layout))

    def write(path: Path) -> None:
        with path.open("wb") as raw:
            if target.name.lower().endswith(".gz"):
                # Neither name nor time, so that the same folder gives the same file.
                with gzip.GzipFile("", "wb", 6, raw, mtime=0) as packed:
                    packed.writelines(_lines(outputs))
            else:
                raw.writelines(_lines(outputs))

    write_atomically(target, write, overwrite=overwrite)
    tally.tell(target)
    return int(bool(tally.unusable))


def _lines(outputs: Iterator[Output]) -> Iterator[bytes]:
    from swifttailor.pattern import to_specification

    for output in outputs:
        if output.pattern is not None:
            line = {
                "id": output.id,
                "pattern": to_specification(output.pattern),
                "layout": output.layout,
                "input": output.input,
                "mended": [change.to_json() for change in output.changes],
                "error": output.error,
            }
            yield json.dumps(line, ensure_ascii=False).encode("utf-8") + b"\n"


class _Tally:
    """What came of a folder."""

    def __init__(self) -> None:
        self.layout = ""
        self.written = self.mended = self.unusable = 0
        self.changes: Counter[str] = Counter()

    def count(self, outputs: Iterator[Output]) -> Iterator[Output]:
        """Passes outputs on, names those that cannot be used, and counts."""
        for output in outputs:
            self.layout = output.layout
            self.written += output.pattern is not None
            self.mended += bool(output.changes)
            self.changes.update({change.code for change in output.changes})
            if output.error:
                self.unusable += 1
                if self.unusable <= _SHOWN:
                    sys.stderr.write(f"{output.id}: {output.error}\n")
            yield output

    def tell(self, target: Path) -> None:
        """Prints the sums."""
        if self.unusable > _SHOWN:
            sys.stderr.write(f"... and {self.unusable - _SHOWN} more that cannot be sewn\n")
        kinds = ", ".join(f"{code} in {n}" for code, n in self.changes.most_common())
        mended = f"{self.mended} mended ({kinds})" if self.mended else "none needed mending"
        sys.stdout.write(
            f"{self.written} patterns in {target}, as {self.layout} writes them; {mended}; "
            f"{self.unusable} cannot be sewn\n"
        )

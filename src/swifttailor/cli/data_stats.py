"""``swifttailor data stats``: what a data set holds, in numbers, sheets and a page."""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.results import open_file

if TYPE_CHECKING:
    from swifttailor.data.stats import Shown, SplitNumbers

MAX_SAMPLES = 5000
STATS = "stats.json"


@dataclass(frozen=True, kw_only=True)
class DataStats:
    """Count and measure what a data set holds, and draw samples to look at.

    Writes stats.json, contact sheets (<split>-01.png, ...; drape, caption and render of random samples) and
    index.html, a page to look through, into a folder.
    """

    dataset: Annotated[tyro.conf.Positional[Path], tyro.conf.arg(metavar="DIR")]
    """The data set, or one split of it."""
    out: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Folder to write. Default: stats/ in the data set."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace files in DIR even where SwiftTailor has not written them, or they were changed since."""
    open: tyro.conf.FlagCreatePairsOff[bool] = False
    """Show the page."""
    samples: Annotated[int, tyro.conf.arg(metavar="N")] = 200
    """How many random samples of each split to draw."""
    seed: int = 0
    """Decides which."""
    workers: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Processes. Default: one per CPU core."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print the numbers as JSON instead of a summary."""

    def run(self) -> int:
        """Measures, writes, prints and returns the exit code.

        Raises:
            SwiftTailorError: The data set cannot be read, or a file not be written.
        """
        from swifttailor.atomic_files import write_text
        from swifttailor.cli.option_checks import in_range, worker_count
        from swifttailor.data.index import split_folders
        from swifttailor.data.stats import write_page, write_sheets
        from swifttailor.data.stats.page import PAGE, PICTURES
        from swifttailor.output_folder import OutputFolder
        from swifttailor.render.numbered_sheets import sheets_named

        in_range("--samples", self.samples, 0, MAX_SAMPLES)
        workers = worker_count(self.workers)
        out = self.out if self.out is not None else self.dataset / "stats"
        numbers: dict[str, SplitNumbers] = {}
        shown: dict[str, list[Shown]] = {}
        splits = split_folders(self.dataset)
        sheets = [name for split in splits for name in sheets_named(split)]
        with OutputFolder(out, overwrite=self.overwrite) as output:
            output.require_own([STATS, PAGE])
            for name, folder in splits.items():
                numbers[name] = self._count(name, folder, workers)
                shown[name] = self._show(name, folder)
            content: dict[str, Any] = {name: found.to_json() for name, found in numbers.items()}
            with output.fill(stale=[*sheets, f"{PICTURES}/*"]) as made:
                for name in splits:
                    write_sheets(made, name, shown[name])
                write_text(made / STATS, json.dumps(content, indent=1) + "\n")
                write_page(made, f"Data set {self.dataset.resolve().name}", numbers, shown)
        page = out / PAGE
        if self.open:
            open_file(page)
        if self.json:
            sys.stdout.write(json.dumps(content, indent=1) + "\n")
        else:
            sys.stdout.writelines(_line(content[name]) for name in content)
            sys.stdout.write(f"Look through it: {page}\n")
        return 0

    def _count(self, name: str, folder: Path, workers: int) -> SplitNumbers:
        from swifttailor.cli.item_progress import ItemProgress
        from swifttailor.data.index import read_index
        from swifttailor.data.stats import count_split

        total = sum(len(s.ids) for s in read_index(folder).shards)
        result = None
        with ItemProgress(total, f"samples of '{name}' measured") as progress:
            for found in count_split(folder, workers=workers):
                if isinstance(found, int):
                    progress.add(found)
                else:
                    result = found
        assert result is not None
        return result

    def _show(self, name: str, folder: Path) -> list[Shown]:
        from swifttailor.cli.item_progress import ItemProgress
        from swifttailor.data.reader import SplitReader
        from swifttailor.data.renders.files import FOLDER, SplitRenders
        from swifttailor.data.stats import choose, show_sample

        reader = SplitReader(folder)
        renders = SplitRenders(reader) if (folder / FOLDER).is_dir() else None
        chosen = choose(self.samples, len(reader), self.seed)
        shown = []
        with ItemProgress(len(chosen), f"samples of '{name}' drawn") as progress:
            for k in chosen:
                shown.append(show_sample(reader, k, renders, self.seed))
                progress.add(1)
        return shown


def _line(n: dict[str, Any]) -> str:
    hours = f", {n['total_hours']:.1f} processor hours" if n["total_hours"] else ""
    return (
        f"{n['split']}: {n['accepted']} of {n['patterns']} patterns accepted ({n['acceptance']:.1%}), "
        f"{n['kilobytes_a_sample']:.1f} KB a sample, {n['megabytes']:.1f} MB{hours}"
        f"{'' if n['complete'] else '; not complete'}\n"
    )

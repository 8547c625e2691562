"""``swifttailor data render``: draws the pictures of a data set."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from swifttailor.cli.postponed_imports import tyro


@dataclass(frozen=True, kw_only=True)
class DataRender:
    """Draw pictures of every garment of a data set into the folder renders/ of each split.

    Two like those of GarmentCodeData (front and back), and others with random cloth, body, light, backdrop
    and camera. Stopped and started again, it resumes where it stopped.
    """

    dataset: Annotated[tyro.conf.Positional[Path], tyro.conf.arg(metavar="DIR")]
    """The data set, or one split of it."""
    size: int = 256
    """Pixels along each side, 16 to 2048."""
    random: Annotated[int, tyro.conf.arg(metavar="N")] = 4
    """Pictures of random looks of each garment: front, back, and the others from anywhere."""
    plain: bool = True
    """Draw the two that are like GarmentCodeData's."""
    seed: int = 0
    """Of the random looks."""
    workers: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Processes. Default: one per CPU core."""

    def run(self) -> int:
        """Draws, says how much, and returns the exit code.

        Raises:
            SwiftTailorError: There is no data set, or other renders are there already.
        """
        from swifttailor.cli.item_progress import ItemProgress
        from swifttailor.cli.option_checks import worker_count
        from swifttailor.data.index import split_folders
        from swifttailor.data.reader import SplitReader
        from swifttailor.data.renders.files import FOLDER, RenderSettings, SplitRenders

        settings = RenderSettings(self.size, self.random, self.plain, self.seed)
        workers = worker_count(self.workers)
        for name, folder in split_folders(self.dataset).items():
            renders = SplitRenders(SplitReader(folder), settings)
            with ItemProgress(len(renders.reader.index.shards), f"shards of '{name}'") as progress:
                for done, _ in renders.draw(workers=workers):
                    progress.add(done - progress.done)
            size = sum(p.stat().st_size for p in (folder / FOLDER).iterdir())
            sys.stdout.write(
                f"'{name}': {len(settings.names())} pictures of each of {len(renders)} garments, "
                f"{size / 1e6:.1f} MB in {folder / FOLDER}\n"
            )
        return 0

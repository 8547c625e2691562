"""``swifttailor evaluate drape-floor``: how far two drapes of one pattern are apart."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from swifttailor.cli.postponed_imports import tyro

if TYPE_CHECKING:
    from swifttailor.data.reader import SplitReader
    from swifttailor.output_folder import OutputFolder


@dataclass(frozen=True, kw_only=True)
class EvaluateDrapeFloor:
    """Drape the patterns of a split once more, from starting positions moved by a hundredth of a millimetre.

    How far these drapes are from those of the data is chance; no network can be expected to come nearer.
    Takes some seconds a garment. Every drape is kept in --out: stopped and started again, it resumes.

    Exit code 0: done; 1: done, but some patterns could not be draped again; 2: not done.
    """

    data: Annotated[Path, tyro.conf.arg(metavar="DIR")]
    """The data set (swifttailor data build)."""
    out: Annotated[Path, tyro.conf.arg(metavar="DIR")] = Path("drape-floor")
    """Folder for the drapes and the results; created when missing."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace files in DIR even where SwiftTailor has not written them, or they were changed since."""
    split: Annotated[str, tyro.conf.arg(metavar="NAME")] = "validation"
    """Which of its splits."""
    limit: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Only N garments, chosen by --seed. A larger N later goes on with the same ones."""
    seed: int = 0
    """Decides which garments, and which points of them are compared."""
    drape_seed: int = 1
    """Moves the starting positions; another than the data were made with."""
    pictures: Annotated[int, tyro.conf.arg(metavar="N")] = 12
    """How many garments to draw, from the nearest to its drape to the farthest."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print the numbers as JSON instead of tables."""

    def run(self) -> int:
        """Drapes, measures, prints, writes and returns the exit code.

        Raises:
            SwiftTailorError: The data or an option cannot be used.
        """
        from swifttailor.cli.evaluation_report import FILES, open_split, require_picture_count
        from swifttailor.cli.option_checks import require_writable_folder

        require_picture_count(self.pictures)
        require_writable_folder(self.out)
        from swifttailor.output_folder import OutputFolder
        from swifttailor.workers.work_folder import saying_how_to_go_on

        reader = open_split(self.data, self.split)
        with saying_how_to_go_on(), OutputFolder(self.out, overwrite=self.overwrite) as output:
            output.require_own(FILES)
            return self._evaluate(reader, output)

    def _evaluate(self, reader: SplitReader, output: OutputFolder) -> int:
        from swifttailor.cli.evaluation_report import SHEETS, GarmentReport
        from swifttailor.cli.item_progress import ItemProgress
        from swifttailor.evaluation.garments.redrape import Redraper
        from swifttailor.evaluation.provenance import choose_samples, provenance

        numbers = choose_samples(reader, self.limit, self.seed)
        redraper = Redraper(reader, self.out, drape_seed=self.drape_seed, seed=self.seed)
        with ItemProgress(len(numbers), "garments draped and measured") as progress:
            made, rejected = redraper.run(numbers, progress.add)
        report = GarmentReport(
            title="Drapes against other drapes of the same patterns",
            about=provenance(reader, numbers, self.seed)
            | {"drape_seed": self.drape_seed, "rejected": rejected},
            notes=[
                f"drape seed {self.drape_seed} against {reader.index.settings['seed']}; "
                f"{rejected} of the new drapes are beyond the limits of quality and count all the same"
            ],
            made=made,
            row=f"another drape, {reader.index.split}",
        )
        summary = report.summarize()
        with output.fill(stale=SHEETS) as folder:
            report.write(summary, folder, as_json=self.json)
            if self.pictures:
                report.draw(reader, folder, self.pictures)
        print(f"Wrote {self.out}", file=sys.stderr)  # noqa: T201
        return 1 if made.errors else 0

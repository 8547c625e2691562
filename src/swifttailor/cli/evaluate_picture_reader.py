"""``swifttailor evaluate picture-reader``: how well pictures are read."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import tyro

SUMMARY, TABLES = "summary.json", "tables.txt"


@dataclass(frozen=True, kw_only=True)
class EvaluatePictureReader:
    """Draw garments in all looks and views, read the pictures, and compare with what is true of the patterns.

    Writes summary.json and tables.txt. A claim counts where one of its words is clearly true of the garment;
    it is read right where the likeliest word is not false, whether it can be seen in that view or not.
    """

    weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """The picture reader's model file; the one of the package without it."""
    close_up_weights: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")] = ()
    """Model files of networks that look at details, beside --weights; that one looks itself without them."""
    plain_reader_weights: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")] = ()
    """Model files of a network that reads plain pictures, and of those that look at their details, beside
    --weights; that one reads all pictures without them."""
    laid_reader_weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Model file of a network that reads pictures of garments that nobody wears, beside --weights; that one
    reads them, too, without it."""
    shop_reader_weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """The same of one that tells photographs of people and reads those by shops."""
    data: Annotated[Path, tyro.conf.arg(metavar="DIR")]
    """Data set of sewn garments (swifttailor data build --engine network)."""
    out: Annotated[Path, tyro.conf.arg(metavar="DIR")] = Path("picture-reader-evaluation")
    """Folder for the results; created when missing."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace files in DIR even where SwiftTailor has not written them, or they were changed since."""
    split: Annotated[str, tyro.conf.arg(metavar="NAME")] = "validation"
    """Which of its splits."""
    limit: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Only N garments, chosen by --seed."""
    seed: int = 0
    """Decides which garments, and their looks."""

    def run(self) -> int:
        """Draws, reads, prints, writes and returns the exit code.

        Raises:
            SwiftTailorError: The data, the weights or an option cannot be used.
        """
        import json
        import sys

        from swifttailor.atomic_files import write_text
        from swifttailor.cli.option_checks import require_writable_folder
        from swifttailor.evaluation.pictures.tables import tables
        from swifttailor.evaluation.provenance import provenance_lines
        from swifttailor.output_folder import OutputFolder

        require_writable_folder(self.out)
        with OutputFolder(self.out, overwrite=self.overwrite) as output:
            output.require_own([SUMMARY, TABLES])
            about, result = self._evaluate()
            text = provenance_lines(about) + "\n" + tables(result)
            with output.fill() as folder:
                write_text(folder / SUMMARY, json.dumps({"about": about, "result": result}, indent=1) + "\n")
                write_text(folder / TABLES, text)
        sys.stdout.write(text)
        return 0

    def _evaluate(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """What was evaluated, and what came of it."""
        from swifttailor.cli.evaluation_report import open_split
        from swifttailor.cli.item_progress import ItemProgress
        from swifttailor.cli.progress import print_line
        from swifttailor.data.pictures.bank import PictureBank
        from swifttailor.evaluation.pictures.reading import SHOWN, read_pictures
        from swifttailor.evaluation.pictures.tables import summary
        from swifttailor.evaluation.provenance import choose_samples, provenance
        from swifttailor.picture_reader.reader import PictureReader

        reader = PictureReader.load(
            self.weights,
            close_ups=self.close_up_weights or None,
            plain=self.plain_reader_weights or None,
            laid=self.laid_reader_weights,
            shop=self.shop_reader_weights,
        )
        split = open_split(self.data, self.split)
        numbers = choose_samples(split, self.limit, self.seed)
        bank = PictureBank([split.folder])
        bank.prepare(report=print_line)
        about = provenance(split, numbers, self.seed)
        with ItemProgress(len(numbers) * len(SHOWN), "pictures read") as progress:
            pictures = list(read_pictures(reader, bank, numbers, seed=self.seed, done=progress.add))
        return about, summary(pictures)

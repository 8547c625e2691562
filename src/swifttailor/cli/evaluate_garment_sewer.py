"""``swifttailor evaluate garment-sewer``: sewn garments against the drapes of the same patterns."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from swifttailor.cli.postponed_imports import tyro

if TYPE_CHECKING:
    from swifttailor.data.reader import SplitReader
    from swifttailor.output_folder import OutputFolder


@dataclass(frozen=True, kw_only=True)
class EvaluateGarmentSewer:
    """Sew the patterns of a split and compare the garments with their drapes.

    Prints tables, kind by kind and beside the paper's rows. With --out also writes them: tables.txt,
    summary.json, garments.jsonl (a line each), sheet-01.png (garments beside their drapes).

    Exit code 0: done; 1: done, but some patterns could not be sewn; 2: not done.
    """

    data: Annotated[Path, tyro.conf.arg(metavar="DIR")]
    """The data set (swifttailor data build)."""
    split: Annotated[str, tyro.conf.arg(metavar="NAME")] = "test"
    """Which of its splits."""
    weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Model file (.onnx) of a trained GarmentSewer. Default: the one in the package."""
    limit: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Only N garments, chosen by --seed."""
    seed: int = 0
    """Decides which garments, and which points of them are compared."""
    resolution: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Pixels along each side of the images. Default: what the network was trained at."""
    finish: tyro.conf.FlagCreatePairsOff[bool] = False
    """Let the garments hang to rest by physics before they are measured; takes a second or two each."""
    relax: bool = True
    """Let the cloth fall for a moment, as sew does."""
    threads: Annotated[int, tyro.conf.arg(metavar="N")] = 1
    """CPU cores for the network."""
    out: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Folder for the results; created when missing."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace files in DIR even where SwiftTailor has not written them, or they were changed since."""
    pictures: Annotated[int, tyro.conf.arg(metavar="N")] = 12
    """How many garments to draw, from the nearest to its drape to the farthest."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print the numbers as JSON instead of tables."""

    def run(self) -> int:
        """Sews, measures, prints, writes and returns the exit code.

        Raises:
            SwiftTailorError: The data, the weights or an option cannot be used.
        """
        from swifttailor.cli.evaluation_report import FILES, open_split, require_picture_count
        from swifttailor.cli.option_checks import require_threads

        require_threads(self.threads)
        require_picture_count(self.pictures)
        from swifttailor.output_folder import OutputFolder

        reader = open_split(self.data, self.split)
        if self.out is None:
            return self._evaluate(reader, None)
        with OutputFolder(self.out, overwrite=self.overwrite) as output:
            output.require_own(FILES)
            return self._evaluate(reader, output)

    def _evaluate(self, reader: SplitReader, output: OutputFolder | None) -> int:
        from swifttailor.cli.evaluation_report import SHEETS, GarmentReport
        from swifttailor.cli.item_progress import ItemProgress
        from swifttailor.evaluation.garments.sew_split import sew_split
        from swifttailor.evaluation.provenance import choose_samples, file_identity, provenance
        from swifttailor.garment_sewer.sewer import SHIPPED, GarmentSewer

        numbers = choose_samples(reader, self.limit, self.seed)
        sewer = GarmentSewer.load(self.weights, threads=self.threads)
        weights = SHIPPED if self.weights is None else self.weights
        model = file_identity(weights)
        with ItemProgress(len(numbers), "garments sewn and measured") as progress:
            made = sew_split(
                sewer,
                reader,
                numbers,
                resolution=self.resolution,
                finish=self.finish,
                relax=self.relax,
                seed=self.seed,
                progress=progress.add,
            )
        size = self.resolution or sewer.model.resolution
        report = GarmentReport(
            title="GarmentSewer against the drapes of the same patterns",
            about=provenance(reader, numbers, self.seed)
            | {"weights": model, "resolution": size, "threads": self.threads}
            | {"finish": self.finish, "relax": self.relax},
            notes=[
                f"weights {model['file']} (sha256 {model['sha256'][:16]}), {size} px, {self.threads} threads"
                + (", finished by physics" if self.finish else "" if self.relax else ", not relaxed")
            ],
            made=made,
            row=f"GarmentSewer{' and physics' if self.finish else ''}, {reader.index.split}",
        )
        summary = report.summarize()
        if output is None:
            report.write(summary, None, as_json=self.json)
        else:
            with output.fill(stale=SHEETS) as folder:
                report.write(summary, folder, as_json=self.json)
                if self.pictures:
                    report.draw(reader, folder, self.pictures)
        return 1 if made.errors else 0

"""What an evaluation of garments prints and writes."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from swifttailor.cli.option_checks import in_range
from swifttailor.errors import InputError
from swifttailor.render.numbered_sheets import sheets_named

if TYPE_CHECKING:
    from swifttailor.data.reader import SplitReader
    from swifttailor.evaluation.garments.sew_split import Made
    from swifttailor.evaluation.garments.summary import Summary

MAX_PICTURES = 200
FILES = "garments.jsonl", "summary.json", "tables.txt"
SHEETS = sheets_named("sheet")


def open_split(data: Path, split: str) -> SplitReader:
    """The split of that name of a data set, or the folder itself where it is that split.

    Raises:
        InputError: There is none.
    """
    from swifttailor.data.index import split_folders
    from swifttailor.data.reader import SplitReader

    found = split_folders(data)
    if split not in found:
        raise InputError(f"'{data}' has no split '{split}', only {', '.join(found)}.")
    return SplitReader(found[split])


def require_picture_count(pictures: int) -> None:
    """Refuses numbers of pictures that nobody can want."""
    in_range("--pictures", pictures, 0, MAX_PICTURES)


@dataclass(frozen=True)
class GarmentReport:
    """The result of an evaluation."""

    title: str
    about: dict[str, Any]
    """`provenance`, and what is particular to this evaluation."""
    notes: Sequence[str]
    """Lines that stand below the provenance."""
    made: Made
    row: str
    """Name of our row in the paper's table."""
    with_paper: bool = True

    def summarize(self) -> Summary:
        """Means and distances between sets, with a progress bar.

        Raises:
            InputError: No garment was made.
        """
        if not self.made.scored:
            id, error = next(iter(self.made.errors.items()))
            raise InputError(
                f"Of {len(self.made.errors)} patterns none gave a garment. The first, '{id}': {error}"
            )
        from swifttailor.cli.item_progress import ItemProgress
        from swifttailor.evaluation.garments.summary import summarize_scores, work

        total = work(len(self.made.scored) + len(self.made.lost))
        with ItemProgress(total, "comparisons of a garment with all others") as progress:
            return summarize_scores(self.made.scored, self.made.lost, progress.add)

    def write(self, summary: Summary, out: Path | None, *, as_json: bool) -> None:
        """Prints the tables and writes `FILES` into an empty folder."""
        from swifttailor.atomic_files import write_text

        content = {"about": self.about, "result": summary.to_json()}
        text = self._text(summary)
        if out is not None:
            lines = [json.dumps(asdict(s.score)) for s in self.made.scored]
            lines += [json.dumps({"id": id, "error": e}) for id, e in self.made.errors.items()]
            write_text(out / "garments.jsonl", "".join(line + "\n" for line in lines))
            write_text(out / "summary.json", json.dumps(content, indent=1, allow_nan=False) + "\n")
            write_text(out / "tables.txt", text)
        sys.stdout.write(json.dumps(content, indent=1, allow_nan=False) + "\n" if as_json else text)

    def draw(self, reader: SplitReader, out: Path, pictures: int) -> list[Path]:
        """Writes sheet-01.png and so on: garments from the nearest to their drapes to the farthest."""
        from swifttailor.evaluation.garments.sheet import Shown, caption, chosen, write_sheets
        from swifttailor.garment.garment import Garment

        numbers = {reader.ids[k]: k for k in self.made.vertices}
        shown = []
        for score in chosen([s.score for s in self.made.scored], pictures):
            drape = reader.sample(score.id).garment
            garment = Garment(drape.mesh, self.made.vertices[numbers[score.id]])
            shown.append(Shown(caption(score), garment, drape))
        return write_sheets(out, shown)

    def _text(self, summary: Summary) -> str:
        from swifttailor.evaluation.garments.garment_table import garment_tables, paper_table
        from swifttailor.evaluation.paper_rows import ABLATION
        from swifttailor.evaluation.provenance import provenance_lines

        notes = "".join(f"{line}\n" for line in self.notes)
        errors = "".join(f"{id}: {error}\n" for id, error in self.made.errors.items())
        return (
            f"{self.title}\n{provenance_lines(self.about)}{notes}\n{garment_tables(summary)}{errors}\n"
            f"{paper_table(summary, self.row, ABLATION if self.with_paper else ())}"
        )

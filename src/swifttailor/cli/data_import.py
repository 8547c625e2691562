"""``swifttailor data import``: folders of GarmentCodeData to shards."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from swifttailor.cli.postponed_imports import tyro
from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.data.garmentcodedata import GarmentCodeData, SampleFolder


@dataclass(frozen=True, kw_only=True)
class DataImport:
    """Put garments of GarmentCodeData into shards, so that they read like those draped by data build.

    Reads the folders as downloaded (garments_5000_0/default_body/rand_.../). Stopped and started again, it
    goes on where it stopped.
    """

    root: Annotated[tyro.conf.Positional[Path], tyro.conf.arg(metavar="ROOT")]
    """Folder with garments_5000_0 and so on, or one of those."""
    out: Annotated[Path, tyro.conf.arg(metavar="DIR")] = Path("dataset")
    """Folder of the data set; created when missing."""
    splits: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Official list of splits (JSON). Without it all garments go into one split."""
    split: Annotated[str | None, tyro.conf.arg(metavar="NAME")] = None
    """With --splits: only this split. Else the name of the one split; train without it."""
    body: Literal["default", "random"] = "default"
    """Garments on the default body, or on the random ones."""
    captions: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Folder of the unpacked captions of GCD-MM, to be kept with the samples."""
    edge_length: float = 2.0
    """Edge length of the panel meshes that the drapes are carried over to, cm."""
    rotation: Literal["intrinsic", "extrinsic"] = "intrinsic"
    """How to read the placement angles of the patterns."""
    limit: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Only the first N garments of each split."""
    workers: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Processes. Default: one per CPU core."""

    def run(self) -> int:
        """Imports, says what came of it, and returns the exit code.

        Raises:
            SwiftTailorError: Something is not usable; what was imported so far is kept.
        """
        from swifttailor.cli.option_checks import require_limit

        require_limit(self.limit)
        from swifttailor.data.garmentcodedata import GarmentCodeData

        dataset = GarmentCodeData(self.root)
        code = 0
        for split, (samples, missing) in self._chosen(dataset).items():
            if missing:
                sys.stderr.write(f"'{split}': {missing} garments of the list are not in '{dataset.root}'\n")
            if samples:
                code = max(code, self._import(dataset, split, samples))
        return code

    def _chosen(self, dataset: GarmentCodeData) -> dict[str, tuple[list[SampleFolder], int]]:
        """Garments of each split, and how many of its list are not there."""
        from swifttailor.data.garmentcodedata import read_split_lists

        there = {s.path: s for s in dataset.samples(self.body, with_failures=True)}
        if self.splits is None:
            return {self.split or "train": (list(there.values()), 0)}
        lists = read_split_lists(self.splits)
        if self.split is not None and self.split not in lists:
            raise InputError(f"'{self.splits}' has no split '{self.split}', only {', '.join(lists)}.")
        chosen = {}
        for split, paths in lists.items():
            if self.split in (None, split):
                found = [there[p] for p in paths if p in there]
                chosen[split] = found, sum(f"/{self.body}_body/" in p for p in paths) - len(found)
        return chosen

    def _import(self, dataset: GarmentCodeData, split: str, samples: list[SampleFolder]) -> int:
        from swifttailor.cli.data_build import finish_build
        from swifttailor.cli.data_progress import BuildProgress
        from swifttailor.cli.option_checks import worker_count
        from swifttailor.data.builder import BuildSettings, build_split
        from swifttailor.data.builder.run import ATTEMPTS, TIME_LIMIT
        from swifttailor.data.garmentcodedata.import_samples import ORIGIN, import_sample, patterns_of
        from swifttailor.draping.batch import BatchSettings
        from swifttailor.workers import run_tasks

        drape = BatchSettings(edge_length=self.edge_length, rotation=self.rotation, preview=False)
        settings = BuildSettings(drape, origin=ORIGIN, origin_body=f"GarmentCodeData {self.body}")
        with BuildProgress(min(len(samples), self.limit or len(samples)), drapes=False) as progress:
            index = build_split(
                patterns_of(samples),
                self.out,
                split,
                settings,
                runner=partial(
                    run_tasks, workers=worker_count(self.workers), time_limit=TIME_LIMIT, attempts=ATTEMPTS
                ),
                limit=self.limit,
                on_start=progress.start,
                on_record=progress.show,
                make=partial(import_sample, root=dataset.root, captions=self.captions),
            )
        return finish_build(index, self.out / split)

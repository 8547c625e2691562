"""``swifttailor data verify``: looks for faults in a data set."""

from __future__ import annotations

import json
import sys
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Annotated

from swifttailor.cli.postponed_imports import tyro

FAULTS = 1


@dataclass(frozen=True, kw_only=True)
class DataVerify:
    """Compare the checksums of a data set and check everything that must hold of each sample.

    Exit code 0: no faults; 1: faults, each named with its file; 2: there is no data set.
    """

    dataset: Annotated[tyro.conf.Positional[Path], tyro.conf.arg(metavar="DIR")]
    """The data set, or one split of it."""
    workers: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Processes. Default: one per CPU core."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print one JSON object (ok, samples, faults) instead of text."""

    def run(self) -> int:
        """Verifies, prints the faults, and returns the exit code.

        Raises:
            SwiftTailorError: There is no data set.
        """
        from swifttailor.cli.item_progress import ItemProgress
        from swifttailor.cli.option_checks import worker_count
        from swifttailor.data.index import read_index, split_folders
        from swifttailor.data.verify import Fault, verify_dataset
        from swifttailor.errors import SwiftTailorError

        total = 0
        for folder in split_folders(self.dataset).values():
            try:
                total += sum(len(s.ids) for s in read_index(folder).shards)
            except SwiftTailorError:  # a fault, reported below
                pass
        faults: list[Fault] = []
        with ItemProgress(total, "samples") as progress:
            for found in verify_dataset(self.dataset, workers=worker_count(self.workers)):
                if isinstance(found, Fault):
                    faults.append(found)
                else:
                    progress.add(found)
        if self.json:
            listed = [asdict(f) for f in faults]
            report = {"ok": not faults, "samples": progress.done, "faults": listed}
            sys.stdout.write(json.dumps(report, indent=2) + "\n")
        else:
            sys.stdout.writelines(f"{fault}\n" for fault in faults)
            count = "no faults" if not faults else "1 fault" if len(faults) == 1 else f"{len(faults)} faults"
            sys.stdout.write(f"{self.dataset}: {progress.done} samples, {count}\n")
        return FAULTS if faults else 0

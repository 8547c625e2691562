"""``swifttailor drape --batch``: what it shows while it works and when it is done."""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from swifttailor.cli.option_checks import worker_count
from swifttailor.cli.progress import CountProgress

if TYPE_CHECKING:
    from swifttailor.cli.drape import Drape

NOT_ALL_ACCEPTED = 1


def run_drape_batch(options: Drape, source: Path) -> int:
    """Drapes all patterns of `source` with the options of the command; returns the exit code."""
    from swifttailor.draping.batch import BatchSettings, run_batch
    from swifttailor.draping.batch.run import TIME_LIMIT
    from swifttailor.pattern.pattern_list import count_patterns

    settings = BatchSettings(
        fabric=options.fabric or "cotton",
        edge_length=options.edge_length,
        engine=options.engine,
        seed=options.seed,
        body=options.body,
        rotation=options.rotation,
        repair=options.repair,
        preview=options.preview,
    )
    total = count_patterns(source)
    started = time.perf_counter()
    with _BatchProgress(min(total, options.limit or total)) as progress:
        summary = run_batch(
            source,
            options.folder,
            settings,
            workers=worker_count(options.workers),
            limit=options.limit,
            time_limit=options.time_limit or TIME_LIMIT,
            retry_failed=options.retry_failed,
            overwrite=options.overwrite,
            on_start=progress.start,
            on_record=progress.show,
        )
    if options.json:
        sys.stdout.write(json.dumps(summary, indent=2) + "\n")
    else:
        _print_summary(summary, options.folder, progress.done, time.perf_counter() - started)
    options.show("sheet-01.png")
    _warn_of_changed(summary.get("changed", {}), options.folder)
    counts = summary["counts"]
    all_well = counts["accepted"] == counts["patterns"] and "changed" not in summary
    return 0 if all_well else NOT_ALL_ACCEPTED


def _warn_of_changed(changed: dict[str, list[str]], out: Path) -> None:
    """Says which garments of earlier calls are not as they were left."""
    if not changed:
        return
    id, names = next(iter(changed.items()))
    shown = ", ".join(names[:3]) + f" of {id}" + (", ..." if len(names) > 3 or len(changed) > 1 else "")
    number = f"{len(changed)} garments have" if len(changed) > 1 else "1 garment has"
    sys.stderr.write(
        f"warning: {number} files that are not as they were written: they were cut short, or changed by "
        f"somebody ({shown}; all are in {out / 'summary.json'}). "
        "To have them made again, start the same command with --overwrite.\n"
    )


def _print_summary(summary: dict[str, Any], out: Path, new: int, seconds: float) -> None:
    counts = summary["counts"]
    lines = [
        f"{counts['patterns']} patterns: {counts['accepted']} accepted, "
        f"{counts['not_accepted']} not accepted, {counts['failed']} failed.",
        f"{new} of them now, in {seconds:.0f} s.",
    ]
    lines += [f"  {number:5}  {reason}" for reason, number in summary["reasons"].items()]
    lines += [f"  {number:5}  failed: {kind}" for kind, number in summary["failures"].items()]
    sheets = len(list(out.glob("sheet-*.png")))
    look = (
        f"Look at {out / 'sheet-01.png'}{f' to sheet-{sheets:02d}.png' if sheets > 1 else ''}; "
        if sheets
        else ""
    )
    lines.append(f"{look}{'the' if look else 'The'} numbers are in {out / 'summary.json'}.")
    sys.stdout.write("\n".join(lines) + "\n")


class _BatchProgress(CountProgress):
    """A bar in a terminal, a line per garment elsewhere; both on stderr."""

    def start(self, done_before: int, compiled: bool) -> None:
        """Says what the batch starts from."""
        self.begin(done_before, compiled=compiled)

    def show(self, record: dict[str, Any]) -> None:
        """Takes note of a garment."""
        self.done += 1
        if record["status"] == "failed":
            text = f"failed: {record['error']}"
        elif record["accepted"]:
            text = "accepted"
        else:
            text = f"not accepted: {'; '.join(record['reasons'])}"
        line = f"{record['id']}: {text}"
        if not self.advance(record["id"]):
            self.note(f"{self.position}/{self._total} {line}")
        elif record["status"] == "failed":
            self.note(line)

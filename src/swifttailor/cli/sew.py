"""``swifttailor sew``: sewing patterns to stitched 3D garments, by a network instead of physics."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import tyro

from swifttailor.cli.option_checks import require_edge_length, require_threads, require_writable_folder
from swifttailor.errors import InputError, SwiftTailorError

if TYPE_CHECKING:
    from swifttailor.garment import Garment
    from swifttailor.garment_sewer.sewer import Floats, GarmentSewer, Prepared
    from swifttailor.pattern import Finding, Pattern
    from swifttailor.pattern.check import Repair

SOMETHING_TO_LOOK_AT = 1
UNUSABLE = 2


@dataclass(frozen=True, kw_only=True)
class Sew:
    """Turn sewing patterns into stitched garments on the default body, in a fraction of a second each.

    Writes pattern.json, pattern.svg, garment.glb, garment.obj and report.json into a folder; of several
    patterns each gets a folder of its own in DIR, named after its file. What is wrong with a pattern is said,
    and it is sewn all the same where that is possible.

    Exit code 0: made; 1: made, but look at what it says, or some were not made; 2: nothing was made.
    """

    patterns: Annotated[tyro.conf.Positional[tuple[Path, ...]], tyro.conf.arg(metavar="PATTERN...")]
    """GarmentCode JSON files."""
    out: Annotated[Path, tyro.conf.arg(metavar="DIR")]
    """Folder to write; created when missing."""
    weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Model file (.onnx) of a trained GarmentSewer; the one of the package without it."""
    resolution: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Pixels along each side of the images; what the network was trained at without it."""
    edge_length: float = 2.0
    """Edge length of the mesh in cm, 0.5 to 10."""
    finish: tyro.conf.FlagCreatePairsOff[bool] = False
    """Let the garment hang to rest by physics in the end: wrinkles, and a report of its quality."""
    repair: tyro.conf.FlagCreatePairsOff[bool] = False
    """Mend the patterns first, as swifttailor check --repair does."""
    rotation: Literal["intrinsic", "extrinsic"] = "intrinsic"
    """How to read the placement angles: as GarmentCode's generator writes them (intrinsic), or as its
    simulator and older files do (extrinsic)."""
    preview: tyro.conf.FlagCreatePairsOff[bool] = False
    """Draw preview.png; takes a second or two a garment."""
    threads: Annotated[int, tyro.conf.arg(metavar="N")] = 1
    """Processor cores for the network."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print the reports as JSON."""

    def run(self) -> int:
        """Sews, prints what came of it, and returns the exit code.

        Raises:
            SwiftTailorError: An option or the weights cannot be used.
        """
        folders = self._folders()
        from swifttailor.garment_sewer.sewer import GarmentSewer

        sewer = GarmentSewer.load(self.weights, threads=self.threads)
        reports = list(self._sew_all(sewer, folders))
        if self.json:
            from swifttailor.garment_files.folder import plain

            sys.stdout.write(json.dumps(plain(reports), indent=2, allow_nan=False) + "\n")
        made = [r for r in reports if "error" not in r]
        if not made:
            return UNUSABLE
        flawed = len(made) < len(reports) or any(_is_flawed(r) for r in made)
        return SOMETHING_TO_LOOK_AT if flawed else 0

    def _folders(self) -> list[tuple[Path, Path]]:
        """Each pattern and its folder; refuses what cannot work before anything is loaded."""
        if not self.patterns:
            raise InputError("No pattern was given. Give one or more: swifttailor sew PATTERN --out DIR")
        require_edge_length(self.edge_length)
        require_threads(self.threads)
        require_writable_folder(self.out)
        if len(self.patterns) == 1:
            return [(self.patterns[0], self.out)]
        folders: dict[str, Path] = {}
        for path in self.patterns:
            if path.stem in folders:
                raise InputError(
                    f"'{folders[path.stem]}' and '{path}' would both be written to '{self.out / path.stem}'. "
                    "Rename one, or sew them in two calls."
                )
            folders[path.stem] = path
        return [(path, self.out / name) for name, path in folders.items()]

    def _sew_all(self, sewer: GarmentSewer, folders: Sequence[tuple[Path, Path]]) -> Iterator[dict[str, Any]]:
        from swifttailor.garment_sewer.sewer import BATCH

        for first in range(0, len(folders), BATCH):
            part = folders[first : first + BATCH]
            works = [_Work(path, folder) for path, folder in part]
            for work in works:
                self._guard(work, self._prepare, sewer)
            ready = [w for w in works if w.prepared is not None]
            if ready:
                started = time.perf_counter()
                predicted = sewer.predict([w.prepared for w in ready if w.prepared is not None])
                share = (time.perf_counter() - started) / len(ready)
                for work, values in zip(ready, predicted, strict=True):
                    work.values = values
                    work.seconds["network"] = share
            for work in works:
                if work.values is not None:
                    self._guard(work, self._complete, sewer)
                report = work.report | {"pattern": str(work.path), "folder": str(work.folder)}
                if not self.json:
                    self._say(work)
                yield report

    def _guard(self, work: _Work, do: Any, sewer: GarmentSewer) -> None:
        """Notes why a pattern cannot be sewn; the others go on."""
        try:
            do(work, sewer)
        except SwiftTailorError as error:
            work.prepared = work.values = None
            work.report = {"error": str(error)}

    def _prepare(self, work: _Work, sewer: GarmentSewer) -> None:
        from swifttailor.pattern import check_pattern, read_pattern_file, repair_pattern

        started = time.perf_counter()
        reading = read_pattern_file(work.path, rotation=self.rotation)
        pattern, findings = reading.pattern, check_pattern(reading.pattern, reader_findings=reading.findings)
        if self.repair:
            pattern = self._mend(work, repair_pattern(pattern, reading.findings))
        else:
            work.findings = findings
        loaded = time.perf_counter()
        work.seconds["loading"] = loaded - started
        try:
            work.prepared = self._prepared(pattern, sewer)
        except SwiftTailorError:
            # What cannot be sewn as it is may be once it is mended; that is said, not done quietly.
            if self.repair or not findings:
                raise
            pattern = self._mend(work, repair_pattern(reading.pattern, reading.findings))
            if not work.mended:
                raise
            work.prepared = self._prepared(pattern, sewer)
        work.seconds["drawing"] = time.perf_counter() - loaded

    def _prepared(self, pattern: Pattern, sewer: GarmentSewer) -> Prepared:
        return sewer.prepare(pattern, edge_length=self.edge_length, resolution=self.resolution)

    def _mend(self, work: _Work, repaired: Repair) -> Pattern:
        work.findings = repaired.remaining
        for change in repaired.changes:
            place = f" ({change.where()})" if change.where() else ""
            work.mended.append(f"{change.code}{place}: {change.message}")
        return repaired.pattern

    def _complete(self, work: _Work, sewer: GarmentSewer) -> None:
        from dataclasses import replace

        started = time.perf_counter()
        assert work.prepared is not None and work.values is not None
        garment = sewer.decode(work.prepared, work.values)
        work.seconds["decoding"] = time.perf_counter() - started
        report = garment.report | {
            "seconds": {name: round(value, 4) for name, value in work.seconds.items()},
            "findings": [_finding(f) for f in work.findings],
        }
        if work.mended:
            report["mended"] = work.mended
        garment = replace(garment, report=report)
        if self.finish:
            from swifttailor.draping.finish import finish

            garment = finish(garment)
        garment.save(work.folder, preview=self.preview)
        work.garment, work.report = garment, garment.report

    def _say(self, work: _Work) -> None:
        if work.garment is None:
            print(f"{work.path}: not sewn. {work.report['error']}")  # noqa: T201
            return
        for change in work.mended:
            print(f"{work.path}: mended {change}")  # noqa: T201
        for finding in work.findings:
            place = f" ({finding.where()})" if finding.where() else ""
            print(f"{work.path}: {finding.severity.value}: {finding.code}{place}: {finding.message}")  # noqa: T201
        report = work.report
        sewing = report["sewing"]
        print(  # noqa: T201
            f"{work.path}: {report['panels']} panels, {report['vertices']} vertices; seams were "
            f"{sewing['seam_gap_before_median_cm']:.2f} cm apart and are closed; "
            f"{sum(report['seconds'].values()):.2f} s. Wrote {work.folder}"
        )


class _Work:
    """One pattern on its way."""

    def __init__(self, path: Path, folder: Path) -> None:
        self.path, self.folder = path, folder
        self.prepared: Prepared | None = None
        self.values: Floats | None = None
        self.garment: Garment | None = None
        self.findings: tuple[Finding, ...] = ()
        self.mended: list[str] = []
        self.seconds: dict[str, float] = {}
        self.report: dict[str, Any] = {}


def _is_flawed(report: dict[str, Any]) -> bool:
    """Whether a person should look: something is wrong with the pattern, or the drape is not accepted."""
    wrong = any(f["severity"] != "info" for f in report["findings"])
    return wrong or "mended" in report or not report.get("quality", {"accepted": True})["accepted"]


def _finding(finding: Finding) -> dict[str, Any]:
    return {
        "code": finding.code,
        "severity": finding.severity.value,
        "where": finding.where(),
        "message": finding.message,
    }

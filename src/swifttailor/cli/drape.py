"""``swifttailor drape``: sewing patterns to stitched 3D garments, by physics."""

from __future__ import annotations

import json
import sys
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from swifttailor.cli.fabric_option import FabricOption
from swifttailor.cli.findings_shown import REPORT_HAS_ALL, first_of
from swifttailor.cli.option_checks import (
    require_edge_length,
    require_limit,
    require_seed,
    require_time_limit,
    require_writable_folder,
    worker_count,
)
from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.results import GarmentResults, file_name, new_place
from swifttailor.cli.wearer_options import WearerOptions, worn_by
from swifttailor.errors import InputError, SwiftTailorError

if TYPE_CHECKING:
    from swifttailor.draping.sewable import Sewable
    from swifttailor.garment.garment import Garment
    from swifttailor.output_folder import OutputFolder
    from swifttailor.pattern import Finding

SOMETHING_TO_LOOK_AT = 1
UNUSABLE = 2
MORE_TIME = "Choose a longer --edge-length, or give it more time with --time-limit SECONDS."


@dataclass(frozen=True, kw_only=True)
class Drape(GarmentResults, WearerOptions, FabricOption):
    """Sew a pattern together on a body and let it hang to rest.

    Writes pattern.json, pattern.svg, garment.glb, garment.obj, preview.png and report.json into a folder.

    With --batch, drapes all patterns of a .jsonl or .jsonl.gz file or of a folder, each into a folder of its
    own, with results.jsonl, summary.json and sheets of the previews. Started again, it goes on where it
    stopped.

    Exit code 0: made, and within the limits of quality; 1: made, but there are warnings about the pattern or
    something is beyond the limits (with --batch: beyond the limits for some garment, or some failed); 2: not
    made.
    """

    pattern: Annotated[tyro.conf.Positional[Path | None], tyro.conf.arg(metavar="PATTERN")] = None
    """GarmentCode JSON file to drape."""
    edge_length: float = 2.0
    """Edge length of the cloth's triangles in cm, 0.5 to 10: shorter is finer and slower."""
    engine: str = "xpbd"
    """What does the last stage: xpbd (built in), newton (extra 'newton'), or the name of an engine of
    another package."""
    seed: int = 0
    """0 gives the same garment every time; others shift the start by a hundredth of a millimetre."""
    rotation: Literal["intrinsic", "extrinsic"] = "intrinsic"
    """How to read the placement angles: as GarmentCode's generator writes them (intrinsic), or as its
    simulator and older files do (extrinsic)."""
    repair: tyro.conf.FlagCreatePairsOff[bool] = False
    """Repair the pattern first, as swifttailor check --repair does."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print the report (with --batch: the summary) as JSON."""
    batch: Annotated[Path | None, tyro.conf.arg(metavar="PATTERNS")] = None
    """Drape many: .jsonl or .jsonl.gz with one {"id": ..., "pattern": ...} a line, or a folder of .json."""
    workers: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """With --batch: garments draped at the same time. Default: one per CPU core."""
    limit: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """With --batch: only the first N patterns."""
    time_limit: Annotated[float | None, tyro.conf.arg(metavar="SECONDS")] = None
    """Give up on a garment after computing for so long. Default: 22, more where --edge-length is below 2;
    with --batch or another engine: 600."""
    retry_failed: tyro.conf.FlagCreatePairsOff[bool] = False
    """With --batch: when resuming, retry what failed before."""

    def run(self) -> int:
        """Drapes, prints what came of it, and returns the exit code.

        Raises:
            SwiftTailorError: Something is not usable. With `json`, that is printed as JSON instead and 2
                returned.
        """
        try:
            self._validate()
            if self.batch is not None:
                from swifttailor.cli.drape_batch import run_drape_batch

                return run_drape_batch(self, self.batch)
            assert self.pattern is not None
            return self._drape_one(self.pattern)
        except SwiftTailorError as error:
            if not self.json:
                raise
            _print_json({"error": str(error)})
            return UNUSABLE

    def _validate(self) -> None:
        """Refuses what cannot work before anything is loaded."""
        if self.pattern is not None and self.batch is not None:
            raise InputError(
                f"Both a pattern ('{self.pattern}') and --batch ('{self.batch}') were given. "
                "Give PATTERN for one garment or --batch PATTERNS for many."
            )
        if self.pattern is None and self.batch is None:
            raise InputError(
                "No pattern was given. Give one: swifttailor drape PATTERN --out DIR, "
                "or many: swifttailor drape --batch PATTERNS --out DIR"
            )
        if self.batch is None:
            self._refuse_batch_options()
        elif self.refits or self.pose != "A":
            raise InputError(
                "With --batch, patterns are draped as they were drafted: --size, --measure, --figure, --fit "
                "and --pose go with a single pattern. Refit them first with: swifttailor fit"
            )
        require_edge_length(self.edge_length)
        require_seed(self.seed)
        worker_count(self.workers)
        require_limit(self.limit)
        require_time_limit(self.time_limit)
        require_writable_folder(self.folder)

    def usual_place(self) -> Path:
        """Named after the pattern; that of a batch is the same each time, so that it is resumed."""
        if self.batch is not None:
            return Path(file_name(f"{self.batch.name.split('.')[0]}-draped"))
        return new_place(f"{self.pattern.stem if self.pattern else 'garment'}-draped")

    def _refuse_batch_options(self) -> None:
        given = {
            "--workers": self.workers is not None,
            "--limit": self.limit is not None,
            "--retry-failed": self.retry_failed,
        }
        for name, is_given in given.items():
            if is_given:
                raise InputError(f"{name} goes with --batch PATTERNS; for a single pattern leave it out.")

    def _drape_one(self, source: Path) -> int:
        from swifttailor.garment.folder import GLB, PREVIEW, names_written
        from swifttailor.output_folder import OutputFolder

        sources = [source] if self.body is None else [source, self.body]
        with OutputFolder(self.folder, overwrite=self.overwrite, sources=sources) as output:
            output.require_own(names_written(preview=self.preview))
            garment, sewable, saving = self._make(source, output)
        if self.json:
            _print_json(garment.report)
        else:
            self._print_summary(garment, sewable.findings, saving)
        self.show(PREVIEW, GLB)
        accepted = garment.report["quality"]["accepted"] and not sewable.doubtful
        return 0 if accepted else SOMETHING_TO_LOOK_AT

    def _make(self, source: Path, output: OutputFolder) -> tuple[Garment, Sewable, float]:
        """Drapes and saves; returns the garment, its pattern and the seconds that saving took."""
        from swifttailor.cli.progress import StageProgress
        from swifttailor.garment.folder import save_garment
        from swifttailor.pattern import read_pattern_file

        started = time.perf_counter()
        reading = read_pattern_file(source, rotation=self.rotation)
        with StageProgress() as progress:
            from swifttailor.body.probe import probe_body
            from swifttailor.body.wearer import body_of
            from swifttailor.draping import drape, get_fabric
            from swifttailor.draping.compiled_code import COMPILE_NOTE, solver_is_compiled
            from swifttailor.draping.sewable import require_sewable
            from swifttailor.draping.time_limit import TimeLimit

            fabric = get_fabric(self.fabric or "cotton")
            asked = self.wearer()
            drafted_for = body_of(reading.pattern.drafted_for) if asked is None or self.refits else asked
            body = asked or drafted_for
            probe = probe_body(drafted_for)
            sewable = require_sewable(reading, str(source), repair=self.repair, body=probe)
            if self.refits:
                from swifttailor.refitting.refitted import fit

                sewable = replace(sewable, pattern=fit(sewable.pattern, body))
            loaded = time.perf_counter()
            compiled = solver_is_compiled()
            if not compiled:
                progress.note(COMPILE_NOTE)
            garment = drape(
                sewable.pattern,
                body=body,
                fabric=fabric,
                edge_length=self.edge_length,
                engine=self.engine,
                seed=self.seed,
                progress=TimeLimit(self._time_limit(), progress, instead=MORE_TIME, compiled=compiled),
            )
            report = sewable.complete_report(garment.report, loaded - started)
            garment, shown = self.posed(replace(garment, report=report), body)
            before_saving = time.perf_counter()
            progress("saving", 0.0)
            save_garment(garment, output, body=shown, preview=self.preview)
            saving = time.perf_counter() - before_saving
        return garment, sewable, saving

    def _time_limit(self) -> float:
        from swifttailor.draping.batch.run import TIME_LIMIT
        from swifttailor.draping.time_limit import usual_time_limit

        if self.time_limit is not None:
            return self.time_limit
        return usual_time_limit(self.edge_length) if self.engine == "xpbd" else TIME_LIMIT

    def _print_summary(self, garment: Garment, findings: tuple[Finding, ...], saving: float) -> None:
        report = garment.report
        quality = report["quality"]
        mended = [f"Mended {change}" for change in report.get("mended", ())]
        shown, more = first_of([*mended, *(f.line() for f in findings)], "findings", REPORT_HAS_ALL)
        print("".join(f"{line}\n" for line in (*shown, *filter(None, [more]))), end="")  # noqa: T201
        if quality["accepted"]:
            verdict = "Accepted: it hangs at rest, within all limits of quality."
        else:
            from swifttailor.draping.quality import not_accepted_line

            verdict = f"N{not_accepted_line(quality)[1:]}"
        seconds = report["seconds"] | {"saving": saving}
        stages = ", ".join(f"{name} {value:.1f}" for name, value in seconds.items() if value >= 0.05)
        look = self.folder / ("preview.png" if self.preview else "garment.glb")
        lines = [
            verdict,
            f"{report['panels']} panels, {report['vertices']} vertices, {report['faces']} faces"
            f"{worn_by(report)}.",
            f"{sum(seconds.values()):.1f} s: {stages}.",
            f"Look at {look}; the numbers are in {self.folder / 'report.json'}.",
        ]
        print("\n".join(lines))  # noqa: T201


def _print_json(value: dict[str, Any]) -> None:
    from swifttailor.garment.folder import plain

    sys.stdout.write(json.dumps(plain(value), indent=2, allow_nan=False) + "\n")

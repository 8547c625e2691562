"""``swifttailor fit``: a pattern refitted to another body, or to all sizes of a run."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from swifttailor.cli.findings_shown import first_of
from swifttailor.cli.option_checks import require_writable_folder
from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.results import file_name, new_place
from swifttailor.cli.wearer_options import BodyOptions
from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.body.size_charts import Size
    from swifttailor.output_folder import OutputFolder
    from swifttailor.pattern import Pattern

SOMETHING_TO_LOOK_AT = 1


@dataclass(frozen=True, kw_only=True)
class Fit(BodyOptions):
    """Refit a pattern to another body: by a size, by measures, or by a file of either.

    Ease, style lines and proportions are kept; seams that were equally long stay so, and what is symmetric
    stays symmetric. The file says for which body it is, so that it can be refitted again.

    With --sizes, refits to every size from one to another, and writes a file each into a folder.

    Exit code 0: done; 1: done, but a check finds something in a refitted pattern; 2: not done.
    """

    pattern: Annotated[tyro.conf.Positional[Path], tyro.conf.arg(metavar="PATTERN")]
    """GarmentCode JSON file."""
    out: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """File to write; with --sizes, the folder. Default: a new one in the current folder."""
    sizes: Annotated[str | None, tyro.conf.arg(metavar="RUN")] = None
    """A run of sizes of one chart: 36-46, "UK 8-16", "men 46-54", S-XL, or a list, 36,40,44."""
    drafted_for: Annotated[str | None, tyro.conf.arg(metavar="SIZE")] = None
    """Size that the pattern was drafted for. Default: the body that its file names, else the default body."""
    rotation: Literal["intrinsic", "extrinsic"] = "intrinsic"
    """How to read the placement angles: as GarmentCode's generator writes them (intrinsic), or as its
    simulator and older files do (extrinsic)."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace FILE where there is one already; with --sizes, files of others in the folder."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print what was done as JSON."""

    def run(self) -> int:
        """Refits, prints what came of it, and returns the exit code.

        Raises:
            SwiftTailorError: An option or the pattern cannot be used.
        """
        if self.sizes is None and not self.names_body:
            raise InputError(
                "No body was given. Give one with --size 44, --measure bust=96 height=172, or --body FILE."
            )
        if self.sizes is not None and self.names_body:
            raise InputError("Both --sizes and another body were given. Give one of them.")
        from swifttailor.atomic_files import require_free

        wanted = self._wanted()
        for _, path in wanted:
            if path.exists() and path.samefile(self.pattern):
                raise InputError(f"'{path}' is the pattern itself. Choose another --out.")
            if self.sizes is None:
                require_free(path, overwrite=self.overwrite)
        from swifttailor.body.wearer import Wearer
        from swifttailor.pattern import check_pattern, read_pattern_file
        from swifttailor.pattern.check import require_no_errors

        reading = read_pattern_file(self.pattern, rotation=self.rotation)
        pattern = reading.pattern
        require_no_errors(check_pattern(pattern, reader_findings=reading.findings), f"'{self.pattern}'")
        first = None if self.drafted_for is None else Wearer(size=self.drafted_for).body()
        bodies = [self.wearer() if size is None else Wearer(size=size.title).body() for size, _ in wanted]
        fitted = [b for b in bodies if b is not None]
        if self.sizes is None:
            return self._fit(pattern, first, fitted, [wanted[0][1]])
        from swifttailor.output_folder import OutputFolder

        paths = [path for _, path in wanted]
        with OutputFolder(paths[0].parent, overwrite=self.overwrite, sources=[self.pattern]) as output:
            output.require_own(path.name for path in paths)
            return self._fit(pattern, first, fitted, paths, output)

    def _wanted(self) -> list[tuple[Size | None, Path]]:
        """Sizes, or None for the body of the other options, and the file of each."""
        if self.sizes is None:
            out = self.out if self.out is not None else new_place(f"{self.pattern.stem}-fitted", ".json")
            require_writable_folder(out.parent)
            return [(None, out)]
        from swifttailor.body.size_charts import size_run

        folder = self.out if self.out is not None else new_place(f"{self.pattern.stem}-sizes")
        require_writable_folder(folder)
        return [(size, folder / f"{file_name(size.title)}.json") for size in size_run(self.sizes)]

    def _fit(
        self,
        pattern: Pattern,
        first: Body | None,
        bodies: Sequence[Body],
        paths: Sequence[Path],
        output: OutputFolder | None = None,
    ) -> int:
        """Refits to each body, then writes all files or none, into `output` where there is one."""
        from swifttailor.body.probe import probe_body
        from swifttailor.pattern import Severity, check_pattern
        from swifttailor.refitting.refitted import refit

        sewn, reports, patterns, flawed = None, [], [], False
        for body, path in zip(bodies, paths, strict=True):
            made = refit(pattern, body, drafted_for=first, sewn=sewn)
            sewn = made.sewn
            findings = [
                f
                for f in check_pattern(made.pattern, body=probe_body(body))
                if f.severity is not Severity.INFO
            ]
            flawed |= bool(findings)
            patterns.append(made.pattern)
            reports.append(_report(body, path, [f.line() for f in findings]))
        if output is None:
            patterns[0].save(paths[0], overwrite=self.overwrite)
        else:
            with output.fill() as folder:
                for one, path in zip(patterns, paths, strict=True):
                    one.save(folder / path.name)
        if not self.json:
            print("\n".join(map(_line, reports)))  # noqa: T201
        if self.json:
            sys.stdout.write(json.dumps(reports, indent=2) + "\n")
        return SOMETHING_TO_LOOK_AT if flawed else 0


def _report(body: Body, path: Path, findings: list[str]) -> dict[str, Any]:
    m = body.measurements
    measures = {name: round(getattr(m, name), 1) for name in ("height", "bust", "waist", "hips")}
    return {"file": str(path), "body": body.name, "measures": measures, "findings": findings}


def _line(report: dict[str, Any]) -> str:
    shown = ", ".join(f"{name} {value:g}" for name, value in report["measures"].items())
    findings, more = first_of(report["findings"], "findings", f"swifttailor check {report['file']} --all")
    lines = [f"{report['file']}: for {report['body']} ({shown} cm)", *findings, more]
    return "\n".join(filter(None, lines))

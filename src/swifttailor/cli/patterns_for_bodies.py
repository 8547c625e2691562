"""Commands that make a pattern for a body, or one for each size of a run, and write nothing else."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

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
class PatternsForBodies(BodyOptions):
    """Options of who wears it, and where patterns are written."""

    out: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """File to write; with --sizes, the folder. Default: a new one in the current folder."""
    sizes: Annotated[str | None, tyro.conf.arg(metavar="RUN")] = None
    """A run of sizes of one chart: 36-46, "UK 8-16", "men 46-54", S-XL, or a list, 36,40,44."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace FILE where there is one already; with --sizes, files of others in the folder."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print what was done as JSON."""

    def make_all(
        self, source: Path, named: str, prepare: Callable[[], Callable[[Body], Pattern]], *, slow: bool
    ) -> int:
        """Makes the pattern for each body, writes all or none, prints what came of it.

        Args:
            source: The file that the patterns are made from; it is not replaced.
            named: What a new file is named after.
            prepare: Reads the file; what it returns makes a pattern.
            slow: Whether a file that is in the way is refused before anything is made.

        Returns:
            The exit code.

        Raises:
            SwiftTailorError: An option or the file cannot be used.
        """
        if self.sizes is not None and self.names_body:
            raise InputError("Both --sizes and another body were given. Give one of them.")
        from swifttailor.atomic_files import require_free
        from swifttailor.body import Body
        from swifttailor.body.wearer import Wearer

        wanted = self._wanted(source, named)
        for _, path in wanted:
            if path.exists() and path.samefile(source):
                raise InputError(f"'{path}' is {self.source_is} itself. Choose another --out.")
            if slow and self.sizes is None:
                require_free(path, overwrite=self.overwrite)
        make = prepare()
        bodies = [self.wearer() if size is None else Wearer(size=size.title).body() for size, _ in wanted]
        worn = [Body.default() if body is None else body for body in bodies]
        paths = [path for _, path in wanted]
        if self.sizes is None:
            return self._write(make, worn, paths)
        from swifttailor.output_folder import OutputFolder

        with OutputFolder(paths[0].parent, overwrite=self.overwrite, sources=[source]) as output:
            output.require_own(path.name for path in paths)
            return self._write(make, worn, paths, output)

    @property
    def source_is(self) -> str:
        """What the file is that patterns are made from."""
        return "the pattern"

    def _wanted(self, source: Path, named: str) -> list[tuple[Size | None, Path]]:
        """Sizes, or None for the body of the other options, and the file of each."""
        if self.sizes is None:
            out = self.out if self.out is not None else new_place(named, ".json")
            require_writable_folder(out.parent)
            return [(None, out)]
        from swifttailor.body.size_charts import size_run

        folder = self.out if self.out is not None else new_place(f"{source.stem}-sizes")
        require_writable_folder(folder)
        return [(size, folder / f"{file_name(size.title)}.json") for size in size_run(self.sizes)]

    def _write(
        self,
        make: Callable[[Body], Pattern],
        bodies: Sequence[Body],
        paths: Sequence[Path],
        output: OutputFolder | None = None,
    ) -> int:
        """Writes into `output` where there is one."""
        from swifttailor.body.probe import probe_body
        from swifttailor.pattern import Severity, check_pattern

        reports, patterns, flawed = [], [], False
        for body, path in zip(bodies, paths, strict=True):
            pattern = make(body)
            findings = [
                f for f in check_pattern(pattern, body=probe_body(body)) if f.severity is not Severity.INFO
            ]
            flawed |= bool(findings)
            patterns.append(pattern)
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

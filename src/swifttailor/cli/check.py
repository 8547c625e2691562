"""``swifttailor check``: a linter for sewing patterns."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from swifttailor.cli.findings_shown import first_of
from swifttailor.cli.postponed_imports import tyro

if TYPE_CHECKING:
    from rich.console import Console

    from swifttailor.pattern import Finding, Pattern
    from swifttailor.pattern.check import Change

UNREADABLE = 2
_ALL = "--all, or --json"


@dataclass(frozen=True)
class Check:
    """Find faults in a sewing pattern, and repair those that are safe to repair.

    Exit code 0: no errors or warnings; 1: there are some; 2: the file cannot be read as a pattern.
    """

    pattern: tyro.conf.Positional[Path]
    """GarmentCode JSON file to check."""
    repair: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Write the repaired pattern to this file. The exit code then tells whether faults remain."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace the file that --repair names where there is one already: the pattern itself, if you like."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print one JSON object (path, ok, findings, changes) instead of text."""
    all: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print all findings and changes. Default: the first 40 of each, gravest first."""
    rotation: Literal["intrinsic", "extrinsic"] = "intrinsic"
    """How to read the placement angles: intrinsic, as GarmentCode writes them, or extrinsic, as its
    simulator and older files mean them."""
    body: bool = True
    """Also look for panels inside the body that the pattern was drafted for, and away from where on it they
    are worn; the default body where the file names none."""

    def run(self) -> int:
        """Checks, repairs where asked, prints, and returns the exit code.

        Raises:
            SwiftTailorError: The file cannot be read as a pattern, or the repaired one not be written. With
                `json`, that is printed as JSON instead and 2 returned.
        """
        from swifttailor.errors import SwiftTailorError

        try:
            return self._check()
        except SwiftTailorError as error:
            if not self.json:
                raise
            _print_json(
                {"path": str(self.pattern), "ok": False, "error": str(error), "findings": [], "changes": []}
            )
            return UNREADABLE

    def _check(self) -> int:
        from swifttailor.pattern import check_pattern, read_pattern_file, repair_pattern
        from swifttailor.pattern.finding import Severity

        reading = read_pattern_file(self.pattern, rotation=self.rotation)
        body = None
        if self.body:
            from swifttailor.body.probe import probe_body
            from swifttailor.body.wearer import body_of

            body = probe_body(body_of(reading.pattern.drafted_for))
        changes: tuple[Change, ...] = ()
        if self.repair is None:
            findings = check_pattern(reading.pattern, reader_findings=reading.findings, body=body)
        else:
            repair = repair_pattern(reading.pattern, reading.findings, body=body)
            findings, changes = repair.remaining, repair.changes
            self._write(repair.pattern, changed=bool(changes))
        ok = not any(f.severity in (Severity.ERROR, Severity.WARNING) for f in findings)
        if self.json:
            _print_json(
                {
                    "path": str(self.pattern),
                    "ok": ok,
                    "findings": [f.to_json() for f in findings],
                    "changes": [c.to_json() for c in changes],
                }
            )
        else:
            self._print_text(findings, changes)
        return 0 if ok else 1

    def _write(self, mended: Pattern, *, changed: bool) -> None:
        """Writes the mended pattern; a sound one is not written over itself."""
        assert self.repair is not None
        if changed or not (self.repair.exists() and self.repair.samefile(self.pattern)):
            mended.save(self.repair, overwrite=self.overwrite)

    def _print_text(self, findings: tuple[Finding, ...], changes: tuple[Change, ...]) -> None:
        from rich.console import Console

        console = Console(highlight=False, soft_wrap=True)
        shown, more_changes = (changes, "") if self.all else first_of(changes, "changes", _ALL)
        for change in shown:
            console.print("[green]mended[/]   ", end="")
            _print_plain(console, _line(change.code, change.where(), change.message))
        listed, more_findings = (findings, "") if self.all else first_of(findings, "findings", _ALL)
        if more_changes:
            _print_plain(console, more_changes)
        _print_findings(console, listed)
        if more_findings:
            _print_plain(console, more_findings)
        _print_plain(console, f"{self.pattern}: {_summary(findings)}")
        if self.repair is not None:
            count = "1 change" if len(changes) == 1 else f"{len(changes) or 'no'} changes"
            _print_plain(console, f"{count}; the pattern is in {self.repair}")


def _print_findings(console: Console, findings: Iterable[Finding]) -> None:
    style = {"error": "bold red", "warning": "yellow", "info": "cyan"}
    for finding in findings:
        console.print(f"[{style[finding.severity]}]{finding.severity:<9}[/]", end="")
        _print_plain(console, _line(finding.code, finding.where(), finding.message))
        reason = "; ".join(part for part in (finding.why, finding.repair) if part)
        if reason:
            _print_plain(console, f"          {reason}")


def _print_plain(console: Console, text: str) -> None:
    """Prints text that may come from a file: no markup, and nothing the terminal cannot encode."""
    encoding = console.encoding or "utf-8"
    safe = text.encode(encoding, "backslashreplace").decode(encoding)
    console.print(safe, markup=False)


def _line(code: str, place: str, message: str) -> str:
    return f"{code}: {place}: {message}" if place else f"{code}: {message}"


def _summary(findings: Iterable[Finding]) -> str:
    counts = {"error": 0, "warning": 0, "info": 0}
    for finding in findings:
        counts[finding.severity] += 1
    if not any(counts.values()):
        return "nothing to report"
    plural = {"error": "errors", "warning": "warnings", "info": "notes"}
    single = {"error": "error", "warning": "warning", "info": "note"}
    return ", ".join(f"{n} {single[k] if n == 1 else plural[k]}" for k, n in counts.items() if n)


def _print_json(value: dict[str, Any]) -> None:
    sys.stdout.write(json.dumps(value) + "\n")

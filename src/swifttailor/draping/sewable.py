"""What stands between a file and the physics: only patterns without errors are draped."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from swifttailor.pattern import Finding, Pattern, Reading, Severity, check_pattern, repair_pattern
from swifttailor.pattern.check import BodyProbe, Change, require_no_errors


@dataclass(frozen=True)
class Sewable:
    """A pattern that may be sewn, and what was done to it."""

    pattern: Pattern
    changes: tuple[Change, ...] = ()
    """What was mended."""
    findings: tuple[Finding, ...] = ()
    """Warnings and notes that remain."""

    @property
    def doubtful(self) -> bool:
        """Whether a person should look at the pattern: there are warnings."""
        return any(finding.severity is Severity.WARNING for finding in self.findings)

    def complete_report(self, report: dict[str, Any], loading: float) -> dict[str, Any]:
        """A drape's report with the seconds for loading, and what was found and mended in the pattern."""
        report = report | {
            "seconds": {"loading": round(loading, 4)} | report["seconds"],
            "findings": [finding.entry() for finding in self.findings],
        }
        if self.changes:
            report["mended"] = [
                f"{c.code}{f' ({c.where()})' if c.where() else ''}: {c.message}" for c in self.changes
            ]
        return report


def require_sewable(
    reading: Reading, source: str, *, repair: bool = False, body: BodyProbe | None = None
) -> Sewable:
    """Checks a pattern that was read, and mends it where asked.

    Args:
        reading: From `read_pattern_file` or `read_specification`.
        source: File name or id, for messages.
        repair: Mend what `repair_pattern` can.
        body: What it is to be worn by; without it, panels inside the body are not looked for.

    Raises:
        PatternError: There are errors (left); the text names the first and how to repair it.
    """
    changes: tuple[Change, ...] = ()
    pattern = reading.pattern
    if repair:
        repaired = repair_pattern(pattern, reading.findings, body=body)
        pattern, changes, findings = repaired.pattern, repaired.changes, repaired.remaining
    else:
        findings = check_pattern(pattern, reader_findings=reading.findings, body=body)
    require_no_errors(findings, f"'{source}'", repaired=repair, option=True)
    return Sewable(pattern, changes, findings)

"""Patterns with errors are refused before anything is computed, and it is said what repairs them."""

from __future__ import annotations

from collections.abc import Iterable

from swifttailor.errors import PatternError
from swifttailor.pattern.finding import Finding, Severity

_BY_REPAIR = "--repair"
"""Stands in what mends a finding where `repair_pattern` does it."""


def errors_of(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """Those of the findings for which a pattern cannot be sewn as it stands."""
    return tuple(one for one in findings if one.severity is Severity.ERROR)


def require_no_errors(
    findings: Iterable[Finding], pattern: str, *, repaired: bool = False, option: bool = False
) -> None:
    """Refuses a pattern in which there are errors.

    Args:
        findings: Of reader and check.
        pattern: What is refused, such as a file's name in quotes; it begins the message.
        repaired: Whether they are what a repair has left.
        option: Whether the command repairs patterns itself when it is told ``--repair``.

    Raises:
        PatternError: The text names the first error, how many there are, and how to repair it.
    """
    errors = errors_of(findings)
    if not errors:
        return
    first = errors[0]
    place = f" ({first.where()})" if first.where() else ""
    count = "an error" if len(errors) == 1 else f"{len(errors)} errors, the first of them"
    remedy = _remedy(first, len(errors), repaired=repaired, option=option)
    raise PatternError(
        f"{pattern} cannot be sewn, it has {count}: {first.code}{place}: {first.message}. {remedy}"
    )


def _remedy(first: Finding, count: int, *, repaired: bool, option: bool) -> str:
    by_hand = f"by hand: {first.repair}." if first.repair else "by hand."
    if repaired:
        return f"What is left cannot be repaired without a guess. Repair it {by_hand}"
    if _BY_REPAIR not in first.repair:
        also = "" if count == 1 else " See all errors with: swifttailor check PATTERN."
        return f"It cannot be repaired without a guess. Repair it {by_hand}{also}"
    command = "swifttailor check PATTERN --repair REPAIRED"
    there = ", or add --repair to this command" if option else ""
    return f"Repair it with: {command}{there} ({first.repair})."

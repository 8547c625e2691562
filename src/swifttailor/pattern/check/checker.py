"""The linter itself: all checks over one pattern."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

from swifttailor.pattern.check.body_levels import BodyLevels
from swifttailor.pattern.check.judgements import directions_of, outlines_of, place_of
from swifttailor.pattern.check.panel_checks import check_panel
from swifttailor.pattern.check.placement_checks import (
    BodyProbe,
    SignedDistance,
    body_probe,
    check_placement,
    check_size,
)
from swifttailor.pattern.check.stitch_checks import check_stitches, usable_stitches
from swifttailor.pattern.finding import Finding, Severity
from swifttailor.pattern.pattern import Pattern

_RANK = {Severity.ERROR: 0, Severity.WARNING: 1, Severity.INFO: 2}


def check_pattern(
    pattern: Pattern,
    *,
    reader_findings: Iterable[Finding] = (),
    body: BodyProbe | SignedDistance | None = None,
) -> tuple[Finding, ...]:
    """Looks for everything that would make a pattern fail or surprise when it is sewn.

    Codes, bounds and their reasons: docs/checks.md.

    Args:
        pattern: Any pattern, faulty ones included.
        reader_findings: What the reader had to say (`Reading.findings`); put in with the rest.
        body: Signed distance to the body the panels are placed around, to find panels inside it; a callable,
            or a `BodyProbe` that knows the body's heights too. Without it that check is left out, and
            garments belong where the default body wears them.

    Returns:
        Findings, errors first; stitch and edge numbers are those of `pattern`.
    """
    found = tuple(reader_findings)
    if body is None and not found:
        return _check_of_itself(pattern)
    return _check(pattern, found, body)


@lru_cache(maxsize=64)
def _check_of_itself(pattern: Pattern) -> tuple[Finding, ...]:
    """The same pattern is checked again by each of those who alter it."""
    return _check(pattern, (), None)


def _check(
    pattern: Pattern, reader_findings: tuple[Finding, ...], body: BodyProbe | SignedDistance | None
) -> tuple[Finding, ...]:
    outlines = outlines_of(pattern)
    usable = usable_stitches(pattern)
    directions = directions_of(pattern)
    probe = body_probe(body)
    place = place_of(pattern, BodyLevels() if probe is None else probe.levels)
    findings = list(reader_findings)
    findings += check_size(pattern, outlines)
    for outline in outlines.values():
        findings += check_panel(outline)
    findings += check_stitches(pattern, outlines, usable, directions)
    findings += check_placement(outlines, directions, place, probe)
    return tuple(sorted(findings, key=lambda f: _RANK[f.severity]))

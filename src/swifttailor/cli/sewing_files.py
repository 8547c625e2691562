"""The printed pattern with its need of cloth, and what is said of its pieces."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from swifttailor.cli.findings_shown import first_of
from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.making import CuttingPlan
    from swifttailor.pattern import Finding


def write_pattern_pdf(
    plan: CuttingPlan, path: Path, *, paper: str, cloth_width: float, preview: Path | None, overwrite: bool
) -> None:
    """Writes the pattern to print.

    Args:
        plan: What is printed.
        path: File to write.
        paper: Its name or size.
        cloth_width: Of the cloth whose length the cover tells, cm.
        preview: Picture of the garment for the cover.
        overwrite: Whether another file of that name is replaced.

    Raises:
        InputError: The paper or the cloth is impossible, or the file cannot be written.
        MissingExtraError: The extra `print` is not installed.
    """
    from swifttailor.making.nesting import require_width
    from swifttailor.making.paper import Paper
    from swifttailor.making.pattern_pdf import write_pdf

    sheet = Paper.named(paper)
    require_width(cloth_width)
    printed = write_pdf(
        plan, path, paper=sheet, cloth=cloth_needed(plan, cloth_width), preview=preview, overwrite=overwrite
    )
    tiles = len(printed.sheet.tiles)
    sys.stdout.write(
        f"{len(plan.pieces)} pieces on {tiles} page{'s' * (tiles != 1)}, {printed.pages} pages in all\n"
    )


def print_findings(findings: Iterable[Finding]) -> None:
    """What a sewist should look at."""
    lines = [f"{finding.severity.value}: {finding.code}: {finding.message}" for finding in findings]
    shown, more = first_of(lines, "findings", "swifttailor check PATTERN --all")
    sys.stdout.write("".join(f"{line}\n" for line in (*shown, *filter(None, [more]))))


def cloth_needed(plan: CuttingPlan, width: float) -> list[str]:
    """Lines about the length of cloth of a width in cm, for a cover."""
    from swifttailor.making.nesting import estimate_length

    try:
        length = estimate_length(plan.pieces, width)
    except InputError as error:  # a piece wider than the cloth is no reason not to print it
        return [f"Not computed: {error}"]
    return [
        f"{length / 100:.2f} m of cloth {width:g} cm wide, without nap or print to match. Add for shrinkage. "
        "swifttailor marker finds the closest layout."
    ]

"""Files to sew from, and for other programs, of a pattern that is shown."""

from __future__ import annotations

from pathlib import Path

from swifttailor.atomic_files import write_text
from swifttailor.errors import InputError
from swifttailor.making import cutting_plan
from swifttailor.pattern import Pattern

FORMATS = ("pdf", "dxf", "md", "clo")
"""As `swifttailor convert` writes them with its usual options; ``clo`` is its ``.zip``."""
CLOTH_CM = 140.0
"""Width of the cloth whose length the cover of a PDF tells."""


def sewing_file(pattern: Pattern, folder: Path, format: str) -> bytes:
    """A file to sew from.

    Args:
        pattern: Placed around a body.
        folder: An empty one, for the time being.
        format: One of `FORMATS`.

    Raises:
        PatternError: It cannot be cut or sewn.
        MissingExtraError: A PDF is wanted, and the extra ``print`` is not installed.
    """
    plan = cutting_plan(pattern)
    path = folder / f"pattern.{'zip' if format == 'clo' else format}"
    if format == "pdf":
        from swifttailor.making.nesting import estimate_length
        from swifttailor.making.paper import Paper
        from swifttailor.making.pattern_pdf import write_pdf

        try:
            metres = estimate_length(plan.pieces, CLOTH_CM) / 100
            cloth = [f"{metres:.2f} m of cloth {CLOTH_CM:g} cm wide, without nap or print to match."]
        except InputError as error:  # a piece wider than the cloth is no reason not to print it
            cloth = [f"Not computed: {error}"]
        write_pdf(plan, path, paper=Paper.named("a4"), cloth=cloth, preview=None)
    elif format == "dxf":
        from swifttailor.making.pattern_dxf import write_dxf

        write_dxf(plan, path)
    elif format == "md":
        from swifttailor.making.sewing_steps import steps_markdown

        write_text(path, steps_markdown(plan))
    else:
        from swifttailor.making.bundle import write_bundle

        write_bundle(plan, path)
    return path.read_bytes()

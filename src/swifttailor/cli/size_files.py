"""A folder with one pattern in several sizes, as one file to print or to cut from."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.making import CuttingPlan
    from swifttailor.making.size_run import Alike, SizeRun
    from swifttailor.pattern import Pattern
    from swifttailor.pattern.panel import RotationReading

ENDINGS = (".pdf", ".dxf")


def patterns_of_sizes(folder: Path) -> list[Path]:
    """The patterns of a folder that ``swifttailor fit --sizes`` has written; none where it is another."""
    from swifttailor.garment.folder import PATTERN
    from swifttailor.pattern.pattern_list import pattern_files

    if not folder.is_dir() or (folder / PATTERN).exists():
        return []
    return pattern_files(folder)


def write_sizes(
    files: list[Path],
    target: Path,
    *,
    plan: Callable[[Pattern, Alike | None], CuttingPlan],
    rotation: RotationReading,
    paper: str,
    cloth_width: float,
    dialect: str,
    overwrite: bool,
) -> None:
    """Writes all sizes into one file, nested, with a layer for each.

    Args:
        files: Patterns, one a size.
        target: File to write.
        plan: Makes the pieces to cut of a pattern, with the sets of panels that may be one piece.
        rotation: How the files mean their placement angles.
        paper: Of a PDF.
        cloth_width: Of the cloth whose length the cover of a PDF tells, cm.
        dialect: Of a DXF.
        overwrite: Whether another file of that name is replaced.

    Raises:
        SwiftTailorError: A pattern cannot be cut, or they are not sizes of one.
    """
    from swifttailor.making.size_run import MOST_SIZES, size_names, size_order, size_run
    from swifttailor.pattern import load_pattern

    if target.suffix.lower() not in ENDINGS:
        raise InputError(
            f"Several sizes cannot be converted to '{target.name}'. Accepted: {', '.join(ENDINGS)}. "
            f"Or convert one of them: swifttailor convert {files[0]} {target.name}"
        )
    if not 2 <= len(files) <= MOST_SIZES:
        raise InputError(
            f"'{files[0].parent}' holds {len(files)} pattern{'s' * (len(files) != 1)}; 2 to {MOST_SIZES} "
            "sizes are put into one file. Make them: swifttailor fit PATTERN --sizes 36-46 --out DIR"
        )
    title = files[0].parent.resolve().name or "pattern"
    patterns = {path: replace(load_pattern(path, rotation=rotation), name=title) for path in files}
    titles = {
        path: path.stem if pattern.drafted_for is None else pattern.drafted_for.name
        for path, pattern in patterns.items()
    }
    ordered = sorted(files, key=lambda path: size_order(titles[path]))
    names = size_names([titles[path] for path in ordered])
    run = size_run([(name, patterns[path]) for name, path in zip(names, ordered, strict=True)], plan)
    if target.suffix.lower() == ".dxf":
        from swifttailor.making.pattern_dxf import write_dxf

        write_dxf(run, target, dialect="aama" if dialect == "aama" else "astm", overwrite=overwrite)
        sys.stdout.write(f"{len(run.nested)} pieces in {len(run.sizes)} sizes\n")
        return
    said = _said(names, [patterns[path] for path in ordered])
    _write_pdf(run, target, paper=paper, cloth_width=cloth_width, said=said, overwrite=overwrite)


def _write_pdf(
    run: SizeRun, target: Path, *, paper: str, cloth_width: float, said: list[str], overwrite: bool
) -> None:
    from swifttailor.cli.sewing_files import cloth_needed
    from swifttailor.making.nesting import require_width
    from swifttailor.making.paper import Paper
    from swifttailor.making.pattern_pdf import write_sizes_pdf

    sheet = Paper.named(paper)
    require_width(cloth_width)
    cloth = [
        f"Size {run.sizes[k]}: {line}" for k in (0, -1) for line in cloth_needed(run.plans[k], cloth_width)
    ]
    printed = write_sizes_pdf(run, target, paper=sheet, said=said, cloth=cloth, overwrite=overwrite)
    tiles = len(printed.sheet.tiles)
    sys.stdout.write(
        f"{len(run.nested)} pieces in {len(run.sizes)} sizes on {tiles} page{'s' * (tiles != 1)}, "
        f"{printed.pages} pages in all\n"
    )


def _said(names: list[str], patterns: list[Pattern]) -> list[str]:
    """Each size's measures; the height where it is not the same in all."""
    from swifttailor.making.made_for import MAIN_MEASURES, measures_in_words

    known = [{} if p.drafted_for is None else dict(p.drafted_for.measures) for p in patterns]
    heights = {measures.get("height") for measures in known}
    titles = [title for title in MAIN_MEASURES if title != "height" or len(heights) > 1]
    lines = []
    for name, measures in zip(names, known, strict=True):
        shown = measures_in_words(measures, titles)
        lines.append(f"{name}: {shown}" if shown else name)
    return lines

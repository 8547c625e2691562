"""``swifttailor convert``: patterns to drawings, garments to other mesh formats."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from swifttailor.cli.postponed_imports import tyro
from swifttailor.errors import InputError
from swifttailor.pattern.panel import RotationReading

PATTERN_ENDINGS = (".svg", ".json")
"""What a pattern is converted to."""


@dataclass(frozen=True)
class Convert:
    """Convert a sewing pattern or a garment to another format, chosen by the target's ending.

    A pattern (.json) becomes .svg or .json; this version cannot write PDF. A garment (.glb, .obj, .ply, .stl,
    .usd, .usda, .usdc, .usdz, or a folder written by another command) becomes any of these. A folder is taken
    as its pattern where the target is a pattern's format.
    """

    source: Annotated[Path, tyro.conf.Positional]
    """Pattern, garment, or folder to read."""
    target: Annotated[Path, tyro.conf.Positional]
    """File to write; its folder is created when missing."""
    rotation: RotationReading = "intrinsic"
    """How to read the placement angles of a pattern: as GarmentCode's generator writes them (intrinsic), or
    as its simulator and older files do (extrinsic)."""

    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace the target where there is one already."""
    open: tyro.conf.FlagCreatePairsOff[bool] = False
    """Show the result."""

    def run(self) -> int:
        """Converts, prints the file written, and returns the exit code."""
        source = self._file_in_folder() if self.source.is_dir() else self.source
        if not source.exists():
            raise InputError(f"There is no file '{source}'. Give a pattern, a garment or a garment's folder.")
        if _same_file(source, self.target):
            raise InputError(
                f"Source and target are the same file, '{self.target}'. Give the target another name."
            )
        if source.suffix.lower() == ".json":
            self._convert_pattern(source)
        else:
            self._convert_garment(source)
        print(self.target)  # noqa: T201
        if self.open:
            from swifttailor.cli.results import open_file

            open_file(self.target)
        return 0

    def _file_in_folder(self) -> Path:
        """The file of a garment's folder that serves the target."""
        from swifttailor.garment.folder import OBJ, PATTERN

        return self.source / (PATTERN if self.target.suffix.lower() in PATTERN_ENDINGS else OBJ)

    def _convert_pattern(self, source: Path) -> None:
        from swifttailor.pattern import load_pattern
        from swifttailor.pattern.svg import write_svg

        ending = self.target.suffix.lower()
        if ending not in PATTERN_ENDINGS:
            raise InputError(
                f"A pattern cannot be converted to '{self.target.name}': {_why_not(ending)}. "
                f"Accepted: {', '.join(PATTERN_ENDINGS)}. "
                f"For a garment in 3D: swifttailor drape {source} --out DIR."
            )
        pattern = load_pattern(source, rotation=self.rotation)
        if ending == ".svg":
            write_svg(pattern, self.target, overwrite=self.overwrite)
        else:
            pattern.save(self.target, overwrite=self.overwrite)

    def _convert_garment(self, source: Path) -> None:
        from swifttailor.garment.formats import MESH_ENDINGS, read_garment_mesh, write_garment_mesh

        if source.suffix.lower() not in MESH_ENDINGS:
            raise InputError(
                f"'{source}' is neither a pattern (.json) nor a garment. "
                f"Accepted: .json, {', '.join(MESH_ENDINGS)}, or a folder with a garment."
            )
        if self.target.suffix.lower() not in MESH_ENDINGS:
            raise InputError(
                f"A garment cannot be converted to '{self.target.name}': "
                f"{_why_not(self.target.suffix.lower())}. Accepted: {', '.join(MESH_ENDINGS)}; of its "
                f"pattern, {' and '.join(PATTERN_ENDINGS)}."
            )
        write_garment_mesh(read_garment_mesh(source), self.target, overwrite=self.overwrite)


def _why_not(ending: str) -> str:
    if ending == ".pdf":
        from swifttailor import __version__

        return (
            f"SwiftTailor {__version__} and earlier cannot write PDF; an .svg in true size can be opened and "
            "printed by any browser"
        )
    return f"the ending '{ending}' is unknown" if ending else "the name has no ending that tells a format"


def _same_file(first: Path, second: Path) -> bool:
    try:
        return first.samefile(second) if second.exists() else first.resolve() == second.resolve()
    except (OSError, ValueError):  # no possible file name; writing will say so
        return False

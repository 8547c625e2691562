"""``swifttailor convert``: patterns to drawings and files to sew from, garments to other mesh formats."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from swifttailor.cli.option_checks import in_range, require_edge_length
from swifttailor.cli.postponed_imports import tyro
from swifttailor.errors import InputError
from swifttailor.pattern.panel import RotationReading

if TYPE_CHECKING:
    from swifttailor.garment.triangle_mesh import TriangleMesh
    from swifttailor.making import Allowances, CuttingPlan
    from swifttailor.making.size_run import Alike
    from swifttailor.pattern import Pattern

PATTERN_ENDINGS = (".svg", ".json", ".pdf", ".dxf", ".md", ".zip", ".obj")
"""What a pattern is converted to."""
_OF_FOLDERS = tuple(ending for ending in PATTERN_ENDINGS if ending != ".obj")
"""Targets for which a garment's folder is taken as its pattern."""
_CUT = (".pdf", ".dxf", ".md", ".zip")
LISTS = (".jsonl", ".jsonl.gz")
"""What a folder of another system's outputs is converted to."""
_COLORED = (".glb", ".usd", ".usda", ".usdc", ".usdz")
_PRINTED = (".glb", ".usdz")
_MOST_ALLOWANCE_CM = 10.0


@dataclass(frozen=True)
class Convert:
    """Convert a sewing pattern or a garment to another format, chosen by the target's ending.

    A pattern (.json) becomes .pdf (to print, cut and sew), .dxf (for cutting rooms), .md (sewing steps),
    .zip (a bundle for CLO and Style3D), .obj (flat panels with sewing springs, for Blender), .svg or
    .json. A garment (.glb, .obj, .ply, .stl, .usd, .usda, .usdc, .usdz, or a folder written by another
    command) becomes any of these formats. A folder is taken as its pattern where the target is a pattern's
    format other than .obj. A folder of outputs of another system (AIpparel, ChatGarment, SewingLDM, ...)
    becomes a list of its patterns, mended, as .jsonl or .jsonl.gz.
    """

    source: Annotated[Path, tyro.conf.Positional]
    """Pattern, garment, or folder to read. A folder of fit --sizes becomes one .pdf or .dxf of all sizes."""
    target: Annotated[Path, tyro.conf.Positional]
    """File to write; its folder is created when missing."""
    rotation: RotationReading = "intrinsic"
    """How to read the placement angles of a pattern: as GarmentCode's generator writes them (intrinsic), or
    as its simulator and older files do (extrinsic)."""

    paper: str = "a4"
    """Of .pdf: a4, a3, a2, a1, a0, letter, legal, tabloid, arch-d, or a size such as 90x200cm."""
    allowance: float | None = None
    """Seam allowance in cm of .pdf, .dxf, .md and .zip. Default: 1."""
    hem_allowance: float | None = None
    """Allowance of hems, cm; curved hems get at most 1.5. Default: 3."""
    edge_allowance: float | None = None
    """Allowance of necklines, armholes and other open edges, cm. Default: 1."""
    fold: Literal["none", "front", "back", "both"] = "none"
    """What is cut on the fold, in .pdf, .dxf, .md and .zip, where there is a straight seam in the middle."""
    cloth_width: float = 140.0
    """Width in cm of the cloth whose length the .pdf tells."""
    dialect: Literal["astm", "aama"] = "astm"
    """Header of .dxf: ASTM D6673-10, or AAMA for programs that ask for it."""
    edge_length: float = 2.0
    """Edge length in cm of the panels' mesh in .obj and .zip."""

    color: str | None = None
    """Colour of the cloth in .glb and .usd, #rrggbb. Default: chosen by how the pattern is built."""
    print: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Picture to print on the cloth in .glb and .usdz; it repeats. The source is a garment's folder."""
    print_width: float = 20.0
    """Width of one repeat of the print, cm."""
    with_body: tyro.conf.FlagCreatePairsOff[bool] = False
    """Put a mannequin of the wearer into .glb and .usd too."""

    layout: Annotated[str | None, tyro.conf.arg(metavar="NAME")] = None
    """Of .jsonl: which system has written the folder. Default: told by its files."""

    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace the target where there is one already."""
    open: tyro.conf.FlagCreatePairsOff[bool] = False
    """Show the result."""

    def run(self) -> int:
        """Converts, prints the file written, and returns the exit code."""
        self._require_sense()
        code = self._convert()
        if self.open:
            from swifttailor.cli.results import open_file

            open_file(self.target)
        return code

    def _convert(self) -> int:
        if self.target.name.lower().endswith(LISTS):
            from swifttailor.cli.released_outputs import write_list

            return write_list(self.source, self.target, self.layout, overwrite=self.overwrite)
        sizes = self._sizes()
        if sizes:
            self._convert_sizes(sizes)
            print(self.target)  # noqa: T201
            return 0
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
        return 0

    def _sizes(self) -> list[Path]:
        from swifttailor.cli.size_files import patterns_of_sizes

        return patterns_of_sizes(self.source)

    def _convert_sizes(self, files: list[Path]) -> None:
        from swifttailor.cli.size_files import write_sizes

        write_sizes(
            files,
            self.target,
            plan=self._plan,
            rotation=self.rotation,
            paper=self.paper,
            cloth_width=self.cloth_width,
            dialect=self.dialect,
            overwrite=self.overwrite,
        )

    @property
    def _ending(self) -> str:
        return self.target.suffix.lower()

    def _require_sense(self) -> None:
        """Refuses options that the target has no use for, and values out of range."""
        for option, value in (
            ("--allowance", self.allowance),
            ("--hem-allowance", self.hem_allowance),
            ("--edge-allowance", self.edge_allowance),
        ):
            in_range(
                option, value, 0.0, _MOST_ALLOWANCE_CM, "cm is accepted. Usual are 1 for seams, 3 for hems."
            )
            if value is not None and self._ending not in _CUT:
                raise InputError(f"{option} has no use in '{self.target.name}'. It is for {', '.join(_CUT)}.")
        if self.fold != "none" and self._ending not in _CUT:
            raise InputError(f"--fold has no use in '{self.target.name}'. It is for {', '.join(_CUT)}.")
        require_edge_length(self.edge_length)
        for option, given, endings in (
            ("--color", self.color is not None, _COLORED),
            ("--print", self.print is not None, _PRINTED),
            ("--with-body", self.with_body, _COLORED),
            ("--layout", self.layout is not None, LISTS),
        ):
            if given and not self.target.name.lower().endswith(endings):
                raise InputError(
                    f"{option} has no use in '{self.target.name}'. It is for {', '.join(endings)}."
                )

    def _file_in_folder(self) -> Path:
        """The file of a garment's folder that serves the target."""
        from swifttailor.garment.folder import OBJ, PATTERN

        return self.source / (PATTERN if self._ending in _OF_FOLDERS else OBJ)

    def _convert_pattern(self, source: Path) -> None:
        from swifttailor.pattern import load_pattern

        if self._ending not in PATTERN_ENDINGS:
            raise InputError(
                f"A pattern cannot be converted to '{self.target.name}': {_why_not(self._ending)}. "
                f"Accepted: {', '.join(PATTERN_ENDINGS)}. "
                f"For a garment in 3D: swifttailor drape {source} --out DIR."
            )
        pattern = load_pattern(source, rotation=self.rotation)
        if self.source.is_dir() and self._ending in _CUT:  # all garments' patterns are called "pattern"
            pattern = replace(pattern, name=self.source.resolve().name or pattern.name)
        if self._ending == ".svg":
            from swifttailor.pattern.svg import write_svg

            write_svg(pattern, self.target, overwrite=self.overwrite)
        elif self._ending == ".json":
            pattern.save(self.target, overwrite=self.overwrite)
        elif self._ending == ".obj":
            from swifttailor.making.flat_panels import write_panels

            write_panels(pattern, self.target, edge_length=self.edge_length, overwrite=self.overwrite)
        else:
            self._write_files_to_sew_from(pattern)

    def _write_files_to_sew_from(self, pattern: Pattern) -> None:
        from swifttailor.atomic_files import write_text
        from swifttailor.cli.sewing_files import print_findings, write_pattern_pdf

        plan = self._plan(pattern)
        if self._ending == ".pdf":
            preview = self.source / "preview.png" if self.source.is_dir() else None
            write_pattern_pdf(
                plan,
                self.target,
                paper=self.paper,
                cloth_width=self.cloth_width,
                preview=preview if preview and preview.is_file() else None,
                overwrite=self.overwrite,
            )
        elif self._ending == ".dxf":
            from swifttailor.making.pattern_dxf import write_dxf

            write_dxf(plan, self.target, dialect=self.dialect, overwrite=self.overwrite)
        elif self._ending == ".md":
            from swifttailor.making.sewing_steps import steps_markdown

            write_text(self.target, steps_markdown(plan), overwrite=self.overwrite)
        else:
            from swifttailor.making.bundle import write_bundle

            write_bundle(plan, self.target, edge_length=self.edge_length, overwrite=self.overwrite)
        print_findings(plan.findings)

    def _plan(self, pattern: Pattern, alike: Alike | None = None) -> CuttingPlan:
        """The pieces to cut."""
        from swifttailor.making import cutting_plan
        from swifttailor.making.sewn_pattern import require_sewable

        trims = None
        if self.fold != "none":
            from swifttailor.making.centre_folds import fold_with_trims

            require_sewable(pattern)
            pattern, trims = fold_with_trims(pattern, front=self.fold != "back", back=self.fold != "front")
        return cutting_plan(pattern, self._allowances(), alike=alike, trims=trims)

    def _allowances(self) -> Allowances:
        from swifttailor.making import Allowances

        usual = Allowances()
        given = {"seam": self.allowance, "hem": self.hem_allowance, "edge": self.edge_allowance}
        return Allowances(**{name: getattr(usual, name) if v is None else v for name, v in given.items()})

    def _convert_garment(self, source: Path) -> None:
        from swifttailor.garment.formats import MESH_ENDINGS, read_garment_mesh, write_garment_mesh

        if source.suffix.lower() not in MESH_ENDINGS:
            raise InputError(
                f"'{source}' is neither a pattern (.json) nor a garment. "
                f"Accepted: .json, {', '.join(MESH_ENDINGS)}, or a folder with a garment."
            )
        if self._ending not in MESH_ENDINGS:
            raise InputError(
                f"A garment cannot be converted to '{self.target.name}': "
                f"{_why_not(self._ending)}. Accepted: {', '.join(MESH_ENDINGS)}; of its "
                f"pattern, {', '.join(_OF_FOLDERS)}."
            )
        mesh = (
            self._dressed(source)
            if self.source.is_dir() and self._ending in _COLORED
            else read_garment_mesh(source)
        )
        if self.print is not None and mesh.print is None:
            raise InputError(
                "Where a print lies on the panels is known of a garment's folder alone, not of "
                f"'{source.name}'. "
                "Give the folder."
            )
        mesh = self._colored(mesh)
        write_garment_mesh(mesh, self.target, overwrite=self.overwrite)

    def _dressed(self, source: Path) -> TriangleMesh:
        """The garment of a folder, in its colours, with its print."""
        from swifttailor.garment.cloth_color import cloth_color
        from swifttailor.garment.folder import PATTERN, REPORT
        from swifttailor.garment.folder_reader import read_report
        from swifttailor.garment.formats import read_garment_mesh
        from swifttailor.garment.part_looks import stated_looks
        from swifttailor.pattern import load_pattern

        report = self.source / REPORT
        looks = stated_looks(read_report(report)) if report.is_file() else ()
        if self.print is None and not looks:
            mesh = read_garment_mesh(source)
            pattern = self.source / PATTERN
            if pattern.is_file():
                mesh = replace(mesh, color=cloth_color(load_pattern(pattern).canonical()))
            return mesh
        from swifttailor.garment import Garment
        from swifttailor.garment.triangle_mesh import mesh_of_garment
        from swifttailor.making.cloth_print import cloth_print

        garment = Garment.load(self.source)
        if self.print is None:
            return mesh_of_garment(garment if self.color is None else replace(garment, color=self.color))
        return replace(mesh_of_garment(garment), print=cloth_print(garment, self.print, self.print_width))

    def _colored(self, mesh: TriangleMesh) -> TriangleMesh:
        if self.color is not None:
            from swifttailor.render.color import to_linear

            to_linear(self.color)
            mesh = replace(mesh, color=self.color)
        if self.with_body:
            from swifttailor.body import Body
            from swifttailor.body.mannequin import mannequin
            from swifttailor.garment.folder_wearer import wearer_of

            # Of a mesh by itself nothing is known but that it is one of ours.
            wearer = wearer_of(self.source) if self.source.is_dir() else Body.default()
            mesh = replace(mesh, wearer=mannequin(wearer, mesh.vertices))
        return mesh


def _why_not(ending: str) -> str:
    return f"the ending '{ending}' is unknown" if ending else "the name has no ending that tells a format"


def _same_file(first: Path, second: Path) -> bool:
    try:
        return first.samefile(second) if second.exists() else first.resolve() == second.resolve()
    except (OSError, ValueError):  # no possible file name; writing will say so
        return False

"""``swifttailor ggi``: patterns and drapes as Garment Geometry Images, and back."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.results import new_place, open_file
from swifttailor.errors import InputError
from swifttailor.garment.garment import Garment
from swifttailor.pattern import Pattern

if TYPE_CHECKING:
    from swifttailor.output_folder import OutputFolder


@dataclass(frozen=True, kw_only=True)
class Ggi:
    """Draw a pattern or a draped garment as a Garment Geometry Image, or turn one back into a garment.

    Writes ggi.npz, which holds everything, and pictures of it: semantic.png (panel types), stitching.png
    (what is sewn to what) and, from a draped garment, geometry.png (positions).

    With --decode, writes garment.glb, garment.obj and report.json.
    """

    source: Annotated[tyro.conf.Positional[Path | None], tyro.conf.arg(metavar="INPUT")] = None
    """GarmentCode JSON file, or the folder of a garment that swifttailor drape has written."""
    out: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Folder to write; created when missing. Default: a new one in the current folder, named after INPUT."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace files in DIR even where SwiftTailor has not written them, or they were changed since."""
    open: tyro.conf.FlagCreatePairsOff[bool] = False
    """Show the result."""
    resolution: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Pixels along each side of the images, 16 to 4096. Default: 256."""
    cm_per_pixel: Annotated[float | None, tyro.conf.arg(metavar="CM")] = None
    """Scale of the images. Default: the finest at which all panels fit."""
    packing: Literal["skyline", "rows"] | None = None
    """How the panels are packed: rows is the paper's way; skyline, the default, loses less space."""
    rotation: Literal["intrinsic", "extrinsic"] | None = None
    """How to read the placement angles of a pattern file: as GarmentCode's generator writes them (intrinsic,
    the default), or as its simulator and older files do (extrinsic)."""
    decode: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Turn this ggi.npz back into a garment."""
    method: Literal["outline", "grid"] | None = None
    """With --decode: panels cut along their exact outlines (outline, the default), or pixels as vertices and
    seams found in the images (grid, the paper's way)."""
    edge_length: Annotated[float | None, tyro.conf.arg(metavar="CM")] = None
    """With --decode and outline: edge length of the mesh in cm. Default: 2."""

    def run(self) -> int:
        """Encodes or decodes, prints what was made, and returns the exit code.

        Raises:
            SwiftTailorError: The input cannot be used.
        """
        from swifttailor.cli.option_checks import require_writable_folder

        if (self.source is None) == (self.decode is None):
            raise InputError(
                "Give either a pattern or a garment's folder: swifttailor ggi INPUT --out DIR, "
                "or a file to decode: swifttailor ggi --decode FILE --out DIR"
            )
        self._refuse_options_of_the_other_way()
        source = self.decode or self.source
        assert source is not None
        folder = self.out or new_place(f"{source.stem}-{'garment' if self.decode else 'ggi'}")
        require_writable_folder(folder)
        from swifttailor.output_folder import OutputFolder

        with OutputFolder(folder, overwrite=self.overwrite, sources=[source]) as output:
            if self.decode is not None:
                from swifttailor.cli.ggi_decode import run_ggi_decode

                shown = run_ggi_decode(self, self.decode, output)
            else:
                shown = self._encode(source, output)
        if self.open:
            open_file(shown)
        return 0

    def _refuse_options_of_the_other_way(self) -> None:
        drawing = {
            "--resolution": self.resolution,
            "--cm-per-pixel": self.cm_per_pixel,
            "--packing": self.packing,
            "--rotation": self.rotation,
        }
        decoding = {"--method": self.method, "--edge-length": self.edge_length}
        for name, value in (drawing if self.decode is not None else decoding).items():
            if value is not None:
                way = (
                    "drawing images; leave it out with"
                    if self.decode is not None
                    else "making garments, with"
                )
                raise InputError(f"{name} is for {way} --decode.")

    def _encode(self, source: Path, output: OutputFolder) -> Path:
        from swifttailor.ggi import encode
        from swifttailor.ggi.file import GGI_FILE, write_ggi
        from swifttailor.ggi.pictures import GEOMETRY, SEMANTIC, STITCHING, write_pictures

        drawn = self._read(source)
        worn = isinstance(drawn, Garment)
        output.require_own([GGI_FILE, SEMANTIC, STITCHING, *([GEOMETRY] if worn else [])])
        images = encode(
            drawn,
            256 if self.resolution is None else self.resolution,
            cm_per_pixel=self.cm_per_pixel,
            packing=self.packing or "skyline",
        )
        with output.fill(stale=[GEOMETRY]) as folder:
            written = [write_ggi(images, folder / GGI_FILE), *write_pictures(images, folder)]
        layout = images.layout
        assert layout is not None
        print(  # noqa: T201
            f"{len(layout.pattern.panels)} panels, {images.stitching.stitch_count} stitches; "
            f"{layout.cm_per_pixel:.3g} cm per pixel, {images.occupancy.mean():.0%} of the image is cloth."
        )
        print(f"Wrote {', '.join(str(output.folder / path.name) for path in written)}")  # noqa: T201
        return output.folder / (GEOMETRY if worn else SEMANTIC)

    def _read(self, source: Path) -> Pattern | Garment:
        from swifttailor.pattern import load_pattern

        if source.is_dir():
            if self.rotation is not None:
                raise InputError("A garment's folder tells how its angles are meant; leave --rotation out.")
            return Garment.load(source)
        if source.suffix.lower() == ".npz":
            raise InputError(
                f"'{source}' is not a pattern; it looks like an image. To turn it into a garment: "
                f"swifttailor ggi --decode {source} --out DIR"
            )
        return load_pattern(source, rotation=self.rotation or "intrinsic")

"""What a tailor hands over: a pattern and the garment made of it, with all that is known of both."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.garment.garment import Garment
from swifttailor.ggi import GarmentGeometryImage, Layout, lay_out
from swifttailor.ggi.geometry import rasterize_geometry
from swifttailor.ggi.semantic import semantic_image
from swifttailor.ggi.stitching import stitching_image
from swifttailor.pattern import Finding, Pattern, Severity
from swifttailor.pattern.check import Change
from swifttailor.tailor.answer import Answer

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.pattern_maker.asking.confidence import Confidence

RESOLUTION = 256
"""Of the images of a garment that was sewn without any."""
SEEN = "seen.png"
PREVIEW_SIZE = 1000, 600
"""Pixels; drawing twice as many takes longer than everything else together."""


@dataclass(frozen=True, eq=False)
class Tailored:
    """A pattern and its garment."""

    garment: Garment
    """Its report is what `save` writes as report.json."""
    answer: Answer
    """The pattern, and how it came to be what it is."""
    notes: tuple[str, ...] = ()
    """What was done that one may want to know."""
    warnings: tuple[str, ...] = ()
    """What of the order was not used, not understood, or is doubtful."""
    body: Body | None = None
    """What it is worn by; the default body when None."""
    layout: Layout | None = None
    """Where the panels lie in the images that the network saw; None of a network that sees none."""
    prediction: Floats | None = None
    """(n, 3) cm: where the network put the occupied pixels of them; None where physics moved the garment."""

    @property
    def pattern(self) -> Pattern:
        """The pattern, in canonical order."""
        return self.garment.pattern

    @property
    def findings(self) -> tuple[Finding, ...]:
        """What a check finds in the pattern."""
        return self.answer.verdict.findings

    @property
    def changes(self) -> tuple[Change, ...]:
        """What was mended in it."""
        return self.answer.changes

    @property
    def confidence(self) -> Confidence | None:
        """How sure the network is of a picture; None without one, or where that was not measured for it."""
        return self.answer.confidence

    @property
    def report(self) -> dict[str, Any]:
        """How it was made and what came of it: JSON values."""
        return self.garment.report

    @property
    def seconds(self) -> dict[str, float]:
        """By stage; garments that were made together share some of them."""
        return self.report["seconds"]

    @property
    def needs_a_look(self) -> bool:
        """Whether something is wrong with it, or may be, or it is not all that was asked for."""
        faulty = (
            any(f.severity is not Severity.INFO for f in self.findings) or self.answer.is_other_than_wanted
        )
        return faulty or bool(self.warnings) or not self.report.get("quality", {"accepted": True})["accepted"]

    @cached_property
    def images(self) -> GarmentGeometryImage:
        """The Garment Geometry Image: as predicted, or of the finished garment."""
        layout = self.layout or lay_out(self.pattern, RESOLUTION)
        if self.prediction is None:
            geometry, _ = rasterize_geometry(layout, self.garment.mesh, self.garment.vertices)
        else:
            size = layout.resolution
            geometry = np.zeros((size, size, 3), np.float32)
            geometry.reshape(-1, 3)[layout.raster.pixels] = self.prediction
        return GarmentGeometryImage(
            layout,
            layout.raster.occupancy,
            layout.raster.panel,
            semantic_image(layout),
            stitching_image(layout),
            geometry,
        )

    def save(self, folder: Path | str, *, preview: bool = True, images: bool = True) -> Path:
        """Writes everything into a folder.

        pattern.json, pattern.svg, garment.glb, garment.obj, report.json, and where wanted ggi.npz and
        preview.png; seen.png where a picture was read. Each file is written whole or not at all, report.json
        as the last.

        Args:
            folder: Created when missing; files of these names in it are replaced, others left alone.
            preview: Whether to draw preview.png; without it that of an earlier garment is removed.
            images: Whether to write ggi.npz; without it that of an earlier garment is removed.

        Returns:
            The folder.

        Raises:
            InputError: The folder cannot be written.
        """
        from swifttailor.garment.folder import REPORT, save_folder, undone_if_it_fails
        from swifttailor.ggi.file import GGI_FILE, write_ggi

        folder = Path(folder)
        with undone_if_it_fails(folder, (GGI_FILE, SEEN)):
            self._save_seen(folder)
            if images:
                write_ggi(self.images, folder / GGI_FILE)
            elif (folder / REPORT).is_file():
                (folder / GGI_FILE).unlink(missing_ok=True)
            save_folder(self.garment, folder, body=self.body, preview=preview, preview_size=PREVIEW_SIZE)
        return folder

    def _save_seen(self, folder: Path) -> None:
        """What was looked at in pictures; that of an earlier garment is removed."""
        from swifttailor.garment.folder import REPORT

        wanted = self.answer.wanted
        if wanted is None or not wanted.pictures:
            if (folder / REPORT).is_file():
                (folder / SEEN).unlink(missing_ok=True)
            return
        from swifttailor.garment.binary_file import write_bytes
        from swifttailor.render.png import encode_png
        from swifttailor.tailor.seen_sheet import draw_seen

        part = None if wanted.part is None else wanted.part.part
        write_bytes(folder / SEEN, encode_png(draw_seen(wanted.pictures, part)))

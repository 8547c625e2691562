"""What a tailor hands over: a pattern and the garment made of it, with all that is known of both."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.garment import Garment
from swifttailor.ggi import GarmentGeometryImage, Layout, lay_out
from swifttailor.ggi.geometry import rasterize_geometry
from swifttailor.ggi.semantic import semantic_image
from swifttailor.ggi.stitching import stitching_image
from swifttailor.output_folder import OutputFolder
from swifttailor.pattern import Finding, Pattern, Severity
from swifttailor.pattern.check import Change
from swifttailor.tailor.answer import Answer

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.pattern_maker.asking.confidence import Confidence

RESOLUTION = 256
"""Of the images of a garment that was sewn without any."""
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

    def save(
        self,
        folder: Path | str,
        *,
        preview: bool = True,
        images: bool = True,
        overwrite: bool = False,
    ) -> Path:
        """Writes everything into a folder.

        pattern.json, pattern.svg, garment.glb, garment.obj, report.json, and where wanted ggi.npz and
        preview.png; seen.png where a picture was read. All of them or none; a garment that was saved there
        before is replaced.

        Args:
            folder: Created when missing; other files in it are left alone.
            preview: Whether to draw preview.png.
            images: Whether to write ggi.npz.
            overwrite: Whether files of these names are replaced that SwiftTailor has not written, or that
                were changed since.

        Returns:
            The folder.

        Raises:
            InputError: The folder cannot be written, or there are such files and not `overwrite`.
        """
        from swifttailor.garment.folder import names_written

        with OutputFolder(folder, overwrite=overwrite) as output:
            output.require_own(names_written(preview=preview))
            return self.save_in(output, preview=preview, images=images)

    def save_in(self, output: OutputFolder, *, preview: bool = True, images: bool = True) -> Path:
        """Writes everything, as `save` does, into a folder that is at hand already."""
        from swifttailor.garment.folder import GGI, OF_A_GARMENT, write_files
        from swifttailor.ggi.file import write_ggi

        with output.fill(stale=OF_A_GARMENT) as folder:
            self._write_seen(folder)
            if images:
                write_ggi(self.images, folder / GGI)
            write_files(self.garment, folder, body=self.body, preview=preview, preview_size=PREVIEW_SIZE)
        return output.folder

    def _write_seen(self, folder: Path) -> None:
        """What was looked at in pictures."""
        wanted = self.answer.wanted
        if wanted is None or not wanted.pictures:
            return
        from swifttailor.atomic_files import write_bytes
        from swifttailor.garment.folder import SEEN
        from swifttailor.render.png import encode_png
        from swifttailor.tailor.seen_sheet import draw_seen

        shown = wanted.part or wanted.in_words
        part = None if shown is None else shown.part
        write_bytes(folder / SEEN, encode_png(draw_seen(wanted.pictures, part)))


def only(outcomes: Sequence[Tailored | SwiftTailorError]) -> Tailored:
    """The one garment of an order for one.

    Raises:
        SwiftTailorError: It could not be made.
    """
    (one,) = outcomes
    if isinstance(one, SwiftTailorError):
        raise one
    return one

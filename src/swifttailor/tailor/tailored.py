"""What a tailor hands over: a pattern and the garment made of it, with all that is known of both."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.garment.garment import Garment
from swifttailor.ggi import GarmentGeometryImage, Layout
from swifttailor.ggi.geometry import rasterize_geometry
from swifttailor.ggi.semantic import semantic_image
from swifttailor.ggi.stitching import stitching_image
from swifttailor.pattern import Finding, Pattern, Severity
from swifttailor.pattern.check import Change
from swifttailor.pattern_maker.asking.confidence import Confidence

PREVIEW_SIZE = 1000, 600
"""Pixels; drawing twice as many takes longer than everything else together."""


@dataclass(frozen=True, eq=False)
class Tailored:
    """A pattern and its garment."""

    garment: Garment
    """On the default body; its report is what `save` writes as report.json."""
    layout: Layout
    """Where the panels lie in the images."""
    prediction: Floats | None
    """(n, 3) cm: where the network put the occupied pixels; None where physics moved the garment."""
    findings: tuple[Finding, ...] = ()
    """What a check finds in the pattern."""
    changes: tuple[Change, ...] = ()
    """What was mended in it."""
    notes: tuple[str, ...] = ()
    """What was done that one may want to know."""
    warnings: tuple[str, ...] = ()
    """What of the order was not used, not understood, or is doubtful."""
    confidence: Confidence | None = None
    """How sure the network is of a picture; None without one, or where that was not measured for it."""

    @property
    def pattern(self) -> Pattern:
        """The pattern, in canonical order."""
        return self.garment.pattern

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
        """Whether something is wrong with it, or may be."""
        faulty = any(f.severity is not Severity.INFO for f in self.findings)
        return faulty or bool(self.warnings) or not self.report.get("quality", {"accepted": True})["accepted"]

    @cached_property
    def images(self) -> GarmentGeometryImage:
        """The Garment Geometry Image: as predicted, or of the finished garment."""
        layout, size = self.layout, self.layout.resolution
        if self.prediction is None:
            geometry, _ = rasterize_geometry(layout, self.garment.mesh, self.garment.vertices)
        else:
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
        preview.png. Each file is written whole or not at all, report.json as the last.

        Args:
            folder: Created when missing; files of these names in it are replaced, others left alone.
            preview: Whether to draw preview.png; without it that of an earlier garment is removed.
            images: Whether to write ggi.npz; without it that of an earlier garment is removed.

        Returns:
            The folder.

        Raises:
            InputError: The folder cannot be written.
        """
        from swifttailor.garment.folder import REPORT, save_folder
        from swifttailor.ggi.file import GGI_FILE, write_ggi

        folder = Path(folder)
        if images:
            write_ggi(self.images, folder / GGI_FILE)
        elif (folder / REPORT).is_file():
            (folder / GGI_FILE).unlink(missing_ok=True)
        return save_folder(self.garment, folder, preview=preview, preview_size=PREVIEW_SIZE)


def finishing_notes(garment: Garment) -> list[str]:
    """What a person should know of how a garment was finished; nothing where it hung from where it was."""
    about = garment.report.get("finishing", {"from": "garment"})
    if about["from"] == "garment":
        return []
    return [f"Draped from the pattern: what was sewn did not come to rest well ({about['reasons'][0]})."]


def finding_entry(finding: Finding) -> dict[str, Any]:
    """A finding for a report."""
    return {
        "code": finding.code,
        "severity": finding.severity.value,
        "where": finding.where(),
        "message": finding.message,
    }


def finding_line(finding: Finding) -> str:
    """A finding for a person."""
    place = f" ({finding.where()})" if finding.where() else ""
    return f"{finding.severity.value}: {finding.code}{place}: {finding.message}"


def change_line(change: Change) -> str:
    """What was mended, for a person."""
    place = f" ({change.where()})" if change.where() else ""
    return f"{change.code}{place}: {change.message}"

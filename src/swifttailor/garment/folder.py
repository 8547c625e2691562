"""The folder that every command leaves behind: pattern, garment, report and preview."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor.atomic_files import write_text
from swifttailor.garment.binary_file import write_bytes
from swifttailor.garment.glb import write_glb
from swifttailor.garment.obj import write_obj
from swifttailor.garment.triangle_mesh import mesh_of_garment

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.garment.garment import Garment

PATTERN, DRAWING, GLB, OBJ = "pattern.json", "pattern.svg", "garment.glb", "garment.obj"
REPORT, PREVIEW = "report.json", "preview.png"


PREVIEW_SIZE = 1500, 900
"""Pixels."""


def save_folder(
    garment: Garment,
    folder: Path | str,
    *,
    body: Body | None = None,
    preview: bool = True,
    preview_size: tuple[int, int] = PREVIEW_SIZE,
) -> Path:
    """Writes a garment's folder.

    Args:
        garment: What to write.
        folder: Created when missing; files of the same names are replaced one by one, others left alone,
            but for the preview of an earlier garment where none is drawn of this one.
        body: Drawn in the preview; the default body when None.
        preview: Whether to draw preview.png.
        preview_size: Its width and height in pixels.

    Returns:
        The folder.

    Raises:
        InputError: The folder cannot be written.
    """
    from swifttailor.pattern.svg import write_svg

    folder = Path(folder)
    mesh = mesh_of_garment(garment)
    if not preview and (folder / REPORT).is_file():
        (folder / PREVIEW).unlink(missing_ok=True)
    garment.pattern.save(folder / PATTERN)
    write_svg(garment.pattern, folder / DRAWING)
    write_glb(mesh, folder / GLB)
    write_obj(mesh, folder / OBJ)
    if preview:
        from swifttailor.body import Body as BodyClass
        from swifttailor.garment.preview import draw_preview
        from swifttailor.render.png import encode_png

        body = body if body is not None else BodyClass.default()
        write_bytes(folder / PREVIEW, encode_png(draw_preview(garment, body, size=preview_size)))
    write_text(folder / REPORT, json.dumps(plain(garment.report), indent=2, allow_nan=False) + "\n")
    return folder


def plain(value: Any) -> Any:
    """A report as JSON can hold it: arrays as lists, numbers that are not finite as null."""
    if isinstance(value, dict):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, list | tuple | set | frozenset):
        return [
            plain(item) for item in (sorted(value, key=str) if isinstance(value, set | frozenset) else value)
        ]
    if isinstance(value, np.generic):
        return plain(value.item())
    if isinstance(value, float) and not np.isfinite(value):
        return None
    if value is None or isinstance(value, bool | int | float | str):
        return value
    return str(value)

"""The folder that every command leaves behind: pattern, garment, report and preview."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor.atomic_files import write_bytes, write_text
from swifttailor.garment.glb import write_glb
from swifttailor.garment.obj import write_obj
from swifttailor.garment.triangle_mesh import mesh_of_garment
from swifttailor.output_folder import OutputFolder

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.garment.garment import Garment

PATTERN, DRAWING, GLB, OBJ = "pattern.json", "pattern.svg", "garment.glb", "garment.obj"
REPORT, PREVIEW = "report.json", "preview.png"
GGI, SEEN = "ggi.npz", "seen.png"
OF_A_GARMENT = (PATTERN, DRAWING, GLB, OBJ, REPORT, PREVIEW, GGI, SEEN)
"""All that may lie in a garment's folder; what is of an earlier garment goes."""


PREVIEW_SIZE = 1500, 900
"""Pixels."""


def names_written(*, preview: bool) -> tuple[str, ...]:
    """Of the files that `write_files` writes."""
    return (PATTERN, DRAWING, GLB, OBJ, REPORT, *([PREVIEW] if preview else []))


def save_garment(
    garment: Garment, output: OutputFolder, *, body: Body | None = None, preview: bool = True
) -> Path:
    """Puts a garment's files into a folder, all of them or none; what is there of an earlier one goes.

    Args:
        garment: What to write.
        output: Where to.
        body: Drawn in the preview; the default body when None.
        preview: Whether to draw preview.png.

    Returns:
        The folder.

    Raises:
        InputError: The folder cannot be written, or a file in it would be replaced that is somebody's.
    """
    with output.fill(stale=OF_A_GARMENT) as folder:
        write_files(garment, folder, body=body, preview=preview)
    return output.folder


def write_files(
    garment: Garment,
    folder: Path,
    *,
    body: Body | None = None,
    preview: bool = True,
    preview_size: tuple[int, int] = PREVIEW_SIZE,
) -> None:
    """Writes a garment's files.

    Args:
        garment: What to write.
        folder: An empty one.
        body: Drawn in the preview; the default body when None.
        preview: Whether to draw preview.png.
        preview_size: Its width and height in pixels.

    Raises:
        InputError: A file cannot be written.
    """
    from swifttailor.pattern.svg import write_svg

    mesh = mesh_of_garment(garment)
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

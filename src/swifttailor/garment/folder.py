"""The folder that every command leaves behind: pattern, garment, report and preview."""

from __future__ import annotations

import json
from collections.abc import Generator, Iterable
from contextlib import contextmanager
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


@contextmanager
def undone_if_it_fails(folder: Path, names: Iterable[str] = ()) -> Generator[None]:
    """Takes back what was written into a garment's folder where not all of it could be.

    Half a garment would be taken for a foreign folder, or for a whole one. What was there before stays.

    Args:
        folder: To be written into; may not exist.
        names: Of files besides those of `save_folder`.
    """
    own = [folder / name for name in (PATTERN, DRAWING, GLB, OBJ, REPORT, PREVIEW, *names)]
    was_there, before = folder.exists(), {path for path in own if path.exists()}
    try:
        yield
    except BaseException:
        for path in own:
            if path not in before:
                path.unlink(missing_ok=True)
        if not was_there and folder.is_dir() and not any(folder.iterdir()):
            folder.rmdir()
        raise


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
    folder = Path(folder)
    with undone_if_it_fails(folder):
        _write(garment, folder, body, preview, preview_size)
    return folder


def _write(
    garment: Garment, folder: Path, body: Body | None, preview: bool, preview_size: tuple[int, int]
) -> None:
    from swifttailor.pattern.svg import write_svg

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

"""Sheets of previews, twenty to a picture."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from swifttailor.atomic_files import write_atomically
from swifttailor.garment_files.folder import PREVIEW
from swifttailor.render.contact_sheet import COLUMNS, Tile, draw_contact_sheet

ROWS = 5


def write_sheets(folder: Path, garments: list[dict[str, Any]]) -> list[Path]:
    """Writes sheet-01.png, sheet-02.png, ... for the garments that have a preview.

    Args:
        folder: Of the batch; sheets of an earlier run are replaced.
        garments: Rows of `summarize`, in the order in which to show them.

    Returns:
        The files.
    """
    shown = [g for g in garments if g["status"] == "made" and (folder / g["folder"] / PREVIEW).is_file()]
    per_sheet = COLUMNS * ROWS
    pages = [shown[k : k + per_sheet] for k in range(0, len(shown), per_sheet)]
    written = []
    for number, page in enumerate(pages, 1):
        sheet = draw_contact_sheet([_tile(folder, garment) for garment in page])
        path = folder / f"sheet-{number:02d}.png"
        write_atomically(path, lambda target, sheet=sheet: sheet.save(target, "PNG"))
        written.append(path)
    for old in folder.glob("sheet-*.png"):
        if old not in written:
            old.unlink()
    return written


def _tile(folder: Path, garment: dict[str, Any]) -> Tile:
    accepted = garment["accepted"]
    verdict = "accepted" if accepted else "; ".join(garment["reasons"])
    return Tile(folder / garment["folder"] / PREVIEW, garment["id"], verdict, accepted)

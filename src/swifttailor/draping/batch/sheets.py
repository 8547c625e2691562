"""Sheets of previews, twenty to a picture."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from swifttailor.garment.folder import PREVIEW
from swifttailor.render.contact_sheet import COLUMNS, Tile, draw_contact_sheet
from swifttailor.render.numbered_sheets import sheets_named, write_numbered_sheets

ROWS = 5
SHEETS = sheets_named("sheet")
"""Patterns of their names."""


def write_sheets(folder: Path, garments: list[dict[str, Any]], target: Path) -> list[Path]:
    """Writes sheet-01.png, sheet-02.png, ... for the garments that have a preview.

    Args:
        folder: Of the batch.
        garments: Rows of `summarize`, in the order in which to show them.
        target: Where the sheets go.

    Returns:
        The files.
    """
    shown = [g for g in garments if g["status"] == "made" and (folder / g["folder"] / PREVIEW).is_file()]
    return write_numbered_sheets(
        target,
        "sheet",
        shown,
        COLUMNS * ROWS,
        lambda page: draw_contact_sheet([_tile(folder, garment) for garment in page]),
    )


def _tile(folder: Path, garment: dict[str, Any]) -> Tile:
    accepted = garment["accepted"]
    verdict = "accepted" if accepted else "; ".join(garment["reasons"])
    return Tile(folder / garment["folder"] / PREVIEW, garment["id"], verdict, accepted)

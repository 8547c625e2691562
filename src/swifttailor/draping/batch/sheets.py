"""Sheets of previews, twenty to a picture, because people would rather look."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from swifttailor.atomic_files import write_atomically
from swifttailor.garment_files.folder import PREVIEW

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageFont import FreeTypeFont, ImageFont

COLUMNS, ROWS = 4, 5
THUMBNAIL = 480, 288
CAPTION_HEIGHT = 52
MARGIN = 8
_PAPER, _INK, _GREEN, _RED = (250, 249, 247), (40, 40, 40), (38, 120, 66), (176, 58, 46)


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
        sheet = _draw_sheet(folder, page)
        path = folder / f"sheet-{number:02d}.png"
        write_atomically(path, lambda target, sheet=sheet: sheet.save(target, "PNG"))
        written.append(path)
    for old in folder.glob("sheet-*.png"):
        if old not in written:
            old.unlink()
    return written


def _draw_sheet(folder: Path, garments: list[dict[str, Any]]) -> Image:
    from PIL import Image, ImageDraw, ImageFont

    width, height = THUMBNAIL
    cell = width + MARGIN, height + CAPTION_HEIGHT + MARGIN
    columns = min(COLUMNS, len(garments))
    rows = -(-len(garments) // COLUMNS)
    sheet = Image.new("RGB", (columns * cell[0] + MARGIN, rows * cell[1] + MARGIN), _PAPER)
    draw = ImageDraw.Draw(sheet)
    bold, small = ImageFont.load_default(18), ImageFont.load_default(14)
    for k, garment in enumerate(garments):
        left, top = MARGIN + k % COLUMNS * cell[0], MARGIN + k // COLUMNS * cell[1]
        with Image.open(folder / garment["folder"] / PREVIEW) as preview:
            picture = preview.convert("RGB")
        picture.thumbnail(THUMBNAIL, Image.Resampling.LANCZOS)
        sheet.paste(picture, (left + (width - picture.width) // 2, top + (height - picture.height) // 2))
        draw.text((left, top + height + 4), _fit(garment["id"], bold, width), fill=_INK, font=bold)
        accepted = garment["accepted"]
        verdict = "accepted" if accepted else "; ".join(garment["reasons"])
        color = _GREEN if accepted else _RED
        draw.text((left, top + height + 28), _fit(verdict, small, width), fill=color, font=small)
    return sheet


def _fit(text: str, font: FreeTypeFont | ImageFont, width: int) -> str:
    """The text, cut with three dots to fit a width in pixels."""
    if font.getlength(text) <= width:
        return text
    low, high = 0, len(text)
    while low < high:
        middle = (low + high + 1) // 2
        if font.getlength(text[:middle] + "...") <= width:
            low = middle
        else:
            high = middle - 1
    return text[:low] + "..."

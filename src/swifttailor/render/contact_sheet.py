"""Many pictures on one sheet, each with a title and a line about it, because people would rather look."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageFont import FreeTypeFont, ImageFont

COLUMNS = 4
THUMBNAIL = 480, 288
CAPTION_HEIGHT = 52
MARGIN = 8
_PAPER, _INK, _GREEN, _RED = (250, 249, 247), (40, 40, 40), (38, 120, 66), (176, 58, 46)


@dataclass(frozen=True)
class Tile:
    """One picture on a sheet."""

    picture: Path
    title: str
    caption: str
    good: bool
    """Decides the colour of the caption, green or red."""


def draw_contact_sheet(tiles: Sequence[Tile], *, columns: int = COLUMNS) -> Image:
    """Draws pictures in rows, from the upper left.

    Args:
        tiles: At least one.
        columns: Pictures in a row at most.
    """
    from PIL import Image, ImageDraw, ImageFont

    width, height = THUMBNAIL
    cell = width + MARGIN, height + CAPTION_HEIGHT + MARGIN
    rows = -(-len(tiles) // columns)
    size = min(columns, len(tiles)) * cell[0] + MARGIN, rows * cell[1] + MARGIN
    sheet = Image.new("RGB", size, _PAPER)
    draw = ImageDraw.Draw(sheet)
    bold, small = ImageFont.load_default(18), ImageFont.load_default(14)
    for k, tile in enumerate(tiles):
        left, top = MARGIN + k % columns * cell[0], MARGIN + k // columns * cell[1]
        with Image.open(tile.picture) as opened:
            picture = opened.convert("RGB")
        picture.thumbnail(THUMBNAIL, Image.Resampling.LANCZOS)
        sheet.paste(picture, (left + (width - picture.width) // 2, top + (height - picture.height) // 2))
        draw.text((left, top + height + 4), _fit(tile.title, bold, width), fill=_INK, font=bold)
        color = _GREEN if tile.good else _RED
        draw.text((left, top + height + 28), _fit(tile.caption, small, width), fill=color, font=small)
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

"""Contact sheets: garments beside their drapes, from the best to the worst."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from swifttailor.body import Body
from swifttailor.evaluation.garments.score import GarmentScore
from swifttailor.evaluation.spread import spread
from swifttailor.garment.garment import Garment
from swifttailor.render.numbered_sheets import write_numbered_sheets

if TYPE_CHECKING:
    from PIL.Image import Image

PER_SHEET = 6
TILE = 720, 430
_MARGIN, _CAPTION = 8, 24
_PAPER, _INK = (250, 249, 247), (40, 40, 40)


@dataclass(frozen=True, eq=False)
class Shown:
    """A row of a sheet."""

    caption: str
    garment: Garment
    drape: Garment


def chosen(scores: Sequence[GarmentScore], count: int) -> list[GarmentScore]:
    """At most `count` garments evenly from the nearest to its drape to the farthest."""
    return spread(sorted(scores, key=lambda s: (s.vertex_mean_cm, s.id)), count)


def write_sheets(folder: Path, shown: Sequence[Shown]) -> list[Path]:
    """Writes sheet-01.png and so on: each garment from three sides, and its drape to the right of it.

    Raises:
        InputError: A file cannot be written.
    """
    return write_numbered_sheets(folder, "sheet", shown, PER_SHEET, _draw)


def _draw(shown: Sequence[Shown]) -> Image:
    from PIL import Image, ImageDraw, ImageFont

    from swifttailor.garment.preview import render_preview

    width, height = 2 * TILE[0] + 3 * _MARGIN, TILE[1] + _CAPTION + _MARGIN
    sheet = Image.new("RGB", (width, height * len(shown) + _MARGIN), _PAPER)
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(16)
    for row, one in enumerate(shown):
        top = _MARGIN + row * height
        draw.text((_MARGIN, top), f"{one.caption}; right: its drape", fill=_INK, font=font)
        for column, garment in enumerate((one.garment, one.drape)):
            picture = render_preview(garment, Body.default(), size=TILE)
            sheet.paste(picture, (_MARGIN + column * (TILE[0] + _MARGIN), top + _CAPTION))
    return sheet


def caption(score: GarmentScore) -> str:
    """One line about a garment."""
    return (
        f"{score.id}, {score.kind}: vertices {score.vertex_mean_cm:.1f} cm, "
        f"surface {score.surface_cm:.1f} cm, CD {score.chamfer_cm2:.1f} cm2, "
        f"{score.inside:.1%} in the body, strain p95 {score.strain_p95:.0%}"
    )

"""Contact sheets: random samples with their drape, a caption and a render."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor.arrays import Pixels
from swifttailor.body import Body
from swifttailor.data.reader import SplitReader
from swifttailor.data.renders.files import SplitRenders
from swifttailor.looks import draw_look, random_look
from swifttailor.looks.look import Backdrop, Look, View
from swifttailor.render import Plain
from swifttailor.render.numbered_sheets import write_numbered_sheets
from swifttailor.wording.captions import write_caption

if TYPE_CHECKING:
    from PIL.Image import Image

COLUMNS, ROWS = 4, 5
TILE = 256
_CAPTION_HEIGHT, _MARGIN = 96, 10
_PAPER, _INK, _GREY = (250, 249, 247), (40, 40, 40), (120, 118, 114)
_CLOTH = Plain((0.10, 0.24, 0.35), 0.0)


@dataclass(frozen=True, eq=False)
class Shown:
    """A sample as people look at it."""

    id: str
    caption: str
    front: Pixels
    """The drape on a grey body."""
    back: Pixels
    render: Pixels
    """One of its renders, or a random look where it has none."""
    facts: dict[str, Any]
    """Numbers for the page."""


def choose(count: int, samples: int, seed: int) -> list[int]:
    """Which of `samples` samples to show, at most `count`, by lot, in ascending order."""
    chance = np.random.default_rng([seed, 77])
    return sorted(int(k) for k in chance.permutation(samples)[:count])


def show_sample(reader: SplitReader, k: int, renders: SplitRenders | None, seed: int) -> Shown:
    """Draws sample number k."""
    sample = reader[k]
    garment, body = sample.garment, Body.default()
    chance = np.random.default_rng([seed, k])
    caption = write_caption(sample.pattern, seed=int(chance.integers(1 << 30))).text
    if renders is None:
        render = draw_look(garment, body, random_look(chance, "free"), TILE)
    else:
        pictures = renders[k]
        render = _fit(pictures[int(chance.integers(len(pictures)))].pixels())
    quality = sample.about.get("quality", {})
    return Shown(
        sample.id,
        caption,
        *(draw_look(garment, body, _grey_look(azimuth), TILE) for azimuth in (0.0, 180.0)),
        render,
        {
            "number": k,
            "panels": len(sample.pattern.panels),
            "vertices": len(sample.vertices),
            "strain": round(float(quality.get("strain_p95", np.nan)), 3),
            "crossings": quality.get("self_intersections", 0),
            "source": sample.about.get("source", ""),
        },
    )


def write_sheets(folder: Path, name: str, shown: Sequence[Shown]) -> list[Path]:
    """Writes <name>-01.png, <name>-02.png, ... with twenty samples each."""
    return write_numbered_sheets(folder, name, shown, COLUMNS * ROWS, _draw_sheet)


def _grey_look(azimuth: float) -> Look:
    backdrop = Backdrop((0.93, 0.93, 0.92), (0.86, 0.86, 0.85))
    return Look(
        _CLOTH, (0.16, 0.15, 0.14), View(azimuth, whole_body=False, margin=0.08), backdrop=backdrop, seams=0.4
    )


def _fit(picture: Pixels) -> Pixels:
    from PIL import Image

    if picture.shape[0] == TILE:
        return picture
    return np.asarray(Image.fromarray(picture).resize((TILE, TILE), Image.Resampling.LANCZOS))


def wrapped(text: str, width: float, length: Callable[[str], float]) -> list[str]:
    """Breaks a text into lines no longer than a width, where no single word is; line breaks become spaces."""
    lines: list[str] = []
    for word in text.split():
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and length(longer) <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines


def _draw_sheet(shown: Sequence[Shown]) -> Image:
    from PIL import Image, ImageDraw, ImageFont

    columns, rows = min(COLUMNS, len(shown)), -(-len(shown) // COLUMNS)
    cell = 3 * TILE + _MARGIN, TILE + _CAPTION_HEIGHT + _MARGIN
    sheet = Image.new("RGB", (columns * cell[0] + _MARGIN, rows * cell[1] + _MARGIN), _PAPER)
    draw = ImageDraw.Draw(sheet)
    font, small = ImageFont.load_default(17), ImageFont.load_default(15)
    for place, one in enumerate(shown):
        left, top = _MARGIN + place % COLUMNS * cell[0], _MARGIN + place // COLUMNS * cell[1]
        for k, picture in enumerate((one.front, one.back, one.render)):
            sheet.paste(Image.fromarray(picture), (left + k * TILE, top))
        draw.text((left, top + TILE + 3), one.id, fill=_GREY, font=small)
        lines = wrapped(one.caption, 3 * TILE, font.getlength)
        text = "\n".join(lines[:4]) + (" ..." if len(lines) > 4 else "")
        draw.text((left, top + TILE + 21), text, fill=_INK, font=font, spacing=1)
    return sheet

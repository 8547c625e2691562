"""Draws photographs beside the garments that are made of them.

``python scripts/make_photograph_sheet.py PICTURE... --out sheet.webp [--picture-reader-weights FILE]``

Each row shows a picture, what was looked at, and the garments, with what was read of them; as `swifttailor
generate --image` makes them, failures included.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from swifttailor.body import Body
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.preview import draw_preview
from swifttailor.tailor import Order, Tailor, Tailored
from swifttailor.tailor.looking import SeenPicture, parts_seen
from swifttailor.tailor.seen_sheet import draw_seen
from swifttailor.wording.wish_lines import wish_line

SIDE, SEEN, GARMENT, TEXT = 300, (600, 300), (500, 300), 420
WIDE = SIDE + SEEN[0] + GARMENT[0]
_PAPER, _INK, _RED = (250, 249, 247), (40, 40, 40), (176, 58, 46)
_MOST_LINES = 14


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("pictures", type=Path, nargs="+")
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--picture-reader-weights", type=Path)
    options = parser.parse_args()
    tailor = Tailor(picture_reader=options.picture_reader_weights)
    rows = [row for path in options.pictures for row in rows_of(tailor, path)]
    sheet = Image.new("RGB", (WIDE + TEXT, SIDE * len(rows)), _PAPER)
    for k, row in enumerate(rows):
        sheet.paste(row, (0, SIDE * k))
    sheet.save(options.out, quality=85)


def rows_of(tailor: Tailor, path: Path) -> list[Image.Image]:
    """A row for each garment that is seen; one that says so where none is."""
    seen = tailor.look(path)
    rows = []
    for part in parts_seen([seen]) or (None,):
        try:
            (made,) = tailor.make(Order(image=seen, part=part))
        except SwiftTailorError as error:
            made = error
        rows.append(row_of(seen, part, made))
    return rows


def row_of(seen: SeenPicture, part: str | None, made: Tailored | SwiftTailorError) -> Image.Image:
    """A picture, what was looked at, the garment, what was read."""
    row = Image.new("RGB", (WIDE + TEXT, SIDE), _PAPER)
    pen, font = ImageDraw.Draw(row), ImageFont.load_default(14)
    row.paste(_fitted(Image.fromarray(seen.pixels), (SIDE, SIDE)), (0, 0))
    row.paste(_fitted(Image.fromarray(draw_seen([seen], part)), SEEN), (SIDE, 0))
    left = WIDE + 10
    if isinstance(made, SwiftTailorError):
        pen.multiline_text((left, 10), _wrapped(str(made)), _RED, font)
        return row
    drawn = draw_preview(made.garment, Body.default(), size=GARMENT)
    row.paste(_fitted(Image.fromarray(drawn), GARMENT), (SIDE + SEEN[0], 0))
    wanted = made.answer.wanted
    assert wanted is not None
    lines = [f"{wish_line(w.change)} ({w.certainty:.0%})" for w in wanted.seen][:_MOST_LINES]
    if wanted.worded:
        lines = ["put into words:", *(wish_line(wish.change) for wish in wanted.worded)]
    pen.multiline_text((left, 10), "\n".join([f"{part}, {made.report['panels']} panels", *lines]), _INK, font)
    return row


def _fitted(image: Image.Image, size: tuple[int, int]) -> Image.Image:
    """Whole, in the middle of a tile."""
    image = image.copy()
    image.thumbnail(size, Image.Resampling.LANCZOS)
    tile = Image.new("RGB", size, _PAPER)
    tile.paste(image, ((size[0] - image.width) // 2, (size[1] - image.height) // 2))
    return tile


def _wrapped(text: str, width: int = 52) -> str:
    lines: list[str] = [""]
    for word in text.split():
        if len(lines[-1]) + len(word) > width:
            lines.append("")
        lines[-1] = f"{lines[-1]} {word}".strip()
    return "\n".join(lines)


if __name__ == "__main__":
    main()

"""Draws the pictures of the README: the shirt-dress draft, flat and draped; nine drafts, sewn by the network.

Run from the repository root:

.venv/bin/python scripts/make_readme_pictures.py
"""

from __future__ import annotations

from pathlib import Path

from PIL import Image

import swifttailor
from swifttailor.garment.preview import render_preview
from swifttailor.pattern.svg import write_svg

FOLDER = Path("docs/images")
SIZE = 1280, 768
SEWN = (
    ("circle-skirt", "fitted-dress", "gathered-skirt"),
    ("hoodie", "jumpsuit", "shirt-dress"),
    ("t-shirt", "tank-top", "trousers"),
)
TILE = 450, 270


def draw_sewn() -> None:
    body, tailor = swifttailor.Body.default(), swifttailor.Tailor.load()
    sheet = Image.new("RGB", (TILE[0] * len(SEWN[0]), TILE[1] * len(SEWN)))
    for row, names in enumerate(SEWN):
        for column, name in enumerate(names):
            garment = tailor.sew(swifttailor.draft(name)).garment
            picture = render_preview(garment, body, size=(2 * TILE[0], 2 * TILE[1])).resize(TILE)
            sheet.paste(picture, (column * TILE[0], row * TILE[1]))
    sheet.quantize(256, dither=0).save(FOLDER / "sewn-drafts.png", optimize=True)


def main() -> None:
    draw_sewn()
    pattern = swifttailor.draft("shirt-dress")
    write_svg(pattern, FOLDER / "shirt-dress-pattern.svg")
    garment = swifttailor.drape(pattern)
    picture = render_preview(garment, swifttailor.Body.default(), size=SIZE)
    # 256 colours without dithering: a third of the size, no visible loss on a plain backdrop.
    picture.quantize(256, dither=0).save(FOLDER / "shirt-dress.png", optimize=True)
    print(
        f"accepted: {garment.report['quality']['accepted']}; {sum(garment.report['seconds'].values()):.1f} s"
    )


if __name__ == "__main__":
    main()

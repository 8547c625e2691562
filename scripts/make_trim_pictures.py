"""Draws the picture of docs/trims.md: drafts with pockets, buttons, belts, frills and bows, by the network.

.venv/bin/python scripts/make_trim_pictures.py
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from PIL import Image

import swifttailor
from swifttailor.garment.preview import render_preview

PICTURE = Path(__file__).parents[1] / "docs" / "images" / "trims.png"
WORN = (
    ("shirt", ("button placket", "chest pocket"), "#b9cbe0"),
    ("coat", ("double-breasted buttons", "side pockets", "tie belt"), "#c3a67c"),
    ("jeans", ("fly", "slant pockets", "back pockets", "buckle belt"), "#3b5578"),
    ("hoodie", ("kangaroo pocket", "zip"), "#8d9096"),
    ("dungarees", ("bib pocket", "slant pockets", "back pockets"), "#6b6a4e"),
    ("denim-jacket", ("buttons", "chest pockets"), "#2c3e5c"),
    ("shirt-dress", ("neck bow", "buttons", "sleeve frills", "hem frill"), "#a8616b"),
    ("t-shirt", ("neck rib", "chest pocket", "hem fringe"), "#5f7d72"),
    ("skater-dress", ("lacing", "apron", "lace trim"), "#4f6b94"),
)
COLUMNS, TILE = 3, (440, 264)


def main() -> None:
    body, tailor = swifttailor.Body.default(), swifttailor.Tailor.load()
    rows = -(-len(WORN) // COLUMNS)
    sheet = Image.new("RGB", (COLUMNS * TILE[0], rows * TILE[1]))
    for k, (name, trims, color) in enumerate(WORN):
        pattern = replace(swifttailor.draft(name), trims=trims)
        garment = replace(tailor.sew(pattern).garment, color=color)
        drawn = render_preview(garment, body, size=(2 * TILE[0], 2 * TILE[1])).resize(TILE)
        sheet.paste(drawn, (k % COLUMNS * TILE[0], k // COLUMNS * TILE[1]))
    sheet.quantize(256, dither=0).save(PICTURE, optimize=True)


if __name__ == "__main__":
    main()

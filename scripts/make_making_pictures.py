"""Draws the pictures of docs/making.md: pages of a printed pattern, a marker, and a printed garment.

.venv/bin/python scripts/make_making_pictures.py
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import pypdfium2
from PIL import Image

from swifttailor.making import cutting_plan
from swifttailor.making.marker_files import write_marker
from swifttailor.making.nesting import estimate_length, nest
from swifttailor.making.paper import Paper
from swifttailor.making.pattern_pdf import write_pdf
from swifttailor.pattern.drafts import draft

IMAGES = Path(__file__).parents[1] / "docs" / "images"
GREY = "#d8d5d0"


def main() -> None:
    plan = cutting_plan(draft("shirt-dress"))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        cloth = [
            f"{estimate_length(plan.pieces, 150.0) / 100:.2f} m of cloth 150 cm wide. Add for shrinkage."
        ]
        printed = write_pdf(plan, folder / "p.pdf", paper=Paper.named("a4"), cloth=cloth)
        document = pypdfium2.PdfDocument(printed.path)
        middle = 1 + len(printed.sheet.tiles) // 2
        pages = [document[k].render(scale=0.75).to_pil() for k in (0, middle, middle + 1, printed.pages - 1)]
        width = sum(p.width for p in pages) + 8 * (len(pages) + 1)
        sheet = Image.new("RGB", (width, pages[0].height + 16), GREY)
        x = 8
        for page in pages:
            sheet.paste(page, (x, 8))
            x += page.width + 8
        sheet.quantize(64).save(IMAGES / "printed-pattern.png", optimize=True)
        marker = nest(plan.pieces, 150.0, seconds=10)
        with Image.open(write_marker(marker, folder / "m.png", title=plan.name)) as picture:
            picture.thumbnail((1000, 1000), Image.Resampling.LANCZOS)
            picture.quantize(32).save(IMAGES / "marker.png", optimize=True)


if __name__ == "__main__":
    main()

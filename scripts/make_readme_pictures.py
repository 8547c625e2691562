"""Draws the pictures of the README: the shirt-dress draft, flat and draped.

Run from the repository root:

.venv/bin/python scripts/make_readme_pictures.py
"""

from __future__ import annotations

from pathlib import Path

import swifttailor
from swifttailor.pattern.svg import write_svg
from swifttailor.render import render_preview

FOLDER = Path("docs/images")
SIZE = 1280, 768


def main() -> None:
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

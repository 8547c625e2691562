"""Lays out photographs of one label as `swifttailor train picture-reader --photographs` wants them.

``python scripts/label_photographs.py FOLDER --label People --out DIR [--longest 800]``

Writes DIR/images.csv and DIR/images/NAME.jpg, the longer side of each at most so many pixels.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from PIL import Image, ImageOps

from swifttailor.data.pictures.photograph_labels import KINDS, NOTHING

SUFFIXES = (".jpg", ".jpeg", ".png", ".webp")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--label", required=True, choices=[*KINDS, *NOTHING])
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--longest", type=int, default=800)
    options = parser.parse_args()
    images = options.out / "images"
    images.mkdir(parents=True)
    rows = ["image,label"]
    for path in sorted(options.folder.iterdir()):
        if path.suffix.lower() in SUFFIXES:
            with Image.open(path) as opened:
                image = ImageOps.exif_transpose(opened).convert("RGB")
            image.thumbnail((options.longest, options.longest))
            image.save(images / f"{path.stem}.jpg", quality=90)
            rows.append(f"{path.stem},{options.label}")
    (options.out / "images.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()

"""Draws a sheet of the pictures that the picture reader learns from.

``python scripts/make_picture_sheet.py SPLIT FILE [--columns 20] [--rows 10] [--size 128] [--laid]``

SPLIT is a folder of garments that GarmentSewer has sewn (`swifttailor data build --engine network`). One
picture in seven is plain, one in five of the studio, the last row of the family that is held out; the others
show people. With ``--laid`` all are of garments that nobody wears.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from PIL import Image

from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.blocks import Family, draw
from swifttailor.data.pictures.scenes import VIEWS, Wardrobe


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("split", type=Path)
    parser.add_argument("file", type=Path)
    parser.add_argument("--columns", type=int, default=20)
    parser.add_argument("--rows", type=int, default=10)
    parser.add_argument("--size", type=int, default=128)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--laid", action="store_true")
    options = parser.parse_args()
    bank = PictureBank([options.split])
    bank.prepare(report=print)
    wardrobe = Wardrobe(bank)
    rows = []
    for row in range(options.rows):
        pictures = []
        for column in range(options.columns):
            k = row * options.columns + column
            chance = np.random.default_rng([options.seed, k])
            family: Family = "plain" if k % 7 == 0 else "studio" if k % 5 == 0 else "people"
            if row == options.rows - 1 and options.rows > 1:
                family = "held out"
            if options.laid:
                family = "laid"
            number = k % len(bank)
            pictures.append(draw(wardrobe, number, family, VIEWS[k % 3], chance, options.size).pixels)
        rows.append(np.concatenate(pictures, axis=1))
    Image.fromarray(np.concatenate(rows, axis=0)).save(options.file, quality=85)


if __name__ == "__main__":
    main()

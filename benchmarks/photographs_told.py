"""How well photographs are told from drawings, and how well people are cut out of them.

``python benchmarks/photographs_told.py --photographs FOLDER... --drawn SEWN/validation... --masks MASKS``

Of photographs of people (folders as docs/picture-reader.md has them) and of drawn people the share that is
taken for a photograph; and where MASKS has a picture of the same name, white where somebody is, intersection
over union of that with who is cut out. Drawn ones are seen from the front, in studios, as people, and in
looks that no training draws, ``--count`` each.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np
from PIL import Image

from swifttailor.cli.item_progress import ItemProgress
from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.blocks import Family, draw
from swifttailor.data.pictures.photograph_lists import SPLITS
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.data.pictures.scenes import Wardrobe
from swifttailor.picture_reader.person_finder import PersonFinder
from swifttailor.picture_reader.reader import PictureReader

LOOKS: tuple[Family, ...] = "studio", "people", "held out"
PIXELS = 600


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--photographs", type=Path, nargs="*", default=[])
    parser.add_argument("--split", choices=[*SPLITS, "all"], default="all")
    parser.add_argument("--drawn", type=Path, nargs="*", default=[], help="splits of garments")
    parser.add_argument("--count", type=int, default=25, help="garments of each")
    parser.add_argument("--masks", type=Path)
    options = parser.parse_args()
    reader = PictureReader.load()
    for folder in options.photographs:
        splits = SPLITS if options.split == "all" else (options.split,)
        shown = [one for split in splits for one in Photographs([folder], split).photographs]
        with ItemProgress(len(shown), f"'{folder.name}'") as progress:
            taken = [_told(reader, one.pixels(), progress.add) for one in shown]
        sys.stdout.write(f"{folder.name}: {sum(taken)} of {len(taken)} are taken for photographs\n")
        if options.masks:
            finder = PersonFinder.load()
            pairs = [(one, options.masks / f"{one.path.stem}.png") for one in shown]
            found = [_overlap(finder, one.pixels(), mask) for one, mask in pairs if mask.is_file()]
            if found:
                mean, half = np.mean(found), np.median(found)
                sys.stdout.write(f"{folder.name}: IoU {mean:.3f}, median {half:.3f}, of {len(found)}\n")
    for folder in options.drawn:
        bank = PictureBank([folder])
        bank.prepare()
        wardrobe = Wardrobe(bank)
        numbers = [int(k) for k in np.linspace(0, len(bank) - 1, min(options.count, len(bank)))]
        for look in LOOKS:
            taken = []
            for k in numbers:
                scene = draw(wardrobe, k, look, "front", np.random.default_rng([5, k]), PIXELS)
                taken.append(_told(reader, scene.pixels))
            sys.stdout.write(f"{folder}, {look}: {sum(taken)} of {len(taken)} are taken for photographs\n")


def _told(reader: PictureReader, pixels: np.ndarray, done=lambda count: None) -> bool:
    read = reader.read(pixels)
    done(1)
    return read.is_photograph


def _overlap(finder: PersonFinder, pixels: np.ndarray, mask: Path) -> float:
    """Intersection over union; 0 where nobody is found."""
    height, width = pixels.shape[:2]
    true = np.asarray(Image.open(mask).convert("L").resize((width, height))) > 127
    person = finder.find(pixels)
    found = np.zeros_like(true) if person is None else person.mask > 0.5
    return float((found & true).sum() / max((found | true).sum(), 1))


if __name__ == "__main__":
    main()

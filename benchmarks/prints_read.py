"""How well stripes, checks, dots and figures are read of photographs of which they are known.

``python benchmarks/prints_read.py FOLDER... [--split validation]``

FOLDER has a list of photographs (docs/picture-reader.md), --prints what is printed on the clothes in them
(benchmarks/photographs/prints.csv). Prints, for each print, of how many of the garments that have it that
is read, and how often what is read is right.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from swifttailor.cli.item_progress import ItemProgress
from swifttailor.data.pictures.photograph_lists import SPLITS
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.evaluation.pictures.prints import known_prints, read_prints
from swifttailor.picture_reader.print_head import PRINTS
from swifttailor.picture_reader.reader import PictureReader

PRINTS_KNOWN = Path(__file__).parent / "photographs" / "prints.csv"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folders", type=Path, nargs="+")
    parser.add_argument("--split", choices=[*SPLITS, "all"], default="validation")
    parser.add_argument("--prints", type=Path, default=PRINTS_KNOWN)
    options = parser.parse_args()
    splits = SPLITS if options.split == "all" else (options.split,)
    photographs = [one for split in splits for one in Photographs(options.folders, split).photographs]
    with ItemProgress(len(photographs), "photographs read") as progress:
        scores = read_prints(PictureReader.load(), photographs, known_prints(options.prints), progress.add)
    sys.stdout.write("| print | have it | read % | said of | right % |\n|---|---|---|---|---|\n")
    for word in PRINTS:
        (have, seen), (said, right) = scores.there(word), scores.said(word)
        shares = [
            f"{100 * part / whole:.1f}" if whole else "" for part, whole in ((seen, have), (right, said))
        ]
        sys.stdout.write(f"| {word} | {have} | {shares[0]} | {said} | {shares[1]} |\n")
    said, right, there = scores.printed()
    sys.stdout.write(f"Any print: said of {said}, right {right}, there {there}.\n")


if __name__ == "__main__":
    main()

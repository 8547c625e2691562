"""How well photographs of clothes are read of which some claims are known.

``python benchmarks/photographs_read.py FOLDER... [--split validation] [--limit N]``

FOLDER is laid out as the clothing dataset, or has a list of garments (docs/picture-reader.md). Prints, by
label, the share of
photographs in which exactly the garment of that part of the body is seen, and of each claim the share whose
likeliest word may be true of such clothes; of hats, shoes and people the share that the reader of laid
garments left to others.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from swifttailor.cli.item_progress import ItemProgress
from swifttailor.data.pictures.photograph_lists import SPLITS
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.evaluation.pictures.photographs import TOLD, made_of_photographs, read_photographs
from swifttailor.picture_reader.reader import SHIPPED_LAID, SHIPPED_PLAIN, PictureReader
from swifttailor.tailor import Tailor


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folders", type=Path, nargs="+")
    parser.add_argument("--split", choices=[*SPLITS, "all"], default="validation")
    parser.add_argument("--limit", type=int, default=0, help="so many of them by lot; all without it")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--picture-reader-weights", type=Path, help="instead of the package's")
    parser.add_argument("--laid-reader-weights", type=Path)
    parser.add_argument("--made", action="store_true", help="measure what is made of them, part by part")
    parser.add_argument("--not-laid", action="store_true", help="as if there were no reader of laid garments")
    options = parser.parse_args()
    splits = SPLITS if options.split == "all" else (options.split,)
    photographs = tuple(one for split in splits for one in Photographs(options.folders, split).photographs)
    if options.limit and options.limit < len(photographs):
        chosen = np.random.default_rng(options.seed).choice(len(photographs), options.limit, replace=False)
        photographs = tuple(photographs[k] for k in sorted(chosen))
    laid = options.laid_reader_weights or SHIPPED_LAID
    reader = PictureReader.load(options.picture_reader_weights, plain=SHIPPED_PLAIN, laid=laid)
    if options.not_laid:
        reader = replace(reader, laid=None)
    with ItemProgress(len(photographs), "photographs read") as progress:
        if options.made:
            tailor = Tailor.load(picture_reader=reader)
            scores = made_of_photographs(tailor, [p for p in photographs if p.main], done=progress.add)
        else:
            scores = read_photographs(reader, photographs, done=progress.add)
    names = ("made" if options.made else "laid", *(() if options.made else ("parts",)), *TOLD)
    sys.stdout.write("| label | n | " + " | ".join(names) + " |\n" + "|---" * (len(names) + 2) + "|\n")
    for label, found in sorted(scores.items(), key=lambda item: (item[0] == "all", item[0])):
        shares, count = found.shares(), max(found.counts().values(), default=0)
        if "left alone" in shares:
            sys.stdout.write(f"| {label} | {count} | {100 * shares['left alone']:.1f} % left alone |\n")
            continue
        cells = (f"{100 * shares[name]:.1f}" if name in shares else "" for name in names)
        sys.stdout.write(f"| {label} | {count} | " + " | ".join(cells) + " |\n")


if __name__ == "__main__":
    main()

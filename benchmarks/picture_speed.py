"""How long it takes from a picture to a pattern and its garment, on one processor core.

``OMP_NUM_THREADS=1 python benchmarks/picture_speed.py PICTURE... [--repeat 3]``

Networks open, one picture after the other, the garment that covers most of each: seconds on the clock by
stage and processor seconds of the whole, of each picture the least of the repeats; medians over the pictures.
"""

from __future__ import annotations

import argparse
import os
import statistics
import time
from pathlib import Path

import numpy as np

from machine import describe


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("pictures", type=Path, nargs="+")
    parser.add_argument("--repeat", type=int, default=3)
    options = parser.parse_args()
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    from swifttailor import Tailor
    from swifttailor.render.picture_file import read_picture

    print(describe())
    tailor = Tailor()
    pictures = [read_picture(path) for path in options.pictures]
    tailor.generate(image=pictures[0])
    rows = [_best(tailor, pixels, options.repeat) for pixels in pictures]
    for name in rows[0]:
        print(f"{name:12} {statistics.median(row.get(name, 0.0) for row in rows):.3f} s")


def _best(tailor, pixels: np.ndarray, repeat: int) -> dict[str, float]:
    """Of the quickest of some times."""
    found = []
    for _ in range(repeat):
        began = time.perf_counter()
        tailor.picture_reader.read(pixels)
        alone = time.perf_counter() - began
        began, before = time.perf_counter(), time.process_time()
        made = tailor.generate(image=pixels)
        spent = {"clock": time.perf_counter() - began, "processor": time.process_time() - before}
        found.append(spent | {"read alone": alone} | made.seconds)
    return min(found, key=lambda row: row["processor"])


if __name__ == "__main__":
    main()

"""How long one picture of a garment takes to draw, and what the coarse body saves and changes.

``OMP_NUM_THREADS=1 python benchmarks/look_speed.py [--size 192] [--repeat 20]``

Three garments on the default body in four looks by lot from two sides each, on one core: milliseconds on
the clock, the median of the repeats, in turn with the body of all faces. The median over the pictures, the
quickest and the slowest; and the share of pixels that differ by more than 12 of 255 between the two bodies.
"""

from __future__ import annotations

import argparse
import os
import statistics
import time

import numpy as np

import swifttailor
from machine import describe
from swifttailor.arrays import Pixels
from swifttailor.looks import draw, draw_look, random_look

WISHES = ("striped knee-length dress", "jeans", "hoodie")
LOOKS, VIEWS = 4, ("front", "free")
_SEEN = 12


def main() -> None:
    """Draws and prints."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--size", type=int, default=192)
    parser.add_argument("--repeat", type=int, default=20)
    options = parser.parse_args()
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    tailor, body = swifttailor.Tailor.load(), swifttailor.Body.default()
    usual = draw._COARSE_CM
    spent: dict[str, list[float]] = {"as it is": [], "all faces": []}
    differing = []
    print(describe())
    for wish in WISHES:
        garment = tailor.generate(wish).garment
        for view in VIEWS:
            for seed in range(LOOKS):
                look = random_look(np.random.default_rng(seed), view)
                pictures: list[Pixels] = []
                for name, least in (("as it is", usual), ("all faces", np.inf)):
                    draw._COARSE_CM = least
                    pictures.append(draw_look(garment, body, look, options.size))
                    times = []
                    for _ in range(options.repeat):
                        began = time.perf_counter()
                        draw_look(garment, body, look, options.size)
                        times.append(time.perf_counter() - began)
                    spent[name].append(1e3 * statistics.median(times))
                first, second = (p.astype(int) for p in pictures)
                differing.append(float((np.abs(first - second).max(axis=2) > _SEEN).mean()))
    for name, times in spent.items():
        print(f"{name:10} {statistics.median(times):.2f} ms ({min(times):.2f} to {max(times):.2f})")
    print(f"pixels that differ: {100 * statistics.mean(differing):.2f} %, most {100 * max(differing):.2f} %")


if __name__ == "__main__":
    main()

"""What a data set costs: bytes a sample, and time to read, to draw geometry images, and to render.

``OMP_NUM_THREADS=1 python benchmarks/data_reading.py SPLIT [--limit N] [--resolution 256]``

SPLIT is a folder that ``swifttailor data build`` has made, such as data/garments/validation. Processor time,
the least of three runs each, as a mean over the samples. Without the variable the threads that numpy starts
for small products wait at the expense of the clock; the workers of the commands have it set.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from machine import describe
from swifttailor.body import Body
from swifttailor.data.geometry_images import GeometryImages, draw
from swifttailor.data.reader import SplitReader
from swifttailor.looks import draw_look, plain_look, random_look
from swifttailor.panel_mesh import mesh_pattern


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("split", type=Path)
    parser.add_argument("--limit", type=int, default=60)
    parser.add_argument("--resolution", type=int, default=256)
    options = parser.parse_args()
    reader = SplitReader(options.split)
    numbers = [int(k) for k in reader.order(seed=0)[: options.limit]]
    print(describe())
    sizes = np.array([reader.stored(k).size for k in numbers]) / 1e3
    print(
        f"{len(numbers)} of {len(reader)} samples: {sizes.mean():.2f} KB each, largest {sizes.max():.2f} KB"
    )
    samples = [reader[k] for k in numbers]
    body = Body.default()
    with tempfile.TemporaryDirectory() as folder:
        images = GeometryImages(reader, folder, options.resolution)
        for number in {reader.place(k)[0] for k in numbers}:
            images[reader.numbers_in(number)[0]]  # draws the images of its shard
        size = sum(p.stat().st_size for p in Path(folder).iterdir()) / 1e6
        report("read a sample", lambda k: reader[k], numbers)
        report("make its panel mesh", lambda s: mesh_pattern(s.pattern, s.edge_length), samples)
        report(
            f"draw its geometry images, {options.resolution} px",
            lambda s: draw(s, options.resolution),
            samples,
        )
        report("read them from the cache instead", lambda k: images[k], numbers)
        print(f"the cache is {size:.1f} MB")
    report("plain render, 256 px", lambda s: draw_look(s.garment, body, plain_look()), samples)
    for view in ("front", "back", "free"):
        report(
            f"random render, 256 px, {view}",
            lambda s, view=view: draw_look(s.garment, body, random_look(_chance(s.id), view)),
            samples,
        )


def report(what: str, work: Callable, items: list) -> None:
    """Prints the time of `work` per item."""
    seconds = np.array([[_seconds(work, item) for item in items] for _ in range(3)]).min(axis=0)
    mean = seconds.mean()
    print(f"{what:<40} {mean * 1e3:8.2f} ms (max {seconds.max() * 1e3:.1f}), {1 / mean:7.0f} a second")


def _seconds(work: Callable, item: object) -> float:
    started = time.process_time()
    work(item)
    return time.process_time() - started


def _chance(id: str) -> np.random.Generator:
    return np.random.default_rng(list(id.encode()))


if __name__ == "__main__":
    main()

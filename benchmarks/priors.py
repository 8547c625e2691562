"""How far GarmentSewer's priors are from the drape, before any network, and what they cost.

``python benchmarks/priors.py SPLIT [--every N] [--resolution N] [--priors placed sewn hung]``

Per drape of a split of a data set: mean over the occupied pixels of the distance between prior and drape;
then the mean over garments, by kind. Processor time of one core for everything that `tabulate` adds for the
prior, the least of three runs: median, and the slowest garment.
"""

from __future__ import annotations

import argparse
from collections import defaultdict
from pathlib import Path

import numpy as np

from machine import describe
from swifttailor.body import Body
from swifttailor.data.reader import SplitReader
from swifttailor.evaluation.garment_kind import KINDS, garment_kind
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.pixels.pixel_table import tabulate
from swifttailor.ggi import lay_out
from swifttailor.ggi.geometry import geometry_raster
from swifttailor.ggi.stitching import stitching_image
from timing import least


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("split", type=Path)
    parser.add_argument("--every", type=int, default=6)
    parser.add_argument("--resolution", type=int, default=128)
    parser.add_argument("--priors", nargs="+", default=["placed", "sewn", "hung"])
    options = parser.parse_args()
    reader = SplitReader(options.split)
    body = BodyDistance.of(Body.default())
    errors: dict[str, dict[str, list[float]]] = {p: defaultdict(list) for p in options.priors}
    seconds: dict[str, list[float]] = {p: [] for p in options.priors}
    for k in range(0, len(reader), options.every):
        sample = reader[k]
        layout = lay_out(sample.pattern, options.resolution)
        stitching = stitching_image(layout)
        drape = geometry_raster(layout, sample.mesh).values(sample.vertices)
        bare, _ = least(lambda: tabulate(layout, "none", None, stitching=stitching))  # noqa: B023
        for prior in options.priors:
            table = tabulate(layout, prior, body, stitching=stitching)
            spent, _ = least(lambda: tabulate(layout, prior, body, stitching=stitching))  # noqa: B023
            errors[prior][garment_kind(layout.pattern)].append(
                float(np.linalg.norm(table.prior - drape, axis=1).mean())
            )
            seconds[prior].append(1e3 * (spent - bare))
    print(describe())
    print(f"{len(seconds[options.priors[0]])} drapes, {options.resolution} pixels; cm and ms")
    kinds = [k for k in KINDS if k in errors[options.priors[0]]]
    heads = [f"{k} ({len(errors[options.priors[0]][k])})" for k in kinds]
    print(" ".join(f"{head:>14}" for head in ("prior", "mean", "median", *heads, "time", "slowest")))
    for prior in options.priors:
        every = np.concatenate([errors[prior][k] for k in kinds])
        numbers = [every.mean(), np.median(every), *(np.mean(errors[prior][k]) for k in kinds)]
        numbers += [np.median(seconds[prior]), max(seconds[prior])]
        print(f"{prior:>14} " + " ".join(f"{n:>14.2f}" for n in numbers))


if __name__ == "__main__":
    main()

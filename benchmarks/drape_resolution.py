"""How far drapes of one pattern are apart that differ in the length of the mesh's edges alone.

``python benchmarks/drape_resolution.py SPLIT [--every 4] [--edge-lengths 6 4 3]``

SPLIT is a folder of ``swifttailor data build``. Its patterns are draped again with other edge lengths, by the
same solver to the end, and compared with the drapes of the data set at the occupied pixels of the geometry
image: mean distance in cm over the pixels, then over the garments, by kind. What a network is asked to
predict, folds and slides included, depends on the mesh by as much as this. Takes one to two seconds a drape.
"""

from __future__ import annotations

import argparse
import statistics
import time
from pathlib import Path

import numpy as np

import swifttailor
from machine import describe
from swifttailor.data.reader import SplitReader
from swifttailor.errors import SwiftTailorError
from swifttailor.evaluation.garment_kind import KINDS, garment_kind
from swifttailor.ggi import lay_out
from swifttailor.ggi.geometry import geometry_raster
from swifttailor.panel_mesh import mesh_pattern

RESOLUTION = 128


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("split", type=Path)
    parser.add_argument("--every", type=int, default=4)
    parser.add_argument("--edge-lengths", type=float, nargs="+", default=[6.0, 4.0, 3.0])
    options = parser.parse_args()
    reader = SplitReader(options.split)
    samples = [reader[k] for k in range(0, len(reader), options.every)]
    print(describe())
    print(f"{reader.index.split}, every {options.every}: n = {len(samples)}, {RESOLUTION} px")
    for edge_length in options.edge_lengths:
        errors: dict[str, list[float]] = {kind: [] for kind in KINDS}
        seconds = []
        for sample in samples:
            layout = lay_out(sample.pattern, RESOLUTION)
            mesh = mesh_pattern(layout.pattern, sample.edge_length)
            wanted = geometry_raster(layout, mesh).values(sample.garment.vertices)
            started = time.process_time()
            try:
                garment = swifttailor.drape(layout.pattern, edge_length=edge_length)
            except SwiftTailorError as error:
                print(f"{sample.id}: {error}")
                continue
            seconds.append(time.process_time() - started)
            found = geometry_raster(layout, garment.mesh).values(garment.vertices)
            errors[garment_kind(sample.pattern)].append(float(np.linalg.norm(found - wanted, axis=1).mean()))
        every = [error for some in errors.values() for error in some]
        kinds = ", ".join(f"{k} {statistics.mean(e):.2f} ({len(e)})" for k, e in errors.items() if e)
        print(
            f"{edge_length:g} cm: mean {statistics.mean(every):.2f} cm, "
            f"median {statistics.median(every):.2f}; "
            f"{kinds}; {statistics.median(seconds):.2f} s of processor time each"
        )


if __name__ == "__main__":
    main()

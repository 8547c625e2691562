"""Times drapes of real patterns and takes the peak memory.

``taskset -c 0 python benchmarks/drape_patterns.py FILE.jsonl.gz`` on an otherwise idle machine.
"""

from __future__ import annotations

import argparse
import gzip
import json
import resource
import time
from pathlib import Path

import numpy as np

import swifttailor
from machine import describe
from swifttailor.pattern import read_specification


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("patterns", type=Path, help="one JSON object with 'pattern' per line, gzipped")
    parser.add_argument("--every", type=int, default=1, help="take every k-th pattern")
    parser.add_argument("--edge-length", type=float, default=2.0, help="cm")
    options = parser.parse_args()
    with gzip.open(options.patterns, "rt") as lines:
        records = [json.loads(line) for k, line in enumerate(lines) if k % options.every == 0]
    swifttailor.drape(swifttailor.draft("tank-top"), edge_length=8.0)  # loads (or compiles) the solver
    seconds, vertices, frames = [], [], []
    for record in records:
        pattern = read_specification(record["pattern"]).pattern
        started = time.perf_counter()
        garment = swifttailor.drape(pattern, edge_length=options.edge_length)
        seconds.append(time.perf_counter() - started)
        vertices.append(len(garment.vertices))
        frames.append(garment.report["quality"]["frames"])
    print(describe())
    print(f"{options.patterns.name}, every {options.every}: n = {len(records)}, {options.edge_length:g} cm")
    for name, values in (("seconds", seconds), ("vertices", vertices), ("frames", frames)):
        low, median, high, top = np.percentile(values, [10, 50, 90, 100])
        print(
            f"{name:<9} p10 {low:.2f}  median {median:.2f}  mean {np.mean(values):.2f}  "
            f"p90 {high:.2f}  max {top:.2f}"
        )
    print(f"peak memory {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MB")


if __name__ == "__main__":
    main()

"""How long it takes from a pattern to its garment by the network, on one processor core.

``python benchmarks/sew_speed.py PATTERNS.jsonl.gz [--every 6] [--weights FILE] [--drape]``

warm
    Network open, patterns one after the other: pattern in memory -> mesh in memory. Of each the least of
    --repeat runs, median over the patterns; by stage.
cold
    ``swifttailor sew`` of one of the patterns in a new process, until its files are written; the first of
    them, which may still compile Python modules, does not count.
drape
    With --drape the same patterns by physics, in the same run, and the ratio of the medians.

The process keeps itself to one core. Run it on an otherwise idle machine.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import swifttailor
from machine import describe
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.pattern import Pattern, to_specification
from swifttailor.pattern.pattern_list import read_patterns


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("patterns", type=Path)
    parser.add_argument("--every", type=int, default=6, help="take every k-th pattern")
    parser.add_argument("--weights", type=Path)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--cold", type=int, default=5)
    parser.add_argument("--drape", action="store_true")
    options = parser.parse_args()
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    patterns = [
        p.read().pattern for k, p in enumerate(read_patterns(options.patterns)) if k % options.every == 0
    ]
    print(describe())
    print(f"{options.patterns.name}, every {options.every}: n = {len(patterns)}")
    sewing = warm(patterns, options)
    cold(patterns[0], options)
    if options.drape:
        draping = drapes(patterns)
        print(f"drape / sew: {draping / sewing:.1f} times")


def warm(patterns: list[Pattern], options: argparse.Namespace) -> float:
    """Median seconds from pattern to mesh."""
    sewer = GarmentSewer.load(options.weights)
    sewer.sew(patterns[0])
    runs = []
    for pattern in patterns:
        timed = []
        for _ in range(options.repeat):
            started = time.perf_counter()
            garment = sewer.sew(pattern)
            timed.append((time.perf_counter() - started, garment.report["seconds"]))
        runs.append(min(timed, key=lambda run: run[0]))
    seconds = np.array([run[0] for run in runs])
    stages = {name: statistics.median(run[1][name] for run in runs) for name in runs[0][1]}
    print(
        f"warm: median {np.median(seconds):.3f} s, p90 {np.percentile(seconds, 90):.3f}, "
        f"most {seconds.max():.3f} ({', '.join(f'{n} {s:.3f}' for n, s in stages.items())}); "
        f"peak memory {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MB"
    )
    return float(np.median(seconds))


def cold(pattern: Pattern, options: argparse.Namespace) -> None:
    """The command, from the shell to its files."""
    times = []
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "pattern.json"
        path.write_text(json.dumps(to_specification(pattern)))
        more = ["--weights", str(options.weights)] if options.weights else []
        # Compiled modules are kept beside their sources unless that is switched off.
        surroundings = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
        for k in range(options.cold + 1):
            started = time.perf_counter()
            subprocess.run(
                [
                    sys.executable,
                    "-m",
                    "swifttailor",
                    "sew",
                    path,
                    "--no-preview",
                    "--out",
                    f"{folder}/{k}",
                    *more,
                ],
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                check=False,
                env=surroundings,
            )
            times.append(time.perf_counter() - started)
    del times[0]
    print(f"cold: median {statistics.median(times):.2f} s, least {min(times):.2f} of {options.cold}")


def drapes(patterns: list[Pattern]) -> float:
    """Median seconds of a drape."""
    swifttailor.drape(swifttailor.draft("tank-top"), edge_length=8.0)  # loads (or compiles) the solver
    seconds = []
    for pattern in patterns:
        started = time.perf_counter()
        swifttailor.drape(pattern)
        seconds.append(time.perf_counter() - started)
    print(f"drape: median {statistics.median(seconds):.2f} s, most {max(seconds):.2f}")
    return statistics.median(seconds)


if __name__ == "__main__":
    main()

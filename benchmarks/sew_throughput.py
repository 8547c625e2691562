"""How many patterns a second become garments by the network, for batches of growing size.

``python benchmarks/sew_throughput.py PATTERNS.jsonl.gz [--counts 1 10 100 1000] [--workers 1 2]``

Pattern in memory -> mesh in memory, patterns taken in turn from the file as often as needed. Each worker is a
process with one thread for the network and its own copy of it; they are started, and have sewn one garment,
before the clock runs. Batches of up to 100 are the median of three. Run it on an otherwise idle machine.
"""

from __future__ import annotations

import argparse
import resource
import statistics
import time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

from machine import describe
from swifttailor.errors import SwiftTailorError
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.pattern import Pattern
from swifttailor.pattern.pattern_list import read_patterns

_SHARED: dict[str, object] = {}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("patterns", type=Path)
    parser.add_argument("--counts", type=int, nargs="+", default=[1, 10, 100, 1000])
    parser.add_argument("--workers", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--weights", type=Path)
    options = parser.parse_args()
    print(describe())
    for workers in options.workers:
        spawned = ProcessPoolExecutor(
            workers, get_context("spawn"), initializer=_open, initargs=(options.patterns, options.weights)
        )
        with spawned as pool:
            list(pool.map(_sew, range(workers), chunksize=1))
            for count in options.counts:
                runs = [_timed(pool, count, workers) for _ in range(3 if count <= 100 else 1)]
                seconds, failed = statistics.median(run[0] for run in runs), runs[0][1]
                lost = f"; {failed} could not be sewn" if failed else ""
                print(
                    f"{workers} process(es), {count} patterns: {seconds:.2f} s, "
                    f"{count / seconds:.1f} a second{lost}"
                )
            memory = max(pool.map(_memory, range(4 * workers)))
        print(f"{workers} process(es): at most {memory:.0f} MB each")


def _timed(pool: ProcessPoolExecutor, count: int, workers: int) -> tuple[float, int]:
    started = time.perf_counter()
    made = list(pool.map(_sew, range(count), chunksize=max(1, min(8, count // workers))))
    return time.perf_counter() - started, made.count(False)


def _open(patterns: Path, weights: Path | None) -> None:
    _SHARED["patterns"] = [given.read().pattern for given in read_patterns(patterns)]
    _SHARED["sewer"] = GarmentSewer.load(weights)


def _sew(number: int) -> bool:
    patterns, sewer = _SHARED["patterns"], _SHARED["sewer"]
    assert isinstance(patterns, list) and isinstance(sewer, GarmentSewer)
    pattern: Pattern = patterns[number % len(patterns)]
    try:
        sewer.sew(pattern)
    except SwiftTailorError:
        return False
    return True


def _memory(_: int) -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


if __name__ == "__main__":
    main()

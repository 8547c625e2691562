"""What a caption costs: measuring the pattern once, and writing each text after that.

``python benchmarks/caption_speed.py [PATTERNS.jsonl.gz] [--limit N] [--captions 20]``

Processor time of one core. Measuring: the least of three runs for each pattern, median over the patterns and
the slowest. Writing: the claims and the words of one caption, mean over `--captions` seeds of a pattern, then
the median and the slowest of the patterns.
"""

from __future__ import annotations

import argparse
import time
from itertools import islice
from pathlib import Path

import numpy as np

from machine import describe
from swifttailor.data.pattern_source import patterns_of
from swifttailor.describing import GarmentFacts, measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.wording.captions import write_caption
from timing import least

PATTERNS = Path("../shared/garmentcode/validation.jsonl.gz")


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("patterns", nargs="?", type=Path, default=PATTERNS)
    parser.add_argument("--limit", type=int, default=60)
    parser.add_argument("--captions", type=int, default=20)
    options = parser.parse_args()
    usable = (p for _, p in patterns_of(options.patterns) if not isinstance(p, SwiftTailorError))
    patterns = list(islice(usable, options.limit))
    print(describe())
    write_caption(measure_facts(patterns[0]), 0)  # whatever is loaded or kept once is not counted
    measuring = np.array([least(lambda p=pattern: measure_facts(p))[0] for pattern in patterns]) * 1e3
    writing = np.array([one_caption(measure_facts(p), options.captions) for p in patterns]) * 1e3
    print(f"{len(patterns)} patterns, processor time, median and slowest")
    print(f"measure a pattern  {np.median(measuring):7.2f} ms (max {measuring.max():.2f})")
    print(f"write a caption    {np.median(writing):7.2f} ms (max {writing.max():.2f})")


def one_caption(facts: GarmentFacts, count: int) -> float:
    """Seconds for a caption, mean over seeds."""
    started = time.process_time()
    for seed in range(count):
        write_caption(facts, seed)
    return (time.process_time() - started) / count


if __name__ == "__main__":
    main()

"""How many ways there are to recut a pattern, how many pairs edits give, and what a pair costs.

``python benchmarks/edit_rates.py [PATTERNS.jsonl.gz] [--edits FILE.jsonl.gz] [--every 10] [--limit N]``

Every tenth pattern is recut about all topics, each tried as often as `swifttailor data edits` tries it.
Printed are how many topics applied to a pattern, how often each way to recut was used, and processor time of
one core per pair. Of the edits, all whose base is among the patterns are compared with it:
printed are how many pairs came of how many possible ones, and their time. Medians over patterns and edits.
``--limit`` ends both after so many.
"""

from __future__ import annotations

import argparse
import time
from collections import Counter
from itertools import islice
from pathlib import Path

import numpy as np

from machine import describe
from swifttailor.data.edits.edit_file import read_edits
from swifttailor.data.edits.pairs import geometric_pairs, is_reversed, pairs_of
from swifttailor.data.pattern_source import parsed_pattern, patterns_of
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.recutting.random_cuts import TOPICS

PATTERNS = Path("../shared/garmentcode/validation.jsonl.gz")
EDITS = Path("../shared/garmentcode/edits.jsonl.gz")


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("patterns", nargs="?", type=Path, default=PATTERNS)
    parser.add_argument("--edits", type=Path, default=EDITS)
    parser.add_argument("--every", type=int, default=10)
    parser.add_argument("--limit", type=int)
    options = parser.parse_args()
    print(describe())
    patterns = {id: p for id, p in patterns_of(options.patterns) if not isinstance(p, SwiftTailorError)}
    recut([p for _, p in islice(patterns.items(), 0, None, options.every)][: options.limit])
    compare(patterns, options.edits, options.limit)


def recut(patterns: list[Pattern]) -> None:
    """Recuts each pattern about every topic."""
    applied: list[int] = []
    seconds: list[float] = []
    counts: Counter[str] = Counter()
    for seed, pattern in enumerate(patterns):
        started = time.process_time()
        pairs = geometric_pairs(pattern, seed, count=len(TOPICS))
        seconds.append((time.process_time() - started) / max(len(pairs), 1))
        done = {p.source.removesuffix(", reversed") for p in pairs}
        counts.update(done)
        applied.append(len(done))
    print(
        f"{len(patterns)} patterns: {np.mean(applied):.1f} of {len(TOPICS)} topics applied to one on "
        f"average ({min(applied)} to {max(applied)}); {milliseconds(seconds)} a pair, failed tries included"
    )
    for topic, ways in TOPICS.items():
        print(f"  {topic}: " + ", ".join(f"{way.label} {counts[way.label]}" for way in ways))


def compare(patterns: dict[str, Pattern], edits: Path, limit: int | None) -> None:
    """Makes the pairs of edits whose bases are there."""
    found = islice((v for v in read_edits(edits) if v.base in patterns), limit)
    seconds: list[float] = []
    there = back = 0
    for seed, version in enumerate(found):
        edited = parsed_pattern(version.pattern)
        if isinstance(edited, SwiftTailorError):
            raise edited
        started = time.process_time()
        pairs = pairs_of(patterns[version.base], edited, seed, source="design")
        seconds.append((time.process_time() - started) / max(len(pairs), 1))
        back += sum(is_reversed(p.source) for p in pairs)
        there += sum(not is_reversed(p.source) for p in pairs)
    print(
        f"{len(seconds)} edits of {edits.name}: {there + back} pairs of {2 * len(seconds)} possible ones, "
        f"{there} there and {back} back; {milliseconds(seconds)} a pair"
    )


def milliseconds(seconds: list[float]) -> str:
    return f"{np.median(seconds) * 1e3:.0f} ms ({min(seconds) * 1e3:.0f} to {max(seconds) * 1e3:.0f})"


if __name__ == "__main__":
    main()

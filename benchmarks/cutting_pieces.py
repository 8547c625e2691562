"""Counts cut lines that cannot be cut, and notches that do not match, over many patterns.

.venv/bin/python benchmarks/cutting_pieces.py ../shared/garmentcode/train.jsonl.gz --limit 1000
"""

from __future__ import annotations

import argparse
import time
from collections import Counter
from itertools import islice
from pathlib import Path

import numpy as np

from swifttailor.errors import SwiftTailorError
from swifttailor.making import cutting_plan
from swifttailor.making.notch_check import notch_faults
from swifttailor.making.overlaps import allowance_faults
from swifttailor.pattern import repair_pattern
from swifttailor.pattern.pattern_list import read_patterns


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("patterns", type=Path)
    parser.add_argument("--limit", type=int, default=1000)
    parser.add_argument("--every", type=int, default=1)
    options = parser.parse_args()
    counts: Counter[str] = Counter()
    refused: Counter[str] = Counter()
    seconds = []
    for entry in islice(read_patterns(options.patterns), 0, options.limit * options.every, options.every):
        pattern = entry.read().pattern
        started = time.perf_counter()
        try:
            plan = cutting_plan(pattern)
        except SwiftTailorError as error:
            refused[str(error)[:70]] += 1
            try:
                plan = cutting_plan(repair_pattern(pattern).pattern)
                counts["patterns repaired first"] += 1
            except SwiftTailorError:
                counts["patterns refused after repair too"] += 1
                continue
        seconds.append(time.perf_counter() - started)
        counts["patterns"] += 1
        counts["pieces"] += len(plan.pieces)
        counts["panels"] += len(plan.sewn.panels)
        counts["stitches"] += len(plan.sewn.pattern.stitches)
        counts["notch pairs"] += len(plan.pairs)
        counts.update(f"finding: {f.code}" for f in plan.findings)
        for piece in plan.pieces:
            faults = allowance_faults(piece.runs, piece.cut)
            counts["broken allowances"] += bool(faults)
            for fault in faults[:2]:
                print(f"{entry.id} {piece.name} ({piece.panels}): {fault}")
        faults = notch_faults(plan)
        counts["patterns with notches that do not match"] += bool(faults)
        for fault in faults[:2]:
            print(f"{entry.id}: {fault}")
    for name, count in counts.items():
        print(f"{name}: {count}")
    for text, count in refused.most_common():
        print(f"refused {count}: {text}")
    print(f"seconds a pattern: median {np.median(seconds):.2f}, largest {max(seconds):.2f}")


if __name__ == "__main__":
    main()

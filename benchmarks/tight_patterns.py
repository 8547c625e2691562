"""How well the coarse drape foretells which patterns are too tight once they are draped.

``python benchmarks/tight_patterns.py SPLIT PATTERNS...``

SPLIT is a folder that `swifttailor data build` has made of PATTERNS, which are files or folders.
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path

import numpy as np

from machine import describe
from swifttailor.errors import SwiftTailorError
from swifttailor.evaluation.maker.questions import PatternSet
from swifttailor.garment_sewer import GarmentSewer
from swifttailor.garment_sewer.tightness import TOO_TIGHT, stretch

LIMITS = (0.08, 0.09, 0.1, TOO_TIGHT, 0.11, 0.12, 0.14)


def main() -> None:
    """Prints how many too tight patterns lie above some limits of `stretch`, and how many others."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("split", type=Path)
    parser.add_argument("patterns", type=Path, nargs="+")
    options = parser.parse_args()
    lines = map(json.loads, (options.split / "results.jsonl").read_text().splitlines())
    draped = {one["id"]: " ".join(one["reasons"]) for one in lines if one.get("quality")}
    patterns, sewer = PatternSet.read(options.patterns).patterns, GarmentSewer.load()
    found, tight, seconds = [], [], 0.0
    for name, reasons in draped.items():
        try:
            prepared = sewer.prepare(patterns[name])
        except SwiftTailorError:
            continue
        begun = time.perf_counter()
        found.append(stretch(prepared))
        seconds += time.perf_counter() - begun
        tight.append("too tight" in reasons)
    values, bad = np.array(found), np.array(tight)
    print(f"{describe()}; {len(values)} drapes, {bad.sum()} of them too tight")
    print(f"{1e3 * seconds / len(values):.1f} ms each")
    for limit in LIMITS:
        above = values > limit
        print(f"above {limit}: {above[bad].sum()} of the too tight, {above[~bad].mean():.1%} of the others")


if __name__ == "__main__":
    main()

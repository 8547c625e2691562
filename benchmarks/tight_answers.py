"""How well the coarse drape foretells which answers are too tight once they are draped.

``python benchmarks/tight_answers.py SYSTEMS...``

SYSTEMS are folders that `swifttailor evaluate systems --generators ours --sewers physics` has written.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from machine import describe
from swifttailor.evaluation.maker.ask import pattern_of
from swifttailor.garment_sewer import GarmentSewer
from swifttailor.garment_sewer.tightness import TOO_TIGHT, stretch
from swifttailor.pattern import Pattern

LIMITS = (0.08, 0.09, 0.1, TOO_TIGHT, 0.11, 0.12, 0.14)


def main() -> None:
    """Prints how many too tight answers lie above some limits of `stretch`, and how many others."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("systems", type=Path, nargs="+")
    folders = parser.parse_args().systems
    sewer = GarmentSewer.load()
    found, tight, seconds = [], [], 0.0
    for pattern, reasons in (one for folder in folders for one in _draped(folder / "ours")):
        prepared = sewer.prepare(pattern)
        begun = time.perf_counter()
        found.append(stretch(prepared))
        seconds += time.perf_counter() - begun
        tight.append("too tight" in reasons)
    values, bad = np.array(found), np.array(tight)
    print(f"{describe()}; {len(values)} answers, {bad.sum()} of them too tight")
    print(f"{1e3 * seconds / len(values):.1f} ms each")
    for limit in LIMITS:
        above = values > limit
        print(f"above {limit}: {above[bad].sum()} of the too tight, {above[~bad].mean():.1%} of the others")


def _draped(folder: Path) -> Iterator[tuple[Pattern, str]]:
    """Each answer that physics has made, and why it is not accepted."""
    made = map(json.loads, (folder / "garments-physics" / "garments.jsonl").read_text().splitlines())
    reasons = {one["id"]: " ".join(one["reasons"]) for one in made}
    for line in (folder / "answers.jsonl").read_text().splitlines():
        record = json.loads(line)
        name = record["question"].partition("/")[2].partition(",")[0]
        pattern = pattern_of(record, name) if name in reasons else None
        if pattern is not None:
            yield pattern, reasons[name]


if __name__ == "__main__":
    main()

"""Draws garments that shops sell: design parameters and the patterns that the garment programs make of them.

python scripts/draw_usual_designs.py --count 3000 --start 70000000 --out usual.jsonl.gz

The archetypes are those of scripts/archetypes. One JSON object a line, as scripts/sample_garmentcode.py
writes them: id ("usual_SEED"), seed, archetype, design (flat parameters), pattern. Nothing else is needed,
and a pattern takes a fiftieth of a second; GarmentCode's own programs take fifty times as long. Designs that
the programs refuse and patterns with errors are left out.
"""

from __future__ import annotations

import argparse
import gzip
import json
import multiprocessing
import os
import random
from functools import cache
from pathlib import Path
from typing import Any

from drawing_archetypes import Archetype, complete, read_archetypes
from swifttailor.pattern import Severity, check_pattern, to_specification
from swifttailor.programs import DESIGN_PARAMETERS, DesignError, make_pattern

ARCHETYPES = Path(__file__).with_name("archetypes")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--count", type=int, required=True, help="seeds that are tried")
    parser.add_argument("--start", type=int, default=70_000_000, help="the first of them")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--out", type=Path, required=True, help=".jsonl.gz to write")
    options = parser.parse_args()
    seeds = range(options.start, options.start + options.count)
    written = 0
    with multiprocessing.Pool(options.workers) as pool, gzip.GzipFile(options.out, "wb", mtime=0) as file:
        for line in filter(None, pool.imap(line_of, seeds, chunksize=8)):
            file.write(line.encode() + b"\n")
            written += 1
    print(f"{options.out}: {written} patterns of {options.count} seeds")


def line_of(seed: int) -> str:
    """What is written of a seed; nothing where no pattern comes of it."""
    random.seed(seed)
    archetypes = archetypes_known()
    archetype = random.choices(archetypes, [one.share for one in archetypes])[0]
    defaults = {name: one.default for name, one in DESIGN_PARAMETERS.items()}
    design: dict[str, Any] = complete(archetype.draw(), defaults)
    try:
        pattern = make_pattern(design).canonical()
    except DesignError:
        return ""
    if any(finding.severity == Severity.ERROR for finding in check_pattern(pattern)):
        return ""
    line = {
        "id": f"usual_{seed}",
        "seed": seed,
        "archetype": archetype.name,
        "design": design,
        "pattern": to_specification(pattern),
    }
    return json.dumps(line, separators=(",", ":"))


@cache
def archetypes_known() -> list[Archetype]:
    """Read once."""
    return read_archetypes(ARCHETYPES)


if __name__ == "__main__":
    main()

"""Writes the designs of garments for training a picture reader that says design parameters, too.

python scripts/place_designs.py --patterns train.jsonl.gz usual.jsonl.gz --out designs.safetensors
swifttailor train picture-reader --designs designs.safetensors ...

The patterns have all of their design parameters beside them (``design``), as those of
scripts/sample_garmentcode.py and scripts/draw_usual_designs.py. Choices and ranges are those of a parameter
reader, so that both can be heard together.
"""

from __future__ import annotations

import argparse
import gzip
import json
from pathlib import Path

from swifttailor.parameter_reader import ParameterReader
from swifttailor.parameter_reader.placed_designs import PlacedDesigns


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument(
        "--patterns", type=Path, nargs="+", required=True, help=".jsonl.gz with id and design"
    )
    parser.add_argument("--reader", type=Path, help="model file of a parameter reader; the package's without")
    parser.add_argument("--out", type=Path, required=True, help=".safetensors to write")
    options = parser.parse_args()
    designs = {}
    for path in options.patterns:
        with gzip.open(path, "rt", encoding="utf-8") as file:
            for line in map(json.loads, file):
                designs[line["id"]] = line["design"]
    placed = PlacedDesigns.of(designs, ParameterReader.load(options.reader).parameters)
    placed.write(options.out, overwrite=True)
    megabytes = options.out.stat().st_size / 1e6
    print(f"{options.out}: {len(placed.rows)} of {len(designs)} designs, {megabytes:.1f} MB")


if __name__ == "__main__":
    main()

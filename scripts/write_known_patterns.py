"""Takes the patterns out of a library of known patterns, to train with where nothing else is at hand.

``python scripts/write_known_patterns.py FOLDER [--library FILE] [--validation 150] [--limit N]``

Writes FOLDER/train.jsonl.gz and FOLDER/validation.jsonl.gz, ``{"id", "pattern"}`` a line, evenly taken out of
the library: one that trains and validates on these must not be judged by what it says of them elsewhere.
"""

from __future__ import annotations

import argparse
import gzip
import json
from pathlib import Path

from swifttailor.pattern import to_specification
from swifttailor.pattern_library import PatternLibrary


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--library", type=Path)
    parser.add_argument("--validation", type=int, default=150)
    parser.add_argument("--limit", type=int)
    options = parser.parse_args()
    library = PatternLibrary.load(options.library)
    count = min(options.limit or len(library), len(library))
    numbers = [k * len(library) // count for k in range(count)]
    held = set(numbers[:: max(1, count // options.validation)][: options.validation])
    options.folder.mkdir(parents=True, exist_ok=True)
    for name, chosen in (("train", [k for k in numbers if k not in held]), ("validation", sorted(held))):
        with gzip.GzipFile(options.folder / f"{name}.jsonl.gz", "wb", mtime=0) as file:
            for k in chosen:
                line = {"id": library.ids[k], "pattern": to_specification(library.pattern(k))}
                file.write(json.dumps(line).encode() + b"\n")
        print(f"{name}: {len(chosen)} patterns")


if __name__ == "__main__":
    main()

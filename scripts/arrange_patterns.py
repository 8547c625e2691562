"""Arranges what scripts/sample_garmentcode.py has sampled into the files that networks learn from.

python scripts/arrange_patterns.py --series        # what to sample: seeds to start from, how many patterns
python scripts/arrange_patterns.py SAMPLED OUT --check runs/designs.txt

SAMPLED holds START.jsonl.gz for each series. The first series is split: its patterns in the order of
sha256("gc-split-v1:" + id), the first 100 to test with, the next 150 to validate with, the others to train
on. All later series are to train on; of the last ones, patterns equal to one to test or validate with are
left out. With --check, design parameters are compared with those recorded: they follow from the seeds alone,
whereas the last digits of patterns, and the order of their stitches, vary from machine to machine. Nothing
but the standard library is needed.
"""

from __future__ import annotations

import argparse
import gzip
import hashlib
import json
from pathlib import Path
from typing import Any

FILES: dict[str, dict[int, int]] = {
    "first": {1_000_000: 2572},
    "train-2": {2_000_000: 1356, 3_000_000: 1408, 4_000_000: 897},
    "train-3": {30_000_000: 800, 30_010_000: 800, 30_020_000: 800, 30_030_000: 800},
}
"""The seeds that the series of each file start from, and how many patterns they give."""
TWINLESS = ("train-3",)
SPLIT_RULE = "gc-split-v1:"
TEST, VALIDATION = 100, 150
DIGITS = 2
"""Decimals of a coordinate that two equal patterns share."""

Samples = list[dict[str, Any]]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("sampled", type=Path, nargs="?", help="folder of START.jsonl.gz")
    parser.add_argument("out", type=Path, nargs="?", help="folder of the files to write")
    parser.add_argument("--series", action="store_true", help="print START COUNT of what to sample")
    parser.add_argument("--few", type=int, metavar="N", help="a rehearsal: N patterns, the first series only")
    parser.add_argument("--check", type=Path, metavar="FILE", help="recorded checksums of design parameters")
    options = parser.parse_args()
    files = FILES if options.few is None else {"first": {1_000_000: options.few}}
    if options.series:
        for series in files.values():
            for start, count in series.items():
                print(start, count)
        return
    if options.sampled is None or options.out is None:
        parser.error("SAMPLED and OUT are missing")
    found = {
        name: [sample for start in series for sample in read(options.sampled / f"{start}.jsonl.gz")]
        for name, series in files.items()
    }
    arranged = arrange(found)
    options.out.mkdir(parents=True, exist_ok=True)
    for name, samples in arranged.items():
        write(options.out / f"{name}.jsonl.gz", samples)
        print(f"{name}: {len(samples)} patterns, designs {designs_checksum(samples)}")
    if options.check is not None:
        check(arranged, options.check)


def arrange(found: dict[str, Samples]) -> dict[str, Samples]:
    """The samples of each file, the first ones split."""
    first = sorted(found["first"], key=lambda s: hashlib.sha256((SPLIT_RULE + s["id"]).encode()).digest())
    quarter = len(first) // 4  # of a rehearsal
    test, validation = min(TEST, quarter), min(VALIDATION, quarter)
    parts = {
        "test": first[:test],
        "validation": first[test : test + validation],
        "train": first[test + validation :],
    }
    arranged = {name: sorted(part, key=place_of) for name, part in parts.items()}
    held = {panels_of(sample) for name in ("test", "validation") for sample in arranged[name]}
    for name, samples in found.items():
        if name in TWINLESS:
            arranged[name] = [sample for sample in samples if panels_of(sample) not in held]
        elif name != "first":
            arranged[name] = samples
    return arranged


def place_of(sample: dict[str, Any]) -> tuple[int, str]:
    """Its place among others: by seed where it has one."""
    return sample.get("seed", 0), sample["id"]


def panels_of(sample: dict[str, Any]) -> str:
    """The panels of a pattern as text, equal for equal ones."""

    def rounded(value: Any) -> Any:
        if isinstance(value, dict):
            return {name: rounded(part) for name, part in value.items()}
        if isinstance(value, list):
            return [rounded(part) for part in value]
        return round(value, DIGITS) + 0.0 if isinstance(value, float) else value

    return json.dumps(rounded(sample["pattern"]["pattern"]["panels"]), sort_keys=True)


def designs_checksum(samples: Samples) -> str:
    """Of ids and design parameters."""
    digest = hashlib.sha256()
    for sample in samples:
        digest.update(json.dumps([sample["id"], sample["design"]], sort_keys=True).encode() + b"\n")
    return digest.hexdigest()


def check(arranged: dict[str, Samples], recorded: Path) -> None:
    """Compares checksums with those of a file of lines ``sha256  name``."""
    wanted = dict(reversed(line.split()) for line in recorded.read_text().splitlines())
    other = [name for name, samples in arranged.items() if designs_checksum(samples) != wanted.get(name)]
    if other:
        raise SystemExit(
            f"The designs of {', '.join(other)} are not those recorded in {recorded}. Sample with the "
            "versions of runs/garmentcode-requirements.txt from the named commit of GarmentCode."
        )


def read(path: Path) -> Samples:
    with gzip.open(path, "rt") as lines:
        return [json.loads(line) for line in lines]


def write(path: Path, samples: Samples) -> None:
    """Whole or not at all."""
    part = path.with_name(path.name + ".part")
    with gzip.GzipFile(part, "wb", mtime=0) as file:
        for sample in samples:
            file.write(json.dumps(sample, separators=(",", ":")).encode() + b"\n")
    part.replace(path)


if __name__ == "__main__":
    main()

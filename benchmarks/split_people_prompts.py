"""Deals people's prompts into two halves by lot: one to build with, one to judge with at the end.

``python benchmarks/split_people_prompts.py --prompts FILE... --edits FILE... [--out DIR] [--seed 0]``

The files are read together and put in the order of their ids first, so the two halves, given again, are
dealt the same way. Nothing of the texts is printed.
"""

from __future__ import annotations

import argparse
import json
import random
from pathlib import Path

from people_prompts import HALVES, WORDS, read_people_edits, read_people_prompts
from swifttailor.errors import InputError


def deal(lines: list[str], seed: int) -> tuple[list[str], list[str]]:
    """Two halves of JSON lines in the order of ids; an odd line more goes to the first."""
    ordered = sorted(lines, key=lambda line: json.loads(line)["id"])
    drawn = set(random.Random(seed).sample(range(len(ordered)), (len(ordered) + 1) // 2))
    return (
        [line for k, line in enumerate(ordered) if k in drawn],
        [line for k, line in enumerate(ordered) if k not in drawn],
    )


def lines_of(files: list[Path]) -> list[str]:
    """The lines of several files.

    Raises:
        InputError: Two lines have the same id or the same text, capitals and blanks aside.
    """
    lines = [line for file in files for line in file.read_text(encoding="utf-8").splitlines()]
    rows = [json.loads(line) for line in lines]
    for key in ("id", "text"):
        if len({" ".join(row[key].lower().split()) for row in rows}) < len(rows):
            raise InputError(f"Two lines have the same {key}; each may occur once.")
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--prompts", type=Path, nargs="+", required=True)
    parser.add_argument("--edits", type=Path, nargs="+", required=True)
    parser.add_argument("--out", type=Path, default=WORDS)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    for name, files, read in (
        ("prompts", options.prompts, read_people_prompts),
        ("edits", options.edits, read_people_edits),
    ):
        for file in files:
            read(file)
        for half, lines in zip(HALVES, deal(lines_of(files), options.seed), strict=True):
            path = options.out / half / f"{name}.jsonl"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("".join(line + "\n" for line in lines), encoding="utf-8")
            print(f"{path}: {len(lines)}")


if __name__ == "__main__":
    main()

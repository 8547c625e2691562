"""What is lost when patterns become tokens and patterns again, and what it costs.

``python benchmarks/token_round_trip.py FILE.jsonl.gz ... [--every K]``

Each file holds GarmentCode samples, one to a line. Printed for each: how many patterns came back with the
same panels, edges, labels and stitches; the largest distance between corresponding points of the outlines and
between placed vertices; how many the grammar accepts under its default limits; lengths of the sequences; and
processor milliseconds of one core, the median over patterns, of writing and reading one, and the microseconds
of one mask.
"""

from __future__ import annotations

import argparse
import gzip
import json
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from machine import describe
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern, read_specification
from swifttailor.pattern_maker.tokens.decode import decode
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.fidelity import Fidelity, compare
from swifttailor.pattern_maker.tokens.grammar import Grammar, Stage, State
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence


@dataclass(frozen=True)
class Measured:
    """One pattern."""

    found: Fidelity
    tokens: int
    accepted: bool
    encode_s: float
    decode_s: float
    mask_s: float


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("files", type=Path, nargs="+")
    parser.add_argument("--every", type=int, default=1)
    options = parser.parse_args()
    print(describe())
    for file in options.files:
        refused: list[str] = []
        rows = []
        with gzip.open(file, "rt") as lines:
            for k, line in enumerate(lines):
                if k % options.every == 0:
                    sample = json.loads(line)
                    try:
                        rows.append(measure(read_specification(sample["pattern"]).pattern))
                    except SwiftTailorError as error:
                        refused.append(f"{sample['id']}: {error}")
        report(file.name, rows, refused)


def measure(pattern: Pattern) -> Measured:
    start = time.process_time()
    sequence = encode(pattern)
    written = time.process_time()
    again = decode(sequence)
    read = time.process_time()
    accepted, mask_s = walk(sequence)
    return Measured(compare(pattern, again), len(sequence), accepted, written - start, read - written, mask_s)


def walk(sequence: TokenSequence) -> tuple[bool, float]:
    """Whether each token is in the mask before it, and the mean seconds of a mask."""
    grammar, state, spent, accepted = Grammar(), State(), 0.0, True
    for token in sequence.tokens.tolist():
        start = time.process_time()
        mask = grammar.allowed(state)
        spent += time.process_time() - start
        accepted = accepted and bool(mask[token])
        state = grammar.advance(state, token)
    return accepted and state.stage is Stage.FINISHED, spent / len(sequence)


def report(name: str, rows: list[Measured], refused: list[str]) -> None:
    lengths = [r.tokens for r in rows]
    print(
        f"{name}: {len(rows) + len(refused)} patterns, {len(refused)} refused, "
        f"{sum(r.found.same_structure for r in rows)} with equal structure, "
        f"{sum(r.accepted for r in rows)} accepted by the grammar; "
        f"outline {max(r.found.outline_cm for r in rows):.2g} cm, "
        f"placement {max(r.found.placement_cm for r in rows):.2g} cm at most; "
        f"tokens median {np.median(lengths):g}, p95 {np.percentile(lengths, 95):g}, max {max(lengths)}; "
        f"write {np.median([r.encode_s for r in rows]) * 1e3:.1f} ms, "
        f"read {np.median([r.decode_s for r in rows]) * 1e3:.1f} ms, "
        f"mask {np.median([r.mask_s for r in rows]) * 1e6:.0f} us"
    )
    for line in refused[:5]:
        print("  " + line)


if __name__ == "__main__":
    main()

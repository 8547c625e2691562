"""Derives the constants of `pattern_maker.normalization`, and the lengths in docs/pattern-maker.md.

.venv/bin/python scripts/measure_token_statistics.py ../shared/garmentcode/train*.jsonl.gz

The files are the training split, one pattern to a line; nothing else may enter the constants.
"""

from __future__ import annotations

import gzip
import json
import sys
from collections.abc import Iterator

import numpy as np

from swifttailor.pattern import Pattern, read_specification
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.grammar import Limits
from swifttailor.pattern_maker.tokens.normalization import (
    WIDEST_MEASURED,
    points_in_cm,
    translation_in_cm,
)
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import COMMANDS, END, MOVE, TRANSLATION

UNLIMITED = Limits(tokens=100_000, edges=10_000)


def main(files: list[str]) -> None:
    points, translations, lengths, edges, stitches = [], [], [], [], []
    panels = wide = 0
    for pattern in patterns(files):
        for panel in pattern.panels:
            panels += 1
            if np.ptp(panel.vertices, axis=0).max() > WIDEST_MEASURED:
                wide += 1
                continue
            sequence = encode(Pattern((panel,)), limits=UNLIMITED)
            points.append(points_in_cm(sequence.numbers[is_edge(sequence)][:, END]))
            translations.append(translation_in_cm(sequence.numbers[sequence.tokens == MOVE][:, TRANSLATION]))
        lengths.append(len(encode(pattern, limits=UNLIMITED)))
        edges.append(max(len(p.edges) for p in pattern.panels))
        stitches.append(len(pattern.stitches))
    print(
        f"{len(lengths)} patterns, {panels} panels; {wide} of them wider than {WIDEST_MEASURED:g} cm left out"
    )
    for name, values in (("POINT", np.concatenate(points)), ("TRANSLATION", np.concatenate(translations))):
        print(f"{name}_SHIFT = np.array({np.round(values.mean(axis=0), 4).tolist()})")
        print(f"{name}_SCALE = np.array({np.round(values.std(axis=0), 4).tolist()})")
    for name, counts in (("tokens", lengths), ("edges of a panel", edges), ("stitches", stitches)):
        print(
            f"{name}: median {np.median(counts):g}, p95 {np.percentile(counts, 95):g}, max {max(counts)}, "
            f"mean {np.mean(counts):.1f}"
        )


def patterns(files: list[str]) -> Iterator[Pattern]:
    for file in files:
        with gzip.open(file, "rt") as lines:
            for line in lines:
                yield read_specification(json.loads(line)["pattern"]).pattern


def is_edge(sequence: TokenSequence) -> np.ndarray:
    return np.isin(sequence.tokens, list(COMMANDS))


if __name__ == "__main__":
    main(sys.argv[1:])

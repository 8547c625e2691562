"""How far a caption tells how many panels its garment has: what a reader that heard every word could know.

``python benchmarks/what_captions_tell.py GARMENTCODE/train*.jsonl.gz --of GARMENTCODE/validation.jsonl.gz``

A multinomial logistic regression of the true claims of captions on the number of panels. Nothing is read or
written, so whatever generates patterns from the same captions is not judged by its hearing here.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
from pathlib import Path

import numpy as np
from scipy.optimize import minimize

from machine import describe
from swifttailor.arrays import Array
from swifttailor.data.pattern_source import patterns_of
from swifttailor.describing import Claim, measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.evaluation.maker.questions import seed_of
from swifttailor.pattern import Pattern
from swifttailor.wording.captions import write_caption

Row = tuple[dict[str, float], int]
"""What a caption claims, and the number of panels."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("known", type=Path, nargs="+", help="patterns to learn from")
    parser.add_argument("--of", type=Path, required=True, help="patterns to ask about")
    parser.add_argument("--captions", type=int, default=3, help="of each pattern to learn from")
    parser.add_argument("--ridge", type=float, default=1e-5)
    options = parser.parse_args()
    known = list(chain.from_iterable(_rows(path, range(options.captions)) for path in options.known))
    asked = list(_rows(options.of, [0]))
    names = sorted({name for signs, _ in known for name in signs})
    counts = sorted({count for _, count in known})
    weights = _fitted(_table(known, names), np.array([counts.index(n) for _, n in known]), options.ridge)
    guessed = np.array(counts)[(_table(asked, names) @ weights).argmax(axis=1)]
    true = np.array([count for _, count in asked])
    usual = max(counts, key=[count for _, count in known].count)
    print(describe())
    print(f"{len(known)} captions learnt from, {len(asked)} asked about")
    print(f"the right number of panels: {np.mean(guessed == true):.1%}")
    print(f"the most frequent number, {usual}: {np.mean(true == usual):.1%}")
    print(f"within one panel: {np.mean(np.abs(guessed - true) <= 1):.1%}")


def _rows(source: Path, seeds: Iterable[int]) -> Iterator[Row]:
    """Of each pattern that can be measured one row for each seed."""
    for id, pattern in patterns_of(source):
        if not isinstance(pattern, Pattern):
            continue
        try:
            facts = measure_facts(pattern)
        except SwiftTailorError:
            continue
        for seed in seeds:
            yield _signs(write_caption(facts, seed_of(seed, id)).claims), len(pattern.panels)


def _signs(claims: Sequence[Claim]) -> dict[str, float]:
    signs: dict[str, float] = {}
    for claim in claims:
        if isinstance(claim.value, str):
            signs[f"{claim.name}={claim.value}"] = 1.0
        else:
            signs[f"{claim.name} told"], signs[claim.name] = 1.0, claim.value / 100.0
    return signs


def _table(rows: Sequence[Row], names: Sequence[str]) -> Array:
    """(rows, names + 1) float64, ones in the last column."""
    return np.array([[*(signs.get(name, 0.0) for name in names), 1.0] for signs, _ in rows])


def _fitted(table: Array, kind: Array, ridge: float) -> Array:
    """Weights (signs, kinds) for `table` (rows, signs) whose rows are of `kind` (rows,)."""
    hit = np.eye(kind.max() + 1)[kind]

    def loss(flat: Array) -> tuple[float, Array]:
        weights = flat.reshape(table.shape[1], -1)
        logits = table @ weights
        shares = np.exp(logits - np.logaddexp.reduce(logits, axis=1, keepdims=True))
        slope = table.T @ (shares - hit) / len(hit) + 2 * ridge * weights
        told = np.log(np.maximum((shares * hit).sum(axis=1), 1e-12)).mean()
        return float(ridge * (weights**2).sum() - told), slope.ravel()

    start = np.zeros(table.shape[1] * hit.shape[1])
    best = minimize(loss, start, jac=True, method="L-BFGS-B", options={"maxiter": 200})
    return np.asarray(best.x).reshape(table.shape[1], -1)


if __name__ == "__main__":
    main()

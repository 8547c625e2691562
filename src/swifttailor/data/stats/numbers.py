"""Counts and distributions of a split."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.data.builder.split_folder import RESULTS
from swifttailor.data.index import SplitIndex, read_index
from swifttailor.data.reader import SplitReader
from swifttailor.data.sample import Sample
from swifttailor.describing import claims_of, measure_facts
from swifttailor.draping.batch.summary import kind_of_reason
from swifttailor.errors import InputError, SwiftTailorError

MEASURES = {
    "panels": "panels",
    "stitches": "stitches",
    "vertices": "vertices",
    "kilobytes": "kilobytes in the shard",
    "length_cm": "from the highest to the lowest point, cm",
    "lowest_cm": "lowest point above the floor, cm",
    "width_cm": "width as worn, cm",
    "strain_p95": "strain that 5 % of the edges exceed",
    "self_intersections": "places where the cloth passes through itself",
    "max_penetration_cm": "deepest point inside the body, cm",
    "frames": "frames until it rests",
}
"""Name and meaning of what is measured on every sample."""
_QUANTILES = (0.0, 0.05, 0.25, 0.5, 0.75, 0.95, 1.0)


@dataclass(frozen=True)
class SplitNumbers:
    """What a split holds."""

    index: SplitIndex
    reasons: dict[str, int]
    """Why patterns gave no sample, without values, most frequent first."""
    values: dict[str, np.ndarray]
    """(n,) each of `MEASURES` for every sample."""
    seconds: dict[str, np.ndarray]
    """Seconds per stage over all patterns that were draped; empty where results.jsonl is missing."""
    claims: dict[str, Counter[str]]
    """How many samples each claim of their captions' is true of, by its name and value."""

    def to_json(self) -> dict[str, Any]:
        """Plain JSON values: counts and quantiles."""
        rejected = [r for s in self.index.shards for r in s.rejected]
        accepted = sum(len(s.ids) for s in self.index.shards)
        size = sum(s.bytes for s in self.index.shards)
        return {
            "split": self.index.split,
            "complete": self.index.complete,
            "patterns": self.index.patterns,
            "accepted": accepted,
            "rejected": sum(r.status == "rejected" for r in rejected),
            "failed": sum(r.status == "failed" for r in rejected),
            "acceptance": round(accepted / max(self.index.patterns, 1), 4),
            "megabytes": round(size / 1e6, 3),
            "kilobytes_a_sample": round(size / 1e3 / max(accepted, 1), 3),
            "shards": len(self.index.shards),
            "reasons": self.reasons,
            "quantiles": {name: _quantiles(values) for name, values in self.values.items()},
            "median_seconds": {name: round(float(np.median(v)), 3) for name, v in self.seconds.items()},
            "total_hours": round(sum(float(v.sum()) for v in self.seconds.values()) / 3600, 3),
            "claims": {name: dict(found.most_common()) for name, found in sorted(self.claims.items())},
            "settings": self.index.settings,
            "built_with": list(self.index.built_with),
        }


def count_split(folder: Path, *, workers: int = 1) -> Iterator[SplitNumbers | int]:
    """Measures every sample of a split.

    Args:
        folder: Of the split.
        workers: Processes.

    Yields:
        Numbers of samples that were measured, and at last the result.

    Raises:
        InputError: The split cannot be read.
    """
    from swifttailor.workers import run_tasks

    index = read_index(folder)
    tasks = [(folder, number) for number, shard in enumerate(index.shards) if shard.file]
    rows: dict[int, list[dict[str, Any]]] = {}
    results = ((number, _count_shard((folder, number))) for _, number in tasks)
    if workers > 1:
        outcomes = run_tasks(_count_shard, tasks, workers=workers, time_limit=36_000.0)
        results = ((o.task[1], o.result or o.lost) for o in outcomes)
    for number, result in results:
        if isinstance(result, str):
            raise InputError(result)
        rows[number] = result
        yield len(result)
    ordered = [row for number in sorted(rows) for row in rows[number]]
    claims: dict[str, Counter[str]] = {}
    for row in ordered:
        for name, value in row["claims"]:
            claims.setdefault(name, Counter())[value] += 1
    values = {name: np.array([row[name] for row in ordered], np.float64) for name in MEASURES}
    yield SplitNumbers(index, _reasons(index), values, _seconds(folder), claims)


def _count_shard(task: tuple[Path, int]) -> list[dict[str, Any]] | str:
    """A row for each sample of a shard, or what went wrong."""
    folder, number = task
    try:
        reader = SplitReader(folder)
        return [_row(reader[k], reader.stored(k).size) for k in reader.numbers_in(number)]
    except SwiftTailorError as error:
        return str(error)


def _row(sample: Sample, size: int) -> dict[str, Any]:
    low, high = sample.vertices.min(axis=0), sample.vertices.max(axis=0)
    quality = sample.about.get("quality", {})
    words = [(c.name, c.value) for c in claims_of(measure_facts(sample.pattern)) if isinstance(c.value, str)]
    return {
        "panels": len(sample.pattern.panels),
        "stitches": len(sample.pattern.stitches),
        "vertices": len(sample.vertices),
        "kilobytes": size / 1e3,
        "length_cm": float(high[1] - low[1]),
        "lowest_cm": float(low[1]),
        "width_cm": float(high[0] - low[0]),
        **{n: float(quality.get(n, np.nan)) for n in list(MEASURES)[7:]},
        "claims": words,
    }


def _reasons(index: SplitIndex) -> dict[str, int]:
    kinds = Counter(kind_of_reason(text) for s in index.shards for r in s.rejected for text in r.reasons)
    return dict(sorted(kinds.items(), key=lambda item: (-item[1], item[0])))


def _seconds(folder: Path) -> dict[str, np.ndarray]:
    """Stage by stage from results.jsonl, which is no part of the data and may be missing."""
    path = folder / RESULTS
    found: dict[str, list[float]] = {}
    if path.is_file():
        for line in path.read_bytes().splitlines():
            try:
                seconds = {k: float(v) for k, v in json.loads(line).get("seconds", {}).items()}
            except (ValueError, TypeError, AttributeError, RecursionError):
                continue
            for stage, value in seconds.items():
                found.setdefault(stage, []).append(value)
    return {stage: np.array(values) for stage, values in found.items()}


def _quantiles(values: np.ndarray) -> dict[str, float]:
    known = values[np.isfinite(values)]
    if not len(known):
        return {}
    return {
        f"p{100 * q:g}": round(float(v), 4)
        for q, v in zip(_QUANTILES, np.quantile(known, _QUANTILES), strict=True)
    }

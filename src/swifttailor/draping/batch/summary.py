"""What a batch came to, in numbers."""

from __future__ import annotations

import platform
import re
import statistics
from collections import Counter
from collections.abc import Iterable
from typing import Any

import numpy as np

from swifttailor import __version__

_NUMBER = re.compile(r"-?\d+(\.\d+)?")
_LIMIT = re.compile(r"\s*\(limit [^)]*\)")


def summarize(
    records: Iterable[dict[str, Any]], settings: dict[str, Any], *, complete: bool
) -> dict[str, Any]:
    """Counts, reasons and medians over the records of a batch.

    Args:
        records: One per pattern.
        settings: `BatchSettings.identity`.
        complete: Whether every pattern of the batch has a record.

    Returns:
        JSON values for summary.json. Apart from the seconds they do not depend on how many workers there
        were, nor on how often the batch was interrupted.
    """
    ordered = sorted(records, key=lambda r: _natural(r["id"]))
    made = [r for r in ordered if r["status"] == "made"]
    failed = [r for r in ordered if r["status"] == "failed"]
    accepted = sum(bool(r["accepted"]) for r in made)
    return {
        "complete": complete,
        "counts": {
            "patterns": len(ordered),
            "accepted": accepted,
            "not_accepted": len(made) - accepted,
            "failed": len(failed),
        },
        "reasons": _histogram(kind_of_reason(reason) for r in made for reason in r["reasons"]),
        "failures": _histogram(r["kind"] for r in failed),
        "median_quality": _medians([r["quality"] for r in made]),
        "median_seconds": _medians([r["seconds"] | {"total": sum(r["seconds"].values())} for r in made]),
        "settings": settings,
        "versions": {
            "swifttailor": __version__,
            "python": platform.python_version(),
            "numpy": np.__version__,
        },
        "garments": [_row(r) for r in ordered],
    }


def kind_of_reason(reason: str) -> str:
    """A reason without its values: ``N edges pass through the body``."""
    return _NUMBER.sub("N", _LIMIT.sub("", reason))


def _row(record: dict[str, Any]) -> dict[str, Any]:
    kept = ("id", "folder", "status", "accepted", "reasons", "kind", "error")
    return {name: record[name] for name in kept if name in record}


def _histogram(values: Iterable[str]) -> dict[str, int]:
    counts = Counter(values)
    return dict(sorted(counts.items(), key=lambda item: (-item[1], item[0])))


def _medians(rows: list[dict[str, Any]]) -> dict[str, float]:
    names = dict.fromkeys(name for row in rows for name in row)
    result = {}
    for name in names:
        values = [
            row[name]
            for row in rows
            if isinstance(row.get(name), int | float) and not isinstance(row.get(name), bool)
        ]
        if values:
            result[name] = round(float(statistics.median(values)), 6)
    return result


def _natural(text: str) -> list[tuple[int, str]]:
    """Sort key under which ``gc_2`` comes before ``gc_10``."""
    return [(int(part), "") if part.isdecimal() else (-1, part) for part in re.split(r"(\d+)", text)]

"""A page of recorded evaluations: every table with the command, commit, seed and machine behind it."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from swifttailor.errors import InputError
from swifttailor.evaluation.table import Table

MOST_BYTES = 2**24
"""A summary has some ten thousand."""

_HEAD = """\
# Results

The paper's tables with a row for every system. This page is written by `swifttailor evaluate page`
from recorded runs; [evaluation](evaluation.md) says how everything is measured and what the paper
leaves unsaid: unit and number of points of its distances, and which of two edge accuracies it
lists. Its data are GarmentCodeData's, with their renders and captions; ours are freshly sampled
GarmentCode patterns, draped by our own physics, drawn by our own renderer and described by our own
captions. Compare with care.
"""


def results_page(runs: Sequence[Path]) -> str:
    """The page of some runs, in Markdown.

    Args:
        runs: Files ``summary.json`` of ``swifttailor evaluate systems`` or ``pattern-maker``, under any name.

    Raises:
        InputError: One of them is something else.
    """
    parts = [_HEAD]
    for path in runs:
        parts.append(_section(path))
    return "\n".join(parts)


def _section(path: Path) -> str:
    summary = _read(path)
    try:
        about, tables = summary["about"], [Table.of_json(value) for value in summary["tables"]]
        asked = ", ".join(f"{int(count)} {task}" for task, count in about["questions"].items())
        title = path.stem.replace("-", " ")
        commit = str(about["commit"] or "unknown")[:12]
        lines = [
            f"## {title[:1].upper()}{title[1:]}\n",
            f"```bash\n{about['command']}\n```\n",
            f"Patterns {', '.join(map(str, about['patterns']))} "
            f"(sha256 of all {about['patterns_sha256'][:16]}), {about['of']};\n"
            f"questions: {asked}; seed {about['seed']}; swifttailor {about['version']}, commit {commit};\n"
            f"{about['machine']}, {about['threads']} thread(s).\n",
        ]
    except (KeyError, TypeError, AttributeError, ValueError) as error:
        raise InputError(
            f"'{path}' is no summary of swifttailor evaluate systems or pattern-maker ({error!r}). Give the "
            "file summary.json of its --out."
        ) from error
    return "\n".join([*lines, *(table.markdown() for table in tables)])


def _read(path: Path) -> dict[str, Any]:
    try:
        if path.stat().st_size > MOST_BYTES:
            raise InputError(f"'{path}' is larger than {MOST_BYTES} bytes; a summary is not.")
        summary = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        raise InputError(f"Cannot read '{path}': {error}.") from error
    if not isinstance(summary, dict):
        raise InputError(f"'{path}' holds no JSON object.")
    return summary

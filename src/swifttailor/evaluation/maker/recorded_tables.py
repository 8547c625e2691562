"""The tables of a PatternMaker's evaluation as values: what `results_page` makes a page of."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from swifttailor.evaluation.maker.questions import Task
from swifttailor.evaluation.maker.sampling import SamplingSummary
from swifttailor.evaluation.maker.scores import TaskResult
from swifttailor.evaluation.maker.tables import PAPER_PATTERNS, SAID, sampling_rows
from swifttailor.evaluation.patterns.pattern_table import (
    AIPPAREL_NOTE,
    BY_NAME_NOTE,
    aipparel_rows,
    by_name_rows,
)
from swifttailor.evaluation.table import Table
from swifttailor.evaluation.text_table import Column, Row

_FROM: Mapping[Task, str] = {
    "text": "from a text",
    "image": "from a picture",
    "text+image": "from a picture and a text",
    "edit": "edited after an instruction, there and back",
}


def task_tables(result: TaskResult) -> Iterator[Table]:
    """Patterns, patterns without conditions, and what holds of what was asked for."""
    task = result.task
    yield Table(
        f"Patterns {_FROM[task]}", AIPPAREL_NOTE, *aipparel_rows(result.patterns, PAPER_PATTERNS[task])
    )
    yield Table(f"Patterns {_FROM[task]}, without conditions", BY_NAME_NOTE, *by_name_rows(result.patterns))
    columns = [Column("statements %", ".1f"), Column("all hold %", ".1f"), Column("n", "d")]
    rows: list[Row] = []
    for name, found in result.adherence:
        shares = (found.claims.share, found.whole.share)
        rows.append((name, [*(None if s is None else 100 * s for s in shares), found.whole.made]))
    yield Table(f"What was asked for, {_FROM[task]}", SAID[task], columns, rows)


def sampling_table(found: Mapping[Task, SamplingSummary], limit: int) -> Table:
    """#Sampling and validity, task by task.

    Args:
        found: Of each task.
        limit: Most attempts for a question.
    """
    note = (
        f"Attempts until a pattern can be made into a garment, at most {limit}; 'mended': what is safe to "
        "mend is mended first; 'found': share of the questions with success. The shares after that are of "
        "first attempts."
    )
    return Table("#Sampling and validity, at temperature 1", note, *sampling_rows(found))

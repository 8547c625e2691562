"""The tables of a PatternMaker's evaluation as values: what `results_page` makes a page of."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from swifttailor.evaluation.maker.questions import Task
from swifttailor.evaluation.maker.sampling import SamplingSummary
from swifttailor.evaluation.maker.scores import TaskResult
from swifttailor.evaluation.maker.tables import PAPER_PATTERNS, SAID, sampling_rows
from swifttailor.evaluation.paper_rows import PatternRow
from swifttailor.evaluation.patterns.adherence import Adherence
from swifttailor.evaluation.patterns.pattern_table import (
    AIPPAREL_NOTE,
    BY_NAME_NOTE,
    PatternSummary,
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
    """Patterns, patterns without conditions, and what holds of what was asked for, of one task."""
    task = result.task
    yield from tables_of_patterns(
        _FROM[task], result.patterns, result.adherence, paper=PAPER_PATTERNS[task], said=SAID[task]
    )


def tables_of_patterns(
    asked: str,
    patterns: Sequence[tuple[str, PatternSummary]],
    adherence: Sequence[tuple[str, Adherence]],
    *,
    paper: Sequence[PatternRow],
    said: str,
) -> Iterator[Table]:
    """The three tables of what several methods answered to the same questions.

    Args:
        asked: For the titles, such as "from a picture".
        patterns: Each method's name and its patterns' metrics.
        adherence: Each method's name and how much holds of what was asked for.
        paper: The paper's rows.
        said: What is counted in the last table.
    """
    yield Table(f"Patterns {asked}", AIPPAREL_NOTE, *aipparel_rows(patterns, paper))
    yield Table(f"Patterns {asked}, without conditions", BY_NAME_NOTE, *by_name_rows(patterns))
    columns = [Column("statements %", ".1f"), Column("all hold %", ".1f"), Column("n", "d")]
    rows: list[Row] = []
    for name, found in adherence:
        shares = (found.claims.share, found.whole.share)
        rows.append((name, [*(None if s is None else 100 * s for s in shares), found.whole.made]))
    yield Table(f"What was asked for, {asked}", said, columns, rows)


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

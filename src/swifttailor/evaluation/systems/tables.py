"""What a comparison of systems prints: the paper's tables with a row for every generator and constructor."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from swifttailor.evaluation.maker.questions import Task
from swifttailor.evaluation.maker.recorded_tables import tables_of_patterns
from swifttailor.evaluation.maker.scores import TaskResult
from swifttailor.evaluation.maker.tables import SAID
from swifttailor.evaluation.paper_rows import (
    FROM_IMAGE,
    FROM_IMAGE_AND_TEXT,
    FROM_TEXT,
    PATTERNS_FROM_IMAGE,
    PATTERNS_FROM_IMAGE_AND_TEXT,
    GarmentRow,
    PatternRow,
)
from swifttailor.evaluation.systems.run import Cell, SystemsResult
from swifttailor.evaluation.table import Table
from swifttailor.evaluation.text_table import Column, Row

_FROM: Mapping[Task, str] = {
    "text": "from a text",
    "image": "from a picture",
    "text+image": "from a picture and a text",
}
_PATTERNS: Mapping[Task, Sequence[PatternRow]] = {
    "image": PATTERNS_FROM_IMAGE,
    "text+image": PATTERNS_FROM_IMAGE_AND_TEXT,
}
_GARMENTS: Mapping[Task, Sequence[GarmentRow]] = {
    "text": FROM_TEXT,
    "image": FROM_IMAGE,
    "text+image": FROM_IMAGE_AND_TEXT,
}
_SAID_OF_IMAGE = "Statements that a caption would have made of what can be seen, and that hold"
_GARMENT_COLUMNS = (
    Column("CD"),
    Column("EMD"),
    Column("MMD"),
    Column("COV"),
    Column("#Sampling"),
    Column("made %", ".1f"),
    Column("sound %", ".1f"),
    Column("within limits %", ".1f"),
    Column("n", "d"),
)
_TIME_COLUMNS = (Column("pattern s"), Column("garment s"), Column("both s"), Column("MiB", "d"))


def tables_of(found: SystemsResult) -> list[Table]:
    """All tables, task by task."""
    tables = []
    for task in found.about["questions"]:
        results = {name: _of(task, some) for name, some in found.answers.items()}
        tables += _pattern_tables(task, results)
        cells = [cell for cell in found.cells if cell.task == task]
        if cells:
            tables.append(_garment_table(task, cells, results, found))
            tables.append(_time_table(task, cells, results))
    return tables


def _of(task: Task, results: Sequence[TaskResult]) -> TaskResult:
    return next(result for result in results if result.task == task)


def _pattern_tables(task: Task, results: Mapping[str, TaskResult]) -> Iterator[Table]:
    patterns = [(name, result.patterns[0][1]) for name, result in results.items()]
    adherence = [(name, result.adherence[0][1]) for name, result in results.items()]
    paper, said = _PATTERNS.get(task, ()), _SAID_OF_IMAGE if task == "image" else SAID[task]
    yield from tables_of_patterns(_FROM[task], patterns, adherence, paper=paper, said=said)


def _garment_table(
    task: Task, cells: Sequence[Cell], results: Mapping[str, TaskResult], found: SystemsResult
) -> Table:
    rows: list[Row] = []
    for cell in cells:
        sets, asked = cell.sets, cell.asked
        rows.append(
            (
                f"{cell.generator} + {cell.constructor}",
                [
                    None if cell.chamfer is None else cell.chamfer.mean,
                    None if cell.emd is None else cell.emd.mean,
                    None if sets is None else sets.mmd,
                    0.0 if sets is None else sets.coverage,
                    results[cell.generator].until_sound or None,
                    100 * cell.made / asked,
                    100 * cell.sound / asked,
                    None if cell.accepted is None else 100 * cell.accepted / asked,
                    asked,
                ],
            )
        )
    floor = found.floors[task]
    rows.append(("  the drapes, points drawn again", [None, None, floor.mmd, floor.coverage, *[None] * 5]))
    rows += [
        (f"paper: {r.name}", [r.chamfer, r.emd, r.mmd, r.coverage, r.attempts, *[None] * 4])
        for r in _GARMENTS[task]
    ]
    return Table(
        f"Garments {_FROM[task]}",
        "CD (to the drape of the pattern asked for) and MMD in cm2, EMD in cm, COV: share; 10,000 points,\n"
        f"2,048 for EMD; of the {cells[0].compared} that have such a drape. CD and EMD are means over the\n"
        "garments that were made; what was not made lowers\n"
        "COV, and counts as not sound and not within the limits. #Sampling: patterns made until one could\n"
        "be made into a garment, where that is known. The paper states neither unit nor number of points,\n"
        "and has other data: see docs/evaluation.md.",
        _GARMENT_COLUMNS,
        rows,
    )


def _time_table(task: Task, cells: Sequence[Cell], results: Mapping[str, TaskResult]) -> Table:
    rows: list[Row] = []
    for cell in cells:
        pattern = sum(results[cell.generator].seconds.values()) or None
        garment = sum(cell.seconds.values()) or None
        both = None if pattern is None or garment is None else pattern + garment
        rows.append((f"{cell.generator} + {cell.constructor}", [pattern, garment, both, cell.mebibytes]))
    return Table(
        f"Running time {_FROM[task]}",
        "Mean seconds of an answer, and of a garment that was made. MiB: most memory of the whole process,\n"
        "all networks loaded, while garments were made in this run.",
        _TIME_COLUMNS,
        rows,
    )


def provenance_text(about: Mapping[str, Any]) -> str:
    """Where the numbers come from."""
    some = "" if about["chosen"] is None else f", at most {about['chosen']} chosen by lot"
    asked = ", ".join(f"{count} {task}" for task, count in about["questions"].items())
    look = f"; pictures: {about['look']}, {about['view']}" if about["look"] else ""
    return (
        f"patterns {', '.join(about['patterns'])}: {about['of']}{some} "
        f"(sha256 of all {about['patterns_sha256'][:16]})\n"
        f"questions: {asked}; seed {about['seed']}{look}\n"
        f"swifttailor {about['version']}, commit {about['commit'] or 'unknown'}\n{about['machine']}\n"
    )

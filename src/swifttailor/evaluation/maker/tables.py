"""What an evaluation of a PatternMaker prints."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from swifttailor.evaluation.maker.garments import GarmentSets
from swifttailor.evaluation.maker.questions import Task
from swifttailor.evaluation.maker.sampling import SamplingSummary
from swifttailor.evaluation.maker.scores import TaskResult
from swifttailor.evaluation.paper_rows import (
    EDITED_PATTERNS,
    FROM_IMAGE,
    FROM_IMAGE_AND_TEXT,
    FROM_TEXT,
    PATTERNS_FROM_IMAGE,
    PATTERNS_FROM_IMAGE_AND_TEXT,
    GarmentRow,
    PatternRow,
)
from swifttailor.evaluation.patterns.adherence import adherence_table
from swifttailor.evaluation.patterns.pattern_table import pattern_tables
from swifttailor.evaluation.text_table import Column, Row, text_table

PAPER_PATTERNS: Mapping[Task, Sequence[PatternRow]] = {
    "text": (),
    "image": PATTERNS_FROM_IMAGE,
    "text+image": PATTERNS_FROM_IMAGE_AND_TEXT,
    "edit": EDITED_PATTERNS,
}
"""The paper has no table of patterns from text alone."""
_GARMENTS: Mapping[Task, Sequence[GarmentRow]] = {
    "text": FROM_TEXT,
    "image": FROM_IMAGE,
    "text+image": FROM_IMAGE_AND_TEXT,
    "edit": (),
}
_TITLES: Mapping[Task, str] = {
    "text": "From text",
    "image": "From a picture",
    "text+image": "From a picture and a text",
    "edit": "Edits after an instruction, there and back",
}
SAID: Mapping[Task, str] = {
    "text": "Statements of the captions that hold",
    "image": "Statements that a caption would have made, and that hold",
    "text+image": "Statements of the captions that hold",
    "edit": "Changes asked for that are there",
}
"""What is counted of what was asked for."""
_SAMPLING = (
    Column("attempts"),
    Column("mended"),
    Column("found %", ".1f"),
    Column("closed %", ".1f"),
    Column("paired %", ".1f"),
    Column("no error %", ".1f"),
    Column("sound %", ".1f"),
    Column("mended %", ".1f"),
    Column("n", "d"),
)


def task_text(result: TaskResult) -> str:
    """Tables of one task."""
    count = result.patterns[0][1].patterns
    dropped = f"{result.dropped} stitch tags stood on one edge or on three and more, and join nothing\n"
    seconds = ", ".join(f"{name} {value:.3f}" for name, value in result.seconds.items())
    return (
        f"== {_TITLES[result.task]}: {count} questions ==\n\n"
        f"{pattern_tables(result.patterns, PAPER_PATTERNS[result.task])}\n"
        f"{SAID[result.task]}\n\n{adherence_table(result.adherence)}\n"
        f"{result.attempts:.2f} patterns were tried for an answer, {result.until_sound:.2f} until one "
        f"could be made into a garment (#Sampling); {result.known} of {count} were cut from known patterns\n"
        f"{result.mended} of {count} answers were mended; in {result.faulty} a check still finds errors\n"
        f"{dropped if result.dropped else ''}"
        f"seconds of an answer, among others answered together: {seconds or 'none'}\n"
    )


def sampling_rows(found: Mapping[Task, SamplingSummary]) -> tuple[Sequence[Column], list[Row]]:
    """Columns and rows of #Sampling and validity, task by task, beside the paper's."""
    rows: list[Row] = []
    for task, s in found.items():
        shares = (s.closed, s.paired, s.checked, s.sound, s.sound_mended)
        of_all = 100 * s.written.succeeded / s.written.inputs
        percent = [100 * share / s.samples for share in shares]
        rows.append((f"PatternMaker, {task}", [s.written.mean, s.mended.mean, of_all, *percent, s.samples]))
        known = {row.name.split(" + ")[0]: row.attempts for row in _GARMENTS[task]}
        nothing: list[float | int | None] = [None] * (len(_SAMPLING) - 1)
        rows += [(f"paper: {name}, {task}", [attempts, *nothing]) for name, attempts in known.items()]
    return _SAMPLING, rows


def sampling_text(found: Mapping[Task, SamplingSummary], limit: int) -> str:
    """Table of #Sampling and validity."""
    failures = [
        f"{task}: samples that failed, by gate: "
        + ", ".join(f"{gate} {count}" for gate, count in s.written.failures.items())
        + "\n"
        for task, s in found.items()
    ]
    return (
        "== #Sampling and validity, at temperature 1 ==\n\n"
        f"Attempts until a pattern can be made into a garment, at most {limit}; 'mended': what is safe to\n"
        "mend is mended first; 'found': share of the questions with success. The shares after that are\n"
        "of first attempts: all panels closed, all stitches in pairs, no error found by the checker, can\n"
        "be made into a garment as written, and mended.\n\n"
        f"{text_table(*sampling_rows(found))}\n{''.join(failures)}"
    )


def garments_text(found: Mapping[Task, GarmentSets]) -> str:
    """Table of the garments of the answers, task by task, beside the paper's."""
    columns = [Column("CD"), Column("MMD"), Column("COV"), Column("not sewn", "d"), Column("n", "d")]
    rows: list[Row] = []
    for task, g in found.items():
        for name, chamfer, sets in (
            (f"PatternMaker + GarmentSewer, {task}", g.chamfer, g.answers),
            ("  true patterns + GarmentSewer", None, g.truth),
            ("  floor", None, g.floor),
        ):
            rows.append((name, [chamfer, sets.mmd, sets.coverage, sets.failed, sets.references]))
        rows += [
            (f"paper: {row.name}, {task}", [None, row.mmd, row.coverage, None, None])
            for row in _GARMENTS[task]
        ]
    return (
        "== Garments of the answers ==\n\n"
        "CD (to the drape of the pattern asked for) and MMD in cm2, COV: share; 10,000 points. Floor: the\n"
        "drapes themselves, their points drawn again. The paper states neither unit nor number of points,\n"
        "and has other data: see docs/evaluation.md.\n\n" + text_table(columns, rows)
    )


def _manner(about: Mapping[str, Any]) -> str:
    """How the questions were asked."""
    temperature = f"temperature {about['temperature']:g}"
    if about["network_alone"]:
        decoded = {"grammar": ", under the grammar", "free": ", decoded without the grammar"}
        how = decoded.get(about.get("decoding", "own"), "")
        return f"answers of the network alone{how}, {temperature}, one pattern each"
    usual = "answers as swifttailor generate and edit give them"
    without = [name for name in ("alter", "crop") if not about[name]]
    if about["source"] != "both":
        usual += f", {'known' if about['source'] == 'library' else 'written'} patterns alone"
    return ", ".join(
        [usual, temperature, f"at most {about['attempts']} attempts", *(f"no {w}" for w in without)]
    )


def provenance_text(about: Mapping[str, Any]) -> str:
    """Where the numbers come from, from `run.Evaluation.about`, the code and the machine."""
    some = "" if about["chosen"] is None else f", at most {about['chosen']} chosen by lot"
    weights = about["weights"]
    asked = ", ".join(f"{count} {task}" for task, count in about["questions"].items())
    lines = [
        "PatternMaker against true patterns",
        f"patterns {', '.join(about['patterns'])}: {about['of']}{some} "
        f"(sha256 of all {about['patterns_sha256'][:16]})",
        f"questions: {asked}; seed {about['seed']}",
        _manner(about),
    ]
    if about["edits"]:
        unseen = len(about["unseen_edits"])
        left = f"; {unseen} change nothing that there are words for, and were left out" if unseen else ""
        lines.append(f"edits {about['edits']}{left}")
    if about["pictures"]:
        drawn = ", ".join(about["pictures_drawn"])
        how = f", drawn of the drapes of {drawn}" if drawn else ""
        lines.append(f"pictures of the splits {', '.join(about['pictures'])}{how}")
    lines.append(f"weights {weights['file']} (sha256 {weights['sha256'][:16]}), threads {about['threads']}")
    others = [c or "unknown" for c in about["answered_by_commits"] if c != about["commit"]]
    made = f" (answers also by {', '.join(others)})" if others else ""
    lines.append(f"swifttailor {about['version']}, commit {about['commit'] or 'unknown'}{made}")
    lines.append(about["machine"])
    return "\n".join(lines) + "\n"

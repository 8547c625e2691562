"""Answers against the truth: what is printed, and a line for each answer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from swifttailor.describing import GarmentFacts
from swifttailor.errors import SwiftTailorError
from swifttailor.evaluation.maker.ask import KeptAnswer
from swifttailor.evaluation.maker.questions import Question, Task
from swifttailor.evaluation.patterns.adherence import (
    Adherence,
    by_chance,
    judge_claims,
    judge_instructions,
    measured,
)
from swifttailor.evaluation.patterns.pattern_table import (
    PatternScore,
    PatternSummary,
    score_pattern,
    summarize_patterns,
    summarize_scores,
)
from swifttailor.pattern import Pattern
from swifttailor.pattern_maker.tokens.decode import decode
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.progress import CountProgress, unwatched

AdherenceRows = list[tuple[str, Adherence]]


@dataclass(frozen=True, eq=False)
class Scored:
    """One answer and how good it is."""

    answer: KeptAnswer
    score: PatternScore
    facts: GarmentFacts | None
    """Of the answer; None where there are none to measure."""

    @property
    def fulfilled(self) -> list[tuple[dict[str, Any], bool]]:
        """Each claim of the caption, or change of the instruction, and whether it holds."""
        question, facts = self.answer.question, self.facts
        if question.instruction is None:
            return [(c.to_json(), facts is not None and c.holds(facts)) for c in question.claims]
        before = question.before_facts
        return [
            (dict(c.to_json()), facts is not None and before is not None and c.holds(before, facts))
            for c in question.instruction.changes
        ]

    def to_json(self) -> dict[str, Any]:
        """Plain JSON values."""
        question, record = self.answer.question, self.answer.record
        kept = (
            *("tokens", "log_likelihood", "attempts", "until_sound", "known", "mended", "altered", "not_so"),
            *("dropped", "errors", "warnings", "error"),
        )
        return {
            "question": question.key,
            "text": question.text,
            **{name: record[name] for name in kept if name in record},
            **self.score.to_json(),
            "measured": self.facts is not None,
            "asked_for": [about | {"holds": holds} for about, holds in self.fulfilled],
        }


@dataclass(frozen=True)
class TaskResult:
    """What came of a task. Rows are pairs of a method's name and its result."""

    task: Task
    patterns: list[tuple[str, PatternSummary]]
    """Ours first; then the true patterns through tokens and back, and another pattern or the input."""
    adherence: AdherenceRows
    attempts: float
    """Patterns that were tried for an answer, in the mean."""
    until_sound: float
    """Patterns until one could be made into a garment, in the mean: #Sampling."""
    known: int
    """Answers that were cut from known patterns."""
    mended: int
    """Answers in which something was mended."""
    faulty: int
    """Answers in which a check still finds an error."""
    seconds: dict[str, float]
    """Mean of an answer, by stage; answered together with others."""
    dropped: int = 0
    """Stitch tags in all answers that were not on two edges, and join nothing; without the grammar alone."""

    def to_json(self) -> dict[str, Any]:
        """Plain JSON values."""
        return {
            "patterns": {name: asdict(found) for name, found in self.patterns},
            "adherence": {name: asdict(found) for name, found in self.adherence},
            "attempts": self.attempts,
            "until_sound": self.until_sound,
            "known": self.known,
            "mended": self.mended,
            "faulty": self.faulty,
            "seconds": self.seconds,
            **({"dropped": self.dropped} if self.dropped else {}),
        }


OURS, TOKENS, OTHER, INPUT, TRUTH, CHANCE = (
    "PatternMaker",
    "truth through tokens",
    "another pattern",
    "input unchanged",
    "truth",
    "by chance",
)


def score_answers(answers: Sequence[KeptAnswer], progress: CountProgress = unwatched) -> list[Scored]:
    """Compares each answer with the truth and measures it; calls `progress` with 1 after each."""
    scored = []
    for answer in answers:
        score = score_pattern(answer.pattern, answer.question.truth)
        scored.append(Scored(answer, score, measured(answer.pattern)))
        progress(1)
    return scored


def summarize_task(task: Task, scored: Sequence[Scored]) -> TaskResult:
    """Means over the answers of a task, at least one, and those of what they are to be read beside."""
    questions = [s.answer.question for s in scored]
    truth = [q.truth for q in questions]
    rows = [(OURS, summarize_scores([s.score for s in scored]))]
    rows.append((TOKENS, summarize_patterns([_through_tokens(p) for p in truth], truth)))
    if task == "edit":
        rows.append((INPUT, summarize_patterns([q.before for q in questions], truth)))
    else:
        rows.append((OTHER, summarize_patterns(truth[1:] + truth[:1], truth)))
    records = [s.answer.record for s in scored]
    return TaskResult(
        task,
        rows,
        _edit_adherence(questions, scored) if task == "edit" else _caption_adherence(questions, scored),
        attempts=_mean(records, "attempts"),
        until_sound=_mean(records, "until_sound"),
        known=sum("known" in r for r in records),
        mended=sum(bool(r.get("mended")) for r in records),
        faulty=sum(r.get("errors", 0) > 0 for r in records),
        seconds=_seconds(records),
        dropped=sum(r.get("dropped", 0) for r in records),
    )


def _mean(records: Sequence[dict[str, Any]], name: str) -> float:
    """Over the records that have it; 0 where none has."""
    return float(np.mean([record[name] for record in records if name in record] or [0]))


def _caption_adherence(questions: Sequence[Question], scored: Sequence[Scored]) -> AdherenceRows:
    prompts, truth = [q.claims for q in questions], [q.facts for q in questions]
    return [
        (OURS, judge_claims(prompts, [s.facts for s in scored])),
        (TRUTH, judge_claims(prompts, truth)),
        (CHANCE, by_chance(prompts, truth)),
    ]


def _edit_adherence(questions: Sequence[Question], scored: Sequence[Scored]) -> AdherenceRows:
    given = [q.instruction for q in questions if q.instruction is not None]
    before = [q.before_facts for q in questions if q.before_facts is not None]
    return [
        (OURS, judge_instructions(given, before, [s.facts for s in scored])),
        (TRUTH, judge_instructions(given, before, [q.facts for q in questions])),
        (INPUT, judge_instructions(given, before, before)),
    ]


def _through_tokens(pattern: Pattern) -> Pattern | None:
    """What a network could write at best; None where tokens cannot say it."""
    try:
        return decode(encode(pattern))
    except SwiftTailorError:
        return None


def _seconds(records: Sequence[dict[str, Any]]) -> dict[str, float]:
    found = [r for r in records if "seconds" in r]
    stages = dict.fromkeys(name for r in found for name in r["seconds"])
    return {
        name: sum(r["seconds"].get(name, 0.0) / r["together"] for r in found) / len(found) for name in stages
    }

"""Patterns to ask for, and makers that answer as a test wants them to."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from swifttailor.errors import InputError
from swifttailor.evaluation.maker.questions import Question
from swifttailor.pattern import Pattern, repair_pattern, to_specification
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_maker.maker import Request, WrittenPattern
from swifttailor.pattern_maker.tokens.encode import encode

DRAFTS = {
    "shirt": ("t-shirt", {}),
    "short": ("fitted-skirt", {"length": 45.0}),
    "long": ("fitted-skirt", {"length": 70.0}),
    "trousers": ("trousers", {}),
}
"""Three of them are those of `sewn_splits.make_data`."""
EDITS = {
    "longer": ("short", ("fitted-skirt", {"length": 80.0})),
    "sleeves": ("shirt", ("t-shirt", {"sleeve_length": 55.0})),
}


def write_patterns(folder: Path) -> Path:
    """A file with `DRAFTS`."""
    patterns = {id: draft(name, **options) for id, (name, options) in DRAFTS.items()}
    # Files need not be in canonical order.
    lines = [_line(id, replace(p, panels=p.panels[::-1])) for id, p in patterns.items()]
    return _write(folder / "patterns.jsonl", lines)


def write_edits(folder: Path, *more: dict) -> Path:
    """A file with `EDITS`, one of a pattern that is not there, and more lines."""
    lines = [_line(id, draft(name, **options), base) for id, (base, (name, options)) in EDITS.items()]
    lines.append(_line("stranger", draft("hoodie"), "nobody"))
    return _write(folder / "edits.jsonl", [*lines, *map(json.dumps, more)])


def _line(id: str, pattern: Pattern, base: str = "") -> str:
    return json.dumps({"id": id, "pattern": to_specification(pattern)} | ({"base": base} if base else {}))


def _write(path: Path, lines: Sequence[str]) -> Path:
    path.write_text("".join(line + "\n" for line in lines))
    return path


def given(written: Pattern) -> WrittenPattern:
    """What a PatternMaker that writes a pattern gives: what is safe to mend is mended."""
    repair = repair_pattern(written)
    return WrittenPattern(
        repair.pattern,
        log_likelihood=-1.5,
        sequence=encode(written),
        changes=repair.changes,
        findings=repair.remaining,
        seconds={"writing": 0.5},
    )


Choose = Callable[[Question, int, float], Pattern]
"""Of a question, the seed and the temperature."""


class StandIn:
    """A maker that knows the questions, and leaves the answers to a function."""

    def __init__(self, questions: Sequence[Question], choose: Choose, pictures=None) -> None:
        self.questions, self.choose, self.pictures = list(questions), choose, pictures
        self.asked: list[list[str]] = []
        """Keys of the questions that were asked together, call by call."""

    def generate_all(
        self, requests: Sequence[Request], *, seed: Sequence[int], temperature: float, draw: int
    ) -> list[WrittenPattern]:
        found = [self._find(request) for request in requests]
        self.asked.append([q.key for q in found])
        return [given(self.choose(q, s, temperature)) for q, s in zip(found, seed, strict=True)]

    def _find(self, request: Request) -> Question:
        for question in self.questions:
            if question.text != request.text or question.before != request.edit:
                continue
            if (request.image is not None) != ("image" in question.task):
                continue
            if request.image is None or np.array_equal(request.image, self._picture(question)):
                return question
        raise AssertionError(f"nobody asked '{request.text}'")

    def _picture(self, question: Question) -> np.ndarray:
        return self.pictures.picture(question.id)[1][0]


def truth(question: Question, seed: int, temperature: float) -> Pattern:
    """The right answer."""
    return question.truth


def copy(question: Question, seed: int, temperature: float) -> Pattern:
    """What was to be edited."""
    assert question.before is not None
    return question.before


def refuse(question: Question, seed: int, temperature: float) -> Pattern:
    """No answer."""
    raise InputError(f"No answer to {question.id}.")

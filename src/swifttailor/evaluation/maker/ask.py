"""Asking the questions, some at a time, and keeping the answers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.evaluation.maker.book import Book
from swifttailor.evaluation.maker.pictures import GarmentPictures
from swifttailor.evaluation.maker.questions import PICTURED, Question, seed_of
from swifttailor.pattern import Finding, Pattern, Severity, read_specification, to_specification
from swifttailor.pattern.check.repair import Change
from swifttailor.pattern_maker.maker import Request
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.progress import CountProgress

BATCH = 16
"""Questions that are answered together."""


class Given(Protocol):
    """What is used of `pattern_maker.maker.Generated`."""

    @property
    def pattern(self) -> Pattern: ...  # noqa: D102
    @property
    def sequence(self) -> TokenSequence: ...  # noqa: D102
    @property
    def log_likelihood(self) -> float: ...  # noqa: D102
    @property
    def changes(self) -> Sequence[Change]: ...  # noqa: D102
    @property
    def findings(self) -> Sequence[Finding]: ...  # noqa: D102
    @property
    def seconds(self) -> dict[str, float]: ...  # noqa: D102


class Maker(Protocol):
    """Anything that answers like `pattern_maker.maker.PatternMaker`."""

    def generate_all(
        self, requests: Sequence[Request], *, seed: Sequence[int], temperature: float, attempts: int
    ) -> Sequence[Given]:
        """Patterns for some requests."""
        ...


@dataclass(frozen=True)
class Asking:
    """How questions are asked."""

    temperature: float = 0.0
    attempts: int = 1
    """Patterns written for each question, of which the best is taken."""
    seed: int = 0


@dataclass(frozen=True, eq=False)
class Answer:
    """What was answered."""

    question: Question
    pattern: Pattern | None
    """None where nothing could be decoded."""
    record: dict[str, Any]
    """As it is kept: see docs/evaluation.md."""


def ask_all(
    maker: Maker,
    questions: Sequence[Question],
    book: Book,
    asking: Asking,
    pictures: GarmentPictures | None = None,
    progress: CountProgress | None = None,
) -> list[Answer]:
    """Asks what has not been answered yet.

    Questions are answered together with those beside them, always the same ones, so that being interrupted
    makes no difference: together or alone, numbers differ in their last digits.

    Args:
        maker: Is asked.
        questions: Of any tasks.
        book: Where answers are kept.
        asking: How.
        pictures: For questions with one.
        progress: Called with the number of questions that are done.

    Raises:
        InputError: An answer cannot be written, or a picture not be read.
    """
    for part in batches(questions):
        if any(book.get(question) is None for question in part):
            given = ask(maker, part, asking, pictures)
            for question, one in zip(part, given, strict=True):
                content = one if isinstance(one, dict) else _content(one, len(part))
                book.add(question, 0, {"text": question.text} | content)
        if progress is not None:
            progress(len(part))
    answers = []
    for question in questions:
        record = book.get(question)
        assert record is not None
        answers.append(Answer(question, pattern_of(record, question.id), record))
    return answers


def batches(questions: Sequence[Question]) -> Iterator[Sequence[Question]]:
    """Questions of one task that are answered together."""
    start = 0
    for k in range(1, len(questions) + 1):
        if k == len(questions) or k - start == BATCH or questions[k].task != questions[start].task:
            yield questions[start:k]
            start = k


def ask(
    maker: Maker,
    questions: Sequence[Question],
    asking: Asking,
    pictures: GarmentPictures | None,
    attempt: int | None = None,
) -> list[Given | dict[str, Any]]:
    """Answers to some questions, or ``{"error": ...}`` where there is none.

    Args:
        maker: Is asked.
        questions: Of any tasks.
        asking: How.
        pictures: For questions with one.
        attempt: Number of the sample, where there are several of each question.
    """
    names: tuple[str | int, ...] = ("answer",) if attempt is None else ("sample", attempt)
    seeds = [seed_of(asking.seed, q.key, *names) for q in questions]
    requests = [_request(q, pictures) for q in questions]

    def answer(some: slice) -> Sequence[Given]:
        return maker.generate_all(
            requests[some], seed=seeds[some], temperature=asking.temperature, attempts=asking.attempts
        )

    try:
        return list(answer(slice(None)))
    except SwiftTailorError as error:
        if len(questions) == 1:
            return [{"error": str(error)}]
    # One of them has no answer; which, shows when they are asked alone.
    answers: list[Given | dict[str, Any]] = []
    for k in range(len(questions)):
        try:
            answers += answer(slice(k, k + 1))
        except SwiftTailorError as error:
            answers.append({"error": str(error)})
    return answers


def pattern_of(record: dict[str, Any], name: str) -> Pattern | None:
    """The pattern of a record; None where it has none.

    Raises:
        InputError: The record is damaged.
    """
    if record.get("pattern") is None:
        return None
    try:
        return read_specification(record["pattern"], name=name).pattern
    except SwiftTailorError as error:
        raise InputError(
            f"The answer to '{record['question']}' is damaged: {error}. Delete its line; it is asked again."
        ) from error


def picture_of(question: Question, pictures: GarmentPictures | None) -> tuple[str, Any] | None:
    """Look and pixels of the picture that goes with a question; None where it has none."""
    if question.task not in PICTURED:
        return None
    if pictures is None:
        raise InputError(f"'{question.key}' is about a picture, and there is no data set with pictures.")
    return pictures.picture(question.id)


def _request(question: Question, pictures: GarmentPictures | None) -> Request:
    shown = picture_of(question, pictures)
    return Request(question.text, None if shown is None else shown[1], question.before)


def _content(given: Given, together: int) -> dict[str, Any]:
    severities = [finding.severity for finding in given.findings]
    return {
        "pattern": to_specification(given.pattern),
        "tokens": len(given.sequence),
        "log_likelihood": given.log_likelihood,
        "mended": [change.code for change in given.changes],
        "errors": severities.count(Severity.ERROR),
        "warnings": severities.count(Severity.WARNING),
        # Of all that were answered together.
        "seconds": given.seconds,
        "together": together,
    }

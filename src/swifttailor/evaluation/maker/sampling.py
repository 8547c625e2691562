"""#Sampling and validity: patterns drawn at temperature 1, until one of each question can be made."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from functools import partial
from typing import Any

from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.evaluation.maker.ask import ask_network, batches, together_or_alone
from swifttailor.evaluation.maker.book import Book
from swifttailor.evaluation.maker.pictures import GarmentPictures
from swifttailor.evaluation.maker.questions import Question, seed_of
from swifttailor.evaluation.patterns.attempts import (
    Attempts,
    AttemptsSummary,
    attempts_of,
    first_fault,
    summarize_attempts,
)
from swifttailor.evaluation.patterns.validity import validity
from swifttailor.pattern import to_specification
from swifttailor.pattern_maker.maker import ChosenDecoding, WrittenPattern
from swifttailor.pattern_maker.tokens.decode import decode
from swifttailor.progress import CountProgress, unwatched
from swifttailor.tailor.protocols import PatternWriter

TEMPERATURE = 1.0


@dataclass(frozen=True, eq=False)
class Sampled:
    """What came of one question."""

    question: Question
    written: Attempts
    """Judging patterns as they were written."""
    mended: Attempts
    """Judging them after `repair_pattern`, which is what people get."""
    first: dict[str, Any]
    """Record of the first sample."""


@dataclass(frozen=True)
class SamplingSummary:
    """Over the questions of a task."""

    written: AttemptsSummary
    mended: AttemptsSummary
    samples: int
    """First samples, one of each question, which the shares below are of."""
    closed: int
    """Of which all panels are closed."""
    paired: int
    """Of which all stitches are pairs."""
    checked: int
    """In which the checker finds no error."""
    sound: int
    """Which can be made into a garment."""
    sound_mended: int
    """Which can when what is safe to mend is mended."""


def sample_all(
    writer: PatternWriter,
    questions: Sequence[Question],
    book: Book,
    limit: int,
    seed: int,
    pictures: GarmentPictures | None = None,
    progress: CountProgress = unwatched,
    decoding: ChosenDecoding = "own",
) -> list[Sampled]:
    """Draws what was not drawn yet, of each question until a pattern is sound, as written and mended.

    Args:
        writer: Is asked; what it writes is neither altered nor judged by anybody else.
        questions: Of any tasks.
        book: Where samples are kept.
        limit: Of the samples of each question.
        seed: Of the draws.
        pictures: For questions with one.
        progress: Called with the number of questions that are done.
        decoding: See `Asking`.

    Raises:
        InputError: A sample cannot be written, or a picture not be read.
    """
    sampled = []
    for part in batches(questions):
        counted: dict[str, Sampled] = {}
        for attempt in range(limit):
            # Those that have a sound pattern are not asked again; so a batch is the same whenever it is made.
            left = [q for q in part if q.key not in counted]
            if any(book.get(q, attempt) is None for q in left):
                given = together_or_alone(left, partial(_drawn, writer, pictures, seed, attempt, decoding))
                for question, one in zip(left, given, strict=True):
                    book.add(question, attempt, _content(one))
            for question in left:
                found = _count(question, book, attempt + 1, limit)
                if found is not None:
                    counted[question.key] = found
            if len(counted) == len(part):
                break
        sampled += [counted[q.key] for q in part]
        progress(len(part))
    return sampled


def summarize_samples(sampled: Sequence[Sampled]) -> SamplingSummary:
    """Puts questions together.

    Raises:
        InputError: There are none.
    """
    first = [s.first for s in sampled]
    return SamplingSummary(
        written=summarize_attempts([s.written for s in sampled]),
        mended=summarize_attempts([s.mended for s in sampled]),
        samples=len(first),
        closed=sum(f["closed"] for f in first),
        paired=sum(f["paired"] for f in first),
        checked=sum(f["fault"] is None or f["fault"][0] == "mesh" for f in first),
        sound=sum(f["fault"] is None for f in first),
        sound_mended=sum(f["fault_mended"] is None for f in first),
    )


def _drawn(
    writer: PatternWriter,
    pictures: GarmentPictures | None,
    seed: int,
    attempt: int,
    decoding: ChosenDecoding,
    questions: Sequence[Question],
) -> Sequence[WrittenPattern | SwiftTailorError]:
    seeds = [seed_of(seed, question.key, "sample", attempt) for question in questions]
    return ask_network(writer, questions, pictures, temperature=TEMPERATURE, seeds=seeds, decoding=decoding)


def _content(given: WrittenPattern | SwiftTailorError) -> dict[str, Any]:
    if isinstance(given, SwiftTailorError):
        fault = ["decode", str(given)]
        return {"fault": fault, "fault_mended": fault, "closed": False, "paired": False, "tokens": 0}
    if given.sequence is None:
        raise InputError(
            "#Sampling is read off the tokens of what was written, and this network tells of none. "
            "Leave it out: --samples 0"
        )
    fault = first_fault(decode(given.sequence))
    mended = first_fault(given.pattern) if given.changes else fault
    content = {"fault": fault, "fault_mended": mended, "tokens": len(given.sequence)}
    if mended is None:
        content["pattern"] = to_specification(given.pattern)
    return content | asdict(validity(given.sequence))


def _count(question: Question, book: Book, drawn: int, limit: int) -> Sampled | None:
    """Judges the samples drawn so far; None where more are needed."""
    records = [r for k in range(drawn) if (r := book.get(question, k)) is not None]
    written, mended = (
        attempts_of([None if r[name] is None else tuple(r[name]) for r in records], limit)
        for name in ("fault", "fault_mended")
    )
    if written is None or mended is None:
        return None
    return Sampled(question, written, mended, records[0])

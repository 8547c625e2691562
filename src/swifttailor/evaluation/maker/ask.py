"""Asking the questions, some at a time, and keeping the answers."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeVar

from swifttailor.arrays import Pixels
from swifttailor.clock import Clock
from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.evaluation.maker.book import Book
from swifttailor.evaluation.maker.pictures import GarmentPictures
from swifttailor.evaluation.maker.questions import PICTURED, Question, seed_of
from swifttailor.evaluation.patterns.attempts import until_sound
from swifttailor.pattern import Pattern, Severity, check_pattern, read_specification, to_specification
from swifttailor.pattern_maker.maker import ChosenDecoding, PatternMaker, Request, WrittenPattern
from swifttailor.pattern_maker.temperatures import USUAL_TEMPERATURE
from swifttailor.progress import CountProgress, unwatched
from swifttailor.tailor import Order, Tailor
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.looking import SeenPicture, parts_seen
from swifttailor.tailor.order import Part, Source
from swifttailor.tailor.protocols import PatternWriter
from swifttailor.tailor.verdict import Verdict

BATCH = 16
"""Questions that are answered together."""


T = TypeVar("T")
A = TypeVar("A")
Content = dict[str, Any]
"""What is kept of an answer, as JSON values."""


@dataclass(frozen=True)
class Asking:
    """How questions are asked: as `swifttailor generate` and `edit` ask, unless told otherwise."""

    temperature: float = USUAL_TEMPERATURE
    attempts: int | None = None
    """See `Order`."""
    alter: bool = True
    """See `Order`."""
    crop: bool = True
    """See `Order`."""
    source: Source = "both"
    """See `Order`."""
    refine: int | None = None
    """See `Order`."""
    network_alone: bool = False
    """Whether the first pattern that the network writes is the answer, whatever is wrong with it: nothing is
    altered, cropped, tried to be sewn, or written again."""
    decoding: ChosenDecoding = "own"
    """Of the network alone: under the grammar, freely, or as its own method does."""
    seed: int = 0

    def order(self, question: Question, pictures: GarmentPictures | None) -> Order:
        """A question as a tailor is asked it."""
        shown = picture_of(question, pictures)
        return Order(
            question.text,
            None if shown is None else shown[1],
            question.before,
            crop=self.crop,
            seed=seed_of(self.seed, question.key, "answer"),
            temperature=self.temperature,
            attempts=self.attempts,
            refine=None if shown is None else self.refine,
            source=self.source if question.before is None and self.alter else "both",
            alter=self.alter,
        )

    def to_json(self) -> dict[str, Any]:
        """What decides the answers; of the network alone only what it is asked with."""
        decides: dict[str, Any] = {"network_alone": self.network_alone, "temperature": self.temperature}
        if self.network_alone and self.decoding != "own":
            decides["decoding"] = self.decoding
        if not self.network_alone:
            order = Order(temperature=self.temperature, attempts=self.attempts)
            decides |= {"attempts": order.most_attempts, "alter": self.alter, "crop": self.crop}
            decides |= {
                "source": self.source,
                "refine": order.most_refined,
                "of_two_garments": "the asked one",
            }
        return decides | {"seed": self.seed}


@dataclass(frozen=True, eq=False)
class KeptAnswer:
    """What was answered."""

    question: Question
    pattern: Pattern | None
    """None where there is none."""
    record: dict[str, Any]
    """As it is kept: see docs/evaluation.md."""


def ask_all(
    tailor: Tailor,
    questions: Sequence[Question],
    book: Book,
    asking: Asking,
    pictures: GarmentPictures | None = None,
    progress: CountProgress = unwatched,
) -> list[KeptAnswer]:
    """Asks what has not been answered yet.

    Questions are answered together with those beside them, always the same ones, so that being interrupted
    makes no difference: together or alone, numbers differ in their last digits.

    Args:
        tailor: Is asked.
        questions: Of any tasks.
        book: Where answers are kept.
        asking: How.
        pictures: For questions with one.
        progress: Called with the number of questions that are done.

    Raises:
        InputError: An answer cannot be written, or a picture not be read.
    """
    return keep_answers(
        questions, book, lambda some: tailor_answers(tailor, some, asking, pictures), progress=progress
    )


def keep_answers(
    questions: Sequence[Question],
    book: Book,
    answer: Callable[[Sequence[Question]], Sequence[Content | SwiftTailorError]],
    *,
    progress: CountProgress = unwatched,
) -> list[KeptAnswer]:
    """Asks anybody what has not been answered yet; see `ask_all`.

    Args:
        questions: Of any tasks.
        book: Where answers are kept.
        answer: Answers some of them, all of one task.
        progress: Called with the number of questions that are done.

    Raises:
        InputError: An answer cannot be written, or a picture not be read.
    """
    for part in batches(questions):
        if any(book.get(question) is None for question in part):
            contents = together_or_alone(part, answer)
            for question, content in zip(part, contents, strict=True):
                if isinstance(content, SwiftTailorError):
                    content = {"error": str(content)}
                book.add(question, 0, {"text": question.text} | content)
        progress(len(part))
    answers = []
    for question in questions:
        record = book.get(question)
        assert record is not None
        answers.append(KeptAnswer(question, pattern_of(record, question.id), record))
    return answers


def batches(questions: Sequence[Question]) -> Iterator[Sequence[Question]]:
    """Questions of one task that are answered together."""
    start = 0
    for k in range(1, len(questions) + 1):
        if k == len(questions) or k - start == BATCH or questions[k].task != questions[start].task:
            yield questions[start:k]
            start = k


def ask_network(
    writer: PatternWriter,
    questions: Sequence[Question],
    pictures: GarmentPictures | None,
    *,
    temperature: float,
    seeds: Sequence[int],
    decoding: ChosenDecoding = "own",
) -> Sequence[WrittenPattern | SwiftTailorError]:
    """What the network alone writes: one pattern for each question, or why what was written is none.

    Args:
        writer: Is asked.
        questions: Of any tasks.
        pictures: For questions with one; shown as they are, and of two the first.
        temperature: Of the draws.
        seeds: One for each question.
        decoding: See `Asking`; of a writer that is no `PatternMaker`, its own.

    Raises:
        SwiftTailorError: One of the questions cannot be answered.
    """
    shown = [picture_of(question, pictures) for question in questions]
    requests = [
        Request(question.text, None if picture is None else picture[1][0], question.before)
        for question, picture in zip(questions, shown, strict=True)
    ]
    if isinstance(writer, PatternMaker):
        if writer.decodes_freely(decoding):
            return writer.write_all(requests, seed=seeds, temperature=temperature, decoding="free")
    elif decoding != "own":
        raise InputError(
            f"How a {type(writer).__name__} decodes cannot be chosen. Give a PatternMaker, or no --decoding."
        )
    return writer.generate_all(requests, seed=seeds, temperature=temperature, draw=0)


def together_or_alone(
    items: Sequence[T], answer: Callable[[Sequence[T]], Sequence[A | SwiftTailorError]]
) -> list[A | SwiftTailorError]:
    """Answers to items together; where one of them has none, which shows when each is asked alone."""
    try:
        return list(answer(items))
    except SwiftTailorError as error:
        if len(items) == 1:
            return [error]
    return [one for item in items for one in together_or_alone([item], answer)]


def tailor_answers(
    tailor: Tailor, questions: Sequence[Question], asking: Asking, pictures: GarmentPictures | None
) -> list[Content | SwiftTailorError]:
    """What is kept of a tailor's answers to some questions.

    Raises:
        SwiftTailorError: One of them cannot be answered at all.
    """
    clock = Clock()
    answers: list[Answer | SwiftTailorError]
    if asking.network_alone:
        seeds = [seed_of(asking.seed, q.key, "answer") for q in questions]
        written = ask_network(
            tailor.pattern_maker,
            questions,
            pictures,
            temperature=asking.temperature,
            seeds=seeds,
            decoding=asking.decoding,
        )
        clock.add(next((one.seconds for one in written if isinstance(one, WrittenPattern)), {}))
        answers = [
            Answer(one.pattern, _verdict(one), tuple(one.changes), written=one)
            if isinstance(one, WrittenPattern)
            else one
            for one in written
        ]
    else:
        orders = [_of_its_part(tailor, asking.order(q, pictures), q) for q in questions]
        answers = tailor.write(orders, clock)
    about = {"seconds": clock.seconds, "together": len(questions)}  # of all that were answered together
    return [_content(one) | about if isinstance(one, Answer) else one for one in answers]


def _of_its_part(tailor: Tailor, order: Order, question: Question) -> Order:
    """The same order, of the garment that is asked for where a person wears two: `generate` makes both."""
    if not order.images or tailor.picture_reader is None:
        return order
    seen = tuple(tailor.look(one) for one in order.images if not isinstance(one, SeenPicture))
    part: Part = "upper" if question.facts.torso is not None else "lower"
    return replace(order, image=seen, part=part if part in parts_seen(seen) else None)


def _verdict(written: WrittenPattern) -> Verdict:
    found = check_pattern(written.pattern) if written.findings is None else written.findings
    return Verdict(tuple(found))


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


def picture_of(question: Question, pictures: GarmentPictures | None) -> tuple[str, tuple[Pixels, ...]] | None:
    """Look and pixels of the pictures that go with a question; None where it has none."""
    if question.task not in PICTURED:
        return None
    if pictures is None:
        raise InputError(f"'{question.key}' is about a picture, and there is no data set with pictures.")
    return pictures.picture(question.id)


def _content(answer: Answer) -> Content:
    from swifttailor.wording.wish_lines import wish_line

    severities = [finding.severity for finding in answer.verdict.findings]
    written = answer.written
    return {
        "pattern": to_specification(answer.pattern),
        "tokens": 0 if written is None else written.tokens,
        "log_likelihood": 0.0 if written is None else written.log_likelihood,
        "attempts": len(answer.failures) + 1,
        "until_sound": until_sound(answer.tried or [answer.pattern]),
        **({"known": answer.known} if answer.known else {}),
        **({"dropped": written.dropped} if written is not None and written.dropped else {}),
        "mended": [change.code for change in answer.changes],
        "altered": list(answer.cuts),
        "not_so": [wish_line(wish) for wish in answer.verdict.open],
        "errors": severities.count(Severity.ERROR),
        "warnings": severities.count(Severity.WARNING),
    }

"""The whole evaluation of a PatternMaker: reads, asks, draws samples, scores."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from swifttailor.data.pictures.blocks import Family
from swifttailor.errors import InputError
from swifttailor.evaluation.maker.ask import Asking, KeptAnswer, ask_all
from swifttailor.evaluation.maker.book import Book, open_books
from swifttailor.evaluation.maker.garments import Garments, GarmentSets
from swifttailor.evaluation.maker.looks import LookPictures
from swifttailor.evaluation.maker.pictures import GarmentPictures
from swifttailor.evaluation.maker.questions import (
    PICTURED,
    TASKS,
    EditSet,
    PatternSet,
    Question,
    Task,
    choose,
    edit_questions,
    generation_questions,
)
from swifttailor.evaluation.maker.sampling import SamplingSummary, sample_all, summarize_samples
from swifttailor.evaluation.maker.scores import Scored, TaskResult, score_answers, summarize_task
from swifttailor.evaluation.patterns.attempts import MAX_ATTEMPTS
from swifttailor.evaluation.pictures.visible import ShownFrom

if TYPE_CHECKING:
    from swifttailor.garment_sewer.sewer import GarmentSewer
    from swifttailor.tailor import Tailor
    from swifttailor.tailor.protocols import PatternWriter


class Counter(Protocol):
    """Something that shows how many items are done."""

    def add(self, count: int) -> None:
        """Takes note of more that are done."""
        ...


ShowProgress = Callable[[int, str], AbstractContextManager[Counter]]
"""Shows the progress of work on so many items with that name."""


@dataclass(frozen=True)
class Plan:
    """What to evaluate."""

    patterns: tuple[Path, ...]
    """Files or folders of the patterns to ask for."""
    data: Path | None = None
    """Data set with drapes of them, for pictures."""
    edits: Path | None = None
    """File of edited versions of them."""
    tasks: tuple[Task, ...] = ()
    """All that there is something for, when empty."""
    limit: int | None = None
    """Of the patterns, and of the edits."""
    asking: Asking = field(default_factory=Asking)
    look: Family | None = None
    """How the pictures look; as the renders of the data set when None."""
    view: ShownFrom = "front"
    """From where they are seen, where they have a look."""
    samples: int = MAX_ATTEMPTS
    """Attempts of #Sampling; 0 leaves it out."""

    def chosen_tasks(self) -> tuple[Task, ...]:
        """The tasks in their order.

        Raises:
            InputError: One was asked for without what it needs.
        """
        possible = {
            "text": True,
            "image": self.data is not None,
            "text+image": self.data is not None,
            "edit": self.edits is not None,
        }
        for task in self.tasks:
            if not possible[task]:
                needed = "pictures: give --data DIR" if task in PICTURED else "edits: give --edits FILE"
                raise InputError(f"The task '{task}' needs {needed}, or leave it out of --tasks.")
        return tuple(t for t in TASKS if possible[t] and (not self.tasks or t in self.tasks))


@dataclass(frozen=True, eq=False)
class Evaluation:
    """What came of it."""

    scored: Mapping[Task, list[Scored]]
    results: list[TaskResult]
    sampling: Mapping[Task, SamplingSummary]
    garments: Mapping[Task, GarmentSets]
    """Of the tasks that make garments from nothing, where they were sewn."""
    skipped: dict[str, str]
    """Patterns and edits that could not be asked for, and why."""
    pictures: GarmentPictures | None
    about: dict[str, Any]
    """Data and settings, as JSON values."""

    @property
    def complete(self) -> bool:
        """Whether everything could be asked for and was answered."""
        answers = [s.answer for scored in self.scored.values() for s in scored]
        return not self.skipped and all(a.pattern is not None for a in answers)


def evaluate(
    tailor: Tailor,
    plan: Plan,
    out: Path,
    weights: dict[str, Any],
    show: ShowProgress,
    sewer: GarmentSewer | None = None,
) -> Evaluation:
    """Runs an evaluation, or goes on with one.

    Args:
        tailor: Is asked.
        plan: What to ask.
        out: Folder that keeps the answers.
        weights: What tells the networks from others, as JSON values.
        show: Shows progress.
        sewer: Sews the answers, to be compared with the drapes of `plan.data`.

    Raises:
        InputError: Something cannot be read or written, or nothing could be asked or was answered.
    """
    tasks, seed = plan.chosen_tasks(), plan.asking.seed
    patterns = PatternSet.read(plan.patterns)
    pictures = pictures_of(plan)
    edits = None if plan.edits is None or "edit" not in tasks else EditSet.read(plan.edits, patterns)
    questions = questions_of(plan, tasks, patterns, pictures, edits, show)
    settings = {
        "weights": weights,
        **plan.asking.to_json(),
        "pictures": None if pictures is None else pictures.identity(),
    }
    with open_books(out, settings) as (answer_book, sample_book):
        answers = _ask(tailor, questions, answer_book, plan.asking, pictures, show)
        sampling = _sample(tailor.pattern_maker, questions, sample_book, plan, pictures, show)
        commits = sorted({*answer_book.commits(), *sample_book.commits()})
    with show(len(answers), "answers measured") as progress:
        scored_all = score_answers(answers, progress.add)
    asked = [task for task in tasks if any(q.task == task for q in questions)]
    scored = {t: [s for s in scored_all if s.answer.question.task == t] for t in asked}
    results = [summarize_task(task, scored[task]) for task in asked]
    garments = _sew(sewer, scored, pictures, seed, show)
    skipped = patterns.skipped | ({} if edits is None else edits.skipped)
    about = settings | {
        "patterns": [p.name for p in plan.patterns],
        "patterns_sha256": patterns.digest,
        "of": len(patterns.patterns),
        "chosen": plan.limit,
        "edits": None if plan.edits is None else plan.edits.name,
        "questions": {task: len(scored[task]) for task in asked},
        "samples": plan.samples,
        "unseen_edits": [] if edits is None else edits.unseen,
        "skipped": skipped,
        "pictures_drawn": [] if pictures is None else list(pictures.drawn),
        "answered_by_commits": commits,
    }
    return Evaluation(scored, results, sampling, garments, skipped, pictures, about)


def pictures_of(plan: Plan) -> GarmentPictures | None:
    """The pictures that go with questions; None where there is no data set.

    Raises:
        InputError: The data set is damaged.
    """
    if plan.data is None:
        return None
    if plan.look is None:
        return GarmentPictures(plan.data, plan.asking.seed)
    return LookPictures(plan.data, plan.asking.seed, plan.look, plan.view)


def _sew(
    sewer: GarmentSewer | None,
    scored: Mapping[Task, list[Scored]],
    pictures: GarmentPictures | None,
    seed: int,
    show: ShowProgress,
) -> dict[Task, GarmentSets]:
    if sewer is None:
        return {}
    if pictures is None:
        raise InputError("Garments are compared with drapes, and there is no data set: give --data DIR.")
    garments = Garments(sewer, pictures.sample, seed)
    compared = {}
    for task, answers in scored.items():
        if task != "edit":
            with show(len(answers), f"answers by {task} sewn") as progress:
                compared[task] = garments.compare(answers, progress.add)
    return {task: found for task, found in compared.items() if found is not None}


def questions_of(
    plan: Plan,
    tasks: Sequence[Task],
    patterns: PatternSet,
    pictures: GarmentPictures | None,
    edits: EditSet | None,
    show: ShowProgress,
) -> list[Question]:
    """All questions of a plan, task by task.

    Args:
        plan: What to ask.
        tasks: Those of the plan that there is something for.
        patterns: What to ask for; those that cannot be asked for are noted there.
        pictures: Those of the plan.
        edits: Those of the plan.
        show: Shows progress.

    Raises:
        InputError: There is nothing to ask.
    """
    seed = plan.asking.seed
    questions: list[Question] = []
    if any(task != "edit" for task in tasks):
        ids = choose(list(patterns.patterns), plan.limit, seed)
        with show(len(ids), "patterns measured") as progress:
            pictured = (lambda id: False) if pictures is None else pictures.__contains__
            view: ShownFrom = "free" if plan.look is None else plan.view
            questions += generation_questions(patterns, ids, tasks, pictured, seed, progress.add, view)
    if edits is not None:
        ids = choose(list(edits.versions), plan.limit, seed)
        with show(len(ids), "edits measured") as progress:
            questions += edit_questions(edits, ids, patterns, seed, progress.add)
    for task in tasks:
        if not any(q.task == task for q in questions) and task in plan.tasks:
            raise InputError(
                f"There is nothing to ask for the task '{task}': none of the patterns has what it needs."
            )
    if not questions:
        id, why = next(iter(patterns.skipped.items()))
        raise InputError(f"There is nothing to ask. The first pattern, '{id}': {why}")
    return questions


def _ask(
    tailor: Tailor,
    questions: Sequence[Question],
    book: Book,
    asking: Asking,
    pictures: GarmentPictures | None,
    show: ShowProgress,
) -> list[KeptAnswer]:
    with show(len(questions), "questions answered") as progress:
        answers = ask_all(tailor, questions, book, asking, pictures, progress.add)
    if all(a.pattern is None for a in answers):
        raise InputError(
            f"Of {len(answers)} questions none was answered. The first, '{answers[0].question.key}': "
            f"{answers[0].record.get('error')}"
        )
    return answers


def _sample(
    writer: PatternWriter,
    questions: Sequence[Question],
    book: Book,
    plan: Plan,
    pictures: GarmentPictures | None,
    show: ShowProgress,
) -> dict[Task, SamplingSummary]:
    if not plan.samples:
        return {}
    with show(len(questions), "questions sampled until a pattern is sound") as progress:
        sampled = sample_all(
            writer,
            questions,
            book,
            plan.samples,
            plan.asking.seed,
            pictures,
            progress.add,
            plan.asking.decoding,
        )
    return {
        task: summarize_samples([s for s in sampled if s.question.task == task])
        for task in dict.fromkeys(q.task for q in questions)
    }

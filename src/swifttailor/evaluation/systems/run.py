"""Every generator asked, every answer made into garments by every constructor; goes on where it stopped."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from swifttailor.errors import InputError
from swifttailor.evaluation.garments.point_cloud import PointCloud, sample_surface
from swifttailor.evaluation.garments.score import POINTS
from swifttailor.evaluation.garments.set_distances import SetDistances, set_distances
from swifttailor.evaluation.maker.ask import KeptAnswer, keep_answers
from swifttailor.evaluation.maker.book import open_books
from swifttailor.evaluation.maker.pictures import GarmentPictures
from swifttailor.evaluation.maker.questions import PatternSet, Question, Task, seed_of
from swifttailor.evaluation.maker.run import Plan, ShowProgress, pictures_of, questions_of
from swifttailor.evaluation.maker.scores import TaskResult, score_answers, summarize_task
from swifttailor.evaluation.mean import Mean, mean_of
from swifttailor.evaluation.systems.constructor import Constructor
from swifttailor.evaluation.systems.generator import GENERATIVE, Generator
from swifttailor.evaluation.systems.made_garments import MadeGarment, make_garments

PREFIX = "garments-"
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_+-]{0,39}")


@dataclass(frozen=True)
class Cell:
    """One generator with one constructor, for one task."""

    task: Task
    generator: str
    constructor: str
    asked: int
    made: int
    """Garments; the others failed somewhere."""
    sound: int
    accepted: int | None
    """Garments within the limits of quality of drapes; None where they did not come to rest by physics."""
    compared: int
    """Patterns asked for that have a drape: what follows is of their answers."""
    chamfer: Mean | None
    """cm^2, over the garments that were made: to the drape of the pattern that was asked for."""
    emd: Mean | None
    """cm, likewise."""
    sets: SetDistances | None
    """cm^2; None where there is no garment."""
    seconds: Mapping[str, float]
    """Mean of a garment, by stage."""
    mebibytes: int | None
    """Most memory of the process while garments were made now; None where they were there already."""
    failures: Mapping[str, str]
    """Ids of the patterns asked for that gave no garment, and why."""


@dataclass(frozen=True, eq=False)
class SystemsResult:
    """All cells, and what the generators answered."""

    answers: Mapping[str, Sequence[TaskResult]]
    """By generator; the row named ``PatternMaker`` is the generator's."""
    cells: Sequence[Cell]
    floors: Mapping[Task, SetDistances]
    """The drapes, their points drawn again: what chance alone makes of a perfect set."""
    skipped: Mapping[str, str]
    """Patterns that could not be asked for, and why."""
    about: Mapping[str, Any]
    """Data and settings, as JSON values."""


def run_systems(
    generators: Sequence[Generator],
    constructors: Sequence[Constructor],
    plan: Plan,
    out: Path,
    show: ShowProgress,
) -> SystemsResult:
    """Fills every cell of the table, or goes on with one that was begun.

    Args:
        generators: Rows.
        constructors: Rows within each.
        plan: What to ask. Without drapes in its data set no garments are made.
        out: Folder that keeps a folder for each generator: its answers, and its garments by constructor.
        show: Shows progress.

    Raises:
        InputError: Something cannot be read or written, or nothing could be asked.
    """
    _require_names([g.name for g in generators])
    _require_names([c.name for c in constructors])
    if "edit" in plan.tasks:
        raise InputError("Systems are compared by what they generate: --tasks text, image, text+image.")
    if constructors and plan.data is None:
        raise InputError(
            "Garments are compared with the drapes of the patterns that are asked for: give the data set "
            "that has them, --data DIR, or no --sewers."
        )
    tasks = tuple(t for t in plan.chosen_tasks() if t in GENERATIVE)
    patterns, pictures = PatternSet.read(plan.patterns), pictures_of(plan)
    references = _References(pictures, plan.asking.seed) if constructors and pictures is not None else None
    if pictures is not None and references is not None:
        _require_drapes(patterns, pictures)
    questions = questions_of(plan, tasks, patterns, pictures, None, show)
    asked = [task for task in tasks if any(q.task == task for q in questions)]
    results: dict[str, list[TaskResult]] = {}
    cells: list[Cell] = []
    for generator in generators:
        answers = _answers(generator, questions, pictures, out, show)
        scored = score_answers(answers)
        results[generator.name] = [
            summarize_task(t, [s for s in scored if s.answer.question.task == t]) for t in asked
        ]
        if references is not None:
            for constructor in constructors:
                cells += _cells(generator.name, constructor, answers, asked, references, plan, out, show)
    floors = {}
    if references is not None:
        for task in asked:
            ids = [q.id for q in questions if q.task == task]
            drapes = [drape for id in ids if (drape := references[id]) is not None]
            floors[task] = set_distances([references.again(id) for id in ids if id in references], drapes)
    about = {
        "patterns": [p.name for p in plan.patterns],
        "patterns_sha256": patterns.digest,
        "of": len(patterns.patterns),
        "chosen": plan.limit,
        "questions": {task: sum(q.task == task for q in questions) for task in asked},
        "seed": plan.asking.seed,
        "look": plan.look,
        "view": plan.view if plan.look is not None else None,
        "pictures": None if pictures is None else pictures.identity(),
        "generators": {g.name: g.identity() for g in generators},
        "constructors": {c.name: c.identity() for c in constructors},
    }
    return SystemsResult(results, cells, floors, dict(patterns.skipped), about)


def _require_names(names: Sequence[str]) -> None:
    """Refuses names that cannot be those of folders, or that occur twice.

    Raises:
        InputError: One of them cannot be used.
    """
    for k, name in enumerate(names):
        if not _NAME.fullmatch(name):
            raise InputError(
                f"{name!r} cannot name a system: letters, digits, '-', '_' and '+' are accepted, 40 at most."
            )
        if name in names[:k]:
            raise InputError(f"There are two systems of the name '{name}'. Give each a name of its own.")


def _require_drapes(patterns: PatternSet, pictures: GarmentPictures) -> None:
    """Garments are compared with drapes; those of patterns without one are made and judged, and not compared.

    Raises:
        InputError: There is none at all.
    """
    if not any(id in pictures for id in patterns.patterns):
        raise InputError("None of the patterns has a drape in the data set, so there is nothing to compare.")


def _answers(
    generator: Generator,
    questions: Sequence[Question],
    pictures: GarmentPictures | None,
    out: Path,
    show: ShowProgress,
) -> list[KeptAnswer]:
    identity = None if pictures is None else pictures.identity()
    settings = {"generator": generator.identity(), "pictures": identity}
    with (
        open_books(out / generator.name, settings) as (book, _),
        show(len(questions), f"questions answered by {generator.name}") as progress,
    ):
        return keep_answers(
            questions, book, lambda some: generator.answer(some, pictures), progress=progress.add
        )


def _cells(
    name: str,
    constructor: Constructor,
    answers: Sequence[KeptAnswer],
    tasks: Sequence[Task],
    references: _References,
    plan: Plan,
    out: Path,
    show: ShowProgress,
) -> list[Cell]:
    cells = []
    folder = out / name / f"{PREFIX}{constructor.name}"
    for task in tasks:
        some = [a for a in answers if a.question.task == task]
        clouds = [references[a.question.id] for a in some]
        with show(len(some), f"answers of {name} ({task}) made by {constructor.name}") as progress:
            made, memory = make_garments(
                constructor, some, clouds, folder, seed=plan.asking.seed, progress=progress.add
            )
        cells.append(_cell(task, name, constructor.name, made, clouds, memory))
    return cells


def _cell(
    task: Task,
    generator: str,
    constructor: str,
    garments: Sequence[MadeGarment],
    references: Sequence[PointCloud | None],
    memory: int | None,
) -> Cell:
    made = [g for g in garments if g.points is not None]
    compared = [(g.points, r) for g, r in zip(garments, references, strict=True) if r is not None]
    some_made = any(points is not None for points, _ in compared)
    judged = [g.accepted for g in made if g.accepted is not None]
    stages = dict.fromkeys(stage for g in made for stage in g.seconds)
    return Cell(
        task,
        generator,
        constructor,
        asked=len(garments),
        made=len(made),
        sound=sum(g.sound for g in made),
        accepted=sum(judged) if judged else None,
        compared=len(compared),
        chamfer=mean_of(g.chamfer_cm2 for g in made),
        emd=mean_of(g.emd_cm for g in made),
        sets=set_distances([p for p, _ in compared], [r for _, r in compared]) if some_made else None,
        seconds={s: sum(g.seconds.get(s, 0.0) for g in made) / len(made) for s in stages},
        mebibytes=memory,
        failures={g.id: g.error for g in garments if g.points is None},
    )


class _References:
    """Points of the drapes of the patterns that are asked for."""

    def __init__(self, pictures: GarmentPictures, seed: int) -> None:
        self._find, self._seed = pictures.sample, seed
        self._known: dict[str, PointCloud | None] = {}

    def __contains__(self, id: str) -> bool:
        return self[id] is not None

    def __getitem__(self, id: str) -> PointCloud | None:
        """None where the pattern has no drape."""
        if id not in self._known:
            self._known[id] = None if self._find(id) is None else self._draw(id, 1)
        return self._known[id]

    def again(self, id: str) -> PointCloud:
        return self._draw(id, 2)

    def _draw(self, id: str, draw: int) -> PointCloud:
        sample = self._find(id)
        assert sample is not None, "only what has a drape is drawn"
        garment, seed = sample.garment, seed_of(self._seed, id, f"drape {draw}")
        return sample_surface(garment.vertices, garment.faces, POINTS, seed)

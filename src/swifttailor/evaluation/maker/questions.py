"""What a PatternMaker is asked and should answer; pattern, task and seed determine a question."""

from __future__ import annotations

import hashlib
import zlib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Literal, get_args

import numpy as np

from swifttailor.data.edits.edit_file import read_edits
from swifttailor.data.edits.pairs import is_reversed, pairs_of
from swifttailor.data.pattern_source import parsed_pattern, patterns_of
from swifttailor.describing import Claim, GarmentFacts, measure_facts
from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.evaluation.pictures.visible import ShownFrom, can_be_seen
from swifttailor.pattern import Pattern
from swifttailor.pattern.digest import pattern_digest
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.progress import CountProgress, unwatched
from swifttailor.wording.captions import write_caption
from swifttailor.wording.instructions.writer import Instruction

Task = Literal["text", "image", "text+image", "edit"]
TASKS: tuple[Task, ...] = get_args(Task)
PICTURED: tuple[Task, ...] = ("image", "text+image")
BACK = ", back"
"""At the end of the id of an edit that leads back to the pattern that was edited."""
_SEEDS = 2**31


@dataclass(frozen=True, eq=False)
class Question:
    """One thing to ask."""

    task: Task
    id: str
    """Of the pattern, or of the edit."""
    truth: Pattern
    facts: GarmentFacts
    """Of the truth."""
    text: str = ""
    """Caption or instruction; empty where the picture says all."""
    claims: tuple[Claim, ...] = ()
    """What the caption says; of a question without words what the caption would have said."""
    before: Pattern | None = None
    """What is to be edited."""
    before_facts: GarmentFacts | None = None
    instruction: Instruction | None = None

    @property
    def key(self) -> str:
        """Names it among all questions."""
        return f"{self.task}/{self.id}"

    @cached_property
    def fingerprint(self) -> str:
        """Changes with all that is asked and that should be answered, but for the picture."""
        before = "" if self.before is None else pattern_digest(self.before)
        parts = [self.key, self.text, pattern_digest(self.truth), before]
        return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16]


@dataclass
class PatternSet:
    """Patterns to ask for."""

    patterns: dict[str, Pattern] = field(default_factory=dict)
    """By id, in the order of their files; in canonical order, as networks write them."""
    skipped: dict[str, str] = field(default_factory=dict)
    """Why others cannot be used, by id."""

    @staticmethod
    def read(sources: Iterable[Path]) -> PatternSet:
        """Reads the patterns of files, folders or data sets (`data.pattern_source`).

        Raises:
            InputError: There is no such source, or no pattern in it that can be read.
        """
        found = PatternSet()
        for source in sources:
            for id, pattern in patterns_of(source):
                if isinstance(pattern, SwiftTailorError):
                    found.skipped[id] = str(pattern)
                elif id in found.patterns:
                    found.skipped[f"{id} in {source.name}"] = "The id was used before; ids must differ."
                else:
                    found.patterns[id] = pattern.canonical()
        if not found.patterns:
            first = next(iter(found.skipped.items()), None)
            why = f" The first, '{first[0]}': {first[1]}" if first else ""
            raise InputError(f"There is no pattern to ask for; {len(found.skipped)} cannot be used.{why}")
        return found

    @property
    def digest(self) -> str:
        """Of all ids and patterns."""
        lines = [f"{id} {pattern_digest(p)}" for id, p in self.patterns.items()]
        return hashlib.sha256("\n".join(lines).encode()).hexdigest()


def choose(ids: Sequence[str], limit: int | None, seed: int) -> list[str]:
    """All ids in an order drawn by lot, or the first `limit`: a larger limit keeps those of a smaller."""
    order = np.random.default_rng([seed, 11]).permutation(len(ids))
    return [ids[int(k)] for k in order[:limit]]


def seed_of(seed: int, *names: str | int) -> int:
    """A seed for one thing of many, the same whatever else there is."""
    return zlib.crc32(" ".join(map(str, (seed, *names))).encode()) % _SEEDS


def generation_questions(
    patterns: PatternSet,
    ids: Sequence[str],
    tasks: Sequence[Task],
    pictured: Callable[[str], bool],
    seed: int,
    progress: CountProgress = unwatched,
    view: ShownFrom = "free",
) -> list[Question]:
    """Asks for patterns by text, by picture and by both.

    A pattern that cannot be measured, and so not be written about, is noted in `patterns.skipped`.

    Args:
        patterns: Where they are.
        ids: Of those to ask for.
        tasks: Those of editing are left out.
        pictured: Whether there is a picture of the pattern of an id.
        seed: Of the captions.
        progress: Called with 1 after each pattern.
        view: From where pictures show garments; a picture alone is asked for what can be seen.

    Returns:
        The questions of the first task, then those of the next.
    """
    by_task: dict[Task, list[Question]] = {task: [] for task in tasks if task != "edit"}
    for id in ids:
        truth = patterns.patterns[id]
        try:
            facts = measure_facts(truth)
        except SwiftTailorError as error:
            patterns.skipped[id] = f"It cannot be measured: {error}"
        else:
            caption = write_caption(facts, seed_of(seed, id))
            for task, questions in by_task.items():
                if task == "text" or pictured(id):
                    text = "" if task == "image" else caption.text
                    claims = caption.claims if text else _seen(caption.claims, view)
                    questions.append(Question(task, id, truth, facts, text, claims))
        progress(1)
    return [question for questions in by_task.values() for question in questions]


def _seen(claims: Sequence[Claim], view: ShownFrom) -> tuple[Claim, ...]:
    return tuple(claim for claim in claims if can_be_seen(claim, view))


@dataclass
class EditSet:
    """Edited versions of patterns."""

    versions: dict[str, tuple[str, Pattern]] = field(default_factory=dict)
    """Id of the base and edited pattern, in canonical order, by id of the edit."""
    skipped: dict[str, str] = field(default_factory=dict)
    """Why others cannot be used, by id."""
    unseen: list[str] = field(default_factory=list)
    """Ids of those that change nothing that there are words for, once they were to be asked for."""

    @staticmethod
    def read(source: Path, patterns: PatternSet) -> EditSet:
        """Reads those edits whose bases are among some patterns.

        Raises:
            InputError: There is no such file, or none of its edits is of these patterns.
        """
        found = EditSet()
        others = 0
        for version in read_edits(source):
            id = version.pattern.id
            if version.base and version.base not in patterns.patterns:
                others += 1
                continue
            pattern = parsed_pattern(version.pattern)
            if isinstance(pattern, SwiftTailorError):
                found.skipped[id] = str(pattern)
            else:
                found.versions[id] = version.base, pattern.canonical()
        if not found.versions:
            raise InputError(
                f"'{source}' has no edit that can be used: {others} are of other patterns than those of "
                f"--patterns, {len(found.skipped)} cannot be read."
            )
        return found


def edit_questions(
    edits: EditSet, ids: Sequence[str], patterns: PatternSet, seed: int, progress: CountProgress = unwatched
) -> list[Question]:
    """Asks for edits, there and back.

    An edit of which nothing is seen is noted in `edits.unseen`; one with a pattern that cannot be measured or
    that the network cannot be shown in `edits.skipped`.

    Args:
        edits: Where they are.
        ids: Of those to ask for.
        patterns: Their bases.
        seed: Of the instructions.
        progress: Called with 1 after each edit.
    """
    questions = []
    for id in ids:
        try:
            questions += _both_ways(id, edits, patterns, seed)
        except SwiftTailorError as error:
            edits.skipped[id] = str(error)
        progress(1)
    return questions


def _both_ways(id: str, edits: EditSet, patterns: PatternSet, seed: int) -> list[Question]:
    base_id, edited = edits.versions[id]
    base = patterns.patterns[base_id]
    facts = measure_facts(base), measure_facts(edited)
    for pattern in (base, edited):
        encode(pattern)  # what the network is shown
    pairs = pairs_of(base, edited, seed_of(seed, id), facts=facts)
    if not pairs:
        edits.unseen.append(id)
    questions = []
    for pair in pairs:
        back = is_reversed(pair.source)
        was, now = facts[::-1] if back else facts
        questions.append(
            Question(
                "edit",
                f"{id}{BACK if back else ''}",
                pair.edited,
                now,
                pair.instruction.text,
                before=pair.base,
                before_facts=was,
                instruction=pair.instruction,
            )
        )
    return questions

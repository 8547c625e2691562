"""The patterns of a training in memory: as tokens, with their facts and the versions that edits lead to."""

from __future__ import annotations

import contextlib
import hashlib
import json
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from swifttailor.data.edits.edit_file import EditedVersion, read_edits
from swifttailor.data.pattern_source import patterns_of
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.facts_file import facts_from
from swifttailor.errors import InputError, SimulationError, SwiftTailorError
from swifttailor.pattern.pattern_list import read_patterns
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.training.maker_measure import MeasureTask, measure, task_name

PATTERNS_A_FILE = 32
_TIME_LIMIT = 3600.0

Report = Callable[[str], None]


@dataclass(frozen=True, eq=False)
class Version:
    """A pattern as tokens, and what it shows of the garment."""

    id: str
    sequence: TokenSequence
    _facts: dict[str, Any]

    @cached_property
    def facts(self) -> GarmentFacts:
        """For captions and instructions."""
        return facts_from(self._facts)


@dataclass(frozen=True, eq=False)
class Garment:
    """A pattern to learn from, and edited versions of it."""

    pattern: Version
    edits: list[Version] = field(default_factory=list)

    @property
    def id(self) -> str:
        """Of the pattern."""
        return self.pattern.id


@dataclass(frozen=True, eq=False)
class PatternBank:
    """The garments of a training or a validation."""

    garments: tuple[Garment, ...]
    checksum: str
    """Of patterns and edits, as they were measured."""
    skipped: tuple[tuple[str, str], ...]
    """Ids of patterns that were left out, and why."""

    def __len__(self) -> int:
        return len(self.garments)

    def sequences(self) -> Iterator[TokenSequence]:
        """Of all patterns; not of their edits."""
        return (garment.pattern.sequence for garment in self.garments)

    def without(self, sequences: Iterable[TokenSequence]) -> PatternBank:
        """The same but for patterns and edits that are equal to some.

        Raises:
            InputError: None is left.
        """
        apart = set(sequences)
        kept, skipped = [], list(self.skipped)
        for garment in self.garments:
            if garment.pattern.sequence in apart:
                skipped.append((garment.id, "It is equal to a pattern to validate or test with."))
                continue
            edits = [version for version in garment.edits if version.sequence not in apart]
            kept.append(Garment(garment.pattern, edits))
        if not kept:
            raise InputError("All patterns to train on are equal to patterns to validate or test with.")
        return PatternBank(tuple(kept), self.checksum, tuple(skipped))

    def numbers(self) -> dict[str, Any]:
        """For the card."""
        edits = sum(len(g.edits) for g in self.garments)
        return {
            "garments": len(self),
            "edits": edits,
            "skipped": len(self.skipped),
            "sha256": self.checksum,
        }


def sequences_of(sources: Iterable[Path]) -> Iterator[TokenSequence]:
    """The patterns of files or folders as tokens; those that tokens cannot say are passed over.

    Raises:
        InputError: There is no such source.
    """
    for source in sources:
        for _, pattern in patterns_of(source):
            if not isinstance(pattern, SwiftTailorError):
                with contextlib.suppress(SwiftTailorError):
                    yield encode(pattern)


def open_bank(
    patterns: Iterable[Path],
    edits: Path | None,
    cache: Path,
    *,
    recuts: int,
    workers: int = 1,
    keep: Callable[[str], bool] | None = None,
    report: Report | None = None,
) -> PatternBank:
    """Measures patterns, or reads what was measured before.

    Args:
        patterns: Files (.jsonl, .jsonl.gz) or folders.
        edits: File with edited versions of some of them; see `read_edits`.
        cache: Folder for what is measured: about 15 kB a pattern.
        recuts: Versions to make of each pattern for editing.
        workers: Processes.
        keep: Whether to use the pattern of an id; all when None.
        report: Called with lines to show.

    Raises:
        InputError: A file cannot be read or written, or there is no pattern that can be used.
        SimulationError: A worker died.
    """
    given = [EditedVersion("", p) for p in read_patterns(*patterns) if keep is None or keep(p.id)]
    known = {p.pattern.id for p in given}
    edited = [] if edits is None else [v for v in read_edits(edits) if v.pattern.error or v.base in known]
    tasks = [*_tasks(given, recuts, cache), *_tasks(edited, 0, cache)]
    _measure_missing(tasks, workers, report)
    garments: dict[str, Garment] = {}
    skipped = [(v.pattern.id, v.pattern.error) for v in (*given, *edited) if v.pattern.error]
    digest = hashlib.sha256()
    for task in tasks:
        digest.update(task.path.name.encode())
        versions, left_out = _read(task.path)
        skipped += left_out
        for base, version in versions:
            if not base:
                garments[version.id] = Garment(version)
            elif base in garments:
                garments[base].edits.append(version)
    if not garments:
        why = f" The first: '{skipped[0][0]}': {skipped[0][1]}" if skipped else ""
        raise InputError(f"There is no pattern to learn from; {len(skipped)} cannot be used.{why}")
    return PatternBank(tuple(garments.values()), digest.hexdigest(), tuple(skipped))


def _tasks(patterns: list[EditedVersion], recuts: int, cache: Path) -> Iterator[MeasureTask]:
    usable = [p for p in patterns if not p.pattern.error]
    for start in range(0, len(usable), PATTERNS_A_FILE):
        part = tuple(usable[start : start + PATTERNS_A_FILE])
        yield MeasureTask(part, recuts, cache / task_name(part, recuts))


def _measure_missing(tasks: list[MeasureTask], workers: int, report: Report | None) -> None:
    from swifttailor.workers import run_tasks

    missing = [task for task in tasks if not task.path.is_file()]
    if not missing:
        return
    here: Iterable[str] = (measure(task) for task in missing)
    if workers > 1:
        outcomes = run_tasks(measure, missing, workers=workers, time_limit=_TIME_LIMIT)
        here = (o.lost or o.result for o in outcomes)
    for done, trouble in enumerate(here, 1):
        if trouble:
            raise (InputError if trouble.startswith("Cannot") else SimulationError)(trouble)
        if report is not None and (done % 8 == 0 or done == len(missing)):
            report(f"measuring patterns: {done} of {len(missing)} files")


def _read(path: Path) -> tuple[list[tuple[str, Version]], list[tuple[str, str]]]:
    from safetensors import SafetensorError
    from safetensors.numpy import load_file

    try:
        arrays = load_file(path)
        about = json.loads(arrays["about"].tobytes())
        versions, start = [], 0
        for each in about["versions"]:
            end = start + each["length"]
            sequence = TokenSequence(arrays["tokens"][start:end], arrays["numbers"][start:end])
            versions.append((each["base"], Version(each["id"], sequence, each["facts"])))
            start = end
        return versions, [(id, why) for id, why in about["skipped"]]
    except (
        SafetensorError,
        OSError,
        ValueError,
        KeyError,
        TypeError,
        AttributeError,
        RecursionError,
    ) as error:
        raise InputError(f"'{path}' is damaged: {error}. Delete it, it is made again.") from error

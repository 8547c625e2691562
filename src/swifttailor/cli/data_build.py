"""``swifttailor data build``: patterns to shards of drapes."""

from __future__ import annotations

import sys
from collections import Counter
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from swifttailor.cli.option_checks import (
    require_edge_length,
    require_limit,
    require_seed,
    require_time_limit,
    worker_count,
)
from swifttailor.cli.postponed_imports import tyro
from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.data.builder.run import Runner
    from swifttailor.data.index import SplitIndex

SOME_FAILED = 1


@dataclass(frozen=True, kw_only=True)
class DataBuild:
    """Drape patterns, keep those within the limits of quality, and put them into shards.

    Writes a folder for the split into DIR: index.json, shard-00000-....safetensors, and results.jsonl with a
    line for every pattern. Stopped at any moment and started again, it resumes where it stopped. The shards
    are the same, byte for byte, however often that happens and however many workers there are.

    Exit code 0: done; 1: done, but some patterns crashed or took too long (--retry-failed tries them again);
    2: not done.
    """

    patterns: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE")]
    """Files (.jsonl, .jsonl.gz) with one {"id": ..., "pattern": ...} a line, or folders of .json files."""
    out: Annotated[Path, tyro.conf.arg(metavar="DIR")] = Path("dataset")
    """Folder of the data set; created when missing."""
    split: Annotated[str | None, tyro.conf.arg(metavar="NAME")] = None
    """Name of the split (train, validation, test). Default: the first file's name."""
    workers: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Patterns draped at the same time on this machine. Default: one per CPU core."""
    ray: Annotated[str | None, tyro.conf.arg(metavar="ADDRESS")] = None
    """Drape on a Ray cluster instead (package 'ray'): auto, HOST:PORT, or local."""
    limit: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Only the first N patterns. More can follow later."""
    fabric: str = "cotton"
    """By name; swifttailor fabrics shows all."""
    edge_length: float = 2.0
    """Edge length of the cloth's triangles in cm, 0.5 to 10."""
    engine: Literal["xpbd", "newton", "network"] = "xpbd"
    """The built-in solver, Newton (package 'newton') for the last stage, or GarmentSewer instead of a drape:
    thirty times as fast, good for pictures of garments, not to train GarmentSewer on."""
    sewer_weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """With --engine network: GarmentSewer's model file. Default: the one in the package."""
    seed: int = 0
    """0 gives the same drapes every time; others shift the start by a hundredth of a millimetre."""
    rotation: Literal["intrinsic", "extrinsic"] = "intrinsic"
    """How to read the placement angles: as GarmentCode's generator writes them (intrinsic), or as its
    simulator and older files do (extrinsic)."""
    repair: tyro.conf.FlagCreatePairsOff[bool] = False
    """Repair patterns first, as swifttailor check --repair does."""
    time_limit: Annotated[float, tyro.conf.arg(metavar="SECONDS")] = 600.0
    """Give up on a pattern after this long."""
    largest: Annotated[int | None, tyro.conf.arg(metavar="VERTICES")] = None
    """Leave patterns with more vertices for a later run with --retry-failed: the largest three of a hundred
    take a quarter of the time."""
    retry_failed: tyro.conf.FlagCreatePairsOff[bool] = False
    """Retry what crashed, took too long or was left for later."""

    def run(self) -> int:
        """Builds, says what came of it, and returns the exit code.

        Raises:
            SwiftTailorError: Something is not usable; what was built so far is kept.
        """
        self._validate()
        from swifttailor.cli.data_progress import BuildProgress
        from swifttailor.data.builder import BuildSettings, build_split
        from swifttailor.data.builder.make_sample import make_sample
        from swifttailor.data.builder.sew_sample import network_of, sew_sample
        from swifttailor.draping.batch import BatchSettings
        from swifttailor.pattern.pattern_list import count_patterns, read_patterns

        drape = BatchSettings(
            fabric=self.fabric,
            edge_length=self.edge_length,
            engine="xpbd" if self.engine == "network" else self.engine,
            seed=self.seed,
            rotation=self.rotation,
            repair=self.repair,
            preview=False,
        )
        by_network = self.engine == "network"
        total = sum(count_patterns(p) for p in self.patterns)
        with BuildProgress(min(total, self.limit or total)) as progress:
            index = build_split(
                read_patterns(*self.patterns),
                self.out,
                self._split(),
                BuildSettings(drape, network=network_of(self.sewer_weights) if by_network else ""),
                runner=self._runner(),
                limit=self.limit,
                retry_failed=self.retry_failed,
                on_start=progress.start,
                on_record=progress.show,
                make=partial(sew_sample, weights=self.sewer_weights)
                if by_network
                else partial(make_sample, largest=self.largest),
            )
        return finish_build(index, self.out / index.split)

    def _split(self) -> str:
        name = self.split if self.split is not None else self.patterns[0].name.split(".")[0]
        if not (name and name.isprintable() and not name.startswith(".") and not set(name) & set("/\\:")):
            raise InputError(
                f"The split's name {name!r} cannot be that of a folder. Give another: --split train"
            )
        return name

    def _runner(self) -> Runner:
        if self.ray is not None:
            from swifttailor.data.builder.run import ATTEMPTS
            from swifttailor.workers.ray_pool import require_ray, run_tasks_on_ray

            require_ray()
            return partial(run_tasks_on_ray, address=self.ray, time_limit=self.time_limit, attempts=ATTEMPTS)
        from swifttailor.data.builder.run import ATTEMPTS
        from swifttailor.draping.compiled_code import solver_is_compiled
        from swifttailor.workers import run_tasks

        return partial(
            run_tasks,
            workers=worker_count(self.workers),
            time_limit=self.time_limit,
            first_alone=not solver_is_compiled(),
            attempts=ATTEMPTS,
        )

    def _validate(self) -> None:
        """Refuses what cannot work before anything is loaded."""
        if not self.patterns:
            raise InputError("No patterns were given. Give at least one file: --patterns FILE")
        self._split()
        if self.sewer_weights is not None and self.engine != "network":
            raise InputError(f"--sewer-weights goes with --engine network; the engine is {self.engine}.")
        if self.largest is not None and (self.engine == "network" or self.largest < 1):
            raise InputError(
                f"--largest is {self.largest} with --engine {self.engine}; at least 1 vertex, and an engine "
                "that drapes, are accepted."
            )
        if self.ray is not None and self.workers is not None:
            raise InputError("--workers and --ray exclude each other: a Ray cluster uses all of its cores.")
        require_edge_length(self.edge_length)
        require_seed(self.seed)
        worker_count(self.workers)
        require_limit(self.limit)
        require_time_limit(self.time_limit)


def finish_build(index: SplitIndex, folder: Path) -> int:
    """Prints what came of a build and gives the exit code."""
    from swifttailor.draping.batch.summary import kind_of_reason

    rejected = [r for s in index.shards for r in s.rejected]
    accepted = sum(len(s.ids) for s in index.shards)
    failed = sum(r.status == "failed" for r in rejected)
    size = sum(s.bytes for s in index.shards)
    lines = [
        f"{index.patterns} patterns: {accepted} accepted, {len(rejected) - failed} rejected, "
        f"{failed} failed.",
    ]
    reasons = Counter(kind_of_reason(reason) for r in rejected for reason in r.reasons)
    lines += [f"  {count:5}  {reason}" for reason, count in reasons.most_common(12)]
    if accepted:
        lines.append(
            f"{size / 1e6:.1f} MB in {len(index.shards)} shards, {size / accepted / 1e3:.1f} KB a sample."
        )
    lines.append(f"The split '{index.split}' is in {folder}")
    sys.stdout.write("\n".join(lines) + "\n")
    return SOME_FAILED if failed else 0

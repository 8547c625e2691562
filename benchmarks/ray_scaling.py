"""How building data, sewing and evaluating go faster with more Ray workers on one machine.

``python benchmarks/ray_scaling.py PATTERNS.jsonl.gz DATA/SPLIT [--workers 1 2 4 8] [--count 48]``

draping
    a pattern of the file becomes a sample of a data set by physics (`data build`), at 3 cm
sewing
    a pattern becomes a mesh in memory by GarmentSewer (`data build --engine network`), at 2 cm
evaluating
    a pattern of the split is sewn and compared with its drape (`evaluate garment-sewer`): CD, EMD, ...

Each worker is a process with one thread, as on a cluster. The clock runs from the moment when every worker
has handed back its first garment: what starting takes is listed beside it. Efficiency is the speed of a
worker beside that of one alone; more workers than cores cannot be faster than the cores are.
Needs the extra `cluster`, and a machine that does nothing else.
"""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

from machine import describe
from ray_jobs import evaluate_one
from swifttailor.data.builder.make_sample import SampleTask, make_sample
from swifttailor.data.builder.sew_sample import sew_sample
from swifttailor.data.reader import SplitReader
from swifttailor.draping.batch import BatchSettings
from swifttailor.pattern.pattern_list import read_patterns
from swifttailor.workers.ray_pool import run_tasks_on_ray

TIME_LIMIT = 600.0


@dataclass(frozen=True)
class Speed:
    """Of one job with some workers."""

    starting: float
    """Seconds until every worker has handed back a garment."""
    per_minute: float
    """Garments after that."""


def measure(function: Callable[[Any], Any], tasks: list[Any], workers: int) -> Speed:
    """Runs all tasks on a cluster of this machine with some workers."""
    import ray

    surroundings = {
        "PYTHONPATH": os.pathsep.join([str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")])
    }
    ray.init(
        num_cpus=workers, include_dashboard=False, log_to_driver=False, runtime_env={"env_vars": surroundings}
    )
    try:
        started, times = time.perf_counter(), []
        for outcome in run_tasks_on_ray(function, tasks, address="local", time_limit=TIME_LIMIT):
            if outcome.lost:
                raise RuntimeError(f"a task was lost: {outcome.lost}")
            times.append(time.perf_counter() - started)
    finally:
        ray.shutdown()
    first = times[workers - 1]
    return Speed(first, 60 * (len(times) - workers) / (times[-1] - first))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("patterns", type=Path)
    parser.add_argument("split", type=Path)
    parser.add_argument("--workers", type=int, nargs="+", default=[1, 2, 4, 8])
    parser.add_argument("--count", type=int, default=48, help="garments of each job; more than workers")
    options = parser.parse_args()
    patterns = list(read_patterns(options.patterns))[: options.count]
    jobs: list[tuple[str, Callable[[Any], Any], list[Any]]] = []
    for name, function, edge in (("draping", make_sample, 3.0), ("sewing", sew_sample, 2.0)):
        settings = BatchSettings(edge_length=edge, preview=False)
        tasks = [SampleTask(k, "", pattern, settings) for k, pattern in enumerate(patterns)]
        jobs.append((name, function, tasks))
    count = min(options.count, len(SplitReader(options.split)))
    jobs.append(("evaluating", evaluate_one, [(options.split.resolve(), k) for k in range(count)]))
    print(describe(), f"Ray {version('ray')}", sep=", ")
    print(f"| {'':<12}| workers | garments a minute | times one worker | efficiency | until all have begun |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    for name, function, tasks in jobs:
        alone = None
        for workers in options.workers:
            speed = measure(function, tasks, workers)
            alone = alone or speed.per_minute / workers
            times = speed.per_minute / alone
            print(
                f"| {name:<12}| {workers} | {speed.per_minute:.1f} | {times:.2f} | {times / workers:.0%} "
                f"| {speed.starting:.1f} s |",
                flush=True,
            )


if __name__ == "__main__":
    main()

"""How long it takes from a prompt to a pattern and its garment, on one processor core.

``OMP_NUM_THREADS=1 python benchmarks/generate_speed.py [--maker-weights FILE] [--sewer-weights FILE]``

Three numbers, and what they are made of:

warm
    Both networks open, prompts of benchmarks/prompts.txt one after the other: prompt -> pattern -> garment
    mesh in memory, nothing written. Median over the prompts, of each the least of --repeat runs; seconds on
    the clock by stage, and processor seconds of the whole.
cold
    ``swifttailor generate`` in a new process, until its files are written, with and without the preview:
    median and least of --cold runs.
memory
    The most that the warm process and a cold one held (resident set).

The process keeps itself to one core. Other programs at work on the machine make the clock's seconds longer;
processor seconds less so.
"""

from __future__ import annotations

import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import swifttailor
from generate_prompts import PROMPTS, read_prompts
from machine import describe

MIB = 1024.0


@dataclass(frozen=True)
class Run:
    """One garment."""

    stages: dict[str, float]
    wall: float
    processor: float
    tokens: int
    attempts: int


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--maker-weights", type=Path)
    parser.add_argument("--sewer-weights", type=Path)
    parser.add_argument("--prompts", type=int, default=12, help="how many, evenly from all styles")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--cold", type=int, default=3)
    parser.add_argument("--temperature", type=float, default=0.5)
    options = parser.parse_args()
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    print(describe())
    prompts = [p.text for p in read_prompts(PROMPTS)]
    prompts = prompts[:: max(1, len(prompts) // options.prompts)][: options.prompts]
    warm(options, prompts)
    for more in ([], ["--no-preview"]):
        cold(options, prompts[0], more)


def warm(options: argparse.Namespace, prompts: list[str]) -> None:
    """Prompt to mesh in memory."""
    tailor = swifttailor.Tailor(options.maker_weights, options.sewer_weights)
    started = time.perf_counter()
    first = make(tailor, prompts[0], options.temperature)
    opening = time.perf_counter() - started
    runs, failed = [], 0
    for prompt in prompts:
        tried = [make(tailor, prompt, options.temperature) for _ in range(options.repeat)]
        made = [run for run in tried if run is not None]
        failed += not made
        if made:
            runs.append(min(made, key=lambda run: run.wall))
    print(f"first garment, with opening both networks: {opening:.2f} s{'' if first else ' (none made)'}")
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / MIB
    if not runs:
        print(f"none of {len(prompts)} prompts gave a garment")
        return
    walls = [run.wall for run in runs]
    tokens, attempts = (statistics.median(v) for v in ([r.tokens for r in runs], [r.attempts for r in runs]))
    print(
        f"warm, {len(runs)} prompts ({failed} gave no garment), {tokens:g} tokens, {attempts:g} attempts: "
        f"median {statistics.median(walls):.3f} s, from {min(walls):.3f} to {max(walls):.3f}; "
        f"processor {statistics.median(r.processor for r in runs):.3f} s; peak memory {peak:.0f} MiB"
    )
    stages = dict.fromkeys(name for run in runs for name in run.stages)
    for name in stages:
        values = [run.stages.get(name, 0.0) for run in runs]
        print(f"  {name:<12}{statistics.median(values):8.3f} s, most {max(values):.3f}")


def make(tailor: Any, prompt: str, temperature: float) -> Run | None:
    wall, processor = time.perf_counter(), time.process_time()
    try:
        tailored = tailor.generate(prompt, seed=0, temperature=temperature)
    except swifttailor.SwiftTailorError:
        return None
    wall, processor = time.perf_counter() - wall, time.process_time() - processor
    writing = tailored.report["writing"]
    return Run(tailored.seconds, wall, processor, writing.get("tokens", 0), writing["attempt"])


def cold(options: argparse.Namespace, prompt: str, more: list[str]) -> None:
    """The command, from the shell to its files."""
    given = [sys.executable, "-m", "swifttailor", "generate", prompt, *more]
    for name in ("maker_weights", "sewer_weights"):
        if getattr(options, name) is not None:
            given += [f"--{name.replace('_', '-')}", str(getattr(options, name))]
    times, peak, codes = [], 0.0, set()
    for _ in range(options.cold):
        with tempfile.TemporaryDirectory() as folder:
            started = time.perf_counter()
            process = subprocess.Popen(
                [*given, "--out", f"{folder}/garment"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
            )
            _, status, usage = os.wait4(process.pid, 0)
            times.append(time.perf_counter() - started)
        process.returncode = os.waitstatus_to_exitcode(status)
        codes.add(process.returncode)
        peak = max(peak, usage.ru_maxrss / MIB)
    print(
        f"cold, {' '.join(['swifttailor generate', *more])}: median {statistics.median(times):.2f} s, least "
        f"{min(times):.2f} of {options.cold}; peak memory {peak:.0f} MiB; exit codes {sorted(codes)}"
    )


if __name__ == "__main__":
    main()

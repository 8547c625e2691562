"""How long this checkout and another take for the same, turn by turn, so that both meet the same machine.

``python benchmarks/beside.py OTHER_CHECKOUT [--rounds 3] [--pattern FILE]``

warm generate
    Both networks open, prompts of benchmarks/prompts.txt one after the other: prompt -> garment in memory.
    Each prompt comes once a process, so that nothing that is remembered of it helps.
cold generate
    ``swifttailor generate`` in a new process, until its files are written.
cold sew
    ``swifttailor sew`` in a new process, of a T-shirt unless a pattern is given.

The other checkout is set up too (`make setup`): its ``.venv/bin/python`` is run. Of both the first round,
which may still compile, does not count. All processes keep to one core. Ratios are taken round by round, of
processor seconds (the program's own, and with the system's for it) and of seconds on the clock; each is
printed as soon as it is known, and of every task the medians. About five minutes on an idle core.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

TASKS = ("warm generate", "cold generate", "cold sew")
KINDS = {
    "user": "the program's own processor seconds",
    "processor": "with the system's for it",
    "wall": "seconds on the clock",
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("other", type=Path)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--prompts", type=int, default=8, help="how many, evenly from all styles")
    parser.add_argument("--text", default="a knee-length sleeveless dress with a V neck", help="when cold")
    parser.add_argument("--pattern", type=Path)
    parser.add_argument("--warm-here", metavar="JSON", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    if options.warm_here:
        print(json.dumps(warm(json.loads(options.warm_here))))
        return
    from generate_prompts import PROMPTS, read_prompts
    from machine import describe

    print(describe())
    prompts = [p.text for p in read_prompts(PROMPTS)]
    prompts = prompts[:: max(1, len(prompts) // options.prompts)][: options.prompts]
    pythons = {"this": Path(sys.executable), "other": options.other.resolve() / ".venv/bin/python"}
    with tempfile.TemporaryDirectory() as folder:
        pattern = options.pattern or Path(folder) / "pattern.json"
        if options.pattern is None:
            command = [sys.executable, "-m", "swifttailor", "draft", "t-shirt", "--out", str(pattern)]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        arguments = {
            "warm generate": [__file__, str(options.other), "--warm-here", json.dumps(prompts)],
            "cold generate": ["-m", "swifttailor", "generate", options.text, "--out", "{own}/made"],
            "cold sew": ["-m", "swifttailor", "sew", str(pattern), "--preview", "--out", "{own}/sewn"],
        }
        for task in TASKS:
            rounds = []
            for k in range(options.rounds + 1):
                rounds.append({})
                for name, python in pythons.items():
                    # Folders of their own: what another version wrote is not replaced.
                    own = [part.replace("{own}", f"{folder}/{name}") for part in arguments[task]]
                    rounds[-1][name] = run([str(python), *own])
                if k:
                    ratios = (
                        f"{kind} {rounds[-1]['this'][kind] / rounds[-1]['other'][kind]:.2f}" for kind in KINDS
                    )
                    print(f"{task}, round {k}: {', '.join(ratios)}", flush=True)
            report(task, rounds[1:])


def warm(prompts: list[str]) -> dict[str, float]:
    """Median seconds of each of `KINDS` over the prompts; by public names alone."""
    import swifttailor

    tailor = swifttailor.Tailor()
    tailor.generate("a long dress", seed=1)
    spent: list[dict[str, float]] = []
    for prompt in prompts:
        wall, before = time.perf_counter(), os.times()
        try:
            tailor.generate(prompt, seed=0, temperature=0.5)
        except swifttailor.SwiftTailorError:
            continue
        after = os.times()
        user, system = after.user - before.user, after.system - before.system
        spent.append({"wall": time.perf_counter() - wall, "user": user, "processor": user + system})
    return {kind: statistics.median(one[kind] for one in spent) for kind in KINDS}


def run(command: list[str]) -> dict[str, float]:
    """Seconds that a process took, or that it says its work took."""
    # Compiled modules are kept beside their sources unless that is switched off.
    surroundings = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    started = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=surroundings)
    assert process.stdout is not None
    said = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.perf_counter() - started
    process.returncode = os.waitstatus_to_exitcode(status)
    accepted = (0,) if "--warm-here" in command else (0, 1)  # 1: made, with something to look at
    if process.returncode not in accepted:
        raise SystemExit(f"exit code {process.returncode}: {' '.join(command)}")
    if "--warm-here" in command:
        return json.loads(said)
    return {"wall": wall, "user": usage.ru_utime, "processor": usage.ru_utime + usage.ru_stime}


def report(task: str, rounds: list[dict[str, dict[str, float]]]) -> None:
    for kind in KINDS:
        this, other = ([r[name][kind] for r in rounds] for name in ("this", "other"))
        ratios = sorted(a / b for a, b in zip(this, other, strict=True))
        here, there, ratio = map(statistics.median, (this, other, ratios))
        print(
            f"{task:<14} {kind:<10} this {here:6.2f} s, other {there:6.2f} s, ratio {ratio:.2f} "
            f"({ratios[0]:.2f} to {ratios[-1]:.2f}), {len(rounds)} rounds",
            flush=True,
        )


if __name__ == "__main__":
    main()

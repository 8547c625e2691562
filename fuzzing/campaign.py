"""Many inputs for one target: workers that may die, what was found, and where to resume."""

from __future__ import annotations

import base64
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from threading import Thread
from typing import IO, Any

import psutil

from fuzzing.failure import folder_of, signature_of_dump
from fuzzing.tally import SharedTally, Tally
from fuzzing.target import Target
from fuzzing.worker import Job

RENEW = 20_000
"""Inputs after which a worker makes place for a new one: what readers remember must not add up."""
_KEPT = 3
"""Inputs that are kept of each kind of failure."""
_SAVE_EVERY, _POLL = 10.0, 0.05
_PATIENCE, _LONGEST_LOOK = 300.0, 1.0
"""Seconds after which a worker is ended that uses no processor time, and so would never run out of it."""


@dataclass(frozen=True)
class Progress:
    """What is kept between runs."""

    target: str
    seed: int
    next: int = 0
    """Number of the first input that was not fed yet."""
    accepted: int = 0
    refused: int = 0
    failed: int = 0
    seconds: float = 0.0
    """Wall time of all runs."""
    failures: dict[str, int] = field(default_factory=dict)
    """How often each signature was seen."""

    def line(self) -> str:
        """For people."""
        return (
            f"{self.target}: {self.next} inputs of seed {self.seed} in {self.seconds / 60:.1f} min: "
            f"{self.accepted} accepted, {self.refused} refused, {self.failed} failed"
        )


class Campaign:
    """The inputs of one target and seed, and a folder for what comes of them."""

    def __init__(self, target: Target, module: str, seed: int, folder: Path, *, resume: bool = True) -> None:
        """Takes up what was done before in that folder, or begins anew."""
        self.target, self.module, self.folder = target, module, folder
        self._file = folder / f"{target.name}-{seed}.json"
        self.progress = Progress(target.name, seed)
        if resume and self._file.exists():
            self.progress = Progress(**json.loads(self._file.read_text()))

    def run(self, inputs: int, say: Callable[[str], None] = lambda line: None) -> Progress:
        """Feeds all numbers below `inputs` that were not fed before."""
        while self.progress.next < inputs:
            first = self.progress.next
            self._work(first, min(inputs, first + RENEW), (), say)
        return self.progress

    def replay(self, files: Sequence[Path]) -> dict[str, int]:
        """Feeds kept inputs; returns the signatures of those that fail, and how often."""
        before, done = self.progress, 0
        self.progress = replace(before, next=0, failures={})
        while (done := self.progress.next) < len(files):
            self._work(done, len(files), tuple(map(str, files)), lambda line: None)
        failures, self.progress = self.progress.failures, before
        return failures

    def _work(self, first: int, end: int, files: tuple[str, ...], say: Callable[[str], None]) -> None:
        """One worker, until it is done or dead; what it was at when it died counts as a failure."""
        start, began = self.progress, time.monotonic()
        with tempfile.TemporaryDirectory() as scratch:
            job = Job(
                self.module,
                self.target.name,
                f"{scratch}/tally",
                first,
                end,
                start.seed,
                files,
                tuple(start.failures),
            )
            tally = SharedTally(Path(job.tally))
            worker = _Worker(job, Path(scratch) / "errors")
            try:
                told, died = self._watch(worker, tally, start, began, not files, say)
            finally:
                worker.end()
        last = tally.read()
        self.progress = _added(start, last, began, self.progress.failures)
        if died is None:
            return
        if last.at < 0:
            raise RuntimeError(
                f"the reader of '{self.target.name}' cannot be loaded:\n{worker.errors[-4000:]}"
            )
        if last.at not in told:
            signature = signature_of_dump(died, worker.errors)
            self._keep({"number": last.at, "signature": signature, "detail": worker.errors[-8000:]}, files)
            self.progress = replace(self.progress, failed=self.progress.failed + 1)
        self.progress = replace(self.progress, next=last.at + 1)
        if not files:
            self._save()

    def _watch(
        self,
        worker: _Worker,
        tally: SharedTally,
        start: Progress,
        began: float,
        fresh: bool,
        say: Callable[[str], None],
    ) -> tuple[set[int], str | None]:
        """Waits for a worker; returns the numbers of failures that it told, and what it died of."""
        told: set[int] = set()
        saved = looked = time.monotonic()
        idle = 0.0
        state: tuple[float, ...] = ()
        stuck = False
        while True:
            ended = worker.process.poll() is not None
            if ended:
                worker.join()
            while worker.events:
                event = worker.events.pop(0)
                told.add(event["number"])
                self._keep(event, worker.job.files)
            if ended:
                break
            now, seen = time.monotonic(), tally.read()
            if state != (state := (seen.at, worker.processor_seconds())):
                idle = 0.0
            # Where the machine itself stood still, no time has passed for the worker.
            elif (idle := idle + min(now - looked, _LONGEST_LOOK)) > _PATIENCE:
                stuck = True
                worker.process.kill()
            looked = now
            if now - saved > _SAVE_EVERY:
                saved = now
                if fresh and seen.at >= 0:
                    self.progress = _added(start, seen, began, self.progress.failures)
                    self._save()
                    say(self.progress.line())
            time.sleep(_POLL)
        if fresh and worker.process.returncode == 0:
            self.progress = _added(start, tally.read(), began, self.progress.failures)
            self._save()
            say(self.progress.line())
        return told, None if worker.process.returncode == 0 else _cause(worker.process.returncode, stuck)

    def _keep(self, event: dict[str, Any], files: tuple[str, ...]) -> None:
        """Counts a failure, and keeps its input where there are few of its kind."""
        signature, number = event["signature"], event["number"]
        if files:
            signature = f"{Path(files[number]).name}: {signature}"
        if "shrunk" not in event:
            counts = dict(self.progress.failures)
            counts[signature] = counts.get(signature, 0) + 1
            self.progress = replace(self.progress, failures=counts)
        if files or self.progress.failures[signature] > _KEPT:
            return
        file = self.target.input(self.progress.seed, number)
        place = self.folder / "failures" / self.target.name / folder_of(signature)
        place.mkdir(parents=True, exist_ok=True)
        name = f"{self.progress.seed}-{number}"
        if "shrunk" in event:
            (place / f"{name}-small{file.ending}").write_bytes(base64.b64decode(event["shrunk"]))
        else:
            (place / f"{name}{file.ending}").write_bytes(file.data)
            (place / f"{name}.txt").write_text(f"{signature}\n\n{event['detail']}\n")

    def _save(self) -> None:
        self.folder.mkdir(parents=True, exist_ok=True)
        new = self._file.with_suffix(".new")
        new.write_text(json.dumps(asdict(self.progress), indent=1) + "\n")
        new.replace(self._file)


class _Worker:
    """The process of a job, and what it says."""

    def __init__(self, job: Job, errors: Path) -> None:
        self.job, self.events = job, list[dict[str, Any]]()
        self._errors = errors
        paths = os.pathsep.join(p for p in [str(Path(__file__).parents[1]), *sys.path] if p)
        one_thread = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
        with errors.open("wb") as stderr:
            self.process = subprocess.Popen(
                [sys.executable, "-m", "fuzzing.worker", job.to_json()],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=stderr,
                env=os.environ | one_thread | {"PYTHONPATH": paths},
                start_new_session=True,  # Ctrl-C is for the parent, which ends its worker itself
                text=True,
            )
        assert self.process.stdout is not None
        self._reader = Thread(target=self._read, args=(self.process.stdout,), daemon=True)
        self._reader.start()

    def _read(self, lines: IO[str]) -> None:
        for line in lines:
            self.events.append(json.loads(line))

    def processor_seconds(self) -> float:
        """What it has used so far; a process that has just ended uses no more."""
        try:
            return sum(psutil.Process(self.process.pid).cpu_times()[:2])
        except psutil.Error:
            return -1.0

    def join(self) -> None:
        """Waits for the last of what it said."""
        self._reader.join(10)

    def end(self) -> None:
        """Ends it, whatever it is at."""
        self.process.kill()
        self.process.wait()
        self.errors = self._errors.read_text(errors="replace")


def _added(start: Progress, tally: Tally, began: float, failures: dict[str, int]) -> Progress:
    return replace(
        start,
        next=max(start.next, tally.at),
        accepted=start.accepted + tally.accepted,
        refused=start.refused + tally.refused,
        failed=start.failed + tally.failed,
        seconds=round(start.seconds + time.monotonic() - began, 1),
        failures=failures,
    )


def _cause(code: int, stuck: bool) -> str:
    if stuck:
        return "stuck"
    if code == -signal.SIGPROF:
        return "hang"
    if code < 0:
        return f"died of {signal.Signals(-code).name}"
    return f"exit code {code}"

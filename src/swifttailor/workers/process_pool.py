"""Worker processes that may crash or hang without taking the rest of the work with them."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
import time
from collections import deque
from collections.abc import Callable, Generator, Iterable
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from pathlib import Path
from typing import Any

from swifttailor.errors import SimulationError

_READY = "ready"
_MAX_FAILED_STARTS = 3
TOO_LATE = "took longer than the time limit"
THREAD_SETTINGS = (
    "OMP_NUM_THREADS",
    "OPENBLAS_NUM_THREADS",
    "MKL_NUM_THREADS",
    "VECLIB_MAXIMUM_THREADS",
    "NUMBA_NUM_THREADS",
)


@dataclass(frozen=True)
class Outcome:
    """What became of one task."""

    task: Any
    result: Any = None
    """What the function returned."""
    lost: str = ""
    """Why there is no result: how the worker ended, or the time limit."""
    late: bool = False
    """Whether it was lost to the time limit."""


class Waiting:
    """Tasks that no worker has yet, those to be tried again first; true while there are any."""

    def __init__(self, tasks: Iterable[Any], attempts: int) -> None:
        self._tasks = iter(tasks)
        self._again: deque[Any] = deque()
        self._attempts = attempts
        self._tried: dict[int, int] = {}
        """Attempts that failed, by the identity of tasks that wait for another or have it."""
        self._upcoming = next(self._tasks, None)

    def __bool__(self) -> bool:
        return bool(self._again) or self._upcoming is not None

    def take(self) -> Any:
        """The next task."""
        if self._again:
            return self._again.popleft()
        task, self._upcoming = self._upcoming, next(self._tasks, None)
        return task

    def take_back(self, outcome: Outcome) -> bool:
        """Whether the task of an outcome is to be tried again, and waits for that now."""
        tried = self._tried.pop(id(outcome.task), 0) + 1
        if not outcome.lost or outcome.late or tried >= self._attempts:
            return False
        self._tried[id(outcome.task)] = tried
        self._again.append(outcome.task)
        return True


def run_tasks(
    function: Callable[[Any], Any],
    tasks: Iterable[Any],
    *,
    workers: int,
    time_limit: float,
    first_alone: bool = False,
    attempts: int = 1,
) -> Generator[Outcome]:
    """Runs a function on each task in worker processes, each with a single thread.

    Args:
        function: Importable by name; given to the workers once.
        tasks: Read as workers become free.
        workers: Processes at the same time.
        time_limit: Seconds after which a task is given up and its worker killed.
        first_alone: Start the other workers only after the first outcome, for when the first task fills a
            cache that all others need.
        attempts: How often a task is given to a worker that then ends; what ends so often is lost. A task
            that took too long is lost at once.

    Yields:
        An outcome per task, in order of completion.

    Raises:
        SimulationError: No worker can be started.
    """
    waiting = Waiting(tasks, attempts)
    running: list[_Worker] = []
    target = 1 if first_alone else workers
    failed_starts = 0
    try:
        while waiting or any(w.busy for w in running):
            while waiting and len(running) < target:
                running.append(_Worker(function))
            for worker in running:
                if waiting and worker.ready and not worker.busy:
                    worker.give(waiting.take(), time_limit)
            for worker in _with_news(running):
                outcome = worker.news()
                if worker.gone:
                    running.remove(worker)
                    failed_starts = 0 if worker.ready else failed_starts + 1
                    if failed_starts >= _MAX_FAILED_STARTS:
                        raise SimulationError(
                            f"Worker processes end before they can start ({worker.how_it_ended()}). "
                            "Is there enough memory? Try --workers 1."
                        )
                if outcome is not None and not waiting.take_back(outcome):
                    target = workers
                    yield outcome
    finally:
        for worker in running:
            worker.end()


class _Worker:
    """One process, and the task it has."""

    def __init__(self, function: Callable[[Any], Any]) -> None:
        context = multiprocessing.get_context("spawn")
        self.connection, theirs = context.Pipe()
        self.process = context.Process(target=_work, args=(theirs, function), daemon=True)
        with single_threaded():
            self.process.start()
        theirs.close()
        self.ready = False
        self.gone = False
        self.task: Any = None
        self.deadline = float("inf")

    @property
    def busy(self) -> bool:
        return self.task is not None

    def give(self, task: Any, time_limit: float) -> None:
        self.task, self.deadline = task, time.monotonic() + time_limit
        try:
            self.connection.send(task)
        except OSError:  # it died while idle; `news` will find out
            pass

    def news(self) -> Outcome | None:
        """Takes in what happened; an outcome when that ends the task."""
        try:
            if self.connection.poll():
                message = self.connection.recv()
                if message == _READY:
                    self.ready = True
                    return None
                return self._finished(Outcome(self.task, message))
        except (EOFError, OSError):
            return self._lost()
        if time.monotonic() >= self.deadline:
            self.end()
            return self._finished(Outcome(self.task, lost=TOO_LATE, late=True))
        return None if self.process.is_alive() else self._lost()

    def _lost(self) -> Outcome | None:
        self.end()
        lost = f"the worker process ended: {self.how_it_ended()}"
        return self._finished(Outcome(self.task, lost=lost)) if self.busy else None

    def _finished(self, outcome: Outcome) -> Outcome:
        self.task, self.deadline = None, float("inf")
        return outcome

    def how_it_ended(self) -> str:
        code = self.process.exitcode
        if code is not None and code < 0:
            hint = "; out of memory?" if -code == 9 else ""
            return f"killed by signal {-code}{hint}"
        return f"exit code {code}"

    def end(self) -> None:
        """Lets an idle process leave, and kills any other."""
        self.gone = True
        self.connection.close()  # an idle worker leaves when it sees this
        if self.busy or not self.ready:
            self.process.kill()
        self.process.join(2.0)
        if self.process.is_alive():
            self.process.kill()
            self.process.join()


def _with_news(workers: list[_Worker]) -> list[_Worker]:
    """Waits until something happens to a worker and gives those concerned."""
    soonest = min((w.deadline for w in workers), default=float("inf"))
    timeout = None if soonest == float("inf") else max(0.0, soonest - time.monotonic())
    signals: dict[Any, _Worker] = {}
    for worker in workers:
        signals[worker.connection] = worker
        signals[worker.process.sentinel] = worker
    happened = [signals[s] for s in wait(list(signals), timeout)]
    late = [w for w in workers if w.deadline <= time.monotonic()]
    return list(dict.fromkeys([*happened, *late]))


def _work(connection: Connection, function: Callable[[Any], Any]) -> None:
    """The life of a worker process."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent decides what Ctrl-C means
    threading.Thread(target=_end_with_parent, daemon=True).start()
    _die_first_without_memory()
    connection.send(_READY)
    while True:
        try:
            task = connection.recv()
        except (EOFError, OSError):
            return
        result = function(task)
        try:
            connection.send(result)
        except OSError:
            return


def _end_with_parent() -> None:
    """Ends this process when the parent is killed: two at work must never write one folder."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _die_first_without_memory() -> None:
    """Where memory runs out, Linux ends a worker and not the process that holds the work together."""
    try:
        Path("/proc/self/oom_score_adj").write_text("1000")
    except OSError:
        pass


@contextmanager
def single_threaded() -> Generator[None]:
    """Processes started inside get one thread for their arrays: more workers, not more threads."""
    before = {name: os.environ.get(name) for name in THREAD_SETTINGS}
    os.environ.update(dict.fromkeys(THREAD_SETTINGS, "1"))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value

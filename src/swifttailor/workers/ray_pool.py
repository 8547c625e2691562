"""The same work on a Ray cluster: one single-threaded worker for each processor core that it has."""

from __future__ import annotations

import socket
import time
from collections.abc import Callable, Generator, Iterable
from contextlib import contextmanager
from typing import Any

from swifttailor import __version__
from swifttailor.errors import InputError, MissingExtraError, SimulationError
from swifttailor.workers.process_pool import THREAD_SETTINGS, TOO_LATE, Outcome, Waiting

LOCAL = "local"
_MAX_FAILED_STARTS = 3
_LOOK_AGAIN = 5.0
"""Seconds after which cores that have come or gone are noticed at the latest."""
_MAX_WAIT_FOR_START = 300.0


def require_ray() -> None:
    """Checks that Ray is there.

    Raises:
        MissingExtraError: It is not installed.
    """
    try:
        import ray  # noqa: F401
    except ImportError as error:
        raise MissingExtraError("ray", "cluster", "Work on a Ray cluster") from error


def run_tasks_on_ray(
    function: Callable[[Any], Any],
    tasks: Iterable[Any],
    *,
    address: str,
    time_limit: float,
    attempts: int = 3,
) -> Generator[Outcome]:
    """Runs a function on each task on the machines of a Ray cluster.

    Every machine needs this version of SwiftTailor installed; files need not be shared, since tasks and
    results travel. Machines may come and go: a task whose machine dies is given to another.

    Args:
        function: Importable by name.
        tasks: Read as workers become free.
        address: Of the cluster's head ("auto", "ray://host:10001", "host:6379"), or "local" for a cluster of
            this machine alone. A program that has called `ray.init` keeps its connection.
        time_limit: Seconds after which a task is given up and its worker killed.
        attempts: How often a task is given to a worker that then dies; what dies so often is lost.

    Yields:
        An outcome per task, in order of completion.

    Raises:
        InputError: There is no cluster at the address.
        SimulationError: No worker can be started.
        MissingExtraError: Ray is not installed.
    """
    require_ray()
    with _connected(address):
        pool = _Pool(function, Waiting(tasks, attempts), time_limit)
        try:
            yield from pool.run()
        finally:
            pool.end()


class Actor:
    """Lives on a machine of the cluster."""

    def __init__(self, function: Callable[[Any], Any]) -> None:
        self._function = function

    def version(self) -> str:
        """Of SwiftTailor on that machine."""
        return __version__

    def work(self, task: Any) -> Any:
        """Runs the function."""
        return self._function(task)


class _Worker:
    def __init__(self, actor: Any) -> None:
        self.actor = actor
        self.reference = actor.version.remote()
        """What it is busy with: starting, or a task. None while it is idle."""
        self.ready = False
        self.task: Any = None
        self.deadline = float("inf")
        self.started = time.monotonic()


class _Pool:
    def __init__(self, function: Callable[[Any], Any], waiting: Waiting, time_limit: float) -> None:
        self._function = function
        self._waiting = waiting
        self._time_limit = time_limit
        self._workers: list[_Worker] = []
        self._failed_starts = 0
        self._cores, self._looked = 0, float("-inf")

    def run(self) -> Generator[Outcome]:
        import ray

        while self._waiting or any(w.task is not None for w in self._workers):
            self._start_workers()
            for worker in self._workers:
                if self._waiting and worker.ready and worker.reference is None:
                    worker.task = self._waiting.take()
                    worker.deadline = time.monotonic() + self._time_limit
                    worker.reference = worker.actor.work.remote(worker.task)
            busy = {w.reference: w for w in self._workers if w.reference is not None}
            soonest = min((w.deadline for w in busy.values()), default=float("inf"))
            timeout = min(_LOOK_AGAIN, max(0.0, soonest - time.monotonic()))
            done, _ = ray.wait(list(busy), num_returns=1, timeout=timeout)
            late = [w for w in busy.values() if w.deadline <= time.monotonic() and w.reference not in done]
            outcomes = [self._news(busy[reference]) for reference in done]
            outcomes += [self._drop(w, TOO_LATE, late=True) for w in late]
            for outcome in outcomes:
                if outcome is not None and not self._waiting.take_back(outcome):
                    yield outcome

    def end(self) -> None:
        import ray

        for worker in self._workers:
            ray.kill(worker.actor)

    def _start_workers(self) -> None:
        import ray

        now = time.monotonic()
        if now - self._looked >= _LOOK_AGAIN:
            self._looked = now
            self._cores = max(1, int(ray.cluster_resources().get("CPU", 1)))
            self._require_progress(now)
        for worker in [w for w in self._workers if w.task is None][: len(self._workers) - self._cores]:
            ray.kill(worker.actor)  # a machine has left, and this worker waits for a core in vain
            self._workers.remove(worker)
        while self._waiting and len(self._workers) < self._cores:
            make = ray.remote(num_cpus=1, max_restarts=0, max_task_retries=0)(Actor)
            environment = {"env_vars": dict.fromkeys(THREAD_SETTINGS, "1")}
            self._workers.append(_Worker(make.options(runtime_env=environment).remote(self._function)))

    def _require_progress(self, now: float) -> None:
        if any(w.ready for w in self._workers) or not self._workers:
            return
        if now - min(w.started for w in self._workers) > _MAX_WAIT_FOR_START:
            raise SimulationError(
                f"The Ray cluster has started no worker in {_MAX_WAIT_FOR_START:.0f} seconds. "
                "Are its processor cores taken by other jobs? See: ray status"
            )

    def _news(self, worker: _Worker) -> Outcome | None:
        import ray

        try:
            result = ray.get(worker.reference)
        except ray.exceptions.RayError as error:
            return self._drop(worker, _why(error))
        worker.reference = None
        if not worker.ready:
            worker.ready = True
            self._failed_starts = 0
            if result != __version__:
                raise InputError(
                    f"A machine of the Ray cluster has SwiftTailor {result}, this one has {__version__}. "
                    "Install the same version on all of them."
                )
            return None
        outcome = Outcome(worker.task, result)
        worker.task, worker.deadline = None, float("inf")
        return outcome

    def _drop(self, worker: _Worker, why: str, *, late: bool = False) -> Outcome | None:
        """Lets go of a worker that has died or hangs."""
        import ray

        self._workers.remove(worker)
        ray.kill(worker.actor)
        if worker.task is not None:
            return Outcome(worker.task, lost=why, late=late)
        if not worker.ready:
            self._failed_starts += 1
            if self._failed_starts >= _MAX_FAILED_STARTS:
                raise SimulationError(
                    f"Workers on the Ray cluster end before they can start ({why}). "
                    f"Is SwiftTailor {__version__} installed on each of its machines?"
                )
        return None


def _why(error: Exception) -> str:
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    return f"the worker died: {type(error).__name__}: {' '.join(lines)[:300]}"


@contextmanager
def _connected(address: str) -> Generator[None]:
    import ray

    if ray.is_initialized():
        yield
        return
    try:
        _require_answer(address)
        ray.init(
            address=address,
            log_to_driver=False,
            logging_level="warning",
            include_dashboard=False if address == LOCAL else None,
        )
    except (OSError, ValueError, RuntimeError) as error:
        raise InputError(
            f"There is no Ray cluster at '{address}': {error}. Start one with 'ray start --head', "
            "or give --ray local for this machine alone."
        ) from error
    try:
        yield
    finally:
        ray.shutdown()


def _require_answer(address: str) -> None:
    """Notices at once that nobody listens at an address; Ray itself would try for minutes.

    Raises:
        OSError: Nobody does.
    """
    host, _, port = address.removeprefix("ray://").rpartition(":")
    if host and port.isdecimal():
        with socket.create_connection((host.strip("[]"), int(port)), timeout=10.0):
            pass

"""Jobs: work that takes seconds, in a bounded queue, with progress, cancel and stop."""

from __future__ import annotations

import asyncio
import secrets
import time
from collections import OrderedDict, deque
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass, field
from typing import Any

from swifttailor.studio.mesh_store import MeshStore
from swifttailor.studio.worker.handle import Message, RefusedError, StoppedError, Worker

ENDED = frozenset({"done", "failed", "cancelled", "stopped"})
MOST_KEPT = 40
"""Jobs that have ended and can still be asked for."""
MOST_STAGES = 30
_HEARTBEAT = 15.0
"""Seconds of silence after which an event stream shows that it is alive."""


class QueueFullError(Exception):
    """Too many jobs wait already."""

    def __init__(self, retry_after: int) -> None:
        super().__init__("queue full")
        self.retry_after = retry_after


@dataclass(eq=False)
class JobRecord:
    """One job, as the server keeps it."""

    kind: str
    arguments: dict[str, Any]
    id: str = field(default_factory=lambda: secrets.token_urlsafe(16))
    state: str = "queued"
    stages: list[list[Any]] = field(default_factory=list)
    """Name, share, when it began, seconds that it took."""
    frame: bytes = b""
    frame_number: int = 0
    frame_mesh: str | None = None
    documents: list[dict[str, Any]] = field(default_factory=list)
    failures: list[dict[str, Any]] = field(default_factory=list)
    error: dict[str, str] | None = None
    started: float = 0.0
    seconds: float = 0.0
    stop: asyncio.Event = field(default_factory=asyncio.Event)
    news: asyncio.Event = field(default_factory=asyncio.Event)
    """Replaced by another whenever something happens."""
    event: str = "place"
    """What happened last."""

    def tell(self, event: str) -> None:
        """Wakes everybody who waits for news."""
        self.event = event
        self.news.set()
        self.news = asyncio.Event()

    def stage(self, name: str, share: float) -> None:
        """Notes how far a stage is."""
        self.clock()
        if not self.stages or self.stages[-1][0] != name:
            if self.stages:
                self.stages[-1][1] = 1.0
            self.stages.append([name, share, time.monotonic(), 0.0])
            del self.stages[:-MOST_STAGES]
        self.stages[-1][1] = min(1.0, max(0.0, share))

    def clock(self) -> None:
        """Brings the seconds of the stage at work up to date."""
        if self.stages and self.state == "running":
            self.stages[-1][3] = time.monotonic() - self.stages[-1][2]


class JobQueue:
    """All jobs of a server. Its methods are called on the event loop."""

    def __init__(self, worker: Worker, store: MeshStore, *, most_waiting: int, time_limit: float) -> None:
        """Nothing runs yet.

        Args:
            worker: Does the jobs, one at a time.
            store: Takes the meshes.
            most_waiting: More jobs are refused.
            time_limit: Seconds for each.
        """
        self.worker, self._store = worker, store
        self._most, self._limit = most_waiting, time_limit
        self._waiting: deque[JobRecord] = deque()
        self._jobs: OrderedDict[str, JobRecord] = OrderedDict()
        self._running: JobRecord | None = None
        self._task: asyncio.Task[None] | None = None
        self._usual = 3.0

    def submit(self, kind: str, arguments: dict[str, Any]) -> JobRecord:
        """Takes a job on.

        Raises:
            QueueFullError: Too many wait.
        """
        if len(self._waiting) >= self._most:
            raise QueueFullError(max(1, round(self._usual * len(self._waiting) / 2)))
        job = JobRecord(kind, arguments)
        self._waiting.append(job)
        self._jobs[job.id] = job
        self._forget()
        if self._task is None or self._task.done():
            self._task = asyncio.ensure_future(self._work())
        return job

    def find(self, name: str) -> JobRecord | None:
        """A job by its id."""
        return self._jobs.get(name)

    def cancel(self, job: JobRecord) -> None:
        """Ends a job: a waiting one never runs, physics keeps its last frame, all else is given up."""
        if job in self._waiting:
            self._waiting.remove(job)
            job.state = "cancelled"
            job.arguments = {}
            job.tell("cancelled")
            self._tell_places()
        elif job is self._running:
            job.stop.set()

    def place(self, job: JobRecord) -> int:
        """How many jobs are before it."""
        if job not in self._waiting:
            return 0
        return self._waiting.index(job) + (self._running is not None)

    def view(self, job: JobRecord, *, documents: bool = True) -> dict[str, Any]:
        """A job as clients see it.

        Args:
            job: Of this queue.
            documents: Whether with the documents.
        """
        running = job.state == "running"
        job.clock()
        return {
            "id": job.id,
            "kind": job.kind,
            "state": job.state,
            "place": self.place(job),
            "stages": [{"name": s[0], "share": s[1], "seconds": round(s[3], 3)} for s in job.stages],
            "frame": job.frame_number,
            "frame_mesh": job.frame_mesh,
            "documents": job.documents if documents else [],
            "failures": job.failures,
            "error": job.error,
            "seconds": round(time.monotonic() - job.started if running else job.seconds, 3),
        }

    async def events(self, job: JobRecord) -> AsyncIterator[tuple[str, dict[str, Any]] | None]:
        """What happens to a job, from now to its end; None where nothing has for a while."""
        while True:
            news = job.news
            ended = job.state in ENDED
            yield (job.state if ended else job.event), self.view(job, documents=ended)
            if ended:
                return
            if job.news is not news:
                continue
            try:
                await asyncio.wait_for(news.wait(), _HEARTBEAT)
            except TimeoutError:
                yield None

    async def _work(self) -> None:
        while self._waiting:
            job = self._running = self._waiting.popleft()
            job.state, job.started = "running", time.monotonic()
            job.tell("stage")
            self._tell_places()
            try:
                await self._carry_out(job)
                if job.state in ("done", "stopped") and job.stages:
                    job.stages[-1][1] = 1.0
            except Exception:
                job.state, job.error = (
                    "failed",
                    {"code": "internal", "message": "A fault inside SwiftTailor.", "hint": ""},
                )
            job.seconds = time.monotonic() - job.started
            job.arguments, job.frame = {}, job.frame if job.state == "stopped" else b""
            self._usual = 0.7 * self._usual + 0.3 * job.seconds
            self._running = None
            job.tell(job.state)

    async def _carry_out(self, job: JobRecord) -> None:
        try:
            result = await self.worker.run(
                job.kind, job.arguments, time_limit=self._limit, say=self._listener(job), stop=job.stop
            )
        except StoppedError:
            job.state = "cancelled"
        except RefusedError as refused:
            job.state, job.error = "failed", refused.error
        else:
            job.clock()
            for record in result.meshes:
                self._store.add(record)
            job.documents, job.failures = result.answer["documents"], result.answer["failures"]
            job.state = "stopped" if result.stopped else "done"

    def _listener(self, job: JobRecord) -> Callable[[Message], None]:
        def listen(message: Message) -> None:
            if message[0] == "stage":
                job.stage(message[1], message[2])
                job.tell("stage")
            elif message[0] == "frame":
                job.frame_mesh, job.frame = message[1], message[2]
                job.frame_number += 1
                job.tell("frame")
            elif message[0] == "meshes":
                for record in message[1]:
                    self._store.add(record)

        return listen

    def _tell_places(self) -> None:
        for job in self._waiting:
            job.tell("place")

    def _forget(self) -> None:
        """Drops the oldest jobs that have ended."""
        ended = [name for name, job in self._jobs.items() if job.state in ENDED]
        for name in ended[: max(0, len(ended) - MOST_KEPT)]:
            del self._jobs[name]

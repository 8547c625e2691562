"""Lanes: tasks that wait for one worker each, so that quick work never waits behind long work."""

from __future__ import annotations

import asyncio
import time
from collections import OrderedDict, deque
from dataclasses import dataclass, field
from typing import Any

from swifttailor.studio.worker.handle import Result, Worker

MOST_KNOWN_CLIENTS = 1000


class BusyError(Exception):
    """Too many tasks wait already."""

    def __init__(self, retry_after: int) -> None:
        super().__init__("busy")
        self.retry_after = retry_after


class QuickLane:
    """Tasks in the order in which they come, at most some of them."""

    def __init__(self, worker: Worker, *, most_waiting: int, time_limit: float) -> None:
        """Nothing runs yet.

        Args:
            worker: Of this lane alone.
            most_waiting: More are refused.
            time_limit: Seconds for each.
        """
        self.worker = worker
        self._most, self._limit = most_waiting, time_limit
        self._lock = asyncio.Lock()
        self._waiting = 0

    async def run(self, name: str, arguments: dict[str, Any], *, patience: float = 1.0) -> Result:
        """Carries out a task.

        Args:
            name: One of `bench.tasks.TASKS`.
            arguments: For it.
            patience: How many times the usual time limit it has.

        Raises:
            BusyError: Too many wait.
            RefusedError: See `Worker.run`.
        """
        if self._waiting >= self._most:
            raise BusyError(2)
        self._waiting += 1
        try:
            async with self._lock:
                return await self.worker.run(name, arguments, time_limit=patience * self._limit)
        finally:
            self._waiting -= 1


@dataclass
class _Pending:
    sequence: int
    arguments: dict[str, Any]
    answer: asyncio.Future[Result | None] = field(
        default_factory=lambda: asyncio.get_running_loop().create_future()
    )


class LiveLane:
    """States of patterns that are being dragged: of each client the latest, clients in turn."""

    def __init__(self, worker: Worker, *, most_clients: int, time_limit: float) -> None:
        """Nothing runs yet.

        Args:
            worker: Of this lane alone.
            most_clients: That wait at the same time; more are refused.
            time_limit: Seconds for each state.
        """
        self.worker = worker
        self._most, self._limit = most_clients, time_limit
        self._pending: dict[str, _Pending] = {}
        self._turns: deque[str] = deque()
        self._latest: OrderedDict[str, int] = OrderedDict()
        self._task: asyncio.Task[None] | None = None
        self.seconds = 0.2
        """That a state takes, about."""

    async def run(self, client: str, sequence: int, arguments: dict[str, Any]) -> Result | None:
        """The answer to a state; None where a later one has come.

        Raises:
            BusyError: Too many clients wait.
            RefusedError: See `Worker.run`.
        """
        if sequence <= self._latest.get(client, 0):
            return None
        before = self._pending.get(client)
        if before is None and len(self._pending) >= self._most:
            raise BusyError(max(1, round(self.seconds * len(self._pending))))
        self._latest[client] = sequence
        self._latest.move_to_end(client)
        while len(self._latest) > MOST_KNOWN_CLIENTS:
            self._latest.popitem(last=False)
        pending = _Pending(sequence, arguments)
        self._pending[client] = pending
        if before is None:
            self._turns.append(client)
        elif not before.answer.done():
            before.answer.set_result(None)
        if self._task is None or self._task.done():
            self._task = asyncio.ensure_future(self._work())
        result = await pending.answer
        return None if self._latest.get(client, 0) > sequence else result

    async def _work(self) -> None:
        while self._turns:
            pending = self._pending.pop(self._turns.popleft())
            if pending.answer.done():  # the client has gone
                continue
            started = time.monotonic()
            try:
                result = await self.worker.run("live", pending.arguments, time_limit=self._limit)
            except Exception as error:
                if not pending.answer.done():
                    pending.answer.set_exception(error)
                continue
            self.seconds = 0.8 * self.seconds + 0.2 * (time.monotonic() - started)
            if not pending.answer.done():
                pending.answer.set_result(result)

"""A worker process, seen from the server: one task at a time, killed and replaced where it overruns."""

from __future__ import annotations

import asyncio
import multiprocessing
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from swifttailor.studio.worker import process
from swifttailor.workers.process_pool import single_threaded

Message = tuple[Any, ...]
STOPPING_SECONDS = 2.0
"""That a task has, once it is asked to stop, before its process is killed."""
STARTING_SECONDS = 300.0
"""That a process has to load networks and, the first time on a machine, to compile."""
COMPILING = "compiling"
"""Stages of this name happen once on a machine; a task gets time for them."""
_LOST = ("lost",)


@dataclass(frozen=True)
class Result:
    """What a task came to."""

    answer: Any
    meshes: tuple[Any, ...]
    stopped: bool = False


class RefusedError(Exception):
    """A task was refused, given up or lost."""

    def __init__(self, error: dict[str, str]) -> None:
        super().__init__(error["message"])
        self.error = error


class StoppedError(Exception):
    """A task was stopped before it had anything to show."""


class Worker:
    """One process. All methods are called on the server's event loop."""

    def __init__(self, *, warm: bool = True, patient: bool = False, bodies: Path | None = None) -> None:
        """Nothing is started yet.

        Args:
            warm: Whether networks are loaded before the first task.
            patient: Whether it gives way to others where processors are short.
            bodies: Folder of the body meshes that people have loaded.
        """
        self._arguments = warm, patient, bodies
        self._process: Any = None
        self._connection: Connection | None = None
        self._messages: asyncio.Queue[Message] = asyncio.Queue()
        self._ready: asyncio.Event = asyncio.Event()
        self._generation = 0
        self._failures = 0
        self._closed = False

    @property
    def ready(self) -> bool:
        """Whether it waits for a task, its networks loaded."""
        return self._ready.is_set()

    def start(self) -> None:
        """Starts the process, unless it runs."""
        if self._process is not None or self._closed:
            return
        context = multiprocessing.get_context("spawn")
        ours, theirs = context.Pipe()
        self._process = context.Process(target=process.live, args=(theirs, *self._arguments), daemon=True)
        with single_threaded():
            self._process.start()
        theirs.close()
        self._connection = ours
        self._generation += 1
        self._messages = asyncio.Queue()
        reader = (ours, asyncio.get_running_loop(), self._generation)
        threading.Thread(target=self._read, args=reader, daemon=True).start()

    async def wait_until_ready(self, seconds: float = STARTING_SECONDS) -> None:
        """Waits until its networks are loaded, or for so long."""
        end = time.monotonic() + seconds
        while not self.ready and self._process is not None and time.monotonic() < end:
            await asyncio.sleep(0.05)

    def kill(self) -> None:
        """Ends the process, whatever it does."""
        if self._process is None:
            return
        self._generation += 1
        self._process.kill()
        self._process.join(5.0)
        if self._connection is not None:
            self._connection.close()
        self._process = self._connection = None
        self._ready = asyncio.Event()

    def close(self) -> None:
        """Ends it for good."""
        self._closed = True
        self.kill()

    async def run(
        self,
        name: str,
        arguments: dict[str, Any],
        *,
        time_limit: float,
        say: Callable[[Message], None] | None = None,
        stop: asyncio.Event | None = None,
    ) -> Result:
        """Carries out a task.

        Args:
            name: One of `bench.tasks.TASKS`.
            arguments: For it.
            time_limit: Seconds from when the process is ready; then it is killed.
            say: Is told what the task says meanwhile.
            stop: Set to ask the task to stop.

        Raises:
            RefusedError: The task was refused, took too long, or its process ended.
            StoppedError: It was stopped and had nothing to show.
        """
        self.start()
        try:
            await self._until_ready(stop)
            connection = self._connection
            assert connection is not None
            await asyncio.to_thread(connection.send, (name, arguments))
            return await self._result(time.monotonic() + time_limit, say or (lambda message: None), stop)
        except asyncio.CancelledError:
            self.kill()
            raise
        except (OSError, ValueError):
            self.kill()
            raise RefusedError(_ended()) from None

    async def _until_ready(self, stop: asyncio.Event | None) -> None:
        while not self._ready.is_set():
            message = await self._next(time.monotonic() + STARTING_SECONDS, stop)
            if message is None and (stop is None or not stop.is_set()):
                raise RefusedError(_not_ready())
            if message is None:
                raise StoppedError
            if message == _LOST:
                self.kill()
                raise RefusedError(_ended())

    async def _result(
        self, deadline: float, say: Callable[[Message], None], stop: asyncio.Event | None
    ) -> Result:
        asked = compiled = False
        while True:
            message = await self._next(deadline, None if asked else stop)
            if message is None and not asked and stop is not None and stop.is_set():
                asked = True
                deadline = min(deadline, time.monotonic() + STOPPING_SECONDS)
                assert self._connection is not None
                self._connection.send(None)
                continue
            if message is None:
                self.kill()
                self.start()
                if asked:
                    raise StoppedError
                raise RefusedError(_too_long())
            kind = message[0]
            if message == _LOST:
                self.kill()
                self.start()
                raise RefusedError(_ended())
            if kind == "refused":
                raise RefusedError(message[1])
            if kind in ("done", "stopped"):
                if message[1] is None and kind == "stopped":
                    raise StoppedError
                return Result(message[1], message[2], kind == "stopped")
            if kind == "stage" and message[1].startswith(COMPILING) and not compiled:
                compiled = True
                deadline += STARTING_SECONDS
            say(message)

    async def _next(self, deadline: float, stop: asyncio.Event | None) -> Message | None:
        """The next message; None at the deadline, or when it is to stop."""
        getting = asyncio.ensure_future(self._messages.get())
        waiting = {getting}
        if stop is not None:
            if stop.is_set():
                getting.cancel()
                return None
            waiting.add(asyncio.ensure_future(stop.wait()))
        try:
            await asyncio.wait(
                waiting, timeout=max(0.0, deadline - time.monotonic()), return_when=asyncio.FIRST_COMPLETED
            )
            return getting.result() if getting.done() else None
        finally:
            for one in waiting:
                one.cancel()

    def _read(self, connection: Connection, loop: asyncio.AbstractEventLoop, generation: int) -> None:
        """Passes messages on to the event loop until the process ends; in a thread of its own."""
        while True:
            try:
                message = connection.recv()
            except (EOFError, OSError, TypeError):
                message = _LOST
            try:
                loop.call_soon_threadsafe(self._take, message, generation)
            except RuntimeError:  # the loop is closed
                return
            if message == _LOST:
                return

    def _take(self, message: Message, generation: int) -> None:
        if generation != self._generation:
            return
        if message == (process.READY,):
            self._ready.set()
        elif message == _LOST:
            self._ready = asyncio.Event()
        self._messages.put_nowait(message)


def _ended() -> dict[str, str]:
    return {
        "code": "worker-ended",
        "message": "The process that did this ended unexpectedly; another takes its place.",
        "hint": "Try again. If it happens again, memory may be short: choose a longer edge length.",
    }


def _not_ready() -> dict[str, str]:
    return {
        "code": "not-ready",
        "message": "The networks are still being loaded, and their code compiled, which happens once.",
        "hint": "Try again in a minute. If it goes on, look into the terminal in which the studio runs.",
    }


def _too_long() -> dict[str, str]:
    return {
        "code": "too-long",
        "message": "This took longer than it may, and was given up.",
        "hint": "Try a simpler pattern, or a longer edge length.",
    }

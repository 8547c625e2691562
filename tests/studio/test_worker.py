"""Workers: tasks that overrun or are asked to stop end, whatever they do."""

from __future__ import annotations

import asyncio
import time

import own_loop
import pytest

from swifttailor.studio.bench import tasks
from swifttailor.studio.worker import handle
from swifttailor.studio.worker.handle import RefusedError, StoppedError, Worker
from swifttailor.studio.worker.link import Link
from swifttailor.studio.worker.refusal import for_people, refusal_of


def run(scene):
    async def whole():
        worker = Worker(warm=False)
        try:
            return await scene(worker)
        finally:
            worker.close()

    return own_loop.run(whole())


def test_a_task_that_takes_too_long_is_killed_and_the_worker_replaced(real_pattern, monkeypatch):
    monkeypatch.setattr(handle, "COMPILING", "never")  # on a fresh machine it gets more time

    async def scene(worker):
        await worker.run("check", {"pattern": real_pattern}, time_limit=60)
        started = time.monotonic()
        with pytest.raises(RefusedError) as refused:
            await worker.run(
                "drape",
                {
                    "pattern": real_pattern,
                    "mesh": None,
                    "fabric": "cotton",
                    "edge_length": 1.0,
                    "color": None,
                },
                time_limit=1.0,
            )
        assert refused.value.error["code"] == "too-long" and time.monotonic() - started < 15
        result = await worker.run("check", {"pattern": real_pattern}, time_limit=60)
        assert "findings" in result.answer

    run(scene)


def test_who_asks_before_it_is_ready_is_told_in_the_end(real_pattern, monkeypatch):
    monkeypatch.setattr(handle, "STARTING_SECONDS", 0.01)

    async def scene(worker):
        with pytest.raises(RefusedError) as refused:
            await worker.run("check", {"pattern": real_pattern}, time_limit=60)
        assert refused.value.error["code"] == "not-ready"

    run(scene)


def test_a_task_that_does_not_listen_is_killed_when_it_is_to_stop(real_pattern, monkeypatch):
    monkeypatch.setattr(handle, "STOPPING_SECONDS", 0.5)

    async def scene(worker):
        await worker.run("check", {"pattern": real_pattern}, time_limit=60)
        stop = asyncio.Event()
        arguments = {
            "text": "a dress",
            "pictures": [],
            "part": None,
            "seed": 0,
            "variants": 4,
            "finish": False,
        }
        running = asyncio.ensure_future(worker.run("generate", arguments, time_limit=60, stop=stop))
        await asyncio.sleep(0.3)
        stop.set()
        started = time.monotonic()
        with pytest.raises(StoppedError):
            await running
        assert time.monotonic() - started < 15

    run(scene)


def test_refusals_come_back_in_words():
    async def scene(worker):
        with pytest.raises(RefusedError) as refused:
            await worker.run("check", {"pattern": {"pattern": 7}}, time_limit=60)
        assert refused.value.error["code"] == "pattern-unusable" and refused.value.error["message"]

    run(scene)


def test_every_task_is_there():
    assert set(tasks.TASKS) >= {
        "live",
        "open",
        "check",
        "repair",
        "describe",
        "alter",
        "generate",
        "edit",
        "sew",
    }
    with pytest.raises(Exception, match="argument"):
        tasks.TASKS["check"](Link(print, lambda: False))


def test_messages_of_the_command_line_lose_its_commands():
    said = "Stitch 3 names edge 9 of panel 'x', which does not exist. Run: swifttailor check "
    said += "PATTERN --repair OUT"
    assert for_people(said) == "Stitch 3 names edge 9 of panel 'x', which does not exist."
    assert refusal_of(RuntimeError("secret"))["code"] == "internal"
    assert "secret" not in refusal_of(RuntimeError("secret"))["message"]

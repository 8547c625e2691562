"""Lanes and the queue, with workers that do what the test says."""

from __future__ import annotations

import asyncio

import pytest
from own_loop import run

from swifttailor.studio.jobs import MOST_KEPT, JobQueue, QueueFullError
from swifttailor.studio.mesh_store import MeshStore
from swifttailor.studio.worker.handle import RefusedError, Result, StoppedError
from swifttailor.studio.worker.lane import BusyError, LiveLane, QuickLane


class Hands:
    """Does tasks when the test lets it."""

    def __init__(self):
        self.done = []
        self.go = asyncio.Semaphore(0)
        self.fails = False

    async def run(self, name, arguments, *, time_limit, say=None, stop=None):
        waits = [asyncio.ensure_future(self.go.acquire())]
        if stop is not None:
            waits.append(asyncio.ensure_future(stop.wait()))
        await asyncio.wait(waits, return_when=asyncio.FIRST_COMPLETED)
        for one in waits:
            one.cancel()
        if stop is not None and stop.is_set():
            raise StoppedError
        if self.fails:
            raise RefusedError({"code": "too-long", "message": "too long", "hint": ""})
        self.done.append(arguments)
        return Result({"documents": [arguments], "failures": []}, ())


async def settle():
    for _ in range(20):
        await asyncio.sleep(0)


def test_of_each_client_the_latest_state_is_sewn_and_clients_take_turns():
    async def scene():
        hands = Hands()
        lane = LiveLane(hands, most_clients=2, time_limit=1)
        first = asyncio.ensure_future(lane.run("a", 1, {"n": "a1"}))
        await settle()
        second = asyncio.ensure_future(lane.run("a", 2, {"n": "a2"}))
        other = asyncio.ensure_future(lane.run("b", 1, {"n": "b1"}))
        await settle()
        third = asyncio.ensure_future(lane.run("a", 3, {"n": "a3"}))
        await settle()
        assert second.done() and await second is None  # replaced while it waited
        with pytest.raises(BusyError):
            await lane.run("c", 1, {})
        for _ in range(3):
            hands.go.release()
        assert await first is None  # sewn, and stale by then
        assert (await third).answer["documents"] == [{"n": "a3"}]
        assert (await other).answer["documents"] == [{"n": "b1"}]
        assert [task["n"] for task in hands.done] == ["a1", "a3", "b1"]
        assert await lane.run("a", 3, {}) is None

    run(scene())


def test_a_state_that_fails_fails_alone():
    async def scene():
        hands = Hands()
        lane = LiveLane(hands, most_clients=2, time_limit=1)
        hands.fails = True
        hands.go.release()
        with pytest.raises(RefusedError):
            await lane.run("a", 1, {})
        hands.fails = False
        hands.go.release()
        assert (await lane.run("a", 2, {"n": 2})).answer["documents"] == [{"n": 2}]

    run(scene())


def test_quick_work_is_bounded():
    async def scene():
        lane = QuickLane(Hands(), most_waiting=2, time_limit=1)
        waiting = [asyncio.ensure_future(lane.run("check", {})) for _ in range(2)]
        await settle()
        with pytest.raises(BusyError):
            await lane.run("check", {})
        lane.worker.go.release()
        lane.worker.go.release()
        await asyncio.gather(*waiting)
        lane.worker.go.release()
        await lane.run("check", {})

    run(scene())


def test_the_queue_is_bounded_and_every_job_ends():
    async def scene():
        hands = Hands()
        queue = JobQueue(hands, MeshStore(), most_waiting=3, time_limit=1)
        jobs = [queue.submit("sew", {"n": 0})]
        await settle()
        jobs += [queue.submit("sew", {"n": n}) for n in (1, 2, 3)]
        assert [queue.place(job) for job in jobs] == [0, 1, 2, 3]
        with pytest.raises(QueueFullError) as refused:
            queue.submit("sew", {})
        assert refused.value.retry_after >= 1
        queue.cancel(jobs[1])
        assert jobs[1].state == "cancelled" and [queue.place(job) for job in jobs[2:]] == [1, 2]
        queue.cancel(jobs[0])
        await settle()
        assert jobs[0].state == "cancelled"
        hands.go.release()
        hands.go.release()
        await settle()
        assert [job.state for job in jobs[2:]] == ["done", "done"]
        queue.cancel(jobs[3])
        assert jobs[3].state == "done"

    run(scene())


def test_events_come_in_order_and_end():
    async def scene():
        hands = Hands()
        queue = JobQueue(hands, MeshStore(), most_waiting=3, time_limit=1)
        job = queue.submit("sew", {})
        seen = []

        async def follow():
            async for event, view in queue.events(job):
                seen.append((event, view["state"], len(view["documents"])))

        following = asyncio.ensure_future(follow())
        await settle()
        hands.go.release()
        await asyncio.wait_for(following, 5)
        assert seen[-1] == ("done", "done", 1) and all(not count for *_, count in seen[:-1])
        again = [event async for event, _ in queue.events(job)]
        assert again == ["done"]

    run(scene())


def test_ended_jobs_are_forgotten():
    async def scene():
        hands = Hands()
        queue = JobQueue(hands, MeshStore(), most_waiting=3, time_limit=1)
        for _ in range(MOST_KEPT + 10):
            hands.go.release()
            last = queue.submit("sew", {})
            await settle()
        assert len(queue._jobs) <= MOST_KEPT + 1 and queue.find(last.id) is last

    run(scene())

"""Many clients at once: does the studio stay up, bounded, and true to every job it accepts?

    .venv/bin/python benchmarks/studio_load.py --clients 50 --seconds 120

Starts a server of its own. Each client submits a job (words, sewing, a drape), waits as long as a refusal
asks for, follows what is accepted to its end or cancels it, and drags a pattern meanwhile. Prints what was
answered, how long it took, and how much memory server and workers had at most. Fails where an accepted job
does not end, or a refusal is no 429 or 503 with Retry-After.
"""

from __future__ import annotations

import argparse
import asyncio
import random
import re
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from collections import Counter

import httpx
import psutil

REFUSALS = (429, 503)
ENDED = ("done", "failed", "cancelled", "stopped")


def start(projects: str) -> tuple[subprocess.Popen[str], str]:
    command = [
        sys.executable,
        "-m",
        "swifttailor",
        "studio",
        "--no-open",
        "--port",
        "0",
        "--projects",
        projects,
    ]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    found = re.search(r"http://\S+", process.stdout.readline())
    assert found, "the server did not start"
    return process, found[0].rstrip("/")


class Crowd:
    """What all clients have met with."""

    def __init__(self, examples: list[dict], end: float) -> None:
        self.examples, self.end = examples, end
        self.statuses, self.states, self.faults = Counter[str](), Counter[str](), []
        self.live_seconds: list[float] = []
        self.accepted: list[str] = []

    def job(self, dice: random.Random) -> dict:
        """What a client asks for."""
        pattern = dice.choice(self.examples)["pattern"]
        return dice.choice(
            [
                {
                    "kind": "generate",
                    "text": "a knee-length dress with long sleeves",
                    "seed": dice.randrange(1000),
                },
                {"kind": "sew", "pattern": pattern},
                {"kind": "drape", "pattern": pattern, "edge_length": 5.0},
                {"kind": "edit", "pattern": pattern, "instruction": "make it 5 cm longer"},
            ]
        )

    async def visit(self, address: str, number: int) -> None:
        """One client, until the time is over."""
        dice = random.Random(number)
        async with httpx.AsyncClient(base_url=address, timeout=300) as client:
            sequence = 0
            while time.monotonic() < self.end:
                answer = await client.post("/api/jobs", json=self.job(dice))
                self.statuses[f"jobs {answer.status_code}"] += 1
                if answer.status_code == 202:
                    await self.follow(client, answer.json()["id"], dice)
                elif answer.status_code in REFUSALS and int(answer.headers.get("retry-after", 0)) >= 1:
                    await asyncio.sleep(min(int(answer.headers["retry-after"]), 5))
                else:
                    self.faults.append(f"{answer.status_code}: {answer.text[:200]}")
                sequence += 1
                body = {
                    "client": f"load-{number:04d}",
                    "sequence": sequence,
                    "pattern": dice.choice(self.examples)["pattern"],
                }
                started = time.monotonic()
                answer = await client.post("/api/live", json=body)
                self.statuses[f"live {answer.status_code}"] += 1
                if answer.status_code == 200:
                    self.live_seconds.append(time.monotonic() - started)
                elif answer.status_code not in REFUSALS or "retry-after" not in answer.headers:
                    self.faults.append(f"live {answer.status_code}: {answer.text[:200]}")

    async def follow(self, client: httpx.AsyncClient, job: str, dice: random.Random) -> None:
        """Looks at a job until it has ended."""
        self.accepted.append(job)
        cancels = dice.random() < 0.2
        while True:
            view = (await client.get(f"/api/jobs/{job}")).json()
            if "state" not in view:
                self.faults.append(f"job lost: {view}")
                return
            if view["state"] in ENDED:
                self.states[view["state"]] += 1
                if view["state"] == "failed":
                    self.faults.append(f"failed: {view['error']}")
                return
            if cancels and view["place"]:
                await client.delete(f"/api/jobs/{job}")
            await asyncio.sleep(0.5)


async def watch(process: psutil.Process, peak: dict[str, int], end: asyncio.Event) -> None:
    while not end.is_set():
        children = process.children(recursive=True)
        sizes = []
        for child in children:
            try:
                sizes.append(child.memory_info().rss)
            except psutil.NoSuchProcess:
                pass
        peak["server"] = max(peak["server"], process.memory_info().rss)
        peak["workers"] = max(peak["workers"], sum(sizes))
        await asyncio.sleep(0.5)


async def measure(address: str, pid: int, clients: int, seconds: float) -> bool:
    async with httpx.AsyncClient(base_url=address, timeout=300) as client:
        while not (state := (await client.get("/api/state")).json())["ready"]:
            await asyncio.sleep(0.3)
        examples = [(await client.get(f"/api/examples/{e['id']}")).json() for e in state["examples"]]
    crowd = Crowd(examples, time.monotonic() + seconds)
    peak, over = {"server": 0, "workers": 0}, asyncio.Event()
    watching = asyncio.ensure_future(watch(psutil.Process(pid), peak, over))
    await asyncio.gather(*(crowd.visit(address, k) for k in range(clients)))
    over.set()
    await watching
    print(f"{clients} clients, {seconds:g} s: {dict(sorted(crowd.statuses.items()))}")
    print(f"accepted jobs {len(crowd.accepted)}, ended {sum(crowd.states.values())}: {dict(crowd.states)}")
    live = sorted(crowd.live_seconds) or [0.0]
    print(
        f"live: median {statistics.median(live):.2f} s, p95 {live[int(0.95 * (len(live) - 1))]:.2f} s, "
        f"n {len(live)}"
    )
    print(
        f"memory at most: server {peak['server'] / 2**20:.0f} MiB, workers {peak['workers'] / 2**20:.0f} MiB"
    )
    for fault in crowd.faults[:10]:
        print("fault:", fault)
    return not crowd.faults and len(crowd.accepted) == sum(crowd.states.values())


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--clients", type=int, default=50)
    parser.add_argument("--seconds", type=float, default=120.0)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as projects:
        process, address = start(projects)
        try:
            sound = asyncio.run(measure(address, process.pid, options.clients, options.seconds))
            sound = sound and process.poll() is None
        finally:
            process.send_signal(signal.SIGINT)
            print(f"ended with code {process.wait(30)}")
    return 0 if sound else 1


if __name__ == "__main__":
    sys.exit(main())

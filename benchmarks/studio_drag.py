"""From a dragged hem to the new garment: seconds a state, at five states a second.

    .venv/bin/python benchmarks/studio_drag.py [--seconds 20] [--rate 5] [--always-full]

Starts a server of its own and does what the client does (studio-ui/src/actions/live.ts): a hem of an example
moves with the clock, at most one request is under way, the newest state follows, and a state is done when its
mesh has been fetched. Where a garment in full takes more than a fifth of a second, what is dragged is sewn
coarsely, and in full once it is let go. Times are from a state to its mesh; states that were overtaken are
counted. Processor seconds are those of the process that sews, user and system.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import math
import signal
import statistics
import sys
import tempfile
import time

import httpx
import psutil

from studio_load import start


def dragged(pattern: dict, fall: float) -> dict:
    """With the lowest points of its large panels `fall` cm lower."""
    moved = json.loads(json.dumps(pattern))
    for panel in moved["pattern"]["panels"].values():
        heights = [y for _, y in panel["vertices"]]
        if max(heights) - min(heights) > 40:
            panel["vertices"] = [[x, y - fall if y < min(heights) + 5 else y] for x, y in panel["vertices"]]
    return moved


SLOW = 0.2
"""Seconds beyond which the client asks for less while it drags."""
HASTY = {"edge_length": 3.5, "dragging": True}


def processor_seconds(server: psutil.Process) -> float:
    """Of all processes of a server."""
    return sum(sum(one.cpu_times()[:2]) for one in (server, *server.children()))


async def measure(
    address: str, server: psutil.Process, *, seconds: float, rate: float, example: str, always_full: bool
) -> None:
    async with httpx.AsyncClient(base_url=address, timeout=60) as client:
        while not (await client.get("/api/state")).json()["ready"]:
            await asyncio.sleep(0.3)
        pattern = (await client.get(f"/api/examples/{example}")).json()["pattern"]
        hasty, full, content = False, 0.0, b""
        begun, found, made, number, done = time.monotonic(), [], 0, 0, 0
        used = processor_seconds(server)
        newest: tuple[int, float] | None = None
        while (now := time.monotonic() - begun) < seconds:
            count = int(now * rate)
            if count == made:
                await asyncio.sleep(0.002)
                continue
            made, newest = count, (count, begun + count / rate)
            number, since = newest
            body = {
                "client": f"drag-{example}",
                "sequence": number,
                "pattern": dragged(pattern, 5 * math.sin(number / 4)),
            } | (HASTY if hasty else {})
            sent = time.monotonic()
            answer = (await client.post("/api/live", json=body)).json()
            assert answer["status"] == "sewn", answer["error"]
            mesh = await client.get(f"/api/meshes/{answer['mesh']}")
            assert mesh.status_code == 200
            if not hasty:
                full = time.monotonic() - sent
            hasty, content = not always_full and full > SLOW, mesh.content
            found.append(time.monotonic() - since)
            done += 1
        used = processor_seconds(server) - used
        found.sort()
        print(
            f"{example}: {done} of {made} states shown in {seconds:g} s; "
            f"median {1000 * statistics.median(found):.0f} ms, "
            f"p95 {1000 * found[int(0.95 * (len(found) - 1))]:.0f} ms, worst {1000 * found[-1]:.0f} ms; "
            f"{1000 * used / done:.0f} ms of a processor and {len(content) / 1000:.0f} kB a state"
            f"{'; sewn coarsely' if hasty else ''}"
        )


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--seconds", type=float, default=20.0)
    parser.add_argument("--rate", type=float, default=5.0)
    parser.add_argument("--always-full", action="store_true", help="sew in full while dragging, too")
    parser.add_argument("--examples", nargs="+", default=["summer-dress", "shirt", "trousers"])
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as projects:
        process, address = start(projects)
        try:
            for example in options.examples:
                asyncio.run(
                    measure(
                        address,
                        psutil.Process(process.pid),
                        seconds=options.seconds,
                        rate=options.rate,
                        example=example,
                        always_full=options.always_full,
                    )
                )
        finally:
            process.send_signal(signal.SIGINT)
            process.wait(30)
    return 0


if __name__ == "__main__":
    sys.exit(main())

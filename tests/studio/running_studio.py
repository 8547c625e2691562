"""A studio in a process of its own, and what tests ask of it."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx

TIMEOUT = 120.0
COLD = Path(__file__).with_name("cold_studio.py")


@dataclass
class RunningStudio:
    """A server in a process of its own."""

    process: subprocess.Popen[str]
    address: str
    projects: Path
    token: str | None

    def client(self, **headers: str) -> httpx.Client:
        return httpx.Client(base_url=self.address, headers=headers, timeout=TIMEOUT)

    def end(self, how: int = signal.SIGINT) -> int:
        if self.process.poll() is None:
            self.process.send_signal(how)
        return self.process.wait(30)


def start_studio(projects: Path, *options: str, cold: bool = False) -> RunningStudio:
    """Starts a server on a free port and waits until it says where it is.

    Args:
        projects: Folder of the projects.
        options: Of the command line.
        cold: Whether its networks are loaded only once they are needed.
    """
    command = [sys.executable, str(COLD)] if cold else [sys.executable, "-m", "swifttailor"]
    command += ["studio", "--no-open", "--port", "0", "--projects", str(projects), *options]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=os.environ
    )
    assert process.stdout is not None
    line = process.stdout.readline()
    found = re.search(r"http://\S+", line)
    assert found, f"{line}{process.stdout.read() if process.poll() is not None else ''}"
    address, _, fragment = found[0].partition("#token=")
    return RunningStudio(process, address.rstrip("/"), projects, fragment or None)


def wait_until_ready(running: RunningStudio) -> None:
    end = time.monotonic() + TIMEOUT
    with running.client() as client:
        while not client.get("/api/state").json()["ready"]:
            assert time.monotonic() < end, "the networks did not load"
            time.sleep(0.2)


def follow(client: httpx.Client, job: str) -> list[tuple[str, dict[str, Any]]]:
    """All events of a job, to its end."""
    found, event = [], ""
    with client.stream("GET", f"/api/jobs/{job}/events") as answer:
        assert answer.status_code == 200
        for line in answer.iter_lines():
            if line.startswith("event: "):
                event = line.removeprefix("event: ")
            elif line.startswith("data: "):
                found.append((event, json.loads(line.removeprefix("data: "))))
    return found


def content_of(document: dict[str, Any], name: str = "A dress") -> dict[str, Any]:
    """A project with one version."""
    version = {"number": 1, "label": "opened", "pattern": document["pattern"], "mesh": document["mesh"]}
    return {
        "name": name,
        "prompt": document["prompt"],
        "seed": document["seed"],
        "document": document,
        "versions": [version],
        "view": {"units": "cm"},
    }
